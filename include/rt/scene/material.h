#pragma once
#include "rt/math/vec.h"

namespace rt {

/// A Phong material. Colours are linear and not negative.
struct Material {
  Rgb kd{0.5};              ///< diffuse reflectance
  Rgb ks{0.0};              ///< strength of the highlight of lights
  double shininess = 1.0;   ///< Phong exponent, >= 0
  Rgb reflectivity{0.0};    ///< mirror reflection of opaque surfaces
  double ior = 1.0;         ///< index of refraction, > 0; matters where opacity < 1
  double opacity = 1.0;     ///< in [0,1]; the rest is transmitted
  double glossiness = 0.0;  ///< in [0,1]: 0 is a perfect mirror
  Rgb absorption{0.0};      ///< Beer-Lambert, per world unit inside
  Rgb emission{0.0};        ///< radiance added at the surface
};

}  // namespace rt
