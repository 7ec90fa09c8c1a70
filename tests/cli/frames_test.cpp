// Animations: one run of the script for each frame.
#include "program.h"
#include "running.h"

namespace rt::test {
namespace {

using Animation = ProgramTest;

/// The ball stands where the frame says.
std::string moving_script() { return sphere_script("ball:translate(0.2 * (frame or 0), 0, 0)"); }

TEST_F(Animation, EachFrameIsARunOfItsOwnWithItsNumber) {
  const Outcome o = run_script(moving_script(), "--frames 0..2 --samples 1");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  for (const char* name : {"ball_0000.png", "ball_0001.png", "ball_0002.png"}) {
    EXPECT_TRUE(exists(name)) << name;
  }
  EXPECT_FALSE(exists("ball.png"));
  EXPECT_FALSE(same_file(folder_ / "ball_0000.png", folder_ / "ball_0001.png"));
  EXPECT_FALSE(same_file(folder_ / "ball_0001.png", folder_ / "ball_0002.png"));
}

TEST_F(Animation, OneFrameIsTheSameAsAmongOthers) {
  ASSERT_EQ(run_script(moving_script(), "--frames 1..3").exit_code, 0);
  std::filesystem::rename(folder_ / "ball_0002.png", folder_ / "then.png");
  ASSERT_EQ(run("scene.lua --frame 2").exit_code, 0);
  EXPECT_TRUE(same_file(folder_ / "ball_0002.png", folder_ / "then.png"));
}

TEST_F(Animation, WithoutTheOptionThereIsNoFrame) {
  const Outcome o = run_script(sphere_script("assert(frame == nil)"));
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(exists("ball.png"));
}

TEST_F(Animation, FrameIsAnIntegerAndGlobalsDoNotLast) {
  const Outcome o = run_script(
      sphere_script("assert(math.type(frame) == 'integer' and last == nil) last = frame"),
      "--frames 8..9 --samples 1");
  EXPECT_EQ(o.exit_code, 0) << o.err;
}

TEST_F(Animation, ANameThatHoldsTheNumberIsKept) {
  std::string script = moving_script();
  script.replace(script.find("'ball.png'"), 10, "'ball' .. frame .. '.png'");
  ASSERT_EQ(run_script(script, "--frames 9..10 --samples 1").exit_code, 0);
  EXPECT_TRUE(exists("ball9.png"));
  EXPECT_TRUE(exists("ball10.png"));
  // A number that is another's is part of the name.
  ASSERT_EQ(run("scene.lua --frame 3 --samples 1 -o take2.png").exit_code, 0);
  EXPECT_TRUE(exists("take2_0003.png"));
}

TEST_F(Animation, OutputNamesAreNumberedAndFoldersFilled) {
  const std::string twice = moving_script() + "gr.render{scene = ball, file = 'more.png',\n" +
                            "  size = {8, 8}, camera = {eye = {0, 0, 5}, look_at = {0, 0, 0}}}\n";
  ASSERT_EQ(run_script(twice, "--frames 1..2 --samples 1 -o out.png").exit_code, 0);
  for (const char* name : {"out_0001.png", "out_0001.2.png", "out_0002.png", "out_0002.2.png"}) {
    EXPECT_TRUE(exists(name)) << name;
  }
  std::filesystem::create_directory(folder_ / "film");
  ASSERT_EQ(run("scene.lua --frames 1..2 --samples 1 -o film").exit_code, 0);
  for (const char* name : {"film/ball_0001.png", "film/more_0002.png"}) {
    EXPECT_TRUE(exists(name)) << name;
  }
}

TEST_F(Animation, WrongFramesExitWithTwo) {
  write("scene.lua", moving_script());
  const struct {
    const char* arguments;
    const char* says;
  } cases[] = {
      {"--frames 3..1", "such as 1..48"},        {"--frames 5", "such as 1..48"},
      {"--frames 1..", "such as 1..48"},         {"--frames=-1..4", "such as 1..48"},
      {"--frames 1..1000000", "999999"},         {"--frames 1..2..3", "such as 1..48"},
      {"--frame 1..2", "did you mean --frames"}, {"--frame 1.5", "whole number"},
      {"--frame 1 --frames 1..2", "--frame"},
  };
  for (const auto& c : cases) {
    const Outcome o = run(std::string("scene.lua ") + c.arguments);
    EXPECT_EQ(o.exit_code, 2) << c.arguments;
    EXPECT_NE(o.err.find(c.says), std::string::npos) << c.arguments << "\n" << o.err;
  }
  EXPECT_FALSE(left_a_file());
}

TEST_F(Animation, AnErrorInALaterFrameKeepsTheEarlierOnes) {
  const Outcome o = run_script(sphere_script("if frame == 3 then error('third') end"),
                               "--frames 1..4 --samples 1");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_NE(o.err.find("third"), std::string::npos) << o.err;
  EXPECT_TRUE(exists("ball_0002.png"));
  EXPECT_FALSE(exists("ball_0003.png"));
}

TEST_F(Animation, AnInterruptedFilmGoesOnWhereItStopped) {
  write("scene.lua", moving_script());
  ASSERT_EQ(run("scene.lua --frames 1..3 -s 150x100 --samples 300 -o whole.png").exit_code, 0);
  Running film(folder_, "scene.lua --frames 1..3 -s 150x100 --samples 300 -o film.png");
  ASSERT_TRUE(film.says("film_0002.png"));
  film.signal(SIGINT);
  ASSERT_EQ(film.wait().exit_code, 130) << "it had come to its end before it was interrupted";
  const Outcome other =
      run("scene.lua --frames 2..3 -s 150x100 --samples 300 -o film.png --resume "
          "--checkpoint-file film_0001.png.checkpoint");
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_NE(other.err.find("--frames is 2..3, and was 1..3"), std::string::npos) << other.err;
  const Outcome o = run("scene.lua --frames 1..3 -s 150x100 --samples 300 -o film.png --resume");
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.err.find("film_0001.png: was finished before"), std::string::npos) << o.err;
  for (const char* frame : {"_0001.png", "_0002.png", "_0003.png"}) {
    EXPECT_TRUE(same_file(folder_ / ("whole" + std::string(frame)),
                          folder_ / ("film" + std::string(frame))))
        << frame;
  }
}

}  // namespace
}  // namespace rt::test
