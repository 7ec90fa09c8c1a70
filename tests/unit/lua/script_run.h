#pragma once
/// Runs scripts from strings with a host that keeps what it is given.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rt/lua/script.h"
#include "rt/scene/error.h"

namespace rt::lua {

class ScriptTest : public testing::Test {
 protected:
  ScriptTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "rt_lua_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    host_.render = [this](RenderJob job) { jobs_.push_back(std::move(job)); };
    host_.warn = [this](const std::string& text) { warnings_.push_back(text); };
    host_.load_mesh = [this](const std::filesystem::path& path) {
      loaded_.push_back(path);
      real_.push_back(std::filesystem::canonical(path));
      return std::make_shared<const MeshData>();
    };
  }
  ~ScriptTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path script() const { return folder_ / "scene.lua"; }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  void run(const std::string& text, const std::vector<std::string>& args = {}) {
    write("scene.lua", text);
    run_script(script(), args, host_, settings_);
  }

  struct Failure {
    ExitCode code = ExitCode::done;
    std::string text;  ///< with the script's folder taken out: "scene.lua:1: ..."
  };

  Failure failure(const std::string& text) {
    try {
      run(text);
    } catch (const UserError& error) {
      return {error.code(), without_folder(error.what())};
    }
    return {};
  }

  std::string without_folder(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  /// The script fails with exit code 1 and a message that begins with `start` and holds `words`.
  void expect_error(const std::string& text, const std::string& start,
                    const std::vector<std::string>& words = {}, ExitCode code = ExitCode::scene) {
    const Failure got = failure(text);
    EXPECT_EQ(got.code, code) << text << "\n" << got.text;
    EXPECT_TRUE(got.text.starts_with(start)) << text << "\n" << got.text;
    for (const std::string& word : words) {
      EXPECT_NE(got.text.find(word), std::string::npos) << word << "\n" << text << "\n" << got.text;
    }
  }

  /// Renders the node that the script calls `root`.
  const RenderJob& job_of_root(const std::string& text) {
    run(text + "\ngr.render(root, 'a.png', 4, 3, {0,0,9}, {0,0,-1}, {0,1,0}, 50, {0,0,0}, {})");
    return jobs_.back();
  }

  Instance instance_of_root(const std::string& text) { return job_of_root(text).instances.at(0); }

  template <class S>
  S shape_of(const std::string& expression) {
    return std::get<S>(*instance_of_root("root = " + expression).shape);
  }

  std::filesystem::path folder_;
  Host host_;
  Settings settings_;
  std::vector<RenderJob> jobs_;
  std::vector<std::string> warnings_;
  std::vector<std::filesystem::path> loaded_;  ///< meshes, as the host was asked for them
  std::vector<std::filesystem::path> real_;    ///< the same, canonical
};

}  // namespace rt::lua
