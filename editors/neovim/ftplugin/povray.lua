-- As `durer fmt` writes: two blanks for each level.
vim.opt_local.commentstring = '// %s'
vim.opt_local.comments = 's1:/*,mb:*,ex:*/,://'
vim.opt_local.shiftwidth = 2
vim.opt_local.softtabstop = 2
vim.opt_local.expandtab = true
vim.opt_local.smartindent = true
-- `#declare` stays where it stands.
vim.opt_local.indentkeys = ''
vim.opt_local.include = [[^\s*#\s*include]]
vim.opt_local.suffixesadd = '.inc'
-- Old versions have no list of servers that they start by themselves.
if not vim.lsp.enable then require('durer').start(0) end
