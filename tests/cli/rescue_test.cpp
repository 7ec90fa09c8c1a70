// Nothing lost: disks that are full, folders that vanish or may not be written to, kills.
#include <sys/mount.h>

#include "running.h"

namespace rt::test {
namespace {

using namespace std::chrono_literals;

/// A file system of a few kilobytes, for as long as this lives.
class SmallDisk {
 public:
  explicit SmallDisk(const std::filesystem::path& folder) : folder_(folder) {
    std::filesystem::create_directory(folder);
    mounted_ = ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) {
      ::umount2(folder_.c_str(), MNT_DETACH);
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool mounted() const { return mounted_; }
  void fill() const { std::ofstream(folder_ / "filler") << std::string(100'000, 'x'); }
  bool make_read_only() const {
    return ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }

 private:
  std::filesystem::path folder_;
  bool mounted_ = false;
};

class Rescued : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("scene.lua", sphere_script());
    ASSERT_EQ(run("scene.lua -q -o whole.png " + std::string(options)).exit_code, 0);
  }

  /// The only file in the folder whose name contains "rescued", with that ending.
  std::filesystem::path rescued(const std::string& ending) const {
    std::filesystem::path found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string name = entry.path().filename();
      if (name.find(".rescued-") != name.npos && name.ends_with(ending)) {
        EXPECT_TRUE(found.empty()) << "two: " << found << " and " << name;
        found = entry.path();
      }
    }
    return found;
  }

  bool left_a_temporary(const std::filesystem::path& folder) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".tmp") {
        return true;
      }
    }
    return false;
  }

  /// Runs with the picture in `disk`; `spoil` is done while it is being rendered.
  void expect_rescue(const std::function<void()>& spoil, const std::string& reason) {
    Running program(folder_, "scene.lua --progress plain -o disk/ball.png " + std::string(options));
    ASSERT_TRUE(program.says("ball.png: "));
    spoil();
    const Outcome o = program.wait();
    EXPECT_EQ(o.exit_code, 3) << o.err;
    EXPECT_NE(o.err.find("cannot write disk/ball.png: " + reason), std::string::npos) << o.err;
    const std::filesystem::path there = rescued(".png");
    ASSERT_FALSE(there.empty()) << o.err;
    EXPECT_NE(o.err.find("The picture is in " + there.string()), std::string::npos) << o.err;
    EXPECT_TRUE(same_file(there, folder_ / "whole.png"));
    EXPECT_FALSE(left_a_temporary(folder_));
  }

  static constexpr const char* options = "--size 200x150 --samples 120";
};

TEST_F(Rescued, AFullDisk) {
  const SmallDisk disk(folder_ / "disk");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no permission to mount";
  }
  expect_rescue([&] { disk.fill(); }, "No space left on device");
  EXPECT_FALSE(left_a_temporary(folder_ / "disk"));
}

TEST_F(Rescued, ADiskThatBecomesReadOnly) {
  const SmallDisk disk(folder_ / "disk");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no permission to mount";
  }
  expect_rescue([&] { ASSERT_TRUE(disk.make_read_only()); }, "Read-only file system");
}

TEST_F(Rescued, AFolderThatVanishes) {
  std::filesystem::create_directory(folder_ / "disk");
  expect_rescue([&] { std::filesystem::rename(folder_ / "disk", folder_ / "gone"); },
                "No such file or directory");
}

TEST_F(Rescued, AScriptThatCatchesTheErrorDoesNotHideIt) {
  write("scene.lua", "pcall(function()\n" + sphere_script() + "\nend)\n");
  std::filesystem::create_directory(folder_ / "disk");
  Running program(folder_, "scene.lua --progress plain -o disk/ball.png " + std::string(options));
  ASSERT_TRUE(program.says("ball.png: "));
  std::filesystem::rename(folder_ / "disk", folder_ / "gone");
  const Outcome o = program.wait();
  EXPECT_EQ(o.exit_code, 3) << o.err;
  EXPECT_NE(o.err.find("The picture is in " + rescued(".png").string()), std::string::npos)
      << o.err;
}

