/// The limits of time, instructions and memory, and every way known to get around them.
#include <chrono>

#include "script_run.h"

namespace rt::lua {
namespace {

// A signal begins the count or ends the script; ThreadSanitizer holds it back until the next system
// call, which an endless loop of Lua never makes.
#if defined(__SANITIZE_THREAD__)
constexpr bool signals_are_late = true;
#else
constexpr bool signals_are_late = false;
#endif

class Guarded : public ScriptTest {
 protected:
  void expect_limit(const std::string& text, const std::string& words) {
    const Failure got = failure(text);
    EXPECT_EQ(got.code, ExitCode::limit) << text << "\n" << got.text;
    EXPECT_NE(got.text.find(words), std::string::npos) << text << "\n" << got.text;
  }
};

/// Loops that end by a limit alone. What the script catches, it must not keep.
const char* const endless[] = {
    "while true do end",
    "local function f() return f() end f()",
    "while true do pcall(error, 'x') end",
    "while true do pcall(function() while true do end end) end",
    "while true do xpcall(function() while true do end end, function() while true do end end) end",
    "local function deep(n) while true do pcall(deep, n + 1) end end deep(0)",
    "coroutine.wrap(function() while true do end end)()",
    "while true do coroutine.resume(coroutine.create(function() while true do end end)) end",
    "while true do coroutine.wrap(function() for i = 1, 10 do end end)() end",
    "local co = coroutine.create(function() while true do pcall(coroutine.yield) end end)\n"
    "while true do pcall(coroutine.resume, co) end",
    "while true do pcall(load, 'x = ') end",
    "while true do pcall(load('while true do end')) end",
    "table.sort({3, 2, 1, 5, 4}, function() while true do end end)",
    "string.gsub('aaaa', 'a', function() while true do end end)",
    "local t = setmetatable({}, {__index = function() while true do end end}) local x = t.y",
    "local t = setmetatable({}, {__tostring = function() while true do end end})\n"
    "while true do pcall(tostring, t) end",
    "for k in function() return 1 end do end",
    "goto a ::a:: goto a",
    "local s = 0 repeat s = s + 1 until false",
};

TEST_F(Guarded, InstructionsAreCountedWhateverTheScriptDoes) {
  settings_.limits.instructions = 300'000;
  settings_.limits.seconds = 30;
  for (const char* text : endless) {
    expect_limit(text, "more than its limit of 300000 instructions");
  }
}

TEST_F(Guarded, TimeIsUpWhateverTheScriptDoes) {
  if (signals_are_late) {
    GTEST_SKIP() << "ThreadSanitizer delays signals";
  }
  settings_.limits.seconds = 0.02;
  for (const char* text : endless) {
    const auto start = std::chrono::steady_clock::now();
    expect_limit(text, "longer than its limit of 0.02 s");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1)) << text;
  }
}

TEST_F(Guarded, AMessageSaysWhereAndHowToRaiseTheLimit) {
  if (signals_are_late) {
    GTEST_SKIP() << "ThreadSanitizer delays signals";
  }
  settings_.limits.instructions = 10'000;
  expect_error("\n\nwhile true do end", "scene.lua:3: the script has run more than its limit",
               {"--script-instructions", "--trust"}, ExitCode::limit);
  settings_.limits = {.seconds = 0.02};
  expect_error("\nwhile true do end", "scene.lua:2: the script has run longer",
               {"--script-time", "--trust"}, ExitCode::limit);
  settings_.limits = {.memory = 4 << 20};
  expect_error("\nlocal t = {} while true do t[#t + 1] = gr.sphere('s') end",
               "scene.lua:2: ", {"memory", "--script-memory", "--trust"}, ExitCode::limit);
}

TEST_F(Guarded, AnInstructionCountIsExactEnough) {
  settings_.limits.instructions = 1'000'000;
  run("for i = 1, 150000 do local x = i + 1 end");
  expect_limit("for i = 1, 600000 do local x = i + 1 end", "instructions");
}

TEST_F(Guarded, ACountThatBeginsLateStillComes) {
  if (signals_are_late) {
    GTEST_SKIP() << "ThreadSanitizer delays signals";
  }
  settings_.limits.instructions = 200'000'001;  // the first that is not counted from the start
  expect_limit("while true do end", "instructions");
}

