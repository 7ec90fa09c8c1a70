#include "obj_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <system_error>

#include "rt/scene/error.h"

namespace rt::io {
namespace {

// Indices are 32-bit, and tinyobjloader keeps them in an int.
constexpr std::uintmax_t max_bytes = std::uintmax_t{4} << 30;
constexpr std::string_view blank = " \t";

/// Calls visit(line number from 1, line without leading blanks) until it returns false. Lines end
/// as they do for tinyobjloader: in \n, \r\n or \r.
template <typename F>
void for_each_line(std::string_view text, F visit) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
    if (!visit(number, line)) {
      return;
    }
    text.remove_prefix(end);
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  }
}

/// True when the line begins with the keyword and a blank; the rest is what follows.
bool is_statement(std::string_view line, std::string_view keyword, std::string_view& rest) {
  if (!line.starts_with(keyword) || line.size() == keyword.size() ||
      blank.find(line[keyword.size()]) == std::string_view::npos) {
    return false;
  }
  rest = line.substr(keyword.size());
  return true;
}

/// The whole word as a finite number.
std::optional<double> finite_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) {  // too small is zero, too large is not a number
    value = std::strtod(std::string(word).c_str(), nullptr);
  }
  const bool is_number = error != std::errc::invalid_argument && end == word.data() + word.size() &&
                         std::isfinite(value);
  return is_number ? std::optional(value) : std::nullopt;
}

}  // namespace

std::string read_obj_text(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& reason) {
    throw FileError(fmt::format("cannot read {}: {}", path.string(), reason));
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    fail(error ? error.message() : "there is no such file");
  }
  if (!std::filesystem::is_regular_file(status)) {  // a pipe or a device may never end
    fail("it is not a regular file");
  }
  const auto bytes = std::filesystem::file_size(path, error);
  if (error || bytes > max_bytes) {
    fail(error ? error.message() : fmt::format("{} bytes are more than {}", bytes, max_bytes));
  }
  std::ifstream file(path, std::ios::binary);
  std::string text(bytes, '\0');
  errno = 0;
  if (!file.read(text.data(), static_cast<std::streamsize>(bytes))) {
    fail(errno != 0 ? std::generic_category().message(errno) : "it became shorter meanwhile");
  }
  if (text.starts_with("\xef\xbb\xbf")) {  // a byte order mark would hide the first statement
    text.erase(0, 3);
  }
  return text;
}

ObjPoints read_obj_points(std::string_view text, const std::filesystem::path& path) {
  struct Statement {
    std::string_view keyword;
    std::size_t least;
    std::vector<Vec3> ObjPoints::*list;
  };
  constexpr std::array statements{Statement{"v", 3, &ObjPoints::positions},
                                  Statement{"vt", 1, &ObjPoints::uvs},
                                  Statement{"vn", 3, &ObjPoints::normals}};
  ObjPoints points;
  for_each_line(text, [&](std::size_t number, std::string_view line) {
    for (const auto& [keyword, least, list] : statements) {
      std::string_view rest;
      if (!is_statement(line, keyword, rest)) {
        continue;
      }
      Vec3 point(0.0);
      std::size_t words = 0;
      for (std::size_t at = 0; (at = rest.find_first_not_of(blank)) != std::string_view::npos;) {
        rest.remove_prefix(at);
        const auto word = rest.substr(0, rest.find_first_of(blank));
        rest.remove_prefix(word.size());
        if (word.starts_with('#')) {
          break;
        }
        const auto value = finite_number(word);
        if (!value) {
          throw SceneError(fmt::format("{}:{}: expected a finite number after {}, got '{:.40}'",
                                       path.string(), number, keyword, word));
        }
        if (words < 3) {  // a weight or a colour may follow
          point[static_cast<int>(words)] = *value;
        }
        ++words;
      }
      if (words < least) {
        throw SceneError(fmt::format("{}:{}: expected {} number{} after {}, got {}", path.string(),
                                     number, least, least == 1 ? "" : "s", keyword, words));
      }
      (points.*list).push_back(point);
    }
    return true;
  });
  return points;
}

std::size_t line_of_face(std::string_view text, std::size_t n) {
  std::size_t found = 0;
  for_each_line(text, [&](std::size_t number, std::string_view line) {
    std::string_view rest;
    if (!is_statement(line, "f", rest) || rest.find_first_not_of(blank) == rest.npos) {
      return true;
    }
    found = number;
    return n-- > 0;
  });
  return found;
}

}  // namespace rt::io
