-- For `vim.lsp.enable('durer')`: Neovim 0.11 and later.
local durer = require('durer')
return { cmd = durer.command(), filetypes = { 'povray' }, root_markers = { '.git' }, on_attach = durer.attach }
