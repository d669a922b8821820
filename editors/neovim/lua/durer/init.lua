-- `vim.g.durer_path`: the program (`durer`); `vim.g.durer_include`: folders of include files, a list.
local M = {}

function M.path() return vim.g.durer_path or 'durer' end

-- The program with these words and all folders.
local function words_of(words)
  local command = vim.list_extend({ M.path() }, words)
  for _, folder in ipairs(vim.g.durer_include or {}) do vim.list_extend(command, { '-I', vim.fn.expand(folder) }) end
  return command
end

function M.command() return words_of({ 'lsp' }) end

-- Shows "Render" and "Watch and pick" above the scene; `:lua vim.lsp.codelens.run()` takes one.
function M.attach(client, buffer)
  local capabilities = client.server_capabilities or client.resolved_capabilities
  if not capabilities.codeLensProvider and not capabilities.code_lens then return end
  local function refresh()
    if vim.api.nvim_get_current_buf() == buffer then vim.lsp.codelens.refresh() end
  end
  local group = vim.api.nvim_create_augroup('durer_lenses_' .. buffer, {})
  vim.api.nvim_create_autocmd({ 'BufEnter', 'BufWritePost', 'InsertLeave' }, { buffer = buffer, group = group, callback = refresh })
  refresh()
end

-- Starts the server, or takes the one that runs: for Neovim before 0.11.
local client
function M.start(buffer)
  if buffer == 0 then buffer = vim.api.nvim_get_current_buf() end
  local options = { name = 'durer', cmd = M.command(), root_dir = vim.fn.getcwd(), on_attach = M.attach }
  if vim.lsp.start then return vim.lsp.start(options, { bufnr = buffer }) end
  if not client or vim.lsp.client_is_stopped(client) then client = vim.lsp.start_client(options) end
  if client then vim.lsp.buf_attach_client(buffer, client) end
end

-- Runs the program with the scene in a terminal below, in the scene's folder.
function M.run(words, scene)
  if not scene or scene == '' then return vim.notify('durer: this text has no file yet', vim.log.levels.ERROR) end
  if scene:match('^file://') then scene = vim.uri_to_fname(scene) end
  scene = vim.fn.fnamemodify(scene, ':p')
  local command = words_of(words)
  table.insert(command, scene)
  vim.cmd('botright new')
  vim.fn.termopen(command, { cwd = vim.fn.fnamemodify(scene, ':h') })
end

return M
