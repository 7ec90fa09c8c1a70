// The command line: options, outputs, exit codes.
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace rt::test {
namespace {

using Command = ProgramTest;

TEST_F(Command, RendersAPictureAndSaysSo) {
  const Outcome o = run_script(sphere_script());
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(exists("ball.png"));
  EXPECT_NE(o.err.find("ball.png: 24x16"), std::string::npos) << o.err;
  EXPECT_EQ(o.err.find('\r'), std::string::npos) << "no progress bar where nobody watches";
  EXPECT_EQ(o.err.find('\033'), std::string::npos);
  EXPECT_EQ(o.out, "");
}

TEST_F(Command, QuietSaysNothing) {
  const Outcome o = run_script(sphere_script(), "-q");
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_EQ(o.err, "");
}

TEST_F(Command, HelpAndVersionNeedNoScene) {
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* flag :
       {"--output", "--size", "--crop", "--threads", "--samples", "--seed", "--max-depth",
        "--encoding", "--accel", "--disable", "--stats", "--progress", "--quiet", "--version"}) {
    EXPECT_NE(help.out.find(flag), std::string::npos) << flag;
  }
  EXPECT_EQ(run("--version").exit_code, 0);
}

TEST_F(Command, WrongCommandLinesExitWithTwo) {
  write("scene.lua", sphere_script());
  const struct {
    const char* arguments;
    const char* says;
  } cases[] = {
      {"", "no scene given"},
      {"scene.lua --sampels 4", "did you mean --samples"},
      {"scene.lua other.lua", "one file too many"},
      {"scene.lua -", "'-' is one file too many"},
      {"scene.lua ---", "'---' is one file too many"},
      {"scene.lua --samples many", "expected a whole number"},
      {"scene.lua --samples 0", "expected a whole number"},
      {"scene.lua --samples", "--samples"},
      {"scene.lua --size 40", "WIDTHxHEIGHT"},
      {"scene.lua --size=-4x4", "WIDTHxHEIGHT"},
      {"scene.lua --crop 1,2,3", "X,Y,WIDTH,HEIGHT"},
      {"scene.lua --crop 0,0,25,16", "reaches beyond"},
      {"scene.lua --crop 2147483647,0,2147483647,1", "reaches beyond"},
      {"scene.lua --threads 0", "--threads"},
      {"scene.lua --encoding gamma", "'srgb'"},
      {"scene.lua --accel grit", "'bvh'"},
      {"scene.lua --disable reflexion", "did you mean reflection"},
      {"scene.lua --disable samples", "not a feature"},
      {"scene.lua --progress loud", "--progress"},
  };
  for (const auto& c : cases) {
    const Outcome o = run(c.arguments);
    EXPECT_EQ(o.exit_code, 2) << c.arguments << ": " << o.err;
    EXPECT_NE(o.err.find(c.says), std::string::npos) << c.arguments << ": " << o.err;
    EXPECT_FALSE(left_a_file()) << c.arguments;
  }
}

TEST_F(Command, EmptyValuesAreRefused) {
  write("scene.lua", sphere_script());
  for (const std::string option :
       {"--samples", "--max-error", "--encoding", "--size", "--crop", "--frame", "--frames",
        "--output", "--stats", "--report", "--checkpoint-file", "--new", "--disable"}) {
    const Outcome o = run("scene.lua " + option + " ''");
    EXPECT_EQ(o.exit_code, 2) << option << o.err;
    EXPECT_NE(o.err.find(option + ": its value is empty"), std::string::npos) << o.err;
    EXPECT_FALSE(left_a_file()) << option;
  }
}

TEST_F(Command, TheSceneMayFollowOptionsThatMayBeRepeated) {
  for (const std::string name : {"one", "two"}) {
    std::filesystem::create_directories(folder_ / name);
    write(name + "/part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }
  std::filesystem::create_directory(folder_ / "scenes");
  write("scenes/scene.lua",
        sphere_script("gr.mesh('a', '../one/part.obj')\ngr.mesh('b', '../two/part.obj')"));
  for (const char* arguments :
       {"-q --allow-path one --allow-path two scenes/scene.lua",
        "-q --allow-path one --disable reflection --allow-path two scenes/scene.lua",
        "-q --allow-path one --allow-path two --disable reflection,refraction scenes/scene.lua "
        "--disable acceleration"}) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.exit_code, 0) << arguments << o.err;
  }
}

TEST_F(Command, OutputNamesAFileOrAFolder) {
  write("scene.lua", sphere_script("",
                                   "gr.render(ball, 'second.png', 8, 8, {0, 0, 5}, {0, 0, -1}, "
                                   "{0, 1, 0}, 40, {0.2, 0.2, 0.2}, {})"));
  std::filesystem::create_directory(folder_ / "pictures");
  EXPECT_EQ(run("scene.lua -q -o pictures").exit_code, 0);
  EXPECT_TRUE(exists("pictures/ball.png") && exists("pictures/second.png"));
  EXPECT_EQ(run("scene.lua -q -o mine.exr").exit_code, 0);
  EXPECT_TRUE(exists("mine.exr") && exists("mine.2.exr"));
  EXPECT_FALSE(exists("ball.png"));
}

TEST_F(Command, SettingsOnTheCommandLineOverrideTheScript) {
  EXPECT_EQ(run_script(sphere_script(),
                       "-q --stats s.json --size 10x6 --samples 9 --threads 1 "
                       "--disable reflection,acceleration --max-depth 2")
                .exit_code,
            0);
  const auto stats = nlohmann::json::parse(contents(folder_ / "s.json"));
  const auto& picture = stats.at("pictures").at(0);
  EXPECT_EQ(picture.at("size"), nlohmann::json({10, 6}));
  EXPECT_EQ(picture.at("samples"), 10 * 6 * 9);
  EXPECT_EQ(picture.at("rays").at("camera"), 10 * 6 * 9);
  EXPECT_GT(picture.at("rays").at("shadow"), 0);
  EXPECT_EQ(picture.at("rays").at("reflection"), 0);
  EXPECT_EQ(picture.at("options").at("reflection"), false);
  EXPECT_EQ(picture.at("options").at("max_depth"), 2);
  EXPECT_EQ(stats.at("threads"), 1);
  EXPECT_GT(stats.at("peak_memory_bytes"), 1'000'000);
  for (const char* phase : {"script", "plan", "trace", "write"}) {
    EXPECT_GE(picture.at("seconds").at(phase), 0.0) << phase;
  }
}

TEST_F(Command, StatsTakeAnyName) {
  const Outcome o = run_script(sphere_script(), "-q --stats s.json -o 'b\xe4ll.png'");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  const auto stats = nlohmann::json::parse(contents(folder_ / "s.json"));
  EXPECT_EQ(stats.at("pictures").at(0).at("picture"), "b\xef\xbf\xbdll.png");
}

TEST_F(Command, SizesThatAFormatCannotHoldAreRefusedBeforeTheRendering) {
  for (const char* options : {"-o a.jpg --size 65501x1", "-o a.tga --size 1x65536"}) {
    const Outcome o = run_script(sphere_script(), std::string(options) + " --stats s.json");
    EXPECT_EQ(o.exit_code, 3) << options << o.err;
    EXPECT_NE(o.err.find("holds at most"), std::string::npos) << o.err;
    EXPECT_EQ(o.err.find("samples a pixel"), std::string::npos) << o.err;
    EXPECT_FALSE(left_a_file()) << options;
  }
  const Outcome o = run_script(sphere_script(), "-q -o a.jpg --size 65501x1 --crop 65490,0,11,1");
  EXPECT_EQ(o.exit_code, 0) << "a crop is as large as itself: " << o.err;
}

TEST_F(Command, ThreadsAreThoseOfTheProcessorsItMayUse) {
  write("scene.lua", sphere_script());
  const std::string one = "taskset -c \"$(taskset -cp $$ | sed 's/.*[ :]//; s/[-,].*//')\"";
  ASSERT_EQ(run("--version", one).exit_code, 0) << "taskset (util-linux) is needed";
  EXPECT_EQ(run("scene.lua -q --stats s.json", one).exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(folder_ / "s.json")).at("threads"), 1);
}

