#include "rt/io/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "rt/scene/error.h"

namespace rt::io {
namespace {

const char* what_to_try(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space, or write elsewhere";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f)";
    case ENOENT:
    case ENOTDIR:
      return "create the folder first, or write elsewhere";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder that you may write to";
    case ENAMETOOLONG:
      return "choose a shorter name";
    default:
      return "choose another file";
  }
}

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw FileError(fmt::format("cannot write {}: {}; {}", path.string(),
                              std::generic_category().message(error), what_to_try(error)));
}

/// Folders, devices and pipes cannot or must not be replaced by a file.
void refuse_what_is_no_file(const std::filesystem::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) {
    if (errno == ENAMETOOLONG) {
      fail(path, errno);
    }
    return;  // nothing there, or the folder is wrong
  }
  if (!S_ISREG(found.st_mode)) {
    throw FileError(fmt::format("cannot write {}: it is a {}; name a file", path.string(),
                                S_ISDIR(found.st_mode) ? "folder" : "device or a pipe"));
  }
}

/// The name of the temporary, for abandon_temporary(): set before the file is made, cleared once it
/// is gone. Names are not used twice, so to remove one that is gone does no harm.
std::array<char, PATH_MAX> name_at_work{};
std::atomic<bool> at_work{false};

void announce(const std::filesystem::path& name) {
  at_work = false;
  if (name.native().size() < name_at_work.size()) {
    std::copy_n(name.c_str(), name.native().size() + 1, name_at_work.begin());
    at_work = true;
  }
}

bool is_temporary(const std::filesystem::path& file) {
  const std::string name = file.filename();
  return name.starts_with(".raytracer-") && name.ends_with(".tmp");
}

/// Removes what killed processes have left in the folder.
void clean(const std::filesystem::path& folder) {
  // A file is locked just after it is made: a minute is ample.
  const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::minutes(1);
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  for (; !error && entries != std::filesystem::end(entries); entries.increment(error)) {
    const std::filesystem::directory_entry& entry = *entries;
    std::error_code unread;
    if (!is_temporary(entry.path()) || !entry.is_regular_file(unread) ||
        !(entry.last_write_time(unread) < old)) {
      continue;
    }
    const int file = ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file >= 0) {
      if (::flock(file, LOCK_EX | LOCK_NB) == 0) {
        ::unlink(entry.path().c_str());
      }
      ::close(file);
    }
  }
}

/// Once a folder.
void clean_first(const std::filesystem::path& folder) {
  static std::mutex mutex;
  static std::set<std::filesystem::path> cleaned;
  const std::scoped_lock lock(mutex);
  if (cleaned.insert(folder).second) {
    clean(folder.empty() ? "." : folder);
  }
}

/// A file under a name of its own; closed and removed unless it was given its final name.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& target) : target_(target) {
    static std::atomic<unsigned> counter{0};
    do {  // an earlier process with the same number may have been killed and left its file
      name_ = target.parent_path() /
              fmt::format(".raytracer-{}-{}.tmp", ::getpid(), counter.fetch_add(1));
      announce(name_);
      file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (file_ < 0 && errno == EEXIST);
    if (file_ < 0) {
      fail(target_, errno);
    }
    ::flock(file_, LOCK_EX | LOCK_NB);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    close();
    if (!name_.empty()) {
      ::unlink(name_.c_str());
    }
    at_work = false;
  }

  void write(std::span<const unsigned char> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) {
        fail(target_, errno);
      }
      bytes = bytes.subspan(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
  }

  void commit() {
    // Some file systems cannot sync (EINVAL); those that can report a full disk here.
    if (::fsync(file_) != 0 && errno != EINVAL && errno != ENOTSUP) {
      fail(target_, errno);
    }
    if (!close()) {
      fail(target_, errno);
    }
    if (::rename(name_.c_str(), target_.c_str()) != 0) {
      fail(target_, errno);
    }
    name_.clear();
  }

 private:
  bool close() {
    const int file = std::exchange(file_, -1);
    return file < 0 || ::close(file) == 0 || errno == EINTR;
  }

  std::filesystem::path target_;
  std::filesystem::path name_;
  int file_ = -1;
};

}  // namespace

void check_place(const std::filesystem::path& path) {
  refuse_what_is_no_file(path);
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw FileError(fmt::format("cannot write {}: there is no folder {}; create it first",
                                path.string(), folder.string()));
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(path, errno);
  }
}

void write_whole_file(const std::filesystem::path& path, std::span<const unsigned char> bytes) {
  refuse_what_is_no_file(path);
  clean_first(path.parent_path());
  Temporary temporary(path);
  temporary.write(bytes);
  temporary.commit();
}

void abandon_temporary() noexcept {
  if (at_work) {
    ::unlink(name_at_work.data());
  }
}

}  // namespace rt::io
