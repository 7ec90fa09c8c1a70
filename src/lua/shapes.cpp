/// gr.node, gr.joint and the primitives: what makes each, and how scripts call it.
#include <fmt/format.h>

#include <array>

#include "functions.h"
#include "guarded.h"
#include "nodes.h"

namespace rt::lua {
namespace {

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

/// "(name)", "(name, thickness)" or "(name, size, thickness)": sets the numbers that are given.
void read_size_and_thickness(const Call& call, std::string_view size_name, double& size,
                             double& thickness) {
  const Value second = call.argument(2, call.argument(3).given() ? size_name : "r");
  const Value third = call.argument(3, "r");
  if (third.given()) {
    size = second.number(positive);
    thickness = third.number(positive);
  } else if (second.given()) {
    thickness = second.number(positive);
  }
}

int make_capsule(Call& call) {
  Capsule capsule;
  read_size_and_thickness(call, "length", capsule.length, capsule.radius);
  return push_own(call, capsule);
}

int make_torus(Call& call) {
  Torus torus;
  read_size_and_thickness(call, "R", torus.major_radius, torus.minor_radius);
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

constexpr std::array table{
    Binding{"gr.node", guarded<make_node>, 1, "(name: string): node",
            "A node without a shape, to group others.", R"(gr.node("group"))"},
    Binding{"gr.joint", guarded<make_joint>, 3,
            "(name: string, x?: {min, init, max}, y?: {min, init, max}): node",
            "A node turned about x, then y, by its initial angles in degrees.",
            R"(gr.joint("neck", {-30, 0, 30}, {-60, 0, 60}))"},
    Binding{"gr.sphere", guarded<make_sphere>, 1, "(name: string): node",
            "The unit sphere about the origin.", R"(gr.sphere("ball"))"},
    Binding{"gr.cube", guarded<make_cube>, 1, "(name: string): node",
            "The unit cube, from (0, 0, 0) to (1, 1, 1).", R"(gr.cube("box"))"},
    Binding{"gr.plane", guarded<make_plane>, 2, "(name: string, size?: number): node",
            "The plane y = 0, unbounded, or a centred square with edges of that size.",
            R"(gr.plane("floor"))"},
    Binding{"gr.cylinder", guarded<make_cylinder>, 1, "(name: string): node",
            "Radius 1 about the y axis, from y = 0 to 1, closed.", R"(gr.cylinder("can"))"},
    Binding{"gr.cone", guarded<make_cone>, 1, "(name: string): node",
            "Radius 1 at y = 0, where it is closed; its apex at (0, 1, 0).", R"(gr.cone("hat"))"},
    Binding{"gr.capsule", guarded<make_capsule>, 3,
            "(name: string), (name: string, r: number) or (name: string, length: number, r: "
            "number): node",
            "All within r of the line from (0, 0, 0) to (0, length, 0): 0.25 and 1, unless given.",
            R"(gr.capsule("arm", 1, 0.25))"},
    Binding{"gr.torus", guarded<make_torus>, 3,
            "(name: string), (name: string, r: number) or (name: string, R: number, r: number): "
            "node",
            "A ring about the y axis: R = 1, and a tube of radius r = 0.25, unless given.",
            R"(gr.torus("ring", 1, 0.25))"},
    Binding{"gr.blob", guarded<make_blob>, 1, "(name: string): node",
            "A rounded head on a truncated cone, from y = -1 to 1.", R"(gr.blob("gumdrop"))"},
    Binding{"gr.nh_sphere", guarded<make_nh_sphere>, 3,
            "(name: string, centre: {x, y, z}, radius: number): node",
            "A sphere by its centre and radius.", R"(gr.nh_sphere("ball", {0, 1, 0}, 2))"},
    Binding{"gr.nh_box", guarded<make_nh_box>, 3,
            "(name: string, corner: {x, y, z}, size: number or {sx, sy, sz}): node",
            "A box by its least corner and its edges.", R"(gr.nh_box("box", {0, 0, 0}, 2))"},
    Binding{"gr.mesh", guarded<make_mesh>, 3,
            "(name: string, file: string) or (name: string, vertices: {{x, y, z}, ...}, faces: "
            "{{0, 1, 2}, ...}): node",
            "Triangles of an OBJ file, or of tables; faces count vertices from 0.",
            R"(gr.mesh("cow", "cow.obj"))"},
};

}  // namespace

std::span<const Binding> shape_bindings() { return table; }

}  // namespace rt::lua
