#include "rt/geometry/shape.h"

namespace rt {
namespace {

const char* kind(const Sphere&) { return "sphere"; }
const char* kind(const Box&) { return "box"; }
const char* kind(const Plane&) { return "plane"; }
const char* kind(const Square&) { return "square"; }
const char* kind(const Cylinder&) { return "cylinder"; }
const char* kind(const PointedCone&) { return "cone"; }
const char* kind(const Torus&) { return "torus"; }
const char* kind(const Blob&) { return "blob"; }
const char* kind(const Mesh&) { return "mesh"; }

}  // namespace

const char* shape_kind(const Shape& shape) {
  return std::visit([](const auto& s) { return kind(s); }, shape);
}

bool convex(const Shape& shape) {
  return !std::holds_alternative<Torus>(shape) && !std::holds_alternative<Mesh>(shape);
}

}  // namespace rt
