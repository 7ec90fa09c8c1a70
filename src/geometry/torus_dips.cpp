#include "torus_dips.h"

#include "convex.h"
#include "torus_quartic.h"

namespace rt {
namespace {

struct Finding {
  Dip dip;
  double s;
};

/// A search from one step beyond `jet`, of which only what it finds after `least` counts.
Finding search_from(const Ring& ring, const RingJet<double>& jet, double start, double least) {
  double s = start + step_to_root(jet).length;
  const Dip dip = search_dip(ring, s);
  return {s > least ? dip : Dip::unclear, s};
}

/// In the dip that the line begins with.
Finding near_dip(const Ring& ring, const Sighting& line) {
  const RingJet<double> jet = ring.at(line.start);
  const bool convex = ring.has_one_dip() || jet.curvature > 0;
  if (convex && jet.slope < 0) {
    const Finding near = search_from(ring, jet, line.start, line.begin);
    const bool strayed = !ring.has_one_dip() && (near.s < line.axis) != (line.start < line.axis);
    return {strayed ? Dip::unclear : near.dip, near.s};
  }
  // Where it is concave a dip lies ahead past the axis, on whichever side of it the line begins.
  return {jet.value > ring.noise() ? Dip::missed : Dip::unclear, convex ? line.start : line.axis};
}

/// In the dip past the axis, searched from where the line leaves the hole or, where it is concave
/// there or does not pass through the hole, back from its end.
Finding far_dip(const Ring& ring, const Sighting& line) {
  const double least = std::max(line.begin, line.axis);
  if (line.exit >= line.end) {
    return {Dip::missed, line.end};
  }
  if (line.exit > line.axis) {
    const RingJet<double> jet = ring.at(line.exit);
    if (jet.curvature > 0) {
      return jet.slope < 0
                 ? search_from(ring, jet, line.exit, least)
                 : Finding{jet.value > ring.noise() ? Dip::missed : Dip::unclear, line.exit};
    }
  }
  const RingJet<double> last = ring.at(line.end);
  if (!(last.value > ring.noise())) {
    return {Dip::unclear, line.end};
  }
  if (!(line.end > line.axis) || last.curvature <= 0 || last.slope <= 0) {
    return {Dip::missed, line.end};
  }
  return search_from(ring, last, line.end, least);
}

/// A root equal to its neighbour to within rounding: the geometric form decides. If it finds none
/// the dip has none, unless what it says is that the dip lies behind the line's beginning, or the
/// line goes in just past the dip: where it touches the torus along an asymptote, three roots
/// coincide, and F is below zero on the concave stretch.
Finding decided(const TorusLine& line, const Ring& ring, const Finding& at, double begin,
                double axis) {
  if (at.dip != Dip::touched) {
    return at;
  }
  if (const std::optional<double> root = finish_root(line, at.s, 1, begin)) {
    return {Dip::crossed, *root};
  }
  if (!ring.has_one_dip() && at.s < axis && !(ring.at(axis).value > ring.noise())) {
    return {Dip::unclear, at.s};
  }
  return {at.s > begin + 0x1p-10 * line.size() ? Dip::missed : Dip::unclear, at.s};
}

}  // namespace

std::optional<double> look_again(const TorusLine& line, const Sighting& first) {
  const Ring ring(line.line.origin, line.direction, line.torus);
  const bool searched = first.found != first.start;
  Finding at =
      decided(line, ring, searched ? Finding{first.dip, first.found} : near_dip(ring, first),
              first.begin, first.axis);
  if (at.dip == Dip::missed && !ring.has_one_dip() && !(at.s > first.axis)) {
    at = decided(line, ring, far_dip(ring, first), first.begin, first.axis);
  }
  switch (at.dip) {
    case Dip::crossed:
      return at.s;
    case Dip::missed:
      return {};
    default:
      return first_quartic_root(line, first.begin, first.end, 1);
  }
}

}  // namespace rt
