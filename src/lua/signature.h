#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lua {

struct Parameter {
  std::string name;
  std::string type;  ///< as messages say it
  bool optional = false;
};

/// One way to call a function.
struct Form {
  std::vector<Parameter> parameters;
  bool is_table = false;  ///< the parameters are fields of one table
};

/// A Binding's signature taken apart: "(a: string, b?: number) or {c: colour, ...options}: node".
/// "...options" becomes the options of gr.render.
struct Signature {
  std::vector<Form> forms;
  std::string result;
};

/// An option of gr.render whose value is a table, beside those of option_specs().
struct TableOption {
  std::string_view name;
  std::string_view type;
  std::string_view help;
};
inline constexpr std::array table_options{
    TableOption{"background", "colour or {top: colour, bottom: colour}",
                "what rays that leave the scene see: one colour, or from bottom to top"},
    TableOption{"shutter", "{open, close}",
                "the part of the time from 0 to 1 that the picture sees (default {0, 1})"},
};

Signature parse_signature(std::string_view text);

/// A type of ours in LuaCATS: "{x, y, z}" is number[], "colour" is gr.Colour.
std::string luacats_type(std::string_view type);

}  // namespace rt::lua