TEST_F(Rescued, AReadOnlyFolderIsRefusedBeforeTheRendering) {
  const SmallDisk disk(folder_ / "disk");
  if (!disk.mounted() || !disk.make_read_only()) {
    GTEST_SKIP() << "no permission to mount";
  }
  const auto begin = std::chrono::steady_clock::now();
  const Outcome o = run("scene.lua -q -o disk/ball.png --size 2000x2000 --samples 100000");
  EXPECT_EQ(o.exit_code, 3) << o.err;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

TEST_F(Rescued, AnInterruptedRunOnAFullDiskGoesOnFromElsewhere) {
  const SmallDisk disk(folder_ / "disk");
  if (!disk.mounted()) {
    GTEST_SKIP() << "no permission to mount";
  }
  Running program(folder_, "scene.lua --progress plain -o disk/ball.png " + std::string(options));
  ASSERT_TRUE(program.says("ball.png: "));
  disk.fill();
  program.signal(SIGINT);
  const Outcome o = program.wait();
  EXPECT_EQ(o.exit_code, 130) << o.err;
  const std::filesystem::path kept = rescued(".checkpoint");
  ASSERT_FALSE(kept.empty()) << o.err;
  EXPECT_FALSE(rescued(".png").empty()) << o.err;
  EXPECT_NE(o.err.find("--resume --checkpoint-file " + kept.string()), std::string::npos) << o.err;
  std::filesystem::remove(folder_ / "disk/filler");
  const Outcome rest = run("scene.lua -q -o disk/ball.png " + std::string(options) +
                           " --resume --checkpoint-file " + kept.string());
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_TRUE(same_file(folder_ / "disk/ball.png", folder_ / "whole.png"));
  EXPECT_FALSE(std::filesystem::exists(kept));
}

TEST_F(Rescued, WhereNothingCanBeWrittenTheMessageSaysSo) {
  Running program(folder_, "scene.lua -q " + std::string(options), [] { limit_file_size(200); });
  const Outcome o = program.wait();
  EXPECT_EQ(o.exit_code, 3) << "not killed by SIGXFSZ";
  EXPECT_FALSE(exists("ball.png"));
  EXPECT_FALSE(left_a_temporary(folder_));
}

TEST_F(Rescued, ACheckpointThatCannotBeWrittenStopsNothing) {
  Running program(folder_, "scene.lua -q --checkpoint 0.05 " + std::string(options),
                  [] { limit_file_size(100'000); });  // the picture is smaller, its state larger
  const Outcome o = program.wait();
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(same_file(folder_ / "ball.png", folder_ / "whole.png"));
  const std::size_t first = o.err.find("warning: cannot write ball.png.checkpoint: File too large");
  EXPECT_NE(first, std::string::npos) << o.err;
  EXPECT_EQ(o.err.find("warning: ", first + 1), std::string::npos) << "once: " << o.err;
}

TEST_F(Rescued, AClosedOrFullStandardErrorCostsNoPicture) {
  const std::string words = std::string("scene.lua --progress json ") + options;
  Running closed(folder_, words, [] {
    int ends[2];
    if (::pipe(ends) == 0) {
      ::close(ends[0]);
      dup2(ends[1], STDERR_FILENO);
    }
  });
  EXPECT_EQ(closed.wait().exit_code, 0) << "not killed by SIGPIPE";
  EXPECT_TRUE(same_file(folder_ / "ball.png", folder_ / "whole.png"));
  std::filesystem::remove(folder_ / "ball.png");
  Running full(folder_, words, [] {
    const int device = ::open("/dev/full", O_WRONLY);
    dup2(device, STDERR_FILENO);
  });
  EXPECT_EQ(full.wait().exit_code, 0);
  EXPECT_TRUE(same_file(folder_ / "ball.png", folder_ / "whole.png"));
}

TEST_F(Rescued, AKillAtAnyMomentLeavesWholeFiles) {
  write("ball.png", "the old one");
  const std::string whole = contents(folder_ / "whole.png");
  bool finished = false;
  for (int i = 0; i < 60 && !finished; ++i) {
    Running program(folder_, std::string("scene.lua -q --checkpoint 0.01 --resume ") + options);
    std::this_thread::sleep_for(20ms + 15ms * i);
    program.signal(SIGKILL);
    const Outcome o = program.wait();
    ASSERT_TRUE(o.exit_code == 128 + SIGKILL || o.exit_code == 0)
        << o.err;  // never a bad checkpoint
    const std::string now = contents(folder_ / "ball.png");
    ASSERT_TRUE(now == "the old one" || now == whole) << "killed after " << 20 + 15 * i << " ms";
    finished = o.exit_code == 0;
  }
  EXPECT_EQ(run(std::string("scene.lua -q --resume ") + options).exit_code, 0);
  EXPECT_TRUE(same_file(folder_ / "ball.png", folder_ / "whole.png"));
  // What was left lying about is known by its name; a later run removes what is old.
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == ".tmp") {
      EXPECT_TRUE(entry.path().filename().string().starts_with(".raytracer-")) << entry.path();
      std::filesystem::last_write_time(entry.path(),
                                       std::filesystem::file_time_type::clock::now() - 1h);
    }
  }
  EXPECT_EQ(run("scene.lua -q --samples 1").exit_code, 0);
  EXPECT_FALSE(left_a_temporary(folder_));
}

}  // namespace
}  // namespace rt::test
