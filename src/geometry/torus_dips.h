#pragma once
/// Along a line with o . d = 0 and |d| = 1 the ring's factor is F(s) = s^2 + a - 2 R rho(s), rho
/// the distance from the axis. With k = dx^2 + dz^2 and D = (ox dz - oz dx)^2, which is rho^2 (k -
/// rho'^2), the derivatives are rho' = (k s + ox dx + oz dz) / rho and rho'' = D / rho^3, hence
///   F'' = 2 - 2 R D / rho^3,  F''' = 6 R D rho' / rho^4,
///   F'''' = 6 R D (D - 4 rho^2 rho'^2) / rho^7, at most 6 R / rho^3 in size, as D / rho^2 and
///   rho'^2 add up to at most 1 (D (D - 4 rho^2 rho'^2) is at most rho^4 in size).
///
/// So F'' falls until the line is nearest to the axis and rises from there on: F is convex except
/// on one stretch about that place, and has a dip on either side of it, or (F'' >= 0 there, that is
/// D >= k^3 R^2) a single dip and no such stretch. For a line that begins at F > 0 this proves:
/// 1. A root with F' < 0, before the concave stretch or without one, is the first: F' is smaller
///    still before it.
/// 2. When the first dip has none, a root with F' < 0 past the axis is the first. Before it F is
///    convex and falling, so positive, and on the concave stretch no less than at its ends.
/// 3. When neither dip has one, and F is positive at the chord's ends, there is none.
/// Both dips are close to parabolas, since F is nearly a squared distance from the tube's circle.
#include "convex.h"
#include "rt/math/rounding.h"
#include "torus_form.h"

namespace rt {

/// Whether the hole is wide enough that the ring's features are all of the tube's size. Elsewhere
/// (a spindle's tips, where two sheets meet) they can be much smaller.
inline bool has_wide_hole(const Torus& torus) {
  return 2 * torus.minor_radius <= torus.major_radius;
}

/// What a search found out: the first crossing, infinity if there is none, or that it cannot tell.
struct Verdict {
  bool certain;
  double s;
};

/// The ring's factor and its derivatives at one place.
struct RingJet {
  double value, slope, curvature;
  double twist;   ///< a sixth of the third derivative
  double square;  ///< rho^2

  double discriminant() const { return slope * slope - 2 * value * curvature; }
};

/// The ring's factor along a line: o its point nearest to the centre, d of unit length.
struct RingAlongLine {
  Vec3 o, d;
  double R, r;
  double k = d.x * d.x + d.z * d.z;
  double b = o.x * d.x + o.z * d.z;
  double D = (o.x * d.z - o.z * d.x) * (o.x * d.z - o.z * d.x);

  double size() const { return R + r; }
  bool has_one_dip() const { return D >= k * k * k * R * R; }

  /// The place is known to 4 u (R + r) and rho to the same, which the value takes times 2 |p| and
  /// 2 |w|; its own roundings add a few u (R + r)^2.
  double noise() const { return 64 * unit_roundoff * size() * size(); }

  /// Both terms of the slope are at most 2 (R + r), after at most ten roundings each, and in `b`
  /// (and o . d, which is not quite 0) a few u (R + r) come times R / rho, below 4 where the
  /// slope's sign matters.
  double slope_noise() const { return 128 * unit_roundoff * size(); }

