#include "signature.h"

#include <fmt/format.h>

#include <cctype>
#include <utility>

#include "rt/scene/options.h"

namespace rt::lua {
namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == text.npos ? std::string_view()
                            : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The text cut at each `separator` that stands in no bracket.
std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  std::size_t depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' || text[i] == '{' ? 1 : 0;
    depth -= text[i] == ')' || text[i] == '}' ? 1 : 0;
    if (depth == 0 && text.substr(i).starts_with(separator)) {
      parts.push_back(trimmed(text.substr(begin, i - begin)));
      begin = i + separator.size();
    }
  }
  parts.push_back(trimmed(text.substr(begin)));
  return parts;
}

/// Where the bracket that opens at `open` closes.
std::size_t closing(std::string_view text, std::size_t open) {
  std::size_t depth = 0;
  std::size_t i = open;
  for (; i < text.size(); ++i) {
    depth += text[i] == '(' || text[i] == '{' ? 1 : 0;
    depth -= text[i] == ')' || text[i] == '}' ? 1 : 0;
    if (depth == 0) {
      break;
    }
  }
  return i;
}

/// "name?: type", or nothing: a piece of the type before it, as in "axis: 'x', 'y' or 'z'".
bool begins_parameter(std::string_view piece) {
  std::size_t i = 0;
  while (i < piece.size() && is_letter(piece[i])) {
    ++i;
  }
  i += i < piece.size() && piece[i] == '?' ? 1 : 0;
  return i > 0 && i < piece.size() && piece[i] == ':';
}

void add_options(std::vector<Parameter>& parameters) {
  for (const TableOption& option : table_options) {
    parameters.push_back({std::string(option.name), std::string(option.type), true});
  }
  for (const OptionSpec& spec : option_specs()) {
    constexpr const char* types[] = {"boolean", "number", "string"};
    parameters.push_back({std::string(spec.name), types[spec.get(RenderOptions{}).index()], true});
  }
}

std::vector<Parameter> parse_parameters(std::string_view text) {
  std::vector<Parameter> parameters;
  for (const std::string_view piece : split(text, ",")) {
    if (piece == "...options") {
      add_options(parameters);
    } else if (begins_parameter(piece)) {
      const std::size_t colon = piece.find(':');
      std::string_view name = piece.substr(0, colon);
      const bool optional = name.ends_with('?');
      name.remove_suffix(optional ? 1 : 0);
      parameters.push_back(
          {std::string(name), std::string(trimmed(piece.substr(colon + 1))), optional});
    } else if (!parameters.empty()) {
      parameters.back().type.append(", ").append(piece);
    }
  }
  return parameters;
}

std::string table_type(std::string_view fields) {
  std::string text;
  for (const Parameter& p : parse_parameters(fields)) {
    text += fmt::format("{}{}{}: {}", text.empty() ? "" : ", ", p.name, p.optional ? "?" : "",
                        luacats_type(p.type));
  }
  return fmt::format("{{ {} }}", text);
}

/// Items of several types, as in {number, colour}.
std::string tuple_type(const std::vector<std::string_view>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += fmt::format("{}[{}]: {}", i == 0 ? "" : ", ", i + 1, luacats_type(items[i]));
  }
  return fmt::format("{{ {} }}", text);
}

std::string simple_type(std::string_view type) {
  constexpr std::pair<std::string_view, std::string_view> ours[] = {
      {"node", "gr.Node"},       {"material", "gr.Material"}, {"light", "gr.Light"},
      {"texture", "gr.Texture"}, {"colour", "gr.Colour"},     {"pose", "gr.Pose"}};
  for (const auto& [name, luacats] : ours) {
    if (type == name) {
      return std::string(luacats);
    }
  }
  if (!type.starts_with('{')) {
    return std::string(type);
  }
  const std::string_view inner = type.substr(1, type.size() - 2);
  const auto items = split(inner, ",");
  if (begins_parameter(items.front())) {
    return table_type(inner);
  }
  if (items.back() == "...") {
    return luacats_type(items.front()) + "[]";
  }
  return items.front() == "number" ? tuple_type(items) : "number[]";
}

}  // namespace

Signature parse_signature(std::string_view text) {
  Signature signature;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '(' && text[i] != '{') {
      if (text[i] == ':') {
        signature.result = trimmed(text.substr(i + 1));
        break;
      }
      ++i;
      continue;
    }
    const std::size_t end = closing(text, i);
    signature.forms.push_back({parse_parameters(text.substr(i + 1, end - i - 1)), text[i] == '{'});
    i = end + 1;
  }
  return signature;
}

std::string luacats_type(std::string_view type) {
  std::string text;
  for (const std::string_view choice : split(type, " or ")) {
    for (const std::string_view part : split(choice, ",")) {
      text += text.empty() ? "" : "|";
      text += simple_type(part);
    }
  }
  return text;
}

}  // namespace rt::lua
