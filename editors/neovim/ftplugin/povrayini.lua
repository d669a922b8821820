vim.opt_local.commentstring = '; %s'
