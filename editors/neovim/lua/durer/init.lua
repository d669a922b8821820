-- `vim.g.durer_path`: the program (`durer`); `vim.g.durer_include`: folders of include files, a list.
local M = {}

function M.path() return vim.g.durer_path or 'durer' end

function M.command()
  local command = { M.path(), 'lsp' }
  for _, folder in ipairs(vim.g.durer_include or {}) do vim.list_extend(command, { '-I', vim.fn.expand(folder) }) end
  return command
end

-- Starts the server, or takes the one that runs: for Neovim before 0.11.
local client
function M.start(buffer)
  if buffer == 0 then buffer = vim.api.nvim_get_current_buf() end
  local options = { name = 'durer', cmd = M.command(), root_dir = vim.fn.getcwd() }
  if vim.lsp.start then return vim.lsp.start(options, { bufnr = buffer }) end
  if not client or vim.lsp.client_is_stopped(client) then client = vim.lsp.start_client(options) end
  if client then vim.lsp.buf_attach_client(buffer, client) end
end

-- Runs the program with the scene in a terminal below, in the scene's folder.
function M.run(words, scene)
  if not scene or scene == '' then return vim.notify('durer: this text has no file yet', vim.log.levels.ERROR) end
  if scene:match('^file://') then scene = vim.uri_to_fname(scene) end
  scene = vim.fn.fnamemodify(scene, ':p')
  local command = vim.list_extend({ M.path() }, words)
  table.insert(command, scene)
  local include = {}
  for _, folder in ipairs(vim.g.durer_include or {}) do vim.list_extend(include, { '-I', vim.fn.expand(folder) }) end
  vim.list_extend(command, include)
  vim.cmd('botright new')
  vim.fn.termopen(command, { cwd = vim.fn.fnamemodify(scene, ':h') })
end

return M
