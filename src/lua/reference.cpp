#include "rt/lua/reference.h"

#include <fmt/format.h>

#include "binding.h"
#include "rt/scene/options.h"
#include "signature.h"

namespace rt::lua {
namespace {

/// "name: string, r?: number", with types of LuaCATS.
std::string typed_fields(const Form& form) {
  std::string text;
  for (const Parameter& p : form.parameters) {
    text += fmt::format("{}{}{}: {}", text.empty() ? "" : ", ", p.name, p.optional ? "?" : "",
                        luacats_type(p.type));
  }
  return text;
}

std::string typed_list(const Form& form) {
  return form.is_table ? fmt::format("fields: {{ {} }}", typed_fields(form)) : typed_fields(form);
}

std::string annotation(const Binding& binding) {
  const Signature signature = parse_signature(binding.signature);
  const std::string result = luacats_type(signature.result);
  std::string text = fmt::format("\n---{}\n---\n---Example: `{}`\n", binding.help, binding.example);
  std::string names;
  const Form& first = signature.forms.front();
  if (first.is_table) {
    text += fmt::format("---@param fields {{ {} }}\n", typed_fields(first));
    names = "fields";
  }
  for (const Parameter& p : first.is_table ? std::vector<Parameter>{} : first.parameters) {
    text += fmt::format("---@param {}{} {}\n", p.name, p.optional ? "?" : "", luacats_type(p.type));
    names += (names.empty() ? "" : ", ") + p.name;
  }
  if (!result.empty()) {
    text += fmt::format("---@return {}\n", result);
  }
  for (std::size_t i = 1; i < signature.forms.size(); ++i) {
    const bool method = binding.is_method();
    text += fmt::format("---@overload fun({}{}){}\n", method ? "self: gr.Node, " : "",
                        typed_list(signature.forms[i]), result.empty() ? "" : ": " + result);
  }
  const std::string title =
      binding.is_method() ? fmt::format("Node:{}", binding.name()) : std::string(binding.title);
  return text + fmt::format("function {}({}) end\n", title, names);
}

void add_section(std::string& page, std::string_view title, bool (*belongs)(const Binding&)) {
  page += fmt::format("\n## {}\n", title);
  for (const Binding& binding : bindings()) {
    if (belongs(binding)) {
      page += fmt::format("\n**`{}`** {}\n\n    {}{}\n    {}\n", binding.title, binding.help,
                          binding.title, binding.signature, binding.example);
    }
  }
}

}  // namespace

std::string editor_annotations() {
  std::string text =
      "---@meta\n"
      "-- What scene scripts can call, for editors. Written out from the tables in src/lua\n"
      "-- (bindings.cpp, shapes.cpp); a test says how when it is out of date.\n\n"
      "---A colour {r, g, b}, or one number for a grey; linear, not negative.\n"
      "---@alias gr.Colour number|number[]\n\n"
      "---@class gr.Material\n---@class gr.Light\n---@class gr.Texture\n\n"
      "---@class gr.Pose\n---@field translate? number[]\n"
      "---@field rotate? { [1]: 'x'|'y'|'z'|number[], [2]: number } axis and degrees\n"
      "---@field scale? number|number[]\n---@field about? number[]\n\n"
      "---@class gr.Node\nlocal Node = {}\n\n"
      "---The frame of an animation (--frames, --frame), else nil.\n"
      "---@type integer?\nframe = nil\n\n"
      "gr = {}\n";
  for (const Binding& binding : bindings()) {
    text += annotation(binding);
  }
  return text;
}

std::string reference_page() {
  std::string page =
      "# Reference\n\nEvery call of a scene script, written out from the tables in "
      "src/lua (bindings.cpp, shapes.cpp). `name?` may be left out; a colour is `{r, g, b}` or one "
      "number for a "
      "grey. What they mean: [scripting.md](scripting.md).\n";
  add_section(page, "Functions", [](const Binding& b) { return b.is_gr(); });
  add_section(page, "Methods of nodes", [](const Binding& b) { return b.is_method(); });
  add_section(page, "Modules and globals",
              [](const Binding& b) { return !b.is_gr() && !b.is_method(); });
  page +=
      "\n**`frame`** The number of the frame with `--frames FIRST..LAST` or `--frame N`, else "
      "nil.\n\n"
      "    frame: integer or nil\n    ball:translate(0.1 * (frame or 0), 0, 0)\n";
  page += "\n## Options of gr.render\n\n| option | meaning |\n|---|---|\n";
  for (const TableOption& option : table_options) {
    page += fmt::format("| `{}` | {} |\n", option.name, option.help);
  }
  for (const OptionSpec& spec : option_specs()) {
    page += fmt::format("| `{}` | {} |\n", spec.name, spec.help);
  }
  return page;
}

}  // namespace rt::lua
