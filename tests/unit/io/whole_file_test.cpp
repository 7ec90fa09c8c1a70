// Files that appear whole or not at all, whenever the process that writes them is killed.
#include "rt/io/whole_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "rt/scene/error.h"
#include "temp_folder.h"

namespace rt::io {
namespace {

using namespace std::chrono_literals;

void write(const std::filesystem::path& file, const std::string& text) {
  write_whole_file(file, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

std::size_t temporaries(const std::filesystem::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    count += name.starts_with(".raytracer-") && name.ends_with(".tmp") ? 1 : 0;
  }
  return count;
}

TEST(WholeFile, AKillLeavesTheOldOrTheNew) {
  const TempFolder folder;
  const auto file = folder / "file";
  const std::string old_text(3'000'000, 'o');
  const std::string new_text(2'000'000, 'n');
  for (int i = 0; i < 100; ++i) {
    write(file, old_text);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (;;) {
        write(file, new_text);
        write(file, old_text);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(50 * i));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string now = bytes_of(file);
    ASSERT_TRUE(now == old_text || now == new_text) << i << ": " << now.size();
  }
  EXPECT_GT(temporaries(folder.path()), 0u) << "none of the kills came while a file was written";
}

TEST(WholeFile, OldTemporariesThatNobodyHoldsAreRemoved) {
  const TempFolder folder;
  const auto make = [&](const char* name, bool old) {
    std::ofstream(folder / name) << "half";
    if (old) {
      std::filesystem::last_write_time(folder / name,
                                       std::filesystem::file_time_type::clock::now() - 1h);
    }
  };
  make(".raytracer-1-0.tmp", true);
  make(".raytracer-1-1.tmp", false);
  make(".raytracer-1-2.tmp", true);
  make("other.tmp", true);
  const int held = ::open((folder / ".raytracer-1-2.tmp").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  write(folder / "file", "text");
  ::close(held);
  EXPECT_FALSE(std::filesystem::exists(folder / ".raytracer-1-0.tmp"));
  EXPECT_TRUE(std::filesystem::exists(folder / ".raytracer-1-1.tmp")) << "may be at work";
  EXPECT_TRUE(std::filesystem::exists(folder / ".raytracer-1-2.tmp")) << "is at work";
  EXPECT_TRUE(std::filesystem::exists(folder / "other.tmp")) << "is somebody else's";
  EXPECT_EQ(bytes_of(folder / "file"), "text");
}

TEST(WholeFile, ReplacesNeitherFoldersNorPipesNorDevices) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "folder");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/null", folder / "link");
  for (const char* name : {"folder", "pipe", "link"}) {
    EXPECT_THROW(check_place(folder / name), FileError) << name;
    EXPECT_THROW(write(folder / name, "text"), FileError) << name;
  }
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
  EXPECT_EQ(temporaries(folder.path()), 0u);
  EXPECT_THROW(check_place(folder / std::string(300, 'n')), FileError);
  EXPECT_THROW(check_place(folder / "missing" / "file"), FileError);
  write(folder / "file", "text");
  EXPECT_NO_THROW(check_place(folder / "file"));
  EXPECT_NO_THROW(check_place(folder / "new"));
}

TEST(WholeFile, NothingIsAbandonedWhenNothingIsWritten) {
  const TempFolder folder;
  write(folder / "file", "text");
  abandon_temporary();
  EXPECT_EQ(bytes_of(folder / "file"), "text");
}

}  // namespace
}  // namespace rt::io
