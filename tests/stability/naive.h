#pragma once
#include "rt/geometry/torus.h"

namespace rt::stability {

/// Ferrari's closed form on the quartic as the textbooks expand it, at the ray's own origin: what
/// this suite exists to reject, and the yardstick of cost.
OptionalHit naive_ferrari(const Torus& torus, const Ray& ray);

/// The smallest of the quartic's positive roots by Ferrari, a4 t^4 + ... + a0, or a negative
/// number.
double smallest_positive_ferrari(double a4, double a3, double a2, double a1, double a0);

}  // namespace rt::stability
