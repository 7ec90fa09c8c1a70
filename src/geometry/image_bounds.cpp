#include "rt/geometry/image_bounds.h"

#include <cmath>

#include "rt/math/rounding.h"

namespace rt {

// Along an axis the image of a sum reaches as far as those of its parts together; with m the map's
// row of that axis a ball's reaches |m| times its radius, a disc's and a stretch's as far by what of
// m they see.
Bounds image_bounds(const Affine& map, const RoundHull& hull) {
  Bounds out;
  for (int row = 0; row < 3; ++row) {
    const Vec3 m(map.linear[0][row], map.linear[1][row], map.linear[2][row]);
    const double centre = map.offset[row] + glm::dot(m, hull.centre);
    const double reach = hull.disc * std::hypot(m.x, m.z) + hull.half * std::abs(m.y) +
                         hull.ball * std::hypot(m.x, m.y, m.z);
    const double magnitude =
        std::abs(map.offset[row]) + glm::dot(glm::abs(m), glm::abs(hull.centre)) + reach;
    const double slack = rounding_of_maps * magnitude;
    out.lo[row] = centre - reach - slack;
    out.hi[row] = centre + reach + slack;
  }
  return out;
}

}  // namespace rt
