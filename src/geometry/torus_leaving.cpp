#include "torus_leaving.h"

#include <algorithm>
#include <array>

#include "convex.h"
#include "first_crossing.h"
#include "torus_quartic.h"

namespace rt {
namespace {

Cubic cubic_of(const Torus& torus, const Vec3& o, const Vec3& d) {
  const double rho = std::sqrt(o.x * o.x + o.z * o.z);
  return cubic_of(torus, o, d, rho, sheet_at(torus, rho, o.y));
}

/// The next crossing of a ray that starts on the torus, at u > 0 with the direction's length one.
/// The crossing at 0 is divided out, and the side to which the ray leaves decides the sign.
std::optional<double> next_crossing(const TorusLine& line, Leaving side) {
  const Torus& torus = line.torus;
  const double size = line.size();
  const double sign = side == Leaving::outward ? 1 : -1;
  Cubic cubic = cubic_of(torus, line.ray.origin, line.direction);
  cubic.c0 = sign * std::max(sign * cubic.c0, 0.0);
  const double end = 2.5 * size;  // a chord is no longer than 2 (R + r)
  // Up to a tube's radius away from the start the cubic is as good as the geometric form, and
  // unlike that has no root at 0; further on it is worse but no longer needed. It turns from
  // concave to convex at its inflection.
  const double near = torus.minor_radius;
  const double turn = std::clamp(-cubic.c2 / 3, 0.0, end);
  const std::array<Piece, 3> pieces{Piece{0, std::min(near, turn), false},
                                    Piece{std::min(near, turn), std::max(near, turn), near >= turn},
                                    Piece{std::max(near, turn), end, true}};
  for (const Piece& piece : pieces) {
    if (!(piece.begin < piece.end)) {
      continue;
    }
    const bool close = piece.end <= near;
    const Accuracy accuracy =
        close ? Accuracy{0, 0}
              : Accuracy{polynomial_noise * size * size * size, coarse_step(torus)};
    std::optional<double> s = first_crossing(cubic, piece, sign, accuracy);
    if (s && !close) {
      s = finish_root(line, *s, sign, piece.begin);
    }
    if (s) {
      return s;
    }
  }
  return {};
}

/// How far p is from the tube's surface.
double distance(const Torus& torus, const Vec3& p) {
  const double rho = std::sqrt(p.x * p.x + p.z * p.z);
  const double w = rho - sheet_at(torus, rho, p.y) * torus.major_radius;
  return std::abs(std::sqrt(w * w + p.y * p.y) - torus.minor_radius);
}

/// Whether p is further than `error` from the box and the ball that hold the torus: most rays that
/// start elsewhere. The sums on either side are rounded three times at most.
bool clear_of_bounds(const Torus& torus, const Vec3& p, double error) {
  const double reach = (size_of(torus) + error) * (1 + gamma(8));
  const double height = (torus.minor_radius + error) * (1 + gamma(8));
  return std::abs(p.y) > height || glm::dot(p, p) > reach * reach;
}

}  // namespace

OptionalHit leave_torus(const Torus& torus, const Ray& ray, double t_max, Leaving side) {
  const double length = glm::length(ray.direction);
  const std::optional<double> u =
      next_crossing({torus, ray, {ray.origin, 0, 0}, ray.direction / length, length}, side);
  if (side == Leaving::inward) {
    return exit_hit(u ? *u / length : 0, 0, t_max);
  }
  return u ? hit_in_range(*u / length, 0, t_max) : OptionalHit{};
}

/// Three operations give rho, one w, three the distance: each rounds something of at most |o| + R.
Leaving coincidence(const Torus& torus, const Ray& ray, double error) {
  const Vec3& o = ray.origin;
  if (clear_of_bounds(torus, o, error)) {
    return Leaving::nothing;
  }
  const double reach = glm::length(o) + torus.major_radius;
  if (!(distance(torus, o) <= error + gamma(7) * reach)) {
    return Leaving::nothing;
  }
  return cubic_of(torus, o, ray.direction).c0 < 0 ? Leaving::inward : Leaving::outward;
}

}  // namespace rt
