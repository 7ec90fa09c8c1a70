#pragma once
/// Finds in a script's text what a message talks about. Lua gives a line; messages name functions,
/// count arguments and quote keys and words.
#include <cstddef>
#include <string_view>

namespace rt::lua {

/// Characters begin <= i < end of a text.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The part of `text` that `message` is about. `text` begins with the line that the message names;
/// lines that follow may hold the rest of a call. When nothing is found: the first line, without
/// the blanks about it.
Span span_of(std::string_view message, std::string_view text);

}  // namespace rt::lua
