/// gr.node, gr.joint and the primitives.
#include "nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "functions.h"

namespace rt::lua {
namespace {

/// What a node takes: itself, the block that counts its shares, the allocator's own.
constexpr std::size_t bytes_of_node = sizeof(ChargedNode) + 48;

std::shared_ptr<Node> new_node(lua_State* L, std::string name) {
  auto node = std::make_shared<ChargedNode>(context(L).memory);
  node->name = std::move(name);
  node->where = shared_location(L);
  charge(L, node->charge, bytes_of_node + node->name.size());
  return node;
}

std::shared_ptr<Node> new_node(const Call& call) {
  return new_node(call.L, call.argument(1).text("a name (string)"));
}

/// All nodes of a shape without parameters share it.
template <class S>
int push_plain(const Call& call) {
  static const auto shape = std::make_shared<const Shape>(S{});
  return push_new_node(call, shape);
}

template <class S>
int push_own(const Call& call, const S& shape) {
  return push_new_node(call, make_charged(call.L, Shape(shape)));
}

/// Turns a joint by the middle one of its three angles, if they are given.
void turn_joint(const Call& call, Node& node, int axis, const Value& angles) {
  if (!angles.given()) {
    return;
  }
  const Vec3 range = angles.triple(any_number, "three angles {min, init, max}");
  if (!(range[0] <= range[1] && range[1] <= range[2])) {
    warn_once(call.L, "joint outside its range",
              fmt::format("{} '{}': the initial angle {} lies outside {} to {}", call.title(),
                          node.name, range[1], range[0], range[2]));
  }
  rotate(node, axis, range[1]);
}

}  // namespace

int push_new_node(const Call& call, std::shared_ptr<const Shape> shape) {
  auto node = new_node(call);
  node->shape = std::move(shape);
  push(call.L, std::move(node));
  return 1;
}

int push_stand_in(lua_State* L) {
  const bool named = lua_type(L, 1) == LUA_TSTRING;
  push(L, new_node(L, named ? lua_tostring(L, 1) : "stand-in"));
  return 1;
}

void charge_child(const Call& call, Node& parent) {
  if (parent.children.size() == parent.children.capacity()) {
    const std::size_t more = std::max<std::size_t>(1, parent.children.capacity());
    charge(call.L, static_cast<ChargedNode&>(parent).charge, more * sizeof(std::shared_ptr<Node>));
  }
}

int make_node(Call& call) { return push_new_node(call, nullptr); }

int make_joint(Call& call) {
  auto node = new_node(call);
  turn_joint(call, *node, 0, call.argument(2, "x"));
  turn_joint(call, *node, 1, call.argument(3, "y"));
  push(call.L, std::move(node));
  return 1;
}

int make_sphere(Call& call) { return push_plain<Sphere>(call); }

int make_cube(Call& call) { return push_plain<Box>(call); }

int make_plane(Call& call) {
  const Value size = call.argument(2, "size");
  return size.given() ? push_own(call, Square{size.number(positive)}) : push_plain<Plane>(call);
}

int make_cylinder(Call& call) { return push_plain<Cylinder>(call); }

int make_cone(Call& call) { return push_plain<PointedCone>(call); }

int make_torus(Call& call) {
  const Value second = call.argument(2, call.argument(3).given() ? "R" : "r");
  const Value third = call.argument(3, "r");
  Torus torus;
  if (third.given()) {
    torus = {second.number(positive), third.number(positive)};
  } else if (second.given()) {
    torus.minor_radius = second.number(positive);
  }
  return push_own(call, torus);
}

int make_blob(Call& call) { return push_plain<Blob>(call); }

int make_nh_sphere(Call& call) {
  const Vec3 centre = call.argument(2, "centre").triple();
  return push_own(call, Sphere{centre, call.argument(3, "radius").number(positive)});
}

int make_nh_box(Call& call) {
  const Vec3 corner = call.argument(2, "corner").triple();
  const Vec3 size = call.argument(3, "size").triple_or_number(
      positive, "a positive number or three {sx, sy, sz}");
  return push_own(call, Box{corner, corner + size});
}

}  // namespace rt::lua
