#include "stability/leaving.h"

#include <cmath>

#include "rt/math/rounding.h"
#include "rt/math/transform.h"
#include "stability/closed_meshes.h"
#include "stability/oracle_convex.h"
#include "stability/oracle_flat.h"
#include "stability/oracle_mesh.h"
#include "stability/oracle_torus.h"

namespace rt::stability {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A ray that leaves a surface, in the world and in the model.
struct Secondary {
  Vec3 origin_world, direction_world, normal_world;
  std::uint32_t feature;
  Leaving side;
  double position_error;  ///< in the model
};

Vec3 secondary_direction(const Vec3& normal, Random& random) {
  if (random.below(4) != 0) {
    return random.direction();
  }
  const Vec3 tangent = glm::cross(normal, random.direction());
  return glm::normalize(tangent / glm::length(tangent) +
                        random.sign() * random.power_of_ten(-9, -1) * normal);
}

/// Shoots a primary ray at a random spot and starts a secondary one where it hits.
std::optional<Secondary> secondary(const Placement& placement, const Affine& world,
                                   const Affine& model, Random& random) {
  const Shape& shape = placement.shape;
  const Spot spot = spot_on(shape, random);
  const Vec3 from = spot.position + (random.below(4) == 0 ? 0.1 : 4.0) * random.direction();
  const Ray primary_world{world.point(from), world.vector(spot.position - from)};
  const Ray primary{model.point(primary_world.origin), model.vector(primary_world.direction)};
  const OptionalHit hit =
      std::visit([&](const auto& s) { return intersect(s, primary, infinity, RayStart{}); }, shape);
  if (!hit) {
    return {};
  }
  const SurfacePoint p =
      std::visit([&](const auto& s) { return surface_point(s, primary, *hit); }, shape);
  Secondary out;
  out.origin_world = world.point(p.position);
  out.normal_world = glm::normalize(glm::transpose(model.linear) * p.normal);
  out.direction_world = secondary_direction(out.normal_world, random);
  out.feature = hit->feature;
  out.side =
      glm::dot(out.normal_world, out.direction_world) < 0 ? Leaving::inward : Leaving::outward;
  // surface_point, the map to the world and the map back: three times at most five roundings of
  // something no larger than the point's distance from the world's origin, in sizes.
  out.position_error = gamma(15) * (glm::length(p.position) + std::abs(placement.offset) * 2 + 1);
  return out;
}

OptionalHit next_hit(const Shape& shape, const Secondary& start, const Affine& model, double scale,
                     Policy policy) {
  Ray ray{model.point(start.origin_world), model.vector(start.direction_world)};
  RayStart state{start.side, start.feature, start.position_error};
  double skipped = 0;
  if (policy == Policy::touching) {
    state = {Leaving::nothing, 0, start.position_error};
  } else if (policy == Policy::offset) {
    const double side = start.side == Leaving::outward ? 1 : -1;
    ray.origin =
        model.point(start.origin_world + side * scale * start.position_error * start.normal_world);
    state = {};
  } else if (policy == Policy::epsilon) {
    skipped = 1e-6;
    ray.origin = ray.at(skipped);
    state = {};
  }
  OptionalHit hit =
      std::visit([&](const auto& s) { return intersect(s, ray, infinity, state); }, shape);
  if (hit) {
    hit->t += skipped;
  }
  return hit;
}

struct Expected {
  double t;
  double cosine;
};

/// The first crossing ahead that fits the side: out of the solid comes first, for a ray that went
/// in, and the other way round. The crossing that the ray starts on is of the other kind.
std::optional<Expected> expected_crossing(const Shape& shape, const Ray& ray, Leaving side,
                                          double offset) {
  const Sphere* sphere = std::get_if<Sphere>(&shape);
  const Line<DoubleDouble> line(ray, sphere != nullptr ? sphere->centre : Vec3(0.0));
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    const auto first = first_crossing(*mesh->data, line, side == Leaving::inward, offset);
    return first ? std::optional(
                       Expected{static_cast<double>(line.parameter(first->s)), first->cosine})
                 : std::nullopt;
  }
  const auto all = std::visit([&](const auto& s) { return crossings(s, line, offset); }, shape);
  const bool convex = !std::holds_alternative<Torus>(shape);
  for (std::size_t i = 0; i < static_cast<std::size_t>(all.count); ++i) {
    const bool exit = convex ? i == 1 : all.cosine[i] > 0;
    if (exit == (side == Leaving::inward) && all.s[i] > line.begin) {
      return Expected{static_cast<double>(line.parameter(all.s[i])), all.cosine[i]};
    }
  }
  return {};
}

