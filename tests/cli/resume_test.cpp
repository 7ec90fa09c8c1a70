// Nothing lost: signals, checkpoints, and going on from them.
#include <fstream>
#include <regex>

#include "running.h"

namespace rt::test {
namespace {

using namespace std::chrono_literals;

/// A scene that takes a second or so, of `pictures` pictures p1.png, p2.png, ...
std::string slow_scene(int pictures = 1) {
  return "local scene = gr.node('scene')\n"
         "scene:add_child(gr.sphere('ball'):set_material(gr.material({0.8, 0.2, 0.2}, 0.5, 30)))\n"
         "scene:add_child(gr.plane('ground'):translate(0, -1, 0):set_material(\n"
         "  gr.material{kd = 0.5, reflectivity = 0.3}))\n"
         "local lamp = gr.light({3, 4, 5}, {1, 1, 1}, {1, 0, 0}, 0.7)\n"
         "for i = 1, " +
         std::to_string(pictures) +
         " do\n"
         "  gr.render(scene, 'p' .. i .. '.png', 200, 150, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 40, "
         "0.2, {lamp})\n"
         "  scene:translate(0.1, 0, 0)\n"
         "end\n";
}

/// A BMP of one grey pixel.
std::string grey_bmp(char grey) {
  std::string bytes = "BM";
  const auto number = [&bytes](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) {
      bytes += static_cast<char>(value >> (8 * i) & 0xffU);
    }
  };
  for (const std::uint32_t v : {58U, 0U, 54U, 40U, 1U, 1U}) {  // sizes, where pixels are, 1 x 1
    number(v, 4);
  }
  number(1, 2);   // planes
  number(24, 2);  // bits a pixel
  for (const std::uint32_t v : {0U, 4U, 2835U, 2835U, 0U, 0U}) {
    number(v, 4);
  }
  return bytes + std::string(3, grey) + '\0';
}

class Resumed : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("scene.lua", slow_scene());
  }

  /// Starts the scene, and sends a signal once so much of a picture is done.
  Outcome interrupt(const std::string& options, int number = SIGINT,
                    const std::string& when = "p1.png: ") const {
    Running program(folder_, "scene.lua --progress plain " + options);
    EXPECT_TRUE(program.says(when)) << options;
    program.signal(number);
    return program.wait();
  }

  /// Interrupts, and goes on: the picture must be that of a run without interruption.
  void expect_equal(const std::string& options) {
    ASSERT_EQ(run("scene.lua -q -o whole.png --stats whole.json " + options).exit_code, 0);
    const Outcome broken = interrupt(options);
    EXPECT_EQ(broken.exit_code, 130) << options << broken.err;
    EXPECT_TRUE(exists("p1.png.checkpoint")) << options << broken.err;
    EXPECT_NE(contents(folder_ / "p1.png"), contents(folder_ / "whole.png")) << options;
    const Outcome o = run("scene.lua -q --resume --stats resumed.json " + options);
    EXPECT_EQ(o.exit_code, 0) << options << o.err;
    EXPECT_TRUE(same_file(folder_ / "p1.png", folder_ / "whole.png")) << options;
    EXPECT_FALSE(exists("p1.png.checkpoint")) << options;
    const std::regex rays("\"samples\": [0-9]+|\"(camera|shadow|reflection)\": [0-9]+");
    const auto counted = [&](const std::string& file) {
      const std::string text = contents(folder_ / file);
      std::string found;
      for (std::sregex_iterator i(text.begin(), text.end(), rays), end; i != end; ++i) {
        found += i->str() + " ";
      }
      return found;
    };
    EXPECT_EQ(counted("resumed.json"), counted("whole.json")) << "what both runs did, once";
  }
};

TEST_F(Resumed, PicturesAreThoseOfAnUninterruptedRun) {
  expect_equal("--samples 200");
  expect_equal("--samples 200 -t 1");
  expect_equal("--max-error 0.001");
  expect_equal("--max-error 0.0015 -t 1 --crop 30,20,130,110");
  expect_equal("--aa corners -s 700x525");  // a second's work, as the others
  expect_equal("--max-error 0.001 --time-limit 1000");
}

