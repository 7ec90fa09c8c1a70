#pragma once
/// How the ring's crossings are found for sure. F'' (see torus_ring.h) falls until the line is
/// nearest to the axis and rises from there on: F is convex except on one stretch about that place,
/// and has a dip on either side of it, or (F'' >= 0 there, that is D >= k^3 R^2) a single dip and
/// no such stretch. For a line that begins at F > 0 this proves:
/// 1. A root with F' < 0, before the concave stretch or without one, is the first: F' is smaller
///    still before it.
/// 2. When the first dip has none, or lies behind the line's beginning, a root with F' < 0 past the
///    axis is the first. Before it F is convex and falling, so positive, and on the concave stretch
///    no less than at its ends.
/// 3. When neither dip has one, and F is positive at the line's ends, there is none.
/// So it does not matter where a search begins, or how it gets near the root: what it finds is
/// judged where it is found.
///
/// Both dips are close to parabolas, since F is nearly a squared distance from the tube's circle.
#include "torus_ring.h"

namespace rt {

/// What is known of a dip.
enum class Dip {
  crossed,  ///< it has a falling root, and this is it
  missed,   ///< it has none
  touched,  ///< its lowest point is zero to within rounding
  unclear,
};

/// The falling root of the dip that `s` lies in; `s` moves to it, or to where it was judged.
/// Inlined by order: as a call it costs a tenth of the whole intersection.
[[gnu::always_inline]] inline Dip search_dip(const Ring& ring, double& s) {
  constexpr int most_steps = 8;  // one or two are the rule
  const double size2 = ring.size() * ring.size();
  for (int i = 0; i < most_steps; ++i) {
    const RingJet<double> jet = ring.at(s);
    // rho in (R + r) / 4 .. 1.42 (R + r): where the bounds on errors hold, and the torus is.
    const bool in_reach = (16 * jet.square >= size2) & (jet.square <= 2 * size2);
    if (!(in_reach & (jet.curvature > 0))) [[unlikely]] {
      return Dip::unclear;
    }
    const double doubt = 4 * ring.noise() * jet.curvature;
    if (jet.discriminant() <= doubt && is_near_lowest(ring, jet)) {
      if ((jet.value - ring.noise()) * jet.curvature > jet.slope * jet.slope) {
        return Dip::missed;
      }
      if (jet.discriminant() >= -doubt) {
        return Dip::touched;
      }
    }
    const RingStep<double> step = step_to_root(jet);
    s += step.length;
    if (settled(ring, jet, step)) {
      const bool falls = (step.fall > ring.slope_noise()) & (step.fall * step.fall > doubt);
      return falls ? Dip::crossed : Dip::unclear;
    }
  }
  return Dip::unclear;
}

/// What the first search of a line came to. Places are values of s.
struct Sighting {
  double begin, end;  ///< the line's part that counts
  double axis;        ///< where it is nearest to the axis
  double exit;        ///< where it leaves the hole; NaN if it does not pass through it
  double start;       ///< the search began there
  double found;       ///< and ended there; at `start` if there was none
  Dip dip;
};

/// The first crossing of a line for which `first` did not tell, from a beginning outside a torus
/// with a wide hole.
std::optional<double> look_again(const TorusLine& line, const Sighting& first);

}  // namespace rt
