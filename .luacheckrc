-- For luacheck: what scene scripts see.
std = "lua53"
read_globals = { "gr", "frame" }
max_line_length = false  -- tables of vertices and faces are as long as they are
files["tests/scripts"] = { std = "lua51+lua53", ignore = { "1", "2", "3", "4" } }
