#include "stability/spots.h"

#include <cmath>
#include <numbers>

namespace rt::stability {
namespace {

struct Turn {
  double cosine, sine;
};

Turn turn_of(Random& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

Spot spot(const Sphere& s, Random& random) {
  const Vec3 n = random.direction();
  return {s.centre + s.radius * n, n};
}

Spot spot(const Torus& s, Random& random) {
  const Turn u = turn_of(random);
  const Turn v = turn_of(random);
  const double rho = s.major_radius + s.minor_radius * v.cosine;
  return {Vec3(rho * u.cosine, s.minor_radius * v.sine, rho * u.sine),
          Vec3(v.cosine * u.cosine, v.sine, v.cosine * u.sine)};
}

Spot spot(const Box& s, Random& random) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) {
    p[i] = random.uniform(s.lo[i], s.hi[i]);
  }
  const int axis = random.below(3);
  const bool high = random.below(2) == 0;
  p[axis] = high ? s.hi[axis] : s.lo[axis];
  Vec3 n(0.0);
  n[axis] = high ? 1 : -1;
  return {p, n};
}

Spot disc_spot(double radius, double y, double side, Random& random) {
  const Turn u = turn_of(random);
  const double rho = radius * std::sqrt(random.uniform());
  return {Vec3(rho * u.cosine, y, rho * u.sine), Vec3(0, side, 0)};
}

Spot spot(const Cylinder&, Random& random) {
  if (random.below(3) == 0) {
    const bool top = random.below(2) == 0;
    return disc_spot(1, top ? 1 : 0, top ? 1 : -1, random);
  }
  const Turn u = turn_of(random);
  return {Vec3(u.cosine, random.uniform(), u.sine), Vec3(u.cosine, 0, u.sine)};
}

Spot spot(const PointedCone&, Random& random) {
  if (random.below(3) == 0) {
    return disc_spot(1, 0, -1, random);
  }
  const Turn u = turn_of(random);
  const double y = random.uniform();
  return {Vec3((1 - y) * u.cosine, y, (1 - y) * u.sine),
          Vec3(u.cosine, 1, u.sine) / std::sqrt(2.0)};
}

const double apex = std::sqrt(26.0);

Spot body_spot(double y, Random& random) {
  const Turn u = turn_of(random);
  const double rho = (apex - y) / 5;
  return {Vec3(rho * u.cosine, y, rho * u.sine), Vec3(5 * u.cosine, 1, 5 * u.sine) / apex};
}

Spot spot(const Blob&, Random& random) {
  switch (random.below(3)) {
    case 0: {
      const double y = random.uniform(1 / apex, 1);
      const Turn u = turn_of(random);
      const double rho = std::sqrt(1 - y * y);
      return {Vec3(rho * u.cosine, y, rho * u.sine), Vec3(rho * u.cosine, y, rho * u.sine)};
    }
    case 1:
      return body_spot(random.uniform(-1, 1 / apex), random);
    default:
      return disc_spot((apex + 1) / 5, -1, -1, random);
  }
}

Spot spot(const Plane&, Random& random) {
  return {Vec3(random.uniform(-2, 2), 0, random.uniform(-2, 2)), Vec3(0, 1, 0)};
}

Spot spot(const Square& s, Random& random) {
  const double h = s.edge / 2;
  return {Vec3(random.uniform(-h, h), 0, random.uniform(-h, h)), Vec3(0, 1, 0)};
}

/// On a mesh of several triangles half of the spots are near an edge.
Spot spot(const Mesh& s, Random& random) {
  const auto count = static_cast<int>(s.data->triangles.size());
  const auto chosen = static_cast<std::size_t>(count > 1 ? random.below(count) : 0);
  const Corners& c = s.data->triangles[chosen];
  const Vec3& a = s.data->positions[c[0]];
  const Vec3 ab = s.data->positions[c[1]] - a;
  const Vec3 ac = s.data->positions[c[2]] - a;
  const double root = std::sqrt(random.uniform());
  const bool near_edge = count > 1 && random.below(2) == 0;
  const double v = near_edge ? random.power_of_ten(-14, -2) : random.uniform();
  return {a + root * (1 - v) * ab + root * v * ac, glm::normalize(glm::cross(ab, ac))};
}

/// A point of an edge, and a direction that points away from the shape there.
struct EdgeSpot {
  Vec3 position;
  Vec3 away;
};

EdgeSpot rim(double radius, double y, double side, Random& random) {
  const Turn u = turn_of(random);
  return {Vec3(radius * u.cosine, y, radius * u.sine),
          glm::normalize(Vec3(u.cosine, side, u.sine))};
}

EdgeSpot edge_of(const Shape& shape, Random& random) {
  if (const Box* box = std::get_if<Box>(&shape)) {
    Spot s = spot(*box, random);
    const int axis = random.below(3);
    const bool high = random.below(2) == 0;
    s.position[axis] = high ? box->hi[axis] : box->lo[axis];
    Vec3 second(0.0);
    second[axis] = high ? 1 : -1;
    return {s.position, glm::normalize(s.normal + second)};
  }
  if (std::holds_alternative<Cylinder>(shape)) {
    const bool top = random.below(2) == 0;
    return rim(1, top ? 1 : 0, top ? 1 : -1, random);
  }
  if (std::holds_alternative<PointedCone>(shape)) {
    return rim(1, 0, -1, random);
  }
  if (std::holds_alternative<Blob>(shape)) {
    if (random.below(2) == 0) {
      return rim((apex + 1) / 5, -1, -1, random);
    }
    const Spot s = body_spot(1 / apex, random);
    return {s.position, s.normal};
  }
  if (const Square* square = std::get_if<Square>(&shape)) {
    Spot s = spot(*square, random);
    const int axis = 2 * random.below(2);
    const double side = random.sign();
    s.position[axis] = side * square->edge / 2;
    Vec3 away(0.0);
    away[axis] = side;
    return {s.position, away};
  }
  const MeshData& data = *std::get<Mesh>(shape).data;
  const Corners& c = data.triangles[0];
  const auto i = static_cast<std::size_t>(random.below(3));
  const Vec3& a = data.positions[c[i]];
  const Vec3& b = data.positions[c[(i + 1) % 3]];
  const Vec3 normal = spot(std::get<Mesh>(shape), random).normal;
  return {glm::mix(a, b, random.uniform()), glm::normalize(glm::cross(b - a, normal))};
}

Shape triangle(Random& random) {
  static const std::vector<Shape> pool = [] {
    std::vector<Shape> shapes;
    Random seeded(42);
    for (int i = 0; i < 64; ++i) {
      MeshData data;
      const double spread = i % 2 == 0 ? 1 : 0.01;
      const Vec3 about = 0.5 * seeded.direction();
      for (int k = 0; k < 3; ++k) {
        data.positions.push_back(about + spread * seeded.direction());
      }
      data.triangles = {{0, 1, 2}};
      shapes.emplace_back(Mesh{std::make_shared<const MeshData>(std::move(data))});
    }
    return shapes;
  }();
  return pool[static_cast<std::size_t>(random.below(static_cast<int>(pool.size())))];
}

}  // namespace