bool agrees(const std::optional<Expected>& expected, const OptionalHit& hit, double length,
            double tolerance) {
  if (!expected || !hit) {
    return !expected && !hit;
  }
  const double off = std::abs(hit->t - expected->t) * length;
  const double cosine = std::abs(expected->cosine);
  // A surface moved by the tolerance moves the crossing by tolerance / cosine, at most by the chord
  // that appears at a tangent point.
  const double chord = 4 * std::sqrt(tolerance);
  return off * cosine <= tolerance || (cosine <= chord && off <= chord);
}

/// Near an edge of a mesh the error of a ray's origin decides whether the ray also passes the face
/// beyond the edge: it does so within the error of either face's plane. A ray that leaves outward
/// is then inside, and the other way round; its answer is that of the other side.
bool passes_an_edge(const Mesh& mesh, const Secondary& start, const Ray& ray,
                    const OptionalHit& hit, double tolerance) {
  const double length = glm::length(ray.direction);
  const double away = start.side == Leaving::outward ? -tolerance : tolerance;
  const auto beyond = expected_crossing(mesh, ray, start.side, away);
  const double sine = std::abs(glm::dot(start.normal_world, start.direction_world));
  if (!beyond || beyond->t * length * std::min(sine, std::abs(beyond->cosine)) > 4 * tolerance) {
    return false;
  }
  const Leaving other = start.side == Leaving::outward ? Leaving::inward : Leaving::outward;
  for (const double offset : {0.0, tolerance, -tolerance}) {
    if (agrees(expected_crossing(mesh, ray, other, offset), hit, length, 4 * tolerance)) {
      return true;
    }
  }
  return false;
}

void judge(const Placement& placement, const Secondary& start, const Affine& model,
           const OptionalHit& hit, Policy policy, LeavingTally& tally) {
  const Ray ray{model.point(start.origin_world), model.vector(start.direction_world)};
  const double length = glm::length(ray.direction);
  // The start is off the surface by its position error, and so is the far end of its chord.
  const double tolerance = 1e-14 + 16 * start.position_error;
  const auto expected = expected_crossing(placement.shape, ray, start.side, 0);
  if (agrees(expected, hit, length, tolerance)) {
    return;
  }
  for (const double offset : {tolerance, -tolerance}) {
    if (agrees(expected_crossing(placement.shape, ray, start.side, offset), hit, length,
               4 * tolerance)) {
      ++tally.below_resolution;
      return;
    }
  }
  // A chord as shallow as the error: whether the ray is inside at all is not known. A mesh that
  // knows the triangle left has no such excuse where there is no crossing: a hit so near is one of
  // the neighbouring triangle.
  const Mesh* mesh = std::get_if<Mesh>(&placement.shape);
  const double sine = std::abs(glm::dot(start.normal_world, start.direction_world));
  const double nearest =
      std::min(hit && (mesh == nullptr || policy == Policy::touching) ? hit->t : infinity,
               expected ? expected->t : infinity);
  if (nearest * length * sine <= tolerance ||
      (mesh != nullptr && passes_an_edge(*mesh, start, ray, hit, tolerance))) {
    ++tally.below_resolution;
    return;
  }
  ++(!hit ? tally.leaks : (!expected ? tally.false_hits : tally.wrong));
}

}  // namespace

void LeavingTally::add(const LeavingTally& other) {
  rays += other.rays;
  false_hits += other.false_hits;
  leaks += other.leaks;
  wrong += other.wrong;
  below_resolution += other.below_resolution;
}

std::vector<Placement> placements() {
  const std::vector<Shape> shapes{
      Sphere{},   Sphere{{1, 2, 3}, 1}, Torus{},        Torus{0.5, 1},    Torus{1, 0.01},
      Cylinder{}, PointedCone{},        Capsule{},      Capsule{1, 0.01}, Box{},
      Blob{},     box_mesh(),           sphere_mesh(2), torus_mesh(12, 6)};
  std::vector<Placement> out;
  for (const Shape& shape : shapes) {
    for (const double offset : {0.0, 1e3}) {
      for (int exponent = -8; exponent <= 8; exponent += 2) {
        out.push_back({shape, std::pow(10.0, exponent), offset});
      }
    }
  }
  return out;
}

LeavingTally run_leaving(const Placement& placement, Policy policy, long count,
                         std::uint64_t seed) {
  Random random(seed);
  const Affine world =
      Affine::translation(placement.scale * placement.offset * Vec3(1, -0.7, 0.3)) *
      Affine::rotation(1, 30) * Affine::rotation(0, 20) * Affine::scaling(Vec3(placement.scale));
  const Affine model = *inverse(world);
  LeavingTally tally;
  while (tally.rays < count) {
    const std::optional<Secondary> start = secondary(placement, world, model, random);
    if (start) {
      ++tally.rays;
      judge(placement, *start, model,
            next_hit(placement.shape, *start, model, placement.scale, policy), policy, tally);
    }
  }
  return tally;
}

}  // namespace rt::stability
