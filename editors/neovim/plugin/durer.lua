-- The language server, what its code lenses ask for, and the commands :DurerRender and :DurerWatch.
local durer = require('durer')

vim.lsp.commands['durer.render'] = function(command) durer.run({ 'render' }, command.arguments[1]) end
vim.lsp.commands['durer.watch'] = function(command) durer.run({ 'watch', '--open' }, command.arguments[1]) end

local function here() return vim.api.nvim_buf_get_name(0) end
vim.api.nvim_create_user_command('DurerRender', function() durer.run({ 'render' }, here()) end, {})
vim.api.nvim_create_user_command('DurerWatch', function() durer.run({ 'watch', '--open' }, here()) end, {})

if vim.lsp.enable then vim.lsp.enable('durer') end