  RingJet at(double s) const {
    const Vec3 p = fused_at(o, d, s);
    const double square = p.x * p.x + p.z * p.z;
    const double rho = std::sqrt(square);
    const double inverse_square = 1 / square;
    const double ratio = rho * (R * inverse_square);
    const double w = rho - R;
    const double climb = k * s + b;
    const double bend = ratio * (D * inverse_square);
    return {w * w + (p.y - r) * (p.y + r), 2 * (s - climb * ratio), 2 - 2 * bend,
            bend * (climb * inverse_square), square};
  }
};

/// A step to the first root of the parabola that fits, or to its vertex if it has none. `fall`: how
/// steeply it falls at that root.
struct RingStep {
  double length, fall;
};

/// Both ways to write the root share one division; they are chosen without a branch, which would be
/// mispredicted half of the time.
inline RingStep step_to_root(const RingJet& jet) {
  const double discriminant = jet.discriminant();
  const bool real = discriminant >= 0;
  const double fall = std::sqrt(real ? discriminant : 0.0);
  const bool falling = real & (jet.slope < 0);
  const double numerator = falling ? 2 * jet.value : -(jet.slope + fall);
  const double denominator = falling ? fall - jet.slope : jet.curvature;
  return {numerator / denominator, fall};
}

/// The step lands within 2 u (R + r) of the root. What it leaves is the cubic term, and the quartic
/// one (R / (4 rho^3) of the fourth power, rho >= (R + r) / 4), over the slope.
inline bool settled(const RingAlongLine& ring, const RingJet& jet, const RingStep& step) {
  const double h = std::abs(step.length);
  const double size = ring.size();
  return h * h * h * (std::abs(jet.twist) * jet.square * size + ring.R * h) <=
         2 * unit_roundoff * size * size * step.fall * jet.square;
}

/// Whether the dip's lowest point is within twice Newton's step to it, delta = |F'| / F'', because
/// F'' is at least half its value up to there. Then it is no lower than F - F'^2 / F''.
///
/// |F'''| <= 2.4 R / rho^2, for D |rho'| is at most 0.39 rho^2. Let 24 R delta <= F'' rho^2. Then
/// delta <= rho^2 / (12 R), below 0.18 rho as rho < 2.13 R (see search_dip), rho does not fall
/// below 0.64 of its value within 2 delta, |F'''| stays below 5.9 R / rho^2, and F'' changes by
/// less than 11.8 R delta / rho^2, less than half.
inline bool is_near_lowest(const RingAlongLine& ring, const RingJet& jet) {
  return 24 * ring.R * std::abs(jet.slope) <= jet.curvature * jet.curvature * jet.square;
}

/// A root equal to its neighbour to within rounding: the geometric form decides. If it finds none
/// the dip has none, unless what it says is that the dip lies behind the line's beginning.
inline Verdict decide_double_root(const TorusLine& line, double begin, double s) {
  const std::optional<double> root = finish_root(line, s, 1, begin);
  return root ? Verdict{true, *root} : Verdict{s > begin + 0x1p-10 * line.size(), infinity};
}

/// The falling root of the dip that `s`, with `jet`, lies in; infinity if it has none. Inlined by
/// order: as a call it costs a tenth of the whole intersection.
[[gnu::always_inline]] inline Verdict search_dip(const RingAlongLine& ring, const TorusLine& line,
                                                 double begin, RingJet jet, double s) {
  constexpr int most_steps = 8;  // one or two are the rule
  const double size2 = ring.size() * ring.size();
  s += step_to_root(jet).length;
  for (int i = 0; i < most_steps; ++i) {
    jet = ring.at(s);
    // rho in (R + r) / 4 .. 1.42 (R + r): where the bounds on errors hold, and the torus is.
    const bool in_reach = (16 * jet.square >= size2) & (jet.square <= 2 * size2);
    if (!(in_reach & (jet.curvature > 0))) [[unlikely]] {
      return {false, s};
    }
    const double doubt = 4 * ring.noise() * jet.curvature;
    if (jet.discriminant() <= doubt && is_near_lowest(ring, jet)) {
      if ((jet.value - ring.noise()) * jet.curvature > jet.slope * jet.slope) {
        return {true, infinity};
      }
      if (jet.discriminant() >= -doubt) {
        return decide_double_root(line, begin, s);
      }
    }
    const RingStep step = step_to_root(jet);
    s += step.length;
    if (settled(ring, jet, step)) {
      return {step.fall > ring.slope_noise() && step.fall * step.fall > doubt, s};
    }
  }
  return {false, s};
}

/// The first crossing of a line that begins outside a torus with a wide hole, by the ring's own
/// form: a few evaluations for most rays, grazing ones too. It answers only what it can prove and
/// leaves the rest (double roots to within rounding, above all) to the search on the quartic.
/// The chord is not empty.
inline Verdict crossing_from_outside(const TorusLine& line, const Chord& chord) {
  const RingAlongLine ring{line.line.origin, line.direction, line.torus.major_radius,
                           line.torus.minor_radius};
  const bool one_dip = ring.has_one_dip();
  const double axis = -ring.b / ring.k;  // used only with two dips: k > 0
  const RingJet first = ring.at(chord.t_in);
  const bool before_axis = one_dip | ((chord.t_in < axis) & (first.curvature > 0));
  if (before_axis & (first.slope < 0)) [[likely]] {
    const Verdict near = search_dip(ring, line, chord.t_in, first, chord.t_in);
    if (!near.certain || near.s < infinity) {
      return {near.certain && near.s > chord.t_in && (one_dip || near.s < axis), near.s};
    }
  } else if (!(first.value > ring.noise())) {
    return {false, chord.t_in};
  }
  if (one_dip) {
    return {true, infinity};
  }
  const RingJet last = ring.at(chord.t_out);
  if (!(last.value > ring.noise())) {
    return {false, chord.t_out};
  }
  if (!(chord.t_out > axis) | (last.curvature <= 0) | (last.slope <= 0)) {
    return {true, infinity};
  }
  const Verdict far = search_dip(ring, line, chord.t_in, last, chord.t_out);
  return {far.certain && far.s > chord.t_in && far.s > axis, far.s};
}

}  // namespace rt
