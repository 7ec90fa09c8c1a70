#pragma once
#include <optional>

namespace rt {

/// A stretch of the line on which a polynomial has curvature of one sign.
struct Piece {
  double begin;
  double end;
  bool convex;
};

/// Looks for the first place in a piece where f loses the sign it has just after piece.begin. The
/// caller knows that sign (from the piece before, or by analysis) better than rounding does.
///
/// With f taken positive there are two cases, and in both Newton's iteration is monotone and cannot
/// pass a root. Convex: go right from the beginning, as long as f falls. Concave: there is a root
/// only if f is negative at the end; go left from there.
///
/// Stops when |f| is within `noise`, the rounding error of f, or when the next step would be below
/// `resolution`: the caller decides there whether the root is real.
template <class Polynomial>
std::optional<double> first_crossing(const Polynomial& f, const Piece& piece, double sign,
                                     double noise, double resolution) {
  constexpr int most_steps =
      80;  // a double root halves its distance each step: 53 in the worst case
  if (piece.convex == (sign > 0)) {
    double s = piece.begin;
    for (int i = 0; i < most_steps; ++i) {
      const double value = sign * f(s);
      const double slope = sign * f.slope(s);
      if (value <= noise && (noise > 0 || slope < 0)) {
        return s;
      }
      if (!(slope < 0)) {
        return std::nullopt;  // past the minimum
      }
      const double step = -value / slope;
      if (!(s + step < piece.end)) {
        return std::nullopt;  // f stays above its tangent
      }
      s += step;
      if (step <= resolution) {
        return s;
      }
    }
    return s;
  }
  double s = piece.end;
  for (int i = 0; i < most_steps; ++i) {
    const double value = sign * f(s);
    const double slope = sign * f.slope(s);
    if (value > (i == 0 ? 0 : -noise)) {
      return i == 0 ? std::nullopt : std::optional(s);
    }
    const double step = value / slope;
    if (!(slope < 0 && s - step > piece.begin)) {
      return piece.begin;
    }
    s -= step;
    if (step <= resolution) {
      return s;
    }
  }
  return s;
}

}  // namespace rt
