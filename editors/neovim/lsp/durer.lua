-- For `vim.lsp.enable('durer')`: Neovim 0.11 and later.
return { cmd = require('durer').command(), filetypes = { 'povray' }, root_markers = { '.git' } }
