/// What scripts can reach, and what they can break.
#include <set>

#include "script_run.h"

namespace rt::lua {
namespace {

using Sandbox = ScriptTest;

TEST_F(Sandbox, DangerousFunctionsAreAbsent) {
  run(R"(
    assert(io == nil and debug == nil and loadfile == nil)
    assert(package.loadlib == nil and package.path == nil and package.loaded == nil)
    assert(string.dump == nil and ("x").dump == nil)
    for name in pairs(os) do
      assert(name == 'time' or name == 'clock' or name == 'date' or name == 'difftime', name)
    end
    assert(math.sqrt(4) == 2 and #table.pack(1, 2) == 2 and utf8.char(65) == 'A')
    assert(not pcall(require, 'io') and not pcall(require, 'os') and not pcall(require, 'debug'))
    assert(coroutine.wrap(function() return 5 end)() == 5 and type(os.time()) == 'number'))");
}

TEST_F(Sandbox, LoadTakesTextOnly) {
  run(R"(
    assert(load('return 1 + 1')() == 2)
    assert(load('return x', 'c', 't', {x = 5})() == 5)
    assert(load('return x', 'c', 'bt', {x = 5})() == 5)
    assert(load('return _G ~= nil')())
    local parts = {'return ', '7'}
    assert(load(function() return table.remove(parts, 1) end)() == 7)
    local f, text = load('return', 'c')
    assert(f)
    f, text = load('x = = 1')
    assert(f == nil and text:find('unexpected symbol'))
    for _, mode in ipairs{'b', 'bt', 't'} do
      f, text = load('\27Lua', 'c', mode)
      assert(f == nil and text:find('binary chunk'), text)
    end
    f, text = load('\27Lua')
    assert(f == nil and text:find('binary chunk'), text))");
}

TEST_F(Sandbox, ABinaryScriptIsRefused) { expect_error("\x1bLua", "", {"bytecode"}); }

TEST_F(Sandbox, ScriptsMayOverwriteGlobals) {
  run(R"(
    local g = gr
    table, math, string, type, tostring, error, pcall, select, pairs, ipairs, next, setmetatable,
      getmetatable, rawget, rawequal, utf8, coroutine, os, load, _G, gr = {}, 1
    local root = g.node('root'):set_material(g.material{kd = {1, 0, 0}})
    root:add_child(g.sphere('s'):translate(1, 2, 3):rotate('X', 20):scale(2, 2, 2))
    root:add_child(g.mesh('m', {{0,0,0}, {1,0,0}, {0,1,0}}, {{0, 1, 2}}))
    local l = g.light{position = {0, 9, 0}, colour = {1, 1, 1}}
    g.render(root, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {l}, {max_depth = 2}))");
  ASSERT_EQ(jobs_.size(), 1u);
  EXPECT_EQ(jobs_[0].instances.size(), 2u);
  EXPECT_EQ(jobs_[0].options.max_depth, 2);
}

TEST_F(Sandbox, ErrorsStillReadWellWhenGlobalsAreGone) {
  expect_error(
      "tostring, string, table, error, type = nil\ngr.sphere({1, 2})",
      "scene.lua:2: gr.sphere: expected a name (string) as argument 1, got a table with 2 items");
}

TEST_F(Sandbox, MethodsOfStringsMayBeChangedWithoutHarm) {
  run(R"(
    local strings = getmetatable('').__index
    for name in pairs(strings) do strings[name] = function() error('called') end end
    getmetatable('').__index = function() error('called') end
    getmetatable('').__tostring = function() error('called') end
    getmetatable('').__gc = function() error('called') end
    local root = gr.node('root'):set_material(gr.material{kd = 1})
    root:add_child(gr.sphere('s'):rotate('x', 20))
    gr.render(root, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})
    collectgarbage())");
  EXPECT_EQ(jobs_.size(), 1u);
  expect_error(
      "string.format = nil string.find = nil getmetatable('').__index = nil\ngr.sphere({1, 2})",
      "scene.lua:2: gr.sphere: expected a name (string) as argument 1, got a table with 2 items");
}

TEST_F(Sandbox, SetmetatableIsTheLibrarysButForFinalisers) {
  run(R"(
    local t, mt = {}, {__index = {x = 5}}
    assert(setmetatable(t, mt) == t and getmetatable(t) == mt and t.x == 5)
    assert(setmetatable(t, nil) == t and getmetatable(t) == nil)
    assert(select('#', setmetatable(t, mt, 3)) == 1)
    local shut = setmetatable({}, {__metatable = 'shut'})
    local function refused(text, ...)
      local ok, message = pcall(setmetatable, ...)
      assert(not ok and message:find(text, 1, true), message)
    end
    refused('protected metatable', shut, {})
    refused('protected metatable', shut, nil)
    refused('table expected', 5, {})
    refused('nil or table expected', {}, 5)
    refused('nil or table expected', {})
    refused('finalisers', {}, {__gc = true}))");
}

TEST_F(Sandbox, TablesWithMetamethodsAreReadRaw) {
  expect_error(
      "local t = setmetatable({}, {__index = function() error('called') end})\n"
      "gr.nh_sphere('s', t, 1)",
      "scene.lua:2: gr.nh_sphere: ", {"item 1 is nil"});
}

TEST_F(Sandbox, MemoryIsLimited) {
  settings_.limits.memory = std::size_t{8} << 20;
  for (const std::string text :
       {"local s = string.rep('x', 1e9)", "local t = {} while true do t[#t + 1] = {} end",
        "local s = 'x' while true do s = s .. s end",
        "local ok, text = pcall(string.rep, 'x', 1e9)\nerror(text)"}) {
    expect_error(text, "scene.lua:1: the script needs more memory than its limit of 8 MB",
                 {"--script-memory"}, ExitCode::limit);
  }
  run("assert(not pcall(string.rep, 'x', 1e9)) local t = {} for i = 1, 1000 do t[i] = {} end");
}

TEST_F(Sandbox, MemoryCanBeTooLittleForAnyStep) {
  // For a state, for its libraries, for the script: wherever it runs out, that is all that happens.
  std::set<std::string> ends;
  for (std::size_t bytes = 8; bytes < 1 << 20; bytes += bytes / 8 + 8) {
    settings_.limits.memory = bytes;
    const Failure got = failure("x = 1");
    EXPECT_EQ(got.code, got.text.empty() ? ExitCode::done : ExitCode::limit) << got.text;
    ends.insert(got.text);
  }
  EXPECT_EQ(ends.size(), 3u) << testing::PrintToString(ends);
  EXPECT_EQ(ends.count("there is not enough memory to start Lua"), 1u);
  EXPECT_EQ(ends.count(""), 1u);
}

TEST_F(Sandbox, ArgumentsReachTheScript) {
  write("scene.lua",
        "assert(#arg == 2 and arg[1] == 'one' and arg[2] == 'two')\n"
        "assert(select('#', ...) == 2 and ... == 'one')\n"
        "assert(arg[0]:match('[^/]+$') == 'scene.lua')");
  run_script(script(), {"one", "two"}, host_);
}

TEST_F(Sandbox, FinalisersCannotBeCalledByScripts) {
  run(R"(
    local n = gr.node('n')
    assert(not pcall(function() return n.__gc end))
    n = nil
    collectgarbage() collectgarbage())");
}

}  // namespace
}  // namespace rt::lua
