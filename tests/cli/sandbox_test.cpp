// What scripts may not do, tried from outside; and the options that allow it.
#include <sys/stat.h>

#include <chrono>

#include "program.h"

namespace rt::test {
namespace {

class Untrusted : public ProgramTest {
 protected:
  void expect_limit(const std::string& script, const std::string& options,
                    const std::string& words) {
    const Outcome o = run_script(script, options);
    EXPECT_EQ(o.exit_code, 4) << script << o.err;
    EXPECT_NE(o.err.find(words), std::string::npos) << script << o.err;
    EXPECT_NE(o.err.find("--trust"), std::string::npos) << o.err;
    EXPECT_FALSE(left_a_file()) << script;
  }
};

TEST_F(Untrusted, LimitsExitWithFourAndSayHowToRaiseThem) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "ThreadSanitizer delays the signals that end a script";
#endif
  expect_limit("while true do end", "--script-time 0.2", "limit of 0.2 s; --script-time");
  expect_limit("while true do pcall(error) end", "--script-instructions 100000",
               "limit of 100000 instructions; --script-instructions");
  expect_limit("local t = {} while true do t[#t + 1] = gr.node('n') end", "--script-memory 50",
               "limit of 50 MB; --script-memory");
  expect_limit("string.find(('a'):rep(1e5), '.-.-b')", "--script-time 0.2", "limit of 0.2 s");
  expect_limit("local s = ('x'):rep(1e9) .. ('x'):rep(1e9) .. ('y'):rep(1e9)", "",
               "limit of 2048 MB");
}

TEST_F(Untrusted, APictureThatIsDoneStaysAndTheNextIsNotBegun) {
  const Outcome o =
      run_script(sphere_script("", "string.find(('a'):rep(1e5), '.-.-b')"), "-q --script-time 0.5");
  EXPECT_EQ(o.exit_code, 4) << o.err;
  EXPECT_TRUE(exists("ball.png"));
}

TEST_F(Untrusted, RenderingIsNotOnTheScriptsTime) {
  const Outcome o =
      run_script(sphere_script(), "-q --size 600x600 --samples 64 -t 1 --script-time 0.3");
  EXPECT_EQ(o.exit_code, 0) << o.err;
}

TEST_F(Untrusted, TenMillionNodesAreStopped) {
  const Outcome o = run_script("keep = {}\nfor i = 1, 1e7 do keep[i] = gr.sphere('s') end\n",
                               "--script-memory 200");
  EXPECT_EQ(o.exit_code, 4) << o.err;
  EXPECT_NE(o.err.find("scene.lua:2"), std::string::npos) << o.err;
}

TEST_F(Untrusted, ADiamondOfAHundredMillionInstancesIsStopped) {
  const Outcome o = run_script(
      "local top = gr.sphere('s')\n"
      "for i = 1, 27 do\n"
      "  local n = gr.node('n') n:add_child(top) n:add_child(top) top = n\n"
      "end\n"
      "gr.render(top, 'x.png', 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, 0, {})",
      "--script-memory 200");
  EXPECT_EQ(o.exit_code, 4) << o.err;
  EXPECT_NE(o.err.find("scene.lua:5"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("shapes, for which there is no memory"), std::string::npos) << o.err;
}

TEST_F(Untrusted, NoWayLeadsToTheSystem) {
  run_script(R"(
    local function absent(...)
      for _, name in ipairs{...} do
        local f, message = load('return ' .. name)
        local ok, value = pcall(f)
        assert(not ok or value == nil, name .. ' is there')
      end
    end
    absent('io', 'io.open', 'io.popen', 'os.execute', 'os.remove', 'os.rename', 'os.exit', 'os.getenv',
           'os.tmpname', 'os.setlocale', 'debug', 'debug.getregistry', 'debug.sethook',
           'debug.setmetatable', 'package.loadlib', 'package.cpath', 'package.searchers',
           'package.preload', 'loadfile', 'string.dump', 'jit', 'ffi')
    for _, name in ipairs{'io', 'debug', 'package', 'os.execute', '_G.io'} do
      local ok, value = pcall(require, name)
      assert(not ok, name)
    end
    assert(getmetatable('').__index == string and getmetatable(gr.node('n')) == false)
    assert(getmetatable(gr) == false)
    print('safe')
  )");
  EXPECT_EQ(contents(folder_ / "stdout.txt"), "safe\n") << contents(folder_ / "stderr.txt");
}

TEST_F(Untrusted, NamesStayInsideTheFolders) {
  write("secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("secret.lua", "return 1");
  std::filesystem::create_directories(folder_ / "deep/inner/work");
  std::filesystem::create_symlink(folder_ / "secret.obj", folder_ / "deep/inner/link.obj");
  std::filesystem::create_symlink(folder_ / "secret.lua", folder_ / "deep/inner/link.lua");
  std::filesystem::create_symlink("/dev/zero", folder_ / "deep/inner/zero.obj");
  std::filesystem::create_directory_symlink(folder_, folder_ / "deep/inner/up");
  ASSERT_EQ(mkfifo((folder_ / "deep/inner/pipe.obj").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder_ / "deep/inner/pipe.lua").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder_ / "deep/inner/pipe.png").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder_ / "deep/inner/zero.lua");
  std::filesystem::create_symlink("/dev/zero", folder_ / "deep/inner/zero.png");
  const std::string absolute = (folder_ / "secret.obj").string();
  const std::string render = ", 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, 0, {})";
  const struct {
    std::string script;
    int exit_code;
    const char* says;
  } cases[] = {
      {"gr.mesh('m', '../../secret.obj')", 1, "lies outside"},
      {"gr.mesh('m', '" + absolute + "')", 1, "lies outside"},
      {"gr.mesh('m', 'link.obj')", 1, "lies outside"},
      {"gr.mesh('m', 'up/secret.obj')", 1, "lies outside"},
      {"gr.mesh('m', 'zero.obj')", 1, "lies outside"},
      {"gr.mesh('m', '/dev/zero')", 1, "lies outside"},
      {"gr.mesh('m', '/proc/self/mem')", 1, "lies outside"},
      {"gr.mesh('m', 'pipe.obj')", 3, "not a regular file"},
      {"gr.texture('../../secret.png')", 1, "lies outside"},
      {"gr.texture('up/secret.png')", 1, "lies outside"},
      {"gr.texture('zero.png')", 1, "lies outside"},
      {"gr.texture('/dev/zero')", 1, "lies outside"},
      {"gr.sphere('s'):set_texture('/etc/passwd')", 1, "lies outside"},
      {"gr.texture('pipe.png')", 3, "not a regular file"},
      {"dofile 'zero.lua'", 1, "lies outside"},
      {"dofile '/dev/zero'", 1, "lies outside"},
      {"require 'pipe'", 3, "not a regular file"},
      {"dofile 'pipe.lua'", 3, "not a regular file"},
      {"dofile '../../secret.lua'", 1, "lies outside"},
      {"dofile 'link.lua'", 1, "lies outside"},
      {"dofile 'nothing/../link.lua'", 1, "lies outside"},
      {"gr.mesh('m', 'nothing/../link.obj')", 1, "lies outside"},
      {"require 'link'", 1, "lies outside"},
      {"require 'up.secret'", 1, "lies outside"},
      {"dofile '/etc/passwd'", 1, "lies outside"},
      {"gr.render(gr.node('n'), '../x.png'" + render, 1, "outside the working folder"},
      {"gr.render(gr.node('n'), '/tmp/x.png'" + render, 1, "outside the working folder"},
      {"gr.render(gr.node('n'), 'up/x.png'" + render, 1, "outside the working folder"},
      {"gr.render(gr.node('n'), '/dev/null'" + render, 1, "outside the working folder"},
  };
  std::filesystem::create_directory_symlink(folder_, folder_ / "deep/inner/work/up");
  for (const auto& c : cases) {
    write("deep/inner/scene.lua", c.script);
    Outcome o = run("../scene.lua", "cd deep/inner/work &&");
    o.err = contents(folder_ / "deep/inner/work/stderr.txt");
    EXPECT_EQ(o.exit_code, c.exit_code) << c.script << "\n" << o.err;
    EXPECT_NE(o.err.find(c.says), std::string::npos) << c.script << "\n" << o.err;
  }
}

TEST_F(Untrusted, AScriptWithoutEndIsNotReadToIt) {
  const Outcome o = run("/dev/zero");
  EXPECT_EQ(o.exit_code, 3) << o.err;
  EXPECT_NE(o.err.find("cannot read '/dev/zero': more than 64 MB"), std::string::npos) << o.err;
}

TEST_F(Untrusted, FoldersCanBeAllowedAndAScriptTrusted) {
  std::filesystem::create_directories(folder_ / "scenes");
  std::filesystem::create_directories(folder_ / "shared");
  write("shared/tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("shared/lib.lua", "return 7");
  const std::string rest = "gr.render(m, 'x.png', 8, 8, {0,0,5}, {0,0,-1}, {0,1,0}, 40, 0.1, {})\n";
  write("scenes/scene.lua",
        "assert(require 'lib' == 7)\nlocal m = gr.mesh('m', '../shared/tri.obj')\n" + rest);
  EXPECT_EQ(run("scenes/scene.lua").exit_code, 3);
  EXPECT_EQ(run("scenes/scene.lua -q --allow-path shared").exit_code, 0);
  EXPECT_EQ(run("scenes/scene.lua --allow-path nowhere").exit_code, 2);
  write("scenes/scene.lua",
        "assert(io.open('shared/lib.lua') and os.getenv('PATH'))\n"
        "local m = gr.mesh('m', '../shared/tri.obj')\n" +
            rest);
  EXPECT_EQ(run("scenes/scene.lua").exit_code, 1);
  EXPECT_EQ(run("scenes/scene.lua -q --trust --script-time 0.001 --script-memory 1").exit_code, 0);
}

}  // namespace
}  // namespace rt::test
