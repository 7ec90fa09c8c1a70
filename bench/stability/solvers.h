#pragma once
/// Torus solvers to compare with, for the bench alone. Each is written from the published idea.
#include <vector>

#include "rt/geometry/torus.h"

namespace rt::bench {

using TorusSolver = OptionalHit (*)(const Torus&, const Ray&);

struct Method {
  const char* name;
  TorusSolver solve;
};

/// This program's first, then: Ferrari on the quartic as expanded at the ray's origin; and, all
/// after the same clipping and recentring as this program's, Ferrari, the companion matrix'
/// eigenvalues, and a factorisation into two quadratics in the manner of Orellana & De Michele
/// (ACM TOMS 1010, 2020).
std::vector<Method> torus_methods();

/// The real roots of s^4 + c2 s^2 + c1 s + c0, in no order, into `roots`; returns how many.
int companion_roots(double c2, double c1, double c0, double* roots);
int factored_roots(double c2, double c1, double c0, double* roots);

}  // namespace rt::bench
