#pragma once
/// The errors a user can cause. Everything else that throws is a defect of this program.
#include <stdexcept>
#include <string>

namespace rt {

/// Exit codes of the command, one for each kind of failure.
enum class ExitCode : int {
  done = 0,
  scene = 1,         ///< the scene is wrong
  command_line = 2,  ///< the command line is wrong
  file = 3,          ///< a file could not be read or written
  limit = 4,         ///< a limit stopped the script
  interrupted = 130,
};

/// A message for the user that says what was expected, what was given and what to try. The binding
/// puts script:line before it.
class UserError : public std::runtime_error {
 public:
  UserError(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The scene is wrong: exit code 1.
class SceneError : public UserError {
 public:
  explicit SceneError(const std::string& message) : UserError(ExitCode::scene, message) {}
};

/// A file could not be read or written: exit code 3.
class FileError : public UserError {
 public:
  explicit FileError(const std::string& message) : UserError(ExitCode::file, message) {}
};

}  // namespace rt
