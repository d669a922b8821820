-- What tests/editor/neovim.sh runs inside of Neovim (0.7 and later), with hall.pov open.

local function fail(what)
  io.stderr:write('FAIL ' .. what .. '\n')
  vim.cmd('cquit 1')
end

local function check(holds, what)
  if not holds then fail(what) end
end

local client = vim.lsp.start_client({ name = 'durer', cmd = { os.getenv('DURER'), 'lsp' }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(0, client)

local function wait(what, holds)
  check(vim.wait(20000, holds, 20), what)
end

local function ask(method, line, character, more)
  local document = { uri = vim.uri_from_bufnr(0) }
  local params = vim.tbl_extend('force', { textDocument = document, position = { line = line, character = character } }, more or {})
  local answers = vim.lsp.buf_request_sync(0, method, params, 10000)
  check(answers and answers[client] and not answers[client].err, method .. ': ' .. vim.inspect(answers))
  return answers[client].result
end

-- What a run finds is told, with its place.
wait('no message', function() return #vim.diagnostic.get(0) == 1 end)
local told = vim.diagnostic.get(0)[1]
check(told.code == 'E0204' and told.lnum == 2 and told.message:find('did you mean `pigment`?', 1, true), vim.inspect(told))

local labels = {}
for _, item in ipairs(ask('textDocument/completion', 1, 9).items) do labels[item.label] = true end
check(labels.look_at and not labels.sphere, 'completion in camera')

local hover = ask('textDocument/hover', 2, 12).contents.value
check(hover:find('#declare Ball = sphere { 0, 1 }', 1, true) and hover:find('parts.inc', 1, true), hover)

-- Keys are typed, and the message goes.
vim.api.nvim_buf_set_text(0, 2, 17, 2, 24, { 'pigment' })
wait('the message stays: ' .. vim.inspect(vim.diagnostic.get(0)), function() return #vim.diagnostic.get(0) == 0 end)

local encoding = vim.lsp.get_client_by_id(client).offset_encoding
vim.lsp.util.apply_text_edits(ask('textDocument/formatting', 0, 0, { options = { tabSize = 2, insertSpaces = true } }), 0, encoding)
local line = vim.api.nvim_buf_get_lines(0, 2, 3, true)[1]
check(line == 'object { Ball pigment { rgb 1 } }', line)

local place = ask('textDocument/definition', 2, 10)
check((place[1] or place).uri:find('parts.inc', 1, true), vim.inspect(place))

vim.lsp.util.apply_workspace_edit(ask('textDocument/rename', 2, 10, { newName = 'Marble' }), encoding)
line = vim.api.nvim_buf_get_lines(0, 2, 3, true)[1]
check(line == 'object { Marble pigment { rgb 1 } }', line)
check(vim.fn.getbufline(vim.fn.bufnr('parts.inc'), 1)[1] == '#declare Marble = sphere { 0, 1 };', 'the include file')

vim.lsp.stop_client(client)
io.stderr:write('ok\n')
vim.cmd('qall!')