TEST_F(Resumed, TheMessageSaysWhereEverythingIsAndHowToGoOn) {
  const Outcome o = interrupt("--samples 900 --seed 7", SIGTERM);
  EXPECT_EQ(o.exit_code, 130);
  EXPECT_TRUE(std::regex_search(
      o.err,
      std::regex("interrupted: at [0-9]+% of p1\\.png; the picture so far is in p1\\.png; "
                 "the checkpoint is in p1\\.png\\.checkpoint; to go on: raytracer scene\\.lua "
                 "--progress plain --samples 900 --seed 7 --resume\n")))
      << o.err;
  EXPECT_NE(contents(folder_ / "p1.png").find("raytracer:unfinished"), std::string::npos);
}

TEST_F(Resumed, ManyInterruptionsMakeNoDifference) {
  ASSERT_EQ(run("scene.lua -q --max-error 0.001 -o whole.png").exit_code, 0);
  int interruptions = 0;
  for (Outcome o{130, {}, {}}; o.exit_code == 130; ++interruptions) {
    ASSERT_LT(interruptions, 100);
    Running program(folder_, "scene.lua -q --max-error 0.001 --resume");
    std::this_thread::sleep_for(100ms + 10ms * interruptions);
    program.signal(SIGINT);
    o = program.wait();
    ASSERT_TRUE(o.exit_code == 130 || o.exit_code == 0) << o.err;
  }
  EXPECT_GT(interruptions, 1);
  EXPECT_TRUE(same_file(folder_ / "p1.png", folder_ / "whole.png"));
}

// OpenImageIO is still being loaded then, and no pixel is finished: nothing waits for it.
TEST_F(Resumed, AnInterruptionAtTheVeryBeginningEndsWell) {
  for (int i = 0; i < 16; ++i) {
    Running program(folder_, "scene.lua -q --max-error 0.001");
    std::this_thread::sleep_for(20ms + 10ms * i);
    program.signal(SIGINT);
    const Outcome o = program.wait();
    EXPECT_EQ(o.exit_code, 130) << o.err;
    EXPECT_EQ(o.err.find("Assertion"), std::string::npos) << o.err;
  }
}

TEST_F(Resumed, FinishedPicturesAreNotRenderedAgain) {
  write("scene.lua", slow_scene(3));
  const std::string options = "--samples 60";
  ASSERT_EQ(run("scene.lua -q -o whole.png " + options).exit_code, 0);
  EXPECT_EQ(interrupt(options, SIGINT, "p2.png: ").exit_code, 130);
  const auto written = std::filesystem::last_write_time(folder_ / "p1.png");
  EXPECT_FALSE(exists("p3.png"));
  const Outcome o = run("scene.lua --resume " + options);
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("p1.png: was finished before"), std::string::npos) << o.err;
  EXPECT_EQ(std::filesystem::last_write_time(folder_ / "p1.png"), written);
  EXPECT_TRUE(same_file(folder_ / "p1.png", folder_ / "whole.png"));
  EXPECT_TRUE(same_file(folder_ / "p2.png", folder_ / "whole.2.png"));
  EXPECT_TRUE(same_file(folder_ / "p3.png", folder_ / "whole.3.png"));
  EXPECT_FALSE(exists("p1.png.checkpoint"));
}

TEST_F(Resumed, WhatHasNotBeenTakenUpYetIsNotLost) {
  const std::string pause = "local t = os.clock() while os.clock() - t < 1 do end\n";
  write("scene.lua",
        std::regex_replace(slow_scene(2), std::regex("(  scene:translate)"), pause + "$1"));
  ASSERT_EQ(run("scene.lua -q -o whole.png --samples 100").exit_code, 0);
  EXPECT_EQ(interrupt("--samples 100", SIGINT, "p2.png: ").exit_code, 130);
  const std::string kept = contents(folder_ / "p1.png.checkpoint");
  const Outcome o = interrupt("--samples 100 --resume", SIGINT, "p1.png: was finished before");
  EXPECT_EQ(o.exit_code, 130) << o.err;
  EXPECT_TRUE(contents(folder_ / "p1.png.checkpoint") == kept);
  EXPECT_EQ(run("scene.lua -q --resume --samples 100").exit_code, 0);
  EXPECT_TRUE(same_file(folder_ / "p2.png", folder_ / "whole.2.png"));
}

