#pragma once
#include <functional>
#include <vector>

#include "stability/families.h"

namespace rt::stability {

/// A solver under test.
using Solver = std::function<OptionalHit(const Shape&, const Ray&)>;

/// This program's own.
OptionalHit own_solver(const Shape& shape, const Ray& ray);

/// What came of a family's rays.
struct Tally {
  long rays = 0;
  long hits = 0;
  long missed = 0;  ///< a crossing that was not found, or found only after a later one
  long false_hits = 0;
  long disputes = 0;  ///< answers that are wrong, or right only for a moved surface
  /// Wrong as well, but right for a shape whose surface is moved by 1e-14 of its size: what doubles
  /// cannot be expected to tell.
  long missed_below_resolution = 0;
  long false_below_resolution = 0;
  /// The hit's distance from the surface along its normal, beyond the last place of t, in sizes.
  double error = 0;
  /// The same of surface_point(), and how far its normal is from unit length.
  double point_error = 0;
  double normal_error = 0;
  std::vector<double> relative_t;  ///< |t - exact| / exact of every hit

  double relative_t_at(double quantile);
};

/// Runs `count` cases of a family through a solver. Thread-free and deterministic in the seed.
Tally run(const Family& family, const Solver& solver, long count, std::uint64_t seed);

/// One line about each way in which a tally misses its figures; empty when it reaches them.
std::vector<std::string> complaints(const Family& family, Tally& tally);

}  // namespace rt::stability
