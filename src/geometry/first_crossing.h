#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "rt/math/rounding.h"

namespace rt {

/// A stretch of the line on which a polynomial has curvature of one sign, largest in size or
/// smallest at one of its ends.
struct Piece {
  double begin;
  double end;
  bool convex;
};

/// What is computed of a polynomial, and how well.
struct Accuracy {
  double noise;       ///< its rounding error
  double resolution;  ///< steps below this are left to the caller
};

/// The least curvature of f, times sign, between two points of a piece; zero if that is negative.
template <class Polynomial>
double least_curvature(const Polynomial& f, double a, double b, double sign) {
  return std::max(0.0, std::min(sign * f.curvature(a), sign * f.curvature(b)));
}

/// Finds the first root of a convex piece on which f (times sign) begins positive: goes right as
/// long as f falls. Newton's steps do while they converge well. Otherwise a step solves a parabola
/// that touches f at s and has the least curvature between s and twice Newton's step: it lies below
/// f up to there, and has its first root, if any, before. So no step passes a root, a parabola
/// without a root proves that there is none, and near-double roots, on which Newton's steps only
/// halve the distance, cost little more than others.
template <class Polynomial>
std::optional<double> convex_crossing(const Polynomial& f, const Piece& piece, double sign,
                                      const Accuracy& accuracy) {
  constexpr int most_steps = 80;  // Newton alone would need at most 53; two or three are the rule
  double s = piece.begin;
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps; ++i) {
    const double value = sign * f(s);
    const double slope = sign * f.slope(s);
    if (value <= accuracy.noise && (accuracy.noise > 0 || slope < 0)) {
      return s;
    }
    if (!(slope < 0)) {
      return std::nullopt;  // past the minimum
    }
    const double newton = -value / slope;
    if (!(s + newton < piece.end)) {
      return std::nullopt;  // f stays above its tangent
    }
    double step = newton;
    if (!(value < 0.1 * previous)) {  // near a double root Newton leaves a quarter
      const double ahead = std::min(s + 2 * newton, piece.end);
      const double curvature = least_curvature(f, s, ahead, sign);
      const double discriminant = slope * slope - 2 * value * curvature;
      if (discriminant < 0) {
        const bool clear = 2 * (value - accuracy.noise) * curvature > slope * slope;
        return clear ? std::nullopt : std::optional(s - slope / curvature);
      }
      step = 2 * value / (std::sqrt(discriminant) - slope);
    }
    previous = value;
    s += step;
    if (!(s < piece.end)) {
      return std::nullopt;
    }
    if (newton <= std::max(accuracy.resolution, 2 * unit_roundoff * s)) {
      return s;
    }
  }
  return s;
}

/// The same on a concave piece: there is a root only if f is negative at the end. From there Newton
/// goes left without passing it.
template <class Polynomial>
std::optional<double> concave_crossing(const Polynomial& f, const Piece& piece, double sign,
                                       const Accuracy& accuracy) {
  constexpr int most_steps = 80;
  double s = piece.end;
  double value = sign * f(s);
  if (value > 0) {
    return std::nullopt;
  }
  for (int i = 0; i < most_steps && value < -accuracy.noise; ++i) {
    const double slope = sign * f.slope(s);
    const double step = value / slope;
    if (!(slope < 0 && s - step > piece.begin)) {
      return piece.begin;
    }
    s -= step;
    if (step <= std::max(accuracy.resolution, 2 * unit_roundoff * s)) {
      return s;
    }
    value = sign * f(s);
  }
  return s;
}

/// Looks for the first place in a piece where f loses the sign it has just after piece.begin. The
/// caller knows that sign (from the piece before, or by analysis) better than rounding does. What
/// comes back is a root to within the resolution, or a place where |f| is within the noise: whether
/// there is a root the caller decides.
template <class Polynomial>
std::optional<double> first_crossing(const Polynomial& f, const Piece& piece, double sign,
                                     const Accuracy& accuracy) {
  return piece.convex == (sign > 0) ? convex_crossing(f, piece, sign, accuracy)
                                    : concave_crossing(f, piece, sign, accuracy);
}

}  // namespace rt
