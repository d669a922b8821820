-- Scenes by their ending; of INI files those in which a switch stands, or an option that can only be POV-Ray's (`Width` others have
-- too), or several settings, all of which are options.
local function is_option_file(lines)
  local known, settings, ours = {}, 0, 0
  for _, name in ipairs(require('durer.options')) do known[name:lower()] = true end
  for _, line in ipairs(lines) do
    local name = line:match('^%s*([%w_]+)%s*=')
    if name and known[name:lower()] then
      if name:find('_') then return true end
      ours = ours + 1
    end
    if name then settings = settings + 1 end
    if line:match('^%s*[-+][WHI]%S') then return true end
  end
  return ours > 1 and ours == settings
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
