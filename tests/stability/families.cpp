#include "stability/families.h"

#include <cmath>
#include <numbers>

#include "rt/math/transform.h"
#include "stability/spots.h"

namespace rt::stability {

std::uint64_t Random::bits() {
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double Random::uniform(double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

int Random::below(int n) {
  return static_cast<int>((bits() >> 32) * static_cast<std::uint64_t>(n) >> 32);
}

double Random::power_of_ten(double lo, double hi) {
  return std::exp(std::numbers::ln10 * uniform(lo, hi));
}

Vec3 Random::direction() {
  const double z = uniform(-1, 1);
  const double phi = uniform(0, 2 * std::numbers::pi);
  const double rho = std::sqrt(1 - z * z);
  return {rho * std::cos(phi), z, rho * std::sin(phi)};
}

std::string Family::name() const {
  static const char* const names[] = {"random",      "grazing", "double root", "far",
                                      "far grazing", "axis",    "equatorial",  "inside",
                                      "edge",        "thin",    "spindle",     "non-uniform"};
  return shape + ", " + names[static_cast<int>(kind)];
}

std::vector<Family> families(const std::string& shape) {
  using enum Kind;
  std::vector<Family> out;
  const auto add = [&](const char* name, std::initializer_list<Kind> kinds) {
    if (!shape.empty() && shape != name) {
      return;
    }
    for (const Kind kind : kinds) {
      const double limit = kind == thin                         ? 5e-14
                           : kind == far || kind == far_grazing ? 1e-11
                           : kind == non_uniform                ? 1e-9
                                                                : 1e-14;
      out.push_back({name, kind, limit});
    }
  };
  add("torus", {random, grazing, thin, far, far_grazing, axis, equatorial, double_root, non_uniform,
                inside, spindle});
  add("sphere", {random, grazing, far, far_grazing, axis, double_root, non_uniform, inside});
  add("cylinder", {random, grazing, far, axis, double_root, non_uniform, inside, edge});
  add("cone", {random, grazing, far, axis, double_root, non_uniform, inside, edge});
  add("blob", {random, grazing, far, axis, double_root, non_uniform, inside, edge});
  add("box", {random, far, axis, non_uniform, inside, edge});
  add("plane", {random, grazing, far});
  add("square", {random, far, axis, edge});
  add("mesh", {random, grazing, far, axis, edge});
  return out;
}

namespace {

Shape shape_for(const Family& family, Random& random) {
  if (family.shape == "torus") {
    if (family.kind == Kind::thin) {
      return Torus{1, random.power_of_ten(-5, -1)};
    }
    if (family.kind == Kind::spindle) {
      switch (random.below(4)) {
        case 0:
          return Torus{0.5, 0.5};
        case 1:
          return Torus{1, random.uniform(0.3, 1)};
        default:
          return Torus{random.power_of_ten(-1, 0), 1};
      }
    }
    return Torus{};
  }
  if (family.shape == "sphere") {
    // The unit sphere, and spheres about other centres.
    return random.below(2) == 0 ? Sphere{} : Sphere{3.0 * random.direction(), 0.5};
  }
  if (family.shape == "box") {
    return random.below(2) == 0 ? Box{} : Box{{-0.3, 0.1, -2.7}, {0.4, 0.9, -0.1}};
  }
  return fixed_shape(family.shape, random);
}

double length_of_direction(Random& random) { return random.power_of_ten(-1, 1); }

Ray towards(const Vec3& target, const Vec3& direction, double distance, Random& random) {
  return {target - distance * direction, length_of_direction(random) * direction};
}

/// A unit vector in the plane of which n is the normal.
Vec3 tangent_at(const Vec3& n, Random& random) {
  while (true) {
    const Vec3 t = glm::cross(n, random.direction());
    if (glm::length(t) > 0.1) {
      return glm::normalize(t);
    }
  }
}

Vec3 target_in(const Shape& shape, Random& random) {
  const Bounds b = std::visit([](const auto& s) { return bounds(s); }, shape);
  Vec3 target;
  for (int i = 0; i < 3; ++i) {
    target[i] = b.finite() ? random.uniform(b.lo[i], b.hi[i]) : random.uniform(-1, 1);
  }
  return target;
}

Ray past_a_tangent(const Shape& shape, double lo, double hi, double distance, Random& random) {
  const Spot spot = spot_on(shape, random);
  const double off = hi > -300 ? random.sign() * random.power_of_ten(lo, hi) : 0;
  return towards(spot.position + off * spot.normal, tangent_at(spot.normal, random), distance,
                 random);
}

/// Planes have no tangent points: a ray at 1e-3 to 1e-12 to them, from a height of its own.
Ray skimming(const Shape& shape, Random& random) {
  const Spot spot = spot_on(shape, random);
  const Vec3 direction =
      glm::normalize(tangent_at(spot.normal, random) - random.power_of_ten(-12, -3) * spot.normal);
  return towards(spot.position, direction, 3, random);
}

Ray along_an_axis(const Shape& shape, Random& random) {
  const int axis = random.below(3);
  Vec3 direction(0.0);
  for (int i = 0; i < 3; ++i) {
    direction[i] = std::copysign(i == axis ? 1.0 : 0.0, random.sign());
  }
  Vec3 target = random.below(2) == 0 ? spot_on(shape, random).position : target_in(shape, random);
  target[axis] = 0;
  return towards(target, direction, 8, random);
}

Ray equatorial(const Shape& shape, Random& random) {
  Vec3 target = target_in(shape, random);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  Vec3 direction(std::cos(angle), 0, std::sin(angle));
  const double off = random.power_of_ten(-16, -3);
  target.y = random.below(2) == 0 ? 0 : random.sign() * off;
  direction.y = random.below(2) == 0 ? 0 : random.sign() * off;
  return towards(target, direction, 4, random);
}

/// The world stretches the shape by up to 1e6 : 1; the ray is random there.
Ray from_a_stretched_world(const Shape& shape, Random& random) {
  Affine world = Affine::scaling(
      {random.power_of_ten(-3, 3), random.power_of_ten(-3, 3), random.power_of_ten(-3, 3)});
  world = Affine::rotation(random.below(3), random.uniform(0, 360)) * world;
  const Affine model = *inverse(world);
  const Vec3 target = world.point(spot_on(shape, random).position);
  const Bounds b = transformed(world, std::visit([](const auto& s) { return bounds(s); }, shape));
  const Vec3 direction = random.direction();
  const Ray ray = towards(target, direction, 3 * glm::length(b.extent()), random);
  return {model.point(ray.origin), model.vector(ray.direction)};
}

Ray ray_for(const Family& family, const Shape& shape, double unit, Random& random) {
  switch (family.kind) {
    case Kind::grazing:
      return family.shape == "plane" || family.shape == "mesh"
                 ? skimming(shape, random)
                 : past_a_tangent(shape, -12, -3, 3, random);
    case Kind::double_root:
      return past_a_tangent(shape, -300, -300, 3, random);
    case Kind::far:
      return towards(target_in(shape, random), random.direction(),
                     (1 + random.power_of_ten(0, 8)) * unit, random);
    case Kind::far_grazing:
      return past_a_tangent(shape, -12, -3, random.power_of_ten(0.5, 8) * unit, random);
    case Kind::thin:
    case Kind::spindle:
      if (random.below(2) == 0) {
        return past_a_tangent(shape, -12, -3, 3, random);
      }
      return towards(spot_on(shape, random).position, random.direction(), 4, random);
    case Kind::axis:
      return along_an_axis(shape, random);
    case Kind::equatorial:
      return equatorial(shape, random);
    case Kind::inside:
      return {inner_point(shape, random), length_of_direction(random) * random.direction()};
    case Kind::edge:
      return past_an_edge(shape, random);
    case Kind::non_uniform:
      return from_a_stretched_world(shape, random);
    case Kind::random:
      break;
  }
  return towards(target_in(shape, random), random.direction(), 4 * unit, random);
}

}  // namespace

Case make_case(const Family& family, Random& random) {
  const Shape shape = shape_for(family, random);
  const double unit = size_of(shape);
  return {shape, ray_for(family, shape, unit, random), unit};
}

}  // namespace rt::stability
