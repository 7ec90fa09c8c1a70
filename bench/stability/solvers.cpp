#include "stability/solvers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rt/geometry/exact.h"
#include "stability/naive.h"

namespace rt::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

OptionalHit own(const Torus& torus, const Ray& ray) {
  return intersect(torus, ray, infinity, RayStart{});
}

using Roots = int (*)(double c2, double c1, double c0, double* roots);

/// Clips to the bounds, recentres, and leaves the depressed quartic to `roots`.
template <Roots roots>
OptionalHit recentred_solver(const Torus& torus, const Ray& ray) {
  const double R = torus.major_radius;
  const double r = torus.minor_radius;
  const Vec3& d = ray.direction;
  const double dd = glm::dot(d, d);
  const double shift = -glm::dot(ray.origin, d) / dd;
  const Vec3 near = fused_at(ray.origin, d, shift);
  const double residual = -glm::dot(near, d) / dd;
  const Vec3 o = fused_at(near, d, residual);
  const double length = std::sqrt(dd);
  const double dy = d.y / length;
  const double h = glm::dot(o, o);
  const double half = std::sqrt((R + r) * (R + r) - h);
  const double low = std::min((-r - o.y) / dy, (r - o.y) / dy);
  const double high = std::max((-r - o.y) / dy, (r - o.y) / dy);
  if (!(half >= 0) || low > half || high < -half || (dy == 0 && std::abs(o.y) > r)) {
    return {};
  }
  double found[4];
  const int count =
      roots(2 * (h - R * R - r * r) + 4 * R * R * dy * dy, 8 * R * R * o.y * dy,
            (h - (R + r) * (R + r)) * (h - (R - r) * (R - r)) + 4 * R * R * o.y * o.y, found);
  double best = infinity;
  for (int i = 0; i < count; ++i) {
    const double t = shift + (residual + found[i] / length);
    best = t > 0 && t < best ? t : best;
  }
  return best < infinity ? OptionalHit(ShapeHit{best}) : OptionalHit{};
}

}  // namespace

std::vector<Method> torus_methods() {
  return {{"this program", own},
          {"Ferrari, as written", stability::naive_ferrari},
          {"Ferrari, recentred", recentred_solver<stability::depressed_ferrari>},
          {"companion matrix, recentred", recentred_solver<companion_roots>},
          {"factorisation, recentred", recentred_solver<factored_roots>}};
}

}  // namespace rt::bench
