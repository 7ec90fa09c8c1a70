#include "torus_quartic.h"

#include <algorithm>
#include <array>

#include "first_crossing.h"

namespace rt {

std::optional<double> first_quartic_root(const TorusLine& line, double begin, double end,
                                         double sign) {
  if (!(begin < end)) {
    return {};
  }
  const double size = line.size();
  const Quartic quartic = quartic_of(line.torus, line.line.origin, line.direction);
  // Convex but for the stretch between the inflections, if there are any.
  const double turn = quartic.c2 < 0 ? std::sqrt(-quartic.c2 / 6) : 0;
  const double left = std::clamp(-turn, begin, end);
  const double right = std::clamp(turn, begin, end);
  const std::array<Piece, 3> pieces{Piece{begin, left, true}, Piece{left, right, false},
                                    Piece{right, end, true}};
  const Accuracy accuracy{polynomial_noise * size * size * size * size, coarse_step(line.torus)};
  for (const Piece& piece : pieces) {
    if (!(piece.begin < piece.end)) {
      continue;
    }
    std::optional<double> s = first_crossing(quartic, piece, sign, accuracy);
    if (s) {
      s = finish_root(line, *s, sign, begin);
    }
    if (s) {
      return s;
    }
  }
  return {};
}

}  // namespace rt
