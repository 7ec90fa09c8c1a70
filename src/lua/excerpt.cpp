#include "excerpt.h"

#include <fmt/format.h>
#include <luaconf.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>

#include "call_text.h"

namespace rt::lua {
namespace {

/// Lines that a call may go on for.
constexpr std::size_t most_lines = 60;
constexpr std::size_t widest = 110;

struct Place {
  std::filesystem::path file;
  std::string_view name;  ///< both of the message
  std::string_view rest;
  std::size_t line = 0;
};

/// "name:12: rest" taken apart.
std::optional<Place> place_of(std::string_view message, const Sources& sources) {
  for (const auto& [name, file] : sources) {
    if (!message.starts_with(name) || message.size() <= name.size() ||
        message[name.size()] != ':') {
      continue;
    }
    const char* begin = message.data() + name.size() + 1;
    const char* end = message.data() + message.size();
    std::size_t line = 0;
    const auto [after, error] = std::from_chars(begin, end, line);
    if (error == std::errc() && line > 0 && after != end && *after == ':') {
      std::string_view rest(after + 1, static_cast<std::size_t>(end - after - 1));
      return Place{file, message.substr(0, name.size()), rest, line};
    }
  }
  return std::nullopt;
}

/// The file's text from the given line (from 1) on, most_lines of it.
std::string text_from(const std::filesystem::path& file, std::size_t line) {
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::string one;
  for (std::size_t n = 1; n < line + most_lines && std::getline(in, one); ++n) {
    if (n >= line) {
      text += one + '\n';
    }
  }
  return text;
}

/// The line on one row of a terminal, cut about the column when it is long, and the row of the
/// caret below it.
std::string rows(std::string line, std::size_t number, std::size_t column, std::size_t width) {
  for (char& c : line) {
    c = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
  }
  if (line.size() > widest) {
    const std::size_t from = column > widest / 2 ? column - widest / 2 : 0;
    line = (from > 0 ? "..." : "") + line.substr(from, widest) +
           (from + widest < line.size() ? "..." : "");
    column = column - from + (from > 0 ? 3 : 0);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  width = std::min(width, line.size() > column ? line.size() - column : 1);
  const std::string digits = std::to_string(number);
  return fmt::format("{:>6} | {}\n{:>6} | {}^{}", digits, line, "", std::string(column, ' '),
                     std::string(std::max<std::size_t>(width, 1) - 1, '~'));
}

}  // namespace

std::string with_full_names(std::string message, const Sources& sources) {
  // As luaO_chunkid cuts them: three dots, and what still fits.
  constexpr std::size_t fits = LUA_IDSIZE - 1;
  for (const auto& [name, file] : sources) {
    if (name.size() <= fits) {
      continue;
    }
    const std::string cut = "..." + name.substr(name.size() - (fits - 3)) + ":";
    for (std::size_t at = message.find(cut); at != message.npos;
         at = message.find(cut, at + name.size())) {
      message.replace(at, cut.size() - 1, name);
    }
  }
  return message;
}

std::string with_excerpt(const std::string& message, const Sources& sources) {
  const auto place = place_of(message, sources);
  if (!place) {
    return {};
  }
  const std::string text = text_from(place->file, place->line);
  if (text.empty()) {
    return {};
  }
  const Span span = span_of(place->rest, text);
  const auto before = std::string_view(text).substr(0, span.begin);
  const auto line = place->line + static_cast<std::size_t>(std::ranges::count(before, '\n'));
  const std::size_t newline = before.rfind('\n');
  const std::size_t line_begin = newline == before.npos ? 0 : newline + 1;
  const std::size_t column = span.begin - line_begin;
  return fmt::format("{}:{}:{}:{}\n{}", place->name, line, column + 1, place->rest,
                     rows(text.substr(line_begin, text.find('\n', line_begin) - line_begin), line,
                          column, span.end - span.begin));
}

}  // namespace rt::lua
