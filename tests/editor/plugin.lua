-- What tests/editor/plugin.sh runs inside of Neovim, with sample.pov open.

local function check(holds, what)
  if holds then return end
  io.stderr:write('FAIL ' .. what .. '\n')
  vim.cmd('cquit 1')
end

local function group(line, column)
  return vim.fn.synIDattr(vim.fn.synID(line, column, 1), 'name')
end

-- The `nth` place of a text, all letters of which are of the group.
local function is(text, expected, nth)
  local seen = 0
  for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
    local from = 1
    while true do
      local first, last = line:find(text, from, true)
      if not first then break end
      seen = seen + 1
      if seen == (nth or 1) then
        for column = first, last do
          local found = group(number, column)
          check(found == expected, string.format('`%s` in line %d is %s, not %s', text, number, found, expected))
        end
        return
      end
      from = last + 1
    end
  end
  check(false, 'there is no `' .. text .. '`')
end

check(vim.bo.filetype == 'povray', 'filetype is ' .. vim.bo.filetype)
check(vim.bo.shiftwidth == 2 and vim.bo.commentstring == '// %s', 'options')
is('all of it', 'povrayComment')
is('sphere in a comment', 'povrayComment')
is('still a comment', 'povrayComment')
is('#version', 'povrayDirective')
is('3.7', 'povrayNumber')
is('#declare', 'povrayDirective')
is('Size', 'povrayDeclared')
is('1.5e-1', 'povrayNumber')
is('#macro', 'povrayDirective')
is('Ball', 'povrayMacro')
is('Where', 'povrayParameter')
is('Where', '', 2)
is('sphere', 'povrayObject', 2)
is('pigment', 'povrayBlock')
is('rgb', 'povrayWord')
is('sin', 'povrayFunction')
is('pi', 'povrayConstant', 2)
is('#for', 'povrayDirective')
is('Index', 'povrayDeclared')
is('"a // text ', 'povrayString')
is('\\"', 'povrayEscape')
is('# end', 'povrayDirective')
is('#unknown', '')

-- The language server tells that `Unknown` is nothing.
check(vim.wait(20000, function() return #vim.diagnostic.get(0) > 0 end, 20), 'no message')

-- What its code lenses ask for.
check(vim.wait(20000, function() return #vim.lsp.codelens.get(0) == 2 end, 20), vim.inspect(vim.lsp.codelens.get(0)))
for _, lens in ipairs(vim.lsp.codelens.get(0)) do
  check(vim.lsp.commands[lens.command.command] and lens.command.arguments[1]:match('^/.*sample%.pov$'), vim.inspect(lens))
end
local ran = {}
require('durer').run = function(words, scene) table.insert(ran, table.concat(words, ' ') .. ' ' .. scene) end
vim.lsp.commands['durer.render']({ arguments = { '/a b.pov' } })
vim.lsp.commands['durer.watch']({ arguments = { '/a b.pov' } })
vim.cmd('DurerRender')
check(ran[1] == 'render /a b.pov' and ran[2] == 'watch --open /a b.pov' and ran[3]:match('^render /.*sample%.pov$'), vim.inspect(ran))
package.loaded['durer'] = nil
local picture = vim.fn.getcwd() .. '/small scene.png'
vim.fn.writefile({ 'camera { location -3 * z } sphere { 0, 1 }' }, 'small scene.pov')
require('durer').run({ 'render', '--size', '8x6' }, 'small scene.pov')
check(vim.wait(20000, function() return vim.fn.filereadable(picture) == 1 end, 20), 'nothing was drawn')

vim.cmd('edit! sample.ini')
check(vim.bo.filetype == 'povrayini', 'sample.ini is ' .. vim.bo.filetype)
is('; all of it', 'povrayiniComment')
is('Input_File_Name', 'povrayiniOption')
is('width', 'povrayiniOption')
is('"sample.pov"', 'povrayiniString')
is('[low]', 'povrayiniSection')
is('+A', 'povrayiniSwitch')
is('320', 'povrayiniNumber')
is('on', 'povrayiniConstant', 2)
vim.cmd('edit size.ini')
check(vim.bo.filetype == 'povrayini', 'size.ini is ' .. vim.bo.filetype)
vim.cmd('edit other.ini')
check(vim.bo.filetype == 'dosini', 'other.ini is ' .. vim.bo.filetype)

io.stderr:write('ok\n')
vim.cmd('qall!')
