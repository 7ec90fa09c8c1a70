#pragma once
/// The program while it runs: what signals do to it.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "program.h"

namespace rt::test {

/// A process of the program, started in a folder; its words are separated by spaces.
class Running {
 public:
  Running(const std::filesystem::path& folder, const std::string& arguments,
          const std::function<void()>& in_child = {})
      : folder_(folder) {
    std::istringstream words("raytracer " + arguments);
    std::vector<std::string> list(std::istream_iterator<std::string>(words), {});
    std::vector<char*> argv;
    for (std::string& word : list) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    std::filesystem::remove(folder / "stderr.txt");  // what an earlier run said
    pid_ = fork();
    if (pid_ == 0) {
      const bool there = chdir(folder.c_str()) == 0;
      const int out = ::open("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666);
      const int err = ::open("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666);
      dup2(out, STDOUT_FILENO);
      dup2(err, STDERR_FILENO);
      for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        ::signal(number, SIG_DFL);  // a shell that runs tests in the background has SIGINT ignored
      }
      if (in_child) {
        in_child();
      }
      if (there) {
        execv(RT_PROGRAM, argv.data());
      }
      _exit(126);
    }
  }
  ~Running() {
    signal(SIGKILL);
    wait();
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Nothing once the process has ended, or was never started: kill() takes -1 for every process
  /// there is.
  void signal(int number) const {
    if (pid_ > 1) {
      ::kill(pid_, number);
    }
  }

  /// Waits until `seen` is in what it has said; false when it ended before.
  bool says(const std::string& seen) {
    while (contents(folder_ / "stderr.txt").find(seen) == std::string::npos) {
      if (ended()) {
        return false;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }

  bool ended() {
    if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) {
      pid_ = -1;
    }
    return pid_ < 0;
  }

  Outcome wait() {
    if (pid_ > 0) {
      waitpid(pid_, &status_, 0);
      pid_ = -1;
    }
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_),
            contents(folder_ / "stdout.txt"), contents(folder_ / "stderr.txt")};
  }

 private:
  std::filesystem::path folder_;
  pid_t pid_ = -1;
  int status_ = 0;
};

/// Limits the size of files that the process may write.
inline void limit_file_size(rlim_t bytes) {
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace rt::test