TEST_F(Guarded, TheTimeOfRenderingIsNotTheScripts) {
  settings_.limits.seconds = 0.1;
  host_.render = [](const RenderJob&) { usleep(400'000); };
  run("gr.render(gr.node('n'), 'a.png', 4, 3, {0,0,1}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})");
}

TEST_F(Guarded, AnInterruptionCannotBeCaught) {
  int calls = 0;
  host_.render = [&](const RenderJob&) {
    ++calls;
    throw UserError(ExitCode::interrupted, "interrupted");
  };
  expect_error(
      "local n = gr.node('n')\n"
      "while true do pcall(gr.render, n, 'a.png', 4, 3, {0,0,1}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, "
      "{}) end",
      "", {"interrupted"}, ExitCode::interrupted);
  EXPECT_EQ(calls, 1);
}

TEST_F(Guarded, FinalisersWhichRunBeyondTheHookAreRefused) {
  expect_error("setmetatable({}, {__gc = function() while true do end end})",
               "scene.lua:1: setmetatable: scripts have no finalisers");
  run("local mt = {} setmetatable({}, mt) mt.__gc = function() x = 1 end\n"
      "collectgarbage() collectgarbage() assert(x == nil)");
}

using GuardedDeathTest = Guarded;

TEST_F(GuardedDeathTest, OneLongCallOfALibraryFunctionEndsTheProcess) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  settings_.limits.seconds = 0.05;
  for (const char* text :
       {"string.find(('a'):rep(1e5), '.-.-b')", "pcall(string.match, ('a'):rep(1e5), '.-.-.-b')",
        "coroutine.wrap(function() string.gsub(('a'):rep(1e5), '.-.-.-b', '') end)()"}) {
    EXPECT_EXIT(run(text), testing::ExitedWithCode(4),
                "error: .*scene.lua: the script has run longer than its limit of 0.05 s")
        << text;
  }
}

TEST_F(Guarded, WhatNodesTakeIsCharged) {
  settings_.limits.memory = 20 << 20;
  const std::string many = "local keep = {}\nfor i = 1, 1e6 do keep[i] = ";
  for (const std::string made : {"gr.sphere('s')", "gr.node(('n'):rep(200))", "gr.material{kd = 1}",
                                 "gr.torus('t', 1, 2)", "gr.light({0,0,0}, {1,1,1}, {1,0,0})",
                                 "gr.mesh('m', {{0,0,0},{1,0,0},{0,1,0}}, {{0,1,2}})"}) {
    expect_limit(many + made + " end", "memory");
  }
  expect_limit("local a, b = gr.node('a'), gr.node('b') while true do a:add_child(b) end",
               "memory");
}

TEST_F(Guarded, WhatIsLetGoIsGivenBack) {
  settings_.limits.memory = 20 << 20;
  run("for i = 1, 2e5 do\n"
      "  local n = gr.node('n') n:add_child(gr.sphere(('s'):rep(50)))\n"
      "  n:set_material(gr.material{kd = 1})\n"
      "end");
}

TEST_F(Guarded, OneFaceInManyPlacesIsManyFaces) {
  settings_.limits.memory = 64 << 20;
  expect_limit(
      "local face = {} for i = 1, 1e5 do face[i] = i % 3 end\n"
      "local faces = {} for i = 1, 1e5 do faces[i] = face end\n"
      "gr.mesh('m', {{0,0,0},{1,0,0},{0,1,0}}, faces)",
      "memory");
}

TEST_F(Guarded, OneLightInManyPlacesIsManyLights) {
  settings_.limits.memory = 64 << 20;
  expect_limit(
      "local l = gr.light({0,0,0}, {1,1,1}, {1,0,0})\n"
      "local lights = {} for i = 1, 1e6 do lights[i] = l end\n"
      "gr.render(gr.sphere('s'), 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, lights)",
      "memory");
}

TEST_F(Guarded, LongNamesOfChunksAreCutInPlaces) {
  run("local f = assert(load('return gr.light({0,0,0}, {1,1,1}, {1,0,0})', '@' .. "
      "('x'):rep(1e5)))\n"
      "gr.render(gr.sphere('s'), 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {f()})");
  EXPECT_LT(jobs_[0].lights[0].where.size(), 1100u);
}

TEST_F(Guarded, TextsOfPlacesAreCharged) {
  settings_.limits.memory = 24 << 20;
  // Two lines in turn, so that each call has a text of its own; without it they take 12 MB at most.
  for (const std::string made : {"gr.node('n')", "gr.light({0,0,0}, {1,1,1}, {1,0,0})"}) {
    const std::string loop = " keep = {} for i = 1, 3e4, 2 do keep[i], keep[i + 1] = f() end";
    const std::string code = "local f = assert(load([[return " + made + ",\n" + made + "]], ";
    run(code + "'@short'))" + loop);
    expect_limit(code + "'@' .. ('x'):rep(1000)))" + loop, "memory");
  }
}

TEST_F(Guarded, DiamondsComeToAnEnd) {
  const std::string render =
      "gr.render(top, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})";
  for (const std::string leaf : {"gr.sphere('s')", "gr.node('nothing')"}) {
    settings_.limits.memory = 64 << 20;
    expect_limit("local top = " + leaf +
                     "\nfor i = 1, 27 do local n = gr.node('n') n:add_child(top) n:add_child(top) "
                     "top = n end\n" +
                     render,
                 "shapes, for which there is no memory");
  }
}

TEST_F(Guarded, MovingNodesBelowEachOtherComeToAnEnd) {
  settings_.limits.memory = 64 << 20;
  const auto chain = [](int links) {
    return "local top = gr.sphere('s')\nfor i = 1, " + std::to_string(links) +
           " do top = gr.node('n'):motion{to = {translate = {1, 0, 0}}}:add_child(top) end\n"
           "gr.render(top, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})";
  };
  run(chain(100));
  expect_limit(chain(3000), "moving nodes above it count too");
}

TEST_F(Guarded, DepthHasALimitAndAMessage) {
  const std::string render =
      "gr.render(top, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})";
  expect_error(
      "local top = gr.sphere('s')\n"
      "for i = 1, 20000 do local n = gr.node('n') n:add_child(top) top = n end\n" +
          render,
      "scene.lua:3: ", {"deeper than 10000"});
  run("local top = gr.sphere('s')\n"
      "for i = 1, 300000 do local n = gr.node('n') n:add_child(top) top = n end");
}

TEST_F(Guarded, RecursionsEnd) {
  for (const char* text : {
           "local function f() return 1 + f() end f()",
           "local t = setmetatable({}, {}) getmetatable(t).__index = t local x = t.y",
           "local f f = function() string.gsub('a', 'a', f) end f()",
           "local function f() coroutine.wrap(f)() end f()",
           "load(('('):rep(1e5) .. '1' .. (')'):rep(1e5))()",
           "load('x = ' .. ('{'):rep(1e5) .. ('}'):rep(1e5))()",
           "string.find(('a'):rep(300000), ('a?'):rep(300000) .. ('a'):rep(300000))",
           "string.find(('('):rep(1e5), ('('):rep(1e5))",
           "local t = {} t[1] = t table.concat(t)",
           "table.unpack({}, 1, 1e8)",
           "string.format(('%s'):rep(1e6), 1)",
           "local s = ('x'):rep(100) s:rep(1e17)",
           "require 'scene'",
           "dofile 'scene.lua'",
       }) {
    const Failure got = failure(text);
    EXPECT_EQ(got.code, ExitCode::scene) << text << "\n" << got.text;
  }
}

TEST_F(Guarded, TrustLiftsEveryLimit) {
  settings_.limits = {.memory = 1 << 20, .seconds = 0.001, .instructions = 10};
  settings_.trust = true;
  write("other.lua", "return 7");
  run("local t = {} for i = 1, 1e5 do t[i] = {} end\n"
      "assert(io.open(arg[0]) and os.getenv and debug.traceback and string.dump)\n"
      "assert(load(string.dump(function() return 5 end))() == 5)\n"
      "assert(require 'other' == 7 and dofile '" +
      (folder_ / "other.lua").string() +
      "' == 7)\n"
      "setmetatable({}, {__gc = function() end})");
}

}  // namespace
}  // namespace rt::lua
