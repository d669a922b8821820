-- Scenes by their ending; of INI files those in which an option of POV-Ray stands.
local function is_option_file(lines)
  local known = {}
  for _, name in ipairs(require('durer.options')) do known[name:lower()] = true end
  for _, line in ipairs(lines) do
    local name = line:match('^%s*([%a_]+)%s*=')
    -- Names of one word, such as `Width`, others have too.
    if name and name:find('_') and known[name:lower()] then return true end
    if line:match('^%s*[-+][WHI]%S') then return true end
  end
  return false
end

-- Later than what Neovim thinks of these endings itself.
local function detect(pattern, filetype, holds)
  vim.api.nvim_create_autocmd({ 'BufNewFile', 'BufRead' }, {
    pattern = pattern,
    callback = function(event)
      if vim.bo[event.buf].filetype ~= filetype and holds(event.buf) then vim.bo[event.buf].filetype = filetype end
    end,
  })
end

detect({ '*.pov', '*.inc', '*.scene' }, 'povray', function() return true end)
detect('*.ini', 'povrayini', function(buffer) return is_option_file(vim.api.nvim_buf_get_lines(buffer, 0, 200, false)) end)
