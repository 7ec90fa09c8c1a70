#pragma once
#include "rt/geometry/torus.h"

namespace rt::stability {

/// Ferrari's closed form on the quartic as the textbooks expand it, at the ray's own origin: what
/// this suite exists to reject, and the yardstick of cost.
OptionalHit naive_ferrari(const Torus& torus, const Ray& ray);

/// Ferrari's closed form for y^4 + p y^2 + q y + r: the real roots, in no order; returns how many.
int depressed_ferrari(double p, double q, double r, double* roots);

}  // namespace rt::stability
