#include "call_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <vector>

namespace rt::lua {
namespace {

using Found = std::optional<Span>;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) {
    ++at;
  }
  return at;
}

/// `word` in the text from `from` on, not as a part of a longer word.
Found find_word(std::string_view text, std::string_view word, std::size_t from = 0) {
  for (auto at = text.find(word, from); at != text.npos && !word.empty();
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool starts = at == 0 || !is_word(word.front()) || !is_word(text[at - 1]);
    const bool ends = end >= text.size() || !is_word(word.back()) || !is_word(text[end]);
    if (starts && ends) {
      return Span{at, end};
    }
  }
  return std::nullopt;
}

/// What stands between the next two `quote`s after `after` in the message, or nothing.
std::string_view quoted(std::string_view message, std::string_view after, char quote = '\'') {
  const std::size_t at = message.find(after);
  if (at == message.npos) {
    return {};
  }
  const std::size_t open = message.find(quote, at + after.size() - 1);
  const std::size_t close = open == message.npos ? open : message.find(quote, open + 1);
  return close == message.npos ? std::string_view() : message.substr(open + 1, close - open - 1);
}

/// Past a string or a comment that begins at `at`; `at` itself when none does.
std::size_t skip_literal(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (c == '"' || c == '\'') {
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != c && text[end] != '\n') {
      end += text[end] == '\\' ? 2 : 1;
    }
    return std::min(end + 1, text.size());
  }
  if (text.substr(at).starts_with("--")) {
    return std::min(text.find('\n', at), text.size());
  }
  return at;
}

/// The arguments of a call, whose opening bracket is at `open`; the last item is what lies before
/// the closing bracket. A call without brackets has one argument.
std::vector<Span> arguments(std::string_view text, std::size_t open) {
  std::vector<Span> list;
  std::size_t depth = 0;
  std::size_t begin = open + 1;
  for (std::size_t at = open; at < text.size();) {
    if (const std::size_t past = skip_literal(text, at); past != at) {
      at = past;
      continue;
    }
    const char c = text[at];
    depth += c == '(' || c == '{' || c == '[' ? 1 : 0;
    const bool closes = c == ')' || c == '}' || c == ']';
    if (closes && depth > 0) {
      --depth;
    }
    if ((depth == 1 && c == ',') || (closes && depth == 0)) {
      list.push_back({skip_blanks(text, begin), at});
      begin = at + 1;
    }
    if (closes && depth == 0) {
      break;
    }
    ++at;
  }
  return list;
}

/// A call of the function `name` at or after `from`: its name, and where its arguments open.
struct CallPlace {
  Span name;
  std::size_t open;
};
std::optional<CallPlace> find_call(std::string_view text, std::string_view name, std::size_t from) {
  for (Found word = find_word(text, name, from); word; word = find_word(text, name, word->end)) {
    const std::size_t next = skip_blanks(text, word->end);
    if (next < text.size() &&
        std::string_view("({'\"").find(text[next]) != std::string_view::npos) {
      return CallPlace{*word, next};
    }
  }
  return std::nullopt;
}

/// The name in "gr.sphere: ..." or "node:rotate of 'ball': ...".
std::string_view called_name(std::string_view message) {
  std::size_t begin = 0;
  if (message.starts_with("gr.")) {
    begin = 3;
  } else if (message.starts_with("node:")) {
    begin = 5;
  } else if (!message.starts_with("require: ") && !message.starts_with("dofile: ")) {
    return {};
  }
  std::size_t end = begin;
  while (end < message.size() && is_word(message[end])) {
    ++end;
  }
  return message.substr(begin, end - begin);
}

/// The value that the message gives in brackets: "got a number (-1)".
std::string_view given_value(std::string_view message) {
  const std::size_t got = message.find("got a ");
  const std::size_t open = got == message.npos ? got : message.find('(', got);
  const std::size_t close = open == message.npos ? open : message.find(')', open);
  return close == message.npos ? std::string_view() : message.substr(open + 1, close - open - 1);
}

/// A key that the message complains about, or nothing: the last part of 'camera.eye'.
std::string_view blamed_key(std::string_view message) {
  for (const std::string_view before : {"unknown key '", "option '", " as '", "has both '"}) {
    if (const std::string_view key = quoted(message, before); !key.empty()) {
      return key.substr(key.rfind('.') + 1);
    }
  }
  return {};
}

std::size_t blamed_argument(std::string_view message) {
  constexpr std::string_view before = "argument ";
  const std::size_t at = message.find(before);
  std::size_t number = 0;
  if (at != message.npos) {
    std::from_chars(message.data() + at + before.size(), message.data() + message.size(), number);
  }
  return number;
}

/// Within one call, what the message is about.
Span in_call(std::string_view message, std::string_view text, const CallPlace& call) {
  const std::vector<Span> list = arguments(text, call.open);
  const std::size_t end = list.empty() ? text.size() : list.back().end;
  if (const auto key = blamed_key(message); !key.empty()) {
    const Found word = find_word(text.substr(0, end), key, call.open);
    return word ? *word : call.name;
  }
  const std::size_t n = blamed_argument(message);
  if (n == 0 || list.empty() || text[call.open] != '(') {
    return call.name;
  }
  const bool absent = n > list.size() || list[n - 1].begin >= list[n - 1].end;
  return absent ? Span{end, end + 1} : list[n - 1];
}

Found about_a_call(std::string_view message, std::string_view text) {
  const std::string_view name = called_name(message);
  if (name.empty()) {
    return std::nullopt;
  }
  const std::string_view value = given_value(message);
  Found first;
  std::size_t from = 0;
  while (const auto call = find_call(text, name, from)) {
    const Span span = in_call(message, text, *call);
    if (!first) {
      first = span;
    }
    // Of several calls the one that shows the value given.
    if (value.empty() || text.substr(span.begin, span.end - span.begin).find(value) != text.npos) {
      return span;
    }
    if (text.substr(0, call->open).find('\n') != text.npos) {
      break;
    }
    from = call->open;
  }
  return first;
}

/// What Lua's own messages quote.
Found about_words(std::string_view message, std::string_view line) {
  if (const auto near = quoted(message, "near '"); !near.empty()) {
    const std::size_t at = line.rfind(near);
    return at == line.npos ? Found() : Span{at, at + near.size()};
  }
  constexpr std::string_view missing = "there is no gr.";
  if (message.starts_with(missing)) {
    const std::size_t end = message.find_first_of(".; ", missing.size());
    return find_word(line, message.substr(missing.size(), end - missing.size()));
  }
  for (const std::string_view before : {"(local '", "(global '", "(field '", "(upvalue '",
                                        "(method '", "no method '", "cannot set '"}) {
    if (const auto word = quoted(message, before); !word.empty()) {
      return find_word(line, word);
    }
  }
  return std::nullopt;
}

}  // namespace

Span span_of(std::string_view message, std::string_view text) {
  message.remove_prefix(skip_blanks(message, 0));
  const std::string_view line = text.substr(0, text.find('\n'));
  Found found = about_a_call(message, text);
  if (!found) {
    found = about_words(message, line);
  }
  const std::size_t begin = std::min(skip_blanks(line, 0), line.size());
  Span span = found.value_or(Span{begin, line.find_last_not_of(" \t\r") + 1});
  // One row is marked.
  span.end = std::min({span.end, text.find('\n', span.begin), text.size()});
  return {span.begin, std::max(span.end, span.begin + 1)};
}

}  // namespace rt::lua
