#pragma once
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "rt/geometry/shape.h"
#include "rt/math/arranged.h"

namespace rt {

/// Shapes by kind, so that each takes no more memory than its own parameters. A shape's kind is its
/// place in the variant Shape.
template <class Variant>
class ShapeColumns;

template <class... S>
class ShapeColumns<std::variant<S...>> {
 public:
  /// Its index among those of its kind.
  std::uint32_t add(const std::variant<S...>& shape) {
    return std::visit(
        [this](const auto& s) {
          using Kind = std::decay_t<decltype(s)>;
          auto& column = std::get<std::vector<Kind>>(columns_);
          if (!std::is_empty_v<Kind> || column.empty()) {  // those without parameters are all one
            column.push_back(s);
          }
          return static_cast<std::uint32_t>(column.size() - 1);
        },
        shape);
  }

  template <class Kind>
  const std::vector<Kind>& of() const {
    return std::get<std::vector<Kind>>(columns_);
  }

  /// f(shape), as std::visit.
  template <class F>
  auto visit(std::size_t kind, std::uint32_t index, F&& f) const {
    return visit_from<0>(kind, index, f);
  }

  /// Once all are there: renumbers them, meshes apart, in the order in which each_use(visit) calls
  /// visit(kind, index), which changes the index.
  template <class EachUse>
  void arrange(EachUse&& each_use) {
    arrange_from<0>(each_use);
  }

  std::size_t bytes() const {
    return std::apply(
        [](const auto&... column) { return (... + (column.size() * sizeof(*column.data()))); },
        columns_);
  }

 private:
  template <std::size_t I, class EachUse>
  void arrange_from(EachUse& each_use) {
    if constexpr (I < sizeof...(S)) {
      auto& column = std::get<I>(columns_);
      if constexpr (!std::is_same_v<std::decay_t<decltype(column)>, std::vector<Mesh>>) {
        arrange_table(column, [&](auto&& visit) { each_use(I, visit); });
      }
      arrange_from<I + 1>(each_use);
    }
  }

  template <std::size_t I, class F>
  auto visit_from(std::size_t kind, std::uint32_t index, F& f) const {
    if constexpr (I + 1 == sizeof...(S)) {
      return f(std::get<I>(columns_)[index]);
    } else {
      return kind == I ? f(std::get<I>(columns_)[index]) : visit_from<I + 1>(kind, index, f);
    }
  }

  std::tuple<std::vector<S>...> columns_;
};

using ShapeTable = ShapeColumns<Shape>;

/// The kind of a shape: its place in the variant.
template <class Kind>
constexpr std::uint8_t kind_of() {
  // The index of a variant that holds one is known to the compiler.
  return static_cast<std::uint8_t>(Shape(std::in_place_type<Kind>).index());
}

}  // namespace rt
