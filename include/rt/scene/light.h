#pragma once
#include <optional>
#include <string>

#include "rt/math/vec.h"

namespace rt {

/// A light that dims as 1 / (c0 + c1 d + c2 d^2), d the distance in world units.
struct Light {
  struct Falloff {
    double c0 = 1.0, c1 = 0.0, c2 = 0.0;
  };
  struct Rectangle {
    Vec3 u, v;  ///< full edges; the rectangle is centred about the light's position
  };

  Vec3 position{0.0};
  Rgb colour{1.0};
  Falloff falloff;
  double radius = 0.0;                 ///< > 0: a spherical light
  std::optional<Rectangle> rectangle;  ///< set: a rectangular light
  Vec3 travel{0.0};                    ///< how far it moves from time 0 to 1
  bool visible = false;                ///< seen by camera, mirror and glass rays
  std::string where;                   ///< script:line of its making, for messages
};

}  // namespace rt
