#pragma once
/// Runs the program as a user would: in a folder of its own, from a shell.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace rt::test {

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// As one value, so that a failing test does not print pictures.
inline bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  const std::string bytes = contents(a);
  return !bytes.empty() && bytes == contents(b);
}

/// A test in an empty temporary folder.
class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override {
    char pattern[] = "/tmp/raytracer-test-XXXXXX";
    folder_ = mkdtemp(pattern);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// `arguments` are a shell's words; the program's own name comes before them.
  Outcome run(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd " + folder_.string() + " && " + before + " " RT_PROGRAM " " +
                                arguments + " >stdout.txt 2>stderr.txt </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            contents(folder_ / "stdout.txt"), contents(folder_ / "stderr.txt")};
  }

  Outcome run_script(const std::string& script, const std::string& options = "") const {
    write("scene.lua", script);
    return run("scene.lua " + options);
  }

  /// Whether the folder holds anything but the scene and what run() writes: a picture, half a file.
  bool left_a_file() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string name = entry.path().filename();
      if (name != "scene.lua" && name != "stdout.txt" && name != "stderr.txt") {
        return true;
      }
    }
    return false;
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  std::filesystem::path folder_;
};

/// A scene of one sphere. `before` and `after` are put around its gr.render.
inline std::string sphere_script(const std::string& before = "", const std::string& after = "") {
  return "local ball = gr.sphere('ball')\n"
         "ball:set_material(gr.material({0.8, 0.2, 0.2}, {0.5, 0.5, 0.5}, 30))\n" +
         before +
         "\ngr.render(ball, 'ball.png', 24, 16, {0, 0, 5}, {0, 0, -1}, {0, 1, 0}, 40,\n"
         "  {0.2, 0.2, 0.2}, {gr.light({3, 4, 5}, {1, 1, 1}, {1, 0, 0})})\n" +
         after;
}

}  // namespace rt::test
