#include "stability/checker.h"

#include <algorithm>
#include <cmath>

#include "stability/oracle_convex.h"
#include "stability/oracle_flat.h"
#include "stability/oracle_torus.h"

namespace rt::stability {
namespace {

/// Roots are told apart up to this gap, in sizes.
constexpr double resolved_gap = 1e-14;
/// A hit further than this from the surface is no hit of it, however inaccurate the solver.
constexpr double recognisable = 1e-6;

/// Lines are seen from near a sphere's centre, and from near the origin for all other shapes.
Vec3 heart_of(const Shape& shape) {
  const Sphere* sphere = std::get_if<Sphere>(&shape);
  return sphere != nullptr ? sphere->centre : Vec3(0.0);
}

template <class T>
std::optional<First<T>> exact_first(const Case& c, double offset) {
  return std::visit(
      [&](const auto& shape) {
        const Line<T> line(c.ray, heart_of(c.shape));
        return first_of(line, crossings(shape, line, offset));
      },
      c.shape);
}

struct Comparison {
  bool agrees = false;
  double error = 0;  ///< perpendicular, in sizes
  double relative_t = 0;
};

/// Whether an answer is the exact first crossing rather than none, the next one or something else.
/// Two crossings whose gap is below `slack` pass for one.
template <class T>
Comparison compare(const Case& c, const std::optional<First<T>>& exact, const OptionalHit& hit,
                   double slack) {
  if (!exact || !hit) {
    return {!exact && !hit, 0, 0};
  }
  const T t(hit->t);
  const double off = std::abs(static_cast<double>(t - exact->t));
  const double to_next =
      exact->next ? std::abs(static_cast<double>(t - *exact->next)) : 2 * off + 1;
  const double last_place = std::abs(hit->t) * 0x1p-52;
  const double across = glm::length(c.ray.direction) * std::abs(exact->cosine) / c.unit;
  const double error = std::max(0.0, off - last_place) * across;
  return {error <= slack || (off <= to_next && error <= recognisable), error,
          off / static_cast<double>(exact->t)};
}

/// How far a point is from the surface along its normal. Points of a rim may miss the shape by a
/// rounding: those are judged against the shape grown by the resolved gap; of a triangle, which
/// grows in its plane alone, as seen along the ray.
double distance_along_normal(const Case& c, const SurfacePoint& p) {
  const double step = 0.25 * c.unit;
  const Line<DoubleDouble> line({p.position - step * p.normal, p.normal}, heart_of(c.shape));
  double nearest = std::numeric_limits<double>::infinity();
  const double gap = 0.1 * resolved_gap * c.unit;
  const double foreshortened =
      std::abs(glm::dot(p.normal, c.ray.direction)) / glm::length(c.ray.direction);
  const double in_plane = std::holds_alternative<Mesh>(c.shape) ? gap / foreshortened : gap;
  for (const double offset : {0.0, gap, in_plane}) {
    const auto all =
        std::visit([&](const auto& shape) { return crossings(shape, line, offset); }, c.shape);
    for (int i = 0; i < all.count; ++i) {
      const auto s = static_cast<double>(all.s[static_cast<std::size_t>(i)] - line.begin);
      nearest = std::min(nearest, std::abs(s - step));
    }
    if (nearest < std::numeric_limits<double>::infinity()) {
      break;
    }
  }
  return nearest / c.unit;
}

void judge_point(const Case& c, const ShapeHit& hit, Tally& tally) {
  const SurfacePoint p =
      std::visit([&](const auto& shape) { return surface_point(shape, c.ray, hit); }, c.shape);
  tally.normal_error = std::max(tally.normal_error, std::abs(glm::length(p.normal) - 1));
  tally.point_error = std::max(tally.point_error, distance_along_normal(c, p));
}

/// A dispute, decided with more digits: for the shape as it is, and moved by the resolved gap. (A
/// chord that is one gap deep ends four gaps below the tangent at its beginning.)
template <class T>
void settle(const Case& c, const OptionalHit& hit, Tally& tally) {
  const auto exact = exact_first<T>(c, 0);
  if (compare(c, exact, hit, resolved_gap).agrees) {
    return;
  }
  ++tally.disputes;
  const bool missed = exact && (!hit || T(hit->t) > exact->t);
  for (const double offset : {resolved_gap * c.unit, -resolved_gap * c.unit}) {
    if (compare(c, exact_first<T>(c, offset), hit, 4 * resolved_gap).agrees) {
      ++(missed ? tally.missed_below_resolution : tally.false_below_resolution);
      return;
    }
  }
  ++(missed ? tally.missed : tally.false_hits);
}

}  // namespace

OptionalHit own_solver(const Shape& shape, const Ray& ray) {
  return std::visit(
      [&](const auto& s) {
        return intersect(s, ray, std::numeric_limits<double>::infinity(), RayStart{});
      },
      shape);
}

double Tally::relative_t_at(double quantile) {
  if (relative_t.empty()) {
    return 0;
  }
  const auto at = relative_t.begin() + static_cast<std::ptrdiff_t>(
                                           quantile * static_cast<double>(relative_t.size() - 1));
  std::nth_element(relative_t.begin(), at, relative_t.end());
  return *at;
}

Tally run(const Family& family, const Solver& solver, long count, std::uint64_t seed) {
  Random random(seed);
  Tally tally;
  for (; tally.rays < count; ++tally.rays) {
    const Case c = make_case(family, random);
    const OptionalHit hit = solver(c.shape, c.ray);
    const Comparison comparison = compare(c, exact_first<DoubleDouble>(c, 0), hit, resolved_gap);
    if (!comparison.agrees) {
      // With 50 digits, unless the solver is so bad that it does not matter and takes hours.
      constexpr long careful = 1000;
      tally.disputes < careful ? settle<Decimal>(c, hit, tally)
                               : settle<DoubleDouble>(c, hit, tally);
      continue;
    }
    if (hit) {
      ++tally.hits;
      tally.error = std::max(tally.error, comparison.error);
      tally.relative_t.push_back(comparison.relative_t);
      if (tally.hits % 16 == 0) {
        judge_point(c, *hit, tally);
      }
    }
  }
  return tally;
}

std::vector<std::string> complaints(const Family& family, Tally& tally) {
  std::vector<std::string> out;
  const auto demand = [&](bool holds, const std::string& what) {
    if (!holds) {
      out.push_back(family.name() + ": " + what);
    }
  };
  const auto per_million = [&](long n) {
    return 1e6 * static_cast<double>(n) / static_cast<double>(tally.rays);
  };
  demand(tally.missed == 0, std::to_string(tally.missed) + " missed");
  demand(tally.false_hits == 0, std::to_string(tally.false_hits) + " false hits");
  demand(tally.error <= family.limit,
         "error " + std::to_string(tally.error / family.limit) + " times the limit");
  demand(tally.point_error <= 1e-14, "surface point off by " + std::to_string(tally.point_error));
  demand(tally.normal_error <= 1e-14, "normal not of unit length");
  if (family.kind == Kind::double_root) {
    demand(per_million(tally.missed_below_resolution) < 500, "too many double roots missed");
    demand(per_million(tally.false_below_resolution) < 800, "too many double roots hit falsely");
  }
  if (family.kind == Kind::random) {
    demand(tally.relative_t_at(0.999) <= 1e-13, "t inaccurate");
  }
  return out;
}

}  // namespace rt::stability
