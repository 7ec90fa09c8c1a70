#include <algorithm>
#include <cmath>

#include "rt/geometry/exact.h"
#include "rt/math/rounding.h"
#include "stability/solvers.h"

/// x^4 + a x^3 + b x^2 + c x + d = (x^2 + p1 x + q1) (x^2 + p2 x + q2), after the idea of Orellana
/// & De Michele, "Algorithm 1010: Boosting efficiency in solving quartic equations with no
/// compromise in accuracy", ACM TOMS 46 (2020). The quartic is read as a quadratic form in (x^2, x,
/// 1), a dominant root of the resolvent makes it of rank two, the factors are found from whichever
/// of several equivalent formulas reproduces the coefficients best, and Newton's iteration on the
/// four coefficients of the factors removes what error is left. Here a = 0.
namespace rt::bench {
namespace {

struct Factors {
  double p1, q1, p2, q2;
};

/// The root of z^3 + g z + h that is largest in size, polished by Newton.
double dominant_root(double g, double h) {
  const double q = -g / 3;
  const double r = h / 2;
  double z;
  if (q > 0 && r * r < q * q * q) {
    const double angle = std::acos(std::clamp(r / (q * std::sqrt(q)), -1.0, 1.0));
    const double turn = r > 0 ? angle / 3 : (angle + 2 * std::acos(-1.0)) / 3;
    z = -2 * std::sqrt(q) * std::cos(turn);
  } else {
    const double u =
        -std::copysign(std::cbrt(std::abs(r) + std::sqrt(std::max(0.0, r * r - q * q * q))), r);
    z = u + (u != 0 ? q / u : 0);
  }
  for (int i = 0; i < 8; ++i) {
    const double value = (z * z + g) * z + h;
    const double slope = 3 * z * z + g;
    if (!(std::abs(value) > unit_roundoff * std::abs(h)) || slope == 0) {
      break;
    }
    z -= value / slope;
  }
  return z;
}

double relative(double wanted, double got) {
  return wanted != 0 ? std::abs((got - wanted) / wanted) : std::abs(got);
}

/// How badly factors reproduce the coefficients.
double misfit(const Factors& f, double b, double c, double d) {
  return relative(b, f.q1 + f.p1 * f.p2 + f.q2) + relative(c, f.p1 * f.q2 + f.q1 * f.p2) +
         relative(d, f.q1 * f.q2);
}

/// One Newton step on the coefficients; with p2 = -p1 and the sum of both as unknowns eliminated.
Factors refined(const Factors& f, double b, double c, double d) {
  // Residuals of b, c, d; unknown changes of p1 (p2 changes by the opposite), q1 and q2.
  const double rb = f.q1 + f.q2 + f.p1 * f.p2 - b;
  const double rc = difference_of_products(f.p1, f.q2, -f.q1, f.p2) - c;
  const double rd = f.q1 * f.q2 - d;
  const double bp = f.p2 - f.p1;
  const double cp = f.q2 - f.q1;
  // [bp 1 1; cp p2 p1; 0 q2 q1] (dp, d1, d2) = -(rb, rc, rd)
  const double minor_b = f.p2 * f.q1 - f.p1 * f.q2;
  const double minor_c = f.q1 - f.q2;
  const double det = bp * minor_b - cp * minor_c;
  if (det == 0) {
    return f;
  }
  const double dp = (-rb * minor_b + rc * minor_c - rd * (f.p1 - f.p2)) / det;
  const double d1 = (bp * (-rc * f.q1 + rd * f.p1) - cp * (-rb * f.q1 + rd)) / det;
  const double d2 = (bp * (-f.p2 * rd + f.q2 * rc) + cp * (rd - f.q2 * rb)) / det;
  return {f.p1 + dp, f.q1 + d1, f.p2 - dp, f.q2 + d2};
}

int quadratic_roots(double p, double q, double* roots) {
  const double discriminant = difference_of_products(p, p, 4, q);
  if (!(discriminant >= 0)) {
    return 0;
  }
  const double larger = -(p + std::copysign(std::sqrt(discriminant), p)) / 2;
  roots[0] = larger;
  roots[1] = larger != 0 ? q / larger : 0;
  return 2;
}

}  // namespace

int factored_roots(double b, double c, double d, double* roots) {
  const double g = -4 * d - b * b / 3;
  const double h = (8 * d - 2 * b * b / 9) * b / 3 - c * c;
  const double phi = dominant_root(g, h);
  const double middle = b / 6 + phi / 2;  // the constant term of the form's square
  const double d2 = 2 * b / 3 - phi;
  Factors f{};
  const double noise = 8 * unit_roundoff * (std::abs(b) + std::abs(phi));
  if (d2 < -noise) {
    const double root = std::sqrt(-d2);
    // Two formulas for the mixed term, of which one may cancel.
    const double first = c / (2 * d2);
    const double second = c != 0 ? 2 * (d - middle * middle) / c : first;
    const Factors with_first{root, middle + root * first, -root, middle - root * first};
    const Factors with_second{root, middle + root * second, -root, middle - root * second};
    f = misfit(with_first, b, c, d) <= misfit(with_second, b, c, d) ? with_first : with_second;
  } else if (d2 <= noise) {
    const double d3 = d - middle * middle;
    if (d3 > 0) {
      return 0;
    }
    const double root = std::sqrt(-d3);
    f = {0, middle + root, 0, middle - root};
  } else {
    return 0;  // two conjugate factors with complex coefficients: no real root
  }
  // The smaller of the constant terms from the product of both.
  (std::abs(f.q2) < std::abs(f.q1) ? f.q2 : f.q1) =
      d / (std::abs(f.q2) < std::abs(f.q1) ? f.q1 : f.q2);
  double best = misfit(f, b, c, d);
  for (int i = 0; i < 8 && best > 0; ++i) {
    const Factors next = refined(f, b, c, d);
    const double error = misfit(next, b, c, d);
    if (!(error < best)) {
      break;
    }
    f = next;
    best = error;
  }
  const int count = quadratic_roots(f.p1, f.q1, roots);
  return count + quadratic_roots(f.p2, f.q2, roots + count);
}

}  // namespace rt::bench