TEST_F(Resumed, AFinishedPictureThatHasGoneIsRenderedAgain) {
  write("scene.lua", slow_scene(2));
  ASSERT_EQ(run("scene.lua -q -o whole.png --samples 200").exit_code, 0);
  EXPECT_EQ(interrupt("--samples 200", SIGINT, "p2.png: ").exit_code, 130);
  std::filesystem::remove(folder_ / "p1.png");
  const Outcome o = run("scene.lua --resume --samples 200");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("p1.png has changed or gone"), std::string::npos) << o.err;
  EXPECT_TRUE(same_file(folder_ / "p1.png", folder_ / "whole.png"));
  EXPECT_TRUE(same_file(folder_ / "p2.png", folder_ / "whole.2.png"));
}

TEST_F(Resumed, AFinishedPictureThatWasMovedDuringTheRunIsRenderedAgain) {
  write("scene.lua", slow_scene(2));
  ASSERT_EQ(run("scene.lua -q -o whole.png --samples 200").exit_code, 0);
  {
    Running program(folder_, "scene.lua --progress plain --samples 200");
    ASSERT_TRUE(program.says("p2.png: "));
    std::filesystem::rename(folder_ / "p1.png", folder_ / "moved.png");
    program.signal(SIGINT);
    EXPECT_EQ(program.wait().exit_code, 130);
  }
  const Outcome o = run("scene.lua --resume --samples 200");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("p1.png has changed or gone"), std::string::npos) << o.err;
  EXPECT_TRUE(same_file(folder_ / "p1.png", folder_ / "whole.png"));
  EXPECT_TRUE(same_file(folder_ / "p2.png", folder_ / "whole.2.png"));
}

TEST_F(Resumed, BetweenPicturesWithoutACheckpointIsStillAnInterruption) {
  write("scene.lua", sphere_script("", "while true do end"));
  Running program(folder_, "scene.lua --size 4x4 -o p1.tga",
                  [] { limit_file_size(1000); });  // the picture is smaller, the checkpoint larger
  ASSERT_TRUE(program.says("p1.tga: 4x4"));
  program.signal(SIGINT);
  const Outcome o = program.wait();
  EXPECT_EQ(o.exit_code, 130) << o.err;
  EXPECT_NE(o.err.find("between pictures; there is no checkpoint: cannot write"), std::string::npos)
      << o.err;
}

TEST_F(Resumed, TheCheckpointsPlaceMayBeNamedTwice) {
  const Outcome o =
      run("scene.lua -q --checkpoint-file a --checkpoint-file b --resume --samples 1");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("there is no b;"), std::string::npos) << o.err;
}