TEST_F(Command, EqualInputsGiveEqualFiles) {
  for (const char* name : {"a.png", "a.exr", "a.bmp", "a.tga", "a.jpg"}) {
    std::string other = name;
    other.front() = 'b';
    ASSERT_EQ(run_script(sphere_script(), "-q -t 1 -o " + std::string(name)).exit_code, 0);
    ASSERT_EQ(run_script(sphere_script(), "-q -t 2 -o " + other).exit_code, 0);
    EXPECT_GT(contents(folder_ / name).size(), 100u);
    EXPECT_EQ(contents(folder_ / name), contents(folder_ / other)) << name;
  }
}

TEST_F(Command, PlacesThatCannotBeWrittenExitWithThree) {
  std::filesystem::create_directory(folder_ / "folder");
  ASSERT_EQ(::mkfifo((folder_ / "folder/pipe.png").c_str(), 0600), 0);
  for (const std::string where :
       {"-o missing/ball.png", "-o ball.gif", "-o ball", "-o folder/pipe.png",
        "--stats missing/s.json", "--stats folder", "--stats folder/pipe.png",
        "--report missing/r.html", "--report folder", "--report folder/pipe.png"}) {
    const Outcome o = run_script(sphere_script(), where);
    EXPECT_EQ(o.exit_code, 3) << where << o.err;
    EXPECT_NE(o.err.find("cannot write"), std::string::npos) << o.err;
    EXPECT_FALSE(exists("ball.png")) << where;
  }
  EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "folder/pipe.png"));
  // Whoever may write to any folder learns only in the end that this takes no files: the picture is
  // then kept elsewhere.
  EXPECT_EQ(run_script(sphere_script(), "-o /proc/ball.png").exit_code, 3);
  EXPECT_EQ(run("nowhere.lua").exit_code, 3);
}

