#pragma once
/// Secondary rays: from a hit, carried to the world and back, to the next hit.
#include <string>
#include <vector>

#include "stability/families.h"

namespace rt::stability {

/// How a ray gets away from the surface it starts on.
enum class Policy {
  side,      ///< this program's: the shape is told to which side the ray leaves
  touching,  ///< this program's, for an equal shape in the same place: told the position error only
  offset,    ///< the origin moved along the normal by its rounding-error bound
  epsilon,   ///< only t > 1e-6 counts
};

/// A shape placed in the world: turned, scaled and moved by `offset` sizes.
struct Placement {
  Shape shape;
  double scale = 1;
  double offset = 0;
};

struct LeavingTally {
  long rays = 0;
  long false_hits = 0;  ///< a crossing that is not there: a surface that shadows itself
  long leaks = 0;       ///< no crossing where there is one: light gets in
  long wrong = 0;       ///< another crossing than the next one
  /// Wrong as well, but right for a shape moved by the error of the ray's origin.
  long below_resolution = 0;

  long failures() const { return false_hits + leaks + wrong; }
  void add(const LeavingTally& other);
};

/// Every shape that can be left, at scales 1e-8 to 1e8, at the origin and 1e3 sizes away from it.
std::vector<Placement> placements();

LeavingTally run_leaving(const Placement& placement, Policy policy, long count, std::uint64_t seed);

}  // namespace rt::stability
