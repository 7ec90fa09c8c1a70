#pragma once
#include <limits>

#include "rt/math/transform.h"
#include "rt/math/vec.h"

namespace rt {

/// An axis-aligned box; empty when any lo > hi, unbounded when a face is infinite.
struct Bounds {
  Vec3 lo{std::numeric_limits<double>::infinity()};
  Vec3 hi{-std::numeric_limits<double>::infinity()};

  bool empty() const;
  bool finite() const;
  Vec3 centre() const { return 0.5 * (lo + hi); }
  Vec3 extent() const { return hi - lo; }
  void extend(const Vec3& p);
  void extend(const Bounds& b);
};

/// A box that holds the image of `b`, rounded outward by the rounding error of the map. An
/// unbounded box stays unbounded.
Bounds transformed(const Affine& a, const Bounds& b);

}  // namespace rt