Spot spot_on(const Shape& shape, Random& random) {
  return std::visit([&](const auto& s) { return spot(s, random); }, shape);
}

Shape fixed_shape(const std::string& name, Random& random) {
  if (name == "cylinder") {
    return Cylinder{};
  }
  if (name == "cone") {
    return PointedCone{};
  }
  if (name == "blob") {
    return Blob{};
  }
  if (name == "plane") {
    return Plane{};
  }
  if (name == "square") {
    return Square{2};
  }
  return triangle(random);
}

double size_of(const Shape& shape) {
  if (const Torus* torus = std::get_if<Torus>(&shape)) {
    return std::max(torus->major_radius, torus->minor_radius);
  }
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) {
    return sphere->radius;
  }
  return 1;
}

Vec3 inner_point(const Shape& shape, Random& random) {
  const double depth = random.power_of_ten(-6, -0.1);  // of the way to the solid's heart
  const Spot s = spot_on(shape, random);
  if (const Torus* torus = std::get_if<Torus>(&shape)) {
    return s.position - depth * torus->minor_radius * s.normal;
  }
  const Bounds b = std::visit([](const auto& x) { return bounds(x); }, shape);
  return glm::mix(s.position, b.centre(), depth);
}

Ray past_an_edge(const Shape& shape, Random& random) {
  const EdgeSpot edge = edge_of(shape, random);
  Vec3 direction = glm::cross(edge.away, random.direction());
  if (std::holds_alternative<Square>(shape) || std::holds_alternative<Mesh>(shape)) {
    // Flat shapes are passed across, not along; and never nearly edge-on (see Kind::grazing).
    const Vec3 normal = spot_on(shape, random).normal;
    direction = random.sign() * normal + 0.8 * random.direction();
  }
  direction = glm::normalize(direction);
  const double off = random.sign() * random.power_of_ten(-13, -3);
  return {edge.position + off * edge.away - 3.0 * direction,
          random.power_of_ten(-1, 1) * direction};
}

}  // namespace rt::stability
