/// gr.light.
#include <fmt/format.h>

#include "fields.h"
#include "functions.h"

namespace rt::lua {
namespace {

struct Draft {
  Light light;
  std::optional<Vec3> u, v, to;
};

void read_falloff(const Value& value, Draft& draft) {
  constexpr std::string_view expected = "three numbers {c0, c1, c2}, not negative";
  const Vec3 c = value.triple(not_negative, expected);
  if (c == Vec3(0.0)) {
    const Vec3& at = draft.light.position;
    value.fail(expected,
               fmt::format("{{0, 0, 0}} for the light at ({}, {}, {}), a division by zero at every "
                           "distance ({{1, 0, 0}} never dims)",
                           at.x, at.y, at.z));
  }
  draft.light.falloff = {c[0], c[1], c[2]};
}

/// In the order of the positional form, which takes the first four.
constexpr std::array light_fields{
    Field<Draft>{"position", [](const Value& v, Draft& d) { d.light.position = v.triple(); }, "",
                 true},
    Field<Draft>{"colour", [](const Value& v, Draft& d) { d.light.colour = v.colour(); }, "color"},
    Field<Draft>{"falloff", read_falloff},
    Field<Draft>{"radius",
                 [](const Value& v, Draft& d) { d.light.radius = v.number(not_negative); }},
    Field<Draft>{"u", [](const Value& v, Draft& d) { d.u = v.triple(); }},
    Field<Draft>{"v", [](const Value& v, Draft& d) { d.v = v.triple(); }},
    Field<Draft>{"to", [](const Value& v, Draft& d) { d.to = v.triple(); }},
    Field<Draft>{"visible", [](const Value& v, Draft& d) { d.light.visible = v.boolean(); }},
};

void make_rectangle(const Call& call, Draft& draft) {
  if (!draft.u && !draft.v) {
    return;
  }
  if (!draft.u || !draft.v) {
    call.fail("a rectangular light needs both edges, 'u' and 'v'");
  }
  if (draft.light.radius > 0.0) {
    call.fail("a light is a sphere ('radius') or a rectangle ('u', 'v'), not both");
  }
  const double u_size = max_abs(*draft.u);
  const double v_size = max_abs(*draft.v);
  if (u_size == 0.0 || v_size == 0.0 ||
      glm::cross(*draft.u / u_size, *draft.v / v_size) == Vec3(0.0)) {
    call.fail("the edges 'u' and 'v' span no area; they must not be zero or parallel");
  }
  draft.light.rectangle = Light::Rectangle{*draft.u, *draft.v};
}

}  // namespace

int make_light(Call& call) {
  const std::span<const Field<Draft>> fields = light_fields;
  Draft draft;
  const Value first = call.argument(1, "position");
  if (call.count() == 1 && first.type() == LUA_TTABLE && !first.is_list()) {
    read_only_fields(call, first.index(), "", fields, draft);
  } else {
    read_positional(call, fields.first(4), 3, draft);
  }
  make_rectangle(call, draft);
  if (draft.to) {
    draft.light.travel = *draft.to - draft.light.position;
  }
  draft.light.where = location(call.L);
  const std::size_t beside = draft.light.where.size();
  push<const Light>(call.L, make_charged(call.L, std::move(draft.light), beside));
  return 1;
}

}  // namespace rt::lua