TEST_F(Resumed, AnotherSceneFileOrOptionIsRefused) {
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  write("part.obj", mesh);
  write("lib.lua", "return 0.2");
  write("tile.bmp", grey_bmp('\x80'));
  const std::string scene =
      "require 'lib'\ngr.mesh('m', 'part.obj')\ngr.texture('tile.bmp')\n" + slow_scene();
  write("scene.lua", scene);
  EXPECT_EQ(interrupt("--samples 400").exit_code, 130);
  const std::string before = contents(folder_ / "p1.png");
  const auto refused = [&](const std::string& options, const std::string& says) {
    const Outcome o = run("scene.lua --resume " + options);
    EXPECT_EQ(o.exit_code, 3) << options << o.err;
    EXPECT_NE(o.err.find("cannot resume from p1.png.checkpoint"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find(says), std::string::npos) << options << o.err;
    EXPECT_TRUE(exists("p1.png.checkpoint")) << "it is not lost";
    EXPECT_EQ(contents(folder_ / "p1.png"), before);
  };
  refused("--samples 401", "the option samples is 401, and was 400");
  refused("--samples 400 --disable reflection", "the option reflection");
  refused("--samples 400 --size 10x10", "the picture's size is 10x10, and was 200x150");
  refused("--samples 400 --crop 0,0,20,20", "the crop");
  refused("--samples 400 -- extra", "what follows -- is 'extra', and was nothing");
  write("part.obj", mesh + "# the same, with a comment\n");
  refused("--samples 400", "part.obj");
  write("part.obj", mesh);
  write("lib.lua", "return 0.3");
  refused("--samples 400", "lib.lua");
  write("lib.lua", "return 0.2");
  write("tile.bmp", grey_bmp('\x81'));
  refused("--samples 400", "tile.bmp");
  write("tile.bmp", grey_bmp('\x80'));
  write("scene.lua", scene + "-- a remark\n");
  refused("--samples 400", "the file scene.lua");
  write("scene.lua", scene);
  EXPECT_EQ(run("scene.lua -q --resume --samples 400").exit_code, 0) << "all as it was";
}

TEST_F(Resumed, ASceneThatDependsOnTheTimeIsRefused) {
  write("scene.lua",
        "local _, now = pcall(require, 'os')\n"
        "local t = os.clock() * 1e-6\n" +
            std::regex_replace(slow_scene(), std::regex("0, 0, 5"), "t, 0, 5"));
  EXPECT_EQ(interrupt("--samples 400").exit_code, 130);
  const Outcome o = run("scene.lua --resume --samples 400");
  EXPECT_EQ(o.exit_code, 3) << o.err;
  EXPECT_NE(o.err.find("does it use the time?"), std::string::npos) << o.err;
}

TEST_F(Resumed, DamagedCheckpointsAreRefused) {
  EXPECT_EQ(interrupt("--samples 2000 --size 60x40").exit_code, 130);
  const std::string good = contents(folder_ / "p1.png.checkpoint");
  ASSERT_GT(good.size(), 1000u);
  const auto refused = [&](const std::string& bytes, const std::string& what) {
    write("p1.png.checkpoint", bytes);
    const Outcome o = run("scene.lua -q --resume --samples 2000 --size 60x40");
    EXPECT_EQ(o.exit_code, 3) << what << o.err;
    EXPECT_NE(o.err.find("cannot resume from p1.png.checkpoint"), std::string::npos) << what;
  };
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, std::size_t{23}, std::size_t{40},
                                 good.size() / 2, good.size() - 1}) {
    refused(good.substr(0, size), "cut to " + std::to_string(size));
  }
  refused(good + "x", "one byte more");
  refused("P6 is no checkpoint", "something else");
  std::uint64_t random = 12345;
  for (int i = 0; i < 60; ++i) {
    random = random * 6364136223846793005u + 1442695040888963407u;
    std::string bad = good;
    // The first hundreds of bytes are lengths and texts, the rest a picture.
    const std::size_t range = i % 2 == 0 ? std::min<std::size_t>(bad.size(), 600) : bad.size();
    bad[(random >> 33) % range] ^= static_cast<char>(1 << ((random >> 20) % 8));
    refused(bad, "flip " + std::to_string(i));
  }
  write("p1.png.checkpoint", good);
  EXPECT_EQ(run("scene.lua -q --resume --samples 2000 --size 60x40").exit_code, 0);
}

TEST_F(Resumed, WithoutACheckpointAllBeginsAnew) {
  const Outcome o = run("scene.lua -q --resume --samples 1");
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err, "warning: --resume: there is no p1.png.checkpoint; all begins anew\n");
}

