/// gr.node, gr.joint and the primitives.
#include "nodes.h"

#include <fmt/format.h>

#include "functions.h"

namespace rt::lua {
namespace {

std::shared_ptr<Node> new_node(const Call& call) {
  auto node = std::make_shared<Node>();
  node->name = call.argument(1).text("a name (string)");
  node->where = location(call.L);
  return node;
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

int push_new_node(const Call& call, std::optional<Shape> shape) {
  auto node = new_node(call);
  node->shape = std::move(shape);
  push(call.L, std::move(node));
  return 1;
}

int make_node(Call& call) { return push_new_node(call, std::nullopt); }

int make_joint(Call& call) {
  auto node = new_node(call);
  turn_joint(call, *node, 0, call.argument(2, "x"));
  turn_joint(call, *node, 1, call.argument(3, "y"));
  push(call.L, std::move(node));
  return 1;
}

int make_sphere(Call& call) { return push_new_node(call, Sphere{}); }

int make_cube(Call& call) { return push_new_node(call, Box{}); }

int make_plane(Call& call) {
  const Value size = call.argument(2, "size");
  return size.given() ? push_new_node(call, Square{size.number(positive)})
                      : push_new_node(call, Plane{});
}

int make_cylinder(Call& call) { return push_new_node(call, Cylinder{}); }

int make_torus(Call& call) {
  const Value second = call.argument(2, call.argument(3).given() ? "R" : "r");
  const Value third = call.argument(3, "r");
  Torus torus;
  if (third.given()) {
    torus = {second.number(positive), third.number(positive)};
  } else if (second.given()) {
    torus.minor_radius = second.number(positive);
  }
  return push_new_node(call, torus);
}

int make_blob(Call& call) { return push_new_node(call, Blob{}); }

int make_nh_sphere(Call& call) {
  const Vec3 centre = call.argument(2, "centre").triple();
  return push_new_node(call, Sphere{centre, call.argument(3, "radius").number(positive)});
}

int make_nh_box(Call& call) {
  const Vec3 corner = call.argument(2, "corner").triple();
  const Vec3 size = call.argument(3, "size").triple_or_number(
      positive, "a positive number or three {sx, sy, sz}");
  return push_new_node(call, Box{corner, corner + size});
}

}  // namespace rt::lua
