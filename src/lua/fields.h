#pragma once
/// Tables with named fields. Each field is declared once, and read by name or by position.
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "call.h"

namespace rt::lua {

/// A field of a table form, or an argument of a positional form, that goes into a Target.
template <class Target>
struct Field {
  std::string_view name;
  void (*read)(const Value&, Target&);
  std::string_view alias = {};  ///< a second spelling
  bool required = false;
};

/// Pushes the field of the table at `index`, under either spelling, or nil. Throws SceneError when
/// both are there.
void push_field(const Call& call, int index, std::string_view name, std::string_view alias);

/// The keys of the table at `index`, sorted, but those in `known`. A key that is no name appears
/// as in "[1]".
std::vector<std::string> other_keys(lua_State* L, int index,
                                    std::span<const std::string_view> known);

/// Throws SceneError about the first of `keys`, if there is one.
void refuse_keys(const Call& call, std::string_view table, std::span<const std::string> keys,
                 std::span<const std::string_view> known);

/// The names of fields.
template <class Target>
std::vector<std::string_view> names_of(std::span<const Field<Target>> fields) {
  std::vector<std::string_view> names;
  for (const auto& field : fields) {
    names.push_back(field.name);
  }
  return names;
}

/// The keys of the table at `index` that are none of `fields`.
template <class Target>
std::vector<std::string> unknown_keys(const Call& call, int index,
                                      std::span<const Field<Target>> fields) {
  std::vector<std::string_view> known = names_of(fields);
  for (const auto& field : fields) {
    if (!field.alias.empty()) {
      known.push_back(field.alias);
    }
  }
  return other_keys(call.L, index, known);
}

/// Reads the fields of the table at `index`, which messages call `table`.
template <class Target>
void read_fields(const Call& call, int index, std::string_view table,
                 std::span<const Field<Target>> fields, Target& target) {
  for (const auto& field : fields) {
    push_field(call, index, field.name, field.alias);
    const Value value(call, lua_gettop(call.L), table, field.name);
    if (value.given() || field.required) {
      field.read(value, target);
    }
    lua_pop(call.L, 1);
  }
}

/// The same; any other key is an error, and the first to be told: a name that is misspelt is one
/// that is missing, too.
template <class Target>
void read_only_fields(const Call& call, int index, std::string_view table,
                      std::span<const Field<Target>> fields, Target& target) {
  refuse_keys(call, table, unknown_keys(call, index, fields), names_of(fields));
  read_fields(call, index, table, fields, target);
}

/// Reads arguments 1, 2, ... as the fields in their order. The first `required` must be there; of
/// the others one that is not a number is ignored with a warning: scripts of the course framework
/// give them meanings of their own.
template <class Target>
void read_positional(Call& call, std::span<const Field<Target>> fields, int required,
                     Target& target) {
  int n = 0;
  for (const auto& field : fields) {
    const Value value = call.argument(++n, field.name);
    if (n <= required || value.type() == LUA_TNUMBER) {
      field.read(value, target);
    } else if (value.given()) {
      call.ignore(n);
    }
  }
}

}  // namespace rt::lua
