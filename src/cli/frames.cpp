#include "rt/cli/frames.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "rt/cli/command_line.h"

namespace rt::cli {
namespace {

/// So that a frame's number has at most six digits.
constexpr int last_frame = 999'999;

/// All of the text as a number of a frame.
std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool right = error == std::errc() && end == text.data() + text.size();
  return right && value >= 0 && value <= last_frame ? std::optional(value) : std::nullopt;
}

}  // namespace

Frames parse_frames(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots != text.npos) {
    const auto first = number(std::string_view(text).substr(0, dots));
    const auto last = number(std::string_view(text).substr(dots + 2));
    if (first && last && *first <= *last) {
      return {*first, *last};
    }
  }
  throw UsageError(fmt::format(
      "--frames: expected FIRST..LAST, whole numbers from 0 to {}, such as 1..48; got '{}'",
      last_frame, text));
}

Frames parse_frame(const std::string& text) {
  if (const auto frame = number(text)) {
    return {*frame, *frame};
  }
  throw UsageError(fmt::format("--frame: expected a whole number from 0 to {}, got '{}'{}",
                               last_frame, text,
                               text.find("..") == text.npos ? "" : "; did you mean --frames?"));
}

std::filesystem::path frame_path(const std::filesystem::path& picture, int frame) {
  const std::string stem = picture.stem().string();
  const std::size_t digits = stem.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
  if (number(std::string_view(stem).substr(digits)) == frame) {
    return picture;
  }
  std::filesystem::path numbered = picture;
  numbered.replace_filename(fmt::format("{}_{:04}{}", stem, frame, picture.extension().string()));
  return numbered;
}

}  // namespace rt::cli