TEST_F(Resumed, AnotherRunSaysThatThereIsACheckpointAndLeavesIt) {
  EXPECT_EQ(interrupt("--samples 400").exit_code, 130);
  const std::string kept = contents(folder_ / "p1.png.checkpoint");
  const Outcome o = run("scene.lua -q --samples 1");
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_NE(o.err.find("--resume would go on from there"), std::string::npos) << o.err;
  EXPECT_EQ(contents(folder_ / "p1.png.checkpoint"), kept);
}

TEST_F(Resumed, PeriodicCheckpointsOutliveAKill) {
  const std::string options = "--max-error 0.002 --checkpoint 0.1 ";
  ASSERT_EQ(run("scene.lua -q --max-error 0.002 -o whole.png").exit_code, 0);
  {
    Running program(folder_, "scene.lua -q " + options);
    while (!exists("p1.png.checkpoint") && !program.ended()) {
      std::this_thread::sleep_for(10ms);
    }
    program.signal(SIGKILL);
    EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
  }
  ASSERT_TRUE(exists("p1.png.checkpoint"));
  EXPECT_FALSE(exists("p1.png"));
  const Outcome rest = run("scene.lua -q --progress json --resume " + options);
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_TRUE(same_file(folder_ / "p1.png", folder_ / "whole.png"));
  EXPECT_FALSE(exists("p1.png.checkpoint"));
}

TEST_F(Resumed, ATimeLimitCountsBothRunsAndMayChange) {
  write("scene.lua", slow_scene());
  EXPECT_EQ(interrupt("--max-error 0.0001 --time-limit 30 --size 300x200").exit_code, 130);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome o = run("scene.lua --resume --max-error 0.0001 --time-limit 1.5 --size 300x200");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
  EXPECT_NE(o.err.find("out of time"), std::string::npos) << o.err;
}

TEST_F(Resumed, ASecondSignalEndsAtOnceWithoutHalfFiles) {
  Running program(folder_, "scene.lua --samples 20000000");
  std::this_thread::sleep_for(500ms);
  // Right after the first, which ends the rendering soon; of another kind, as two of one may be one.
  program.signal(SIGINT);
  program.signal(SIGTERM);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome o = program.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
  EXPECT_EQ(o.exit_code, 130);
  EXPECT_NE(o.err.find("interrupted at once"), std::string::npos) << o.err;
  EXPECT_FALSE(left_a_file());
}

TEST_F(Resumed, AScriptIsInterrupted) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "ThreadSanitizer delays the signals that end a script";
#endif
  const char* scripts[] = {
      "while true do end",
      "while true do pcall(function() while true do end end) end",
      "coroutine.wrap(function() while true do end end)()",
      "local s = ('a'):rep(1e5) s:find('.-.-b')",
  };
  for (const char* options : {"", "--trust"}) {
    for (const char* script : scripts) {
      write("scene.lua", script);
      Running program(folder_, std::string("scene.lua ") + options);
      std::this_thread::sleep_for(300ms);
      program.signal(SIGTERM);
      const auto begin = std::chrono::steady_clock::now();
      const Outcome o = program.wait();
      EXPECT_LT(std::chrono::steady_clock::now() - begin, 3s) << script;
      EXPECT_EQ(o.exit_code, 130) << script << o.err;
      EXPECT_NE(o.err.find("interrupted"), std::string::npos) << script << o.err;
      EXPECT_FALSE(left_a_file()) << script;
    }
  }
}

TEST_F(Resumed, ACaughtInterruptionIsStillOne) {
  write("scene.lua", "for i = 1, 3 do pcall(function()\n" + slow_scene() + "end) end\n");
  EXPECT_EQ(interrupt("--samples 400").exit_code, 130);
}

TEST_F(Resumed, ASignalThatIsIgnoredStaysIgnored) {
  Running program(folder_, "scene.lua --samples 100 --progress plain",
                  [] { ::signal(SIGHUP, SIG_IGN); });
  EXPECT_TRUE(program.says("p1.png: "));
  program.signal(SIGHUP);
  EXPECT_EQ(program.wait().exit_code, 0);
}

}  // namespace
}  // namespace rt::test