TEST_F(Command, NamesThatAreTooLongAreRefusedBeforeTheRendering) {
  const std::string name = std::string(300, 'n') + ".png";
  std::string named = sphere_script();
  named.replace(named.find("ball.png"), 8, name);
  const struct {
    std::string script, options;
  } cases[] = {{sphere_script(), "-o " + name},
               {sphere_script(), "--frame 1 -o " + name},
               {sphere_script(), "--stats " + name},
               {named, ""},
               {named, "--trust"}};
  for (const auto& c : cases) {
    const Outcome o = run_script(c.script, c.options);
    EXPECT_EQ(o.exit_code, 3) << c.options << o.err;
    EXPECT_NE(o.err.find("File name too long"), std::string::npos) << o.err;
    EXPECT_EQ(o.err.find("internal error"), std::string::npos) << o.err;
    EXPECT_FALSE(left_a_file()) << c.options;
  }
}

TEST_F(Command, ScriptsMayNotWriteOutsideTheWorkingFolder) {
  for (const char* name : {"../escape.png", "/tmp/escape.png", "a/../../escape.png"}) {
    std::string script = sphere_script();
    script.replace(script.find("ball.png"), 8, name);
    const Outcome o = run_script(script);
    EXPECT_EQ(o.exit_code, 1) << name << o.err;
    EXPECT_NE(o.err.find("scene.lua:4"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("outside the working folder"), std::string::npos) << o.err;
  }
}

TEST_F(Command, ArgumentsAfterTheDashesReachTheScript) {
  const Outcome o =
      run_script("print(arg[0], arg[1], arg[2])\n" + sphere_script(), "-q -- --one two");
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(o.out, "scene.lua\t--one\ttwo\n");
}

TEST_F(Command, ProgressStyles) {
  EXPECT_EQ(run_script(sphere_script(), "--progress none").err.find('%'), std::string::npos);
  const Outcome json =
      run_script(sphere_script(), "--progress json --size 300x300 --samples 64 -t 1");
  EXPECT_NE(json.err.find("{\"fraction\""), std::string::npos) << json.err;
}

}  // namespace
}  // namespace rt::test
