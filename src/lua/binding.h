#pragma once
/// How a function that scripts may call is declared.
#include <lua.hpp>
#include <span>
#include <string_view>

namespace rt::lua {

struct Binding {
  std::string_view title;      ///< "gr.sphere", "node:translate", or the global "require"
  lua_CFunction function;      ///< wrapped in guarded<>
  int most;                    ///< arguments beyond these are ignored with a warning
  std::string_view signature;  ///< its forms, parameters with their types
  std::string_view help;       ///< one line
  std::string_view example;    ///< what messages suggest to try

  constexpr bool is_method() const { return title.starts_with("node:"); }
  constexpr bool is_gr() const { return title.starts_with("gr."); }
  /// The title without its table.
  constexpr std::string_view name() const { return title.substr(title.find_first_of(".:") + 1); }
};

/// Every function and method there is.
std::span<const Binding> bindings();
/// Those of them that make nodes.
std::span<const Binding> shape_bindings();

/// Each C closure carries its Binding in this upvalue.
inline constexpr int binding_upvalue = 1;
/// Address under which the registry holds the table `gr`.
inline constexpr char gr_table_key = 0;

/// Sets the globals `gr`, `require` and `dofile` and makes the metatables.
void open_bindings(lua_State* L);

}  // namespace rt::lua
