#pragma once
/// The errors a user can cause. Everything else that throws is a defect of this program.
#include <stdexcept>
#include <string>
#include <utility>

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
  UserError(ExitCode code, const std::string& message, std::string report = {})
      : std::runtime_error(message), code_(code), report_(std::move(report)) {}
  ExitCode code() const { return code_; }
  /// The message as a terminal shows it: with the column, and the source line below. Without a line
  /// to show it is what().
  std::string report() const { return report_.empty() ? what() : report_; }

 private:
  ExitCode code_;
  std::string report_;
};

/// The scene is wrong: exit code 1.
class SceneError : public UserError {
 public:
  explicit SceneError(const std::string& message, std::string report = {})
      : UserError(ExitCode::scene, message, std::move(report)) {}
};

/// A file could not be read or written: exit code 3.
class FileError : public UserError {
 public:
  explicit FileError(const std::string& message, std::string report = {})
      : UserError(ExitCode::file, message, std::move(report)) {}
};

}  // namespace rt
