#pragma once
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

Signature parse_signature(std::string_view text);

/// A type of ours in LuaCATS: "{x, y, z}" is number[], "colour" is gr.Colour.
std::string luacats_type(std::string_view type);

}  // namespace rt::lua
