#pragma once
/// Rays that are hard on purpose. Every family is a function of its seed alone.
#include <cstdint>
#include <string>
#include <vector>

#include "rt/geometry/shape.h"

namespace rt::stability {

/// SplitMix64 (Steele, Lea & Flood 2014): the same numbers on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  double uniform(double lo = 0, double hi = 1);  ///< in [lo, hi)
  int below(int n);                              ///< 0 .. n - 1
  double sign() { return below(2) == 0 ? -1.0 : 1.0; }
  double power_of_ten(double lo, double hi);  ///< log-uniform
  Vec3 direction();                           ///< uniform on the unit sphere

 private:
  std::uint64_t state_;
};

/// One question to a solver: where does the ray first meet the shape? Lengths are judged relative
/// to `unit`, the shape's size.
struct Case {
  Shape shape;
  Ray ray;
  double unit = 1;
};

/// What makes a family hard; not every kind applies to every shape.
enum class Kind {
  random,       ///< from around, towards the bounds; direction's length 0.1 to 10
  grazing,      ///< passes a tangent point at 1e-3 to 1e-12 of the size, on either side
  double_root,  ///< tangent as exactly as doubles can say
  far,          ///< origin at 1 to 1e8 sizes
  far_grazing,  ///< both
  axis,         ///< parallel to a coordinate axis, zeros of either sign
  equatorial,   ///< in the plane y = 0, or within 1e-3 to 1e-16 of it
  inside,       ///< from a point of the solid
  edge,         ///< passes an edge, rim or join at 1e-3 to 1e-13
  thin,         ///< torus: r / R = 1e-1 to 1e-5, half of the rays grazing
  spindle,      ///< torus: r / R = 0.3 to 10, 1 among them, half of the rays grazing
  non_uniform,  ///< carried from a world in which the shape is stretched by up to 1e6 : 1
  scaled,       ///< sphere: radius 1e-8 to 1e8, half of the rays grazing
};

struct Family {
  std::string shape;
  Kind kind;
  /// Allowed error perpendicular to the surface, in units of the size.
  double limit;
  std::string name() const;
};

/// Every family of every shape, or of one.
std::vector<Family> families(const std::string& shape = "");

/// The next case of a family.
Case make_case(const Family& family, Random& random);

/// A point of the surface, uniform in its parameters, with its outward normal.
struct Spot {
  Vec3 position;
  Vec3 normal;
};
Spot spot_on(const Shape& shape, Random& random);

}  // namespace rt::stability
