#pragma once
#include "rt/math/spherical_rectangle.h"
#include "rt/scene/light.h"

namespace rt {

/// A light in render space.
struct PlannedLight : Light {
  explicit PlannedLight(Light light) : Light(std::move(light)) {
    if (rectangle) {
      edges.emplace(rectangle->u, rectangle->v);
    }
  }
  bool extended() const { return radius > 0.0 || rectangle; }
  /// Of the rectangle, from where its edges run.
  Vec3 first_corner() const { return position - 0.5 * (edges->u + edges->v); }

  std::optional<RectangleEdges> edges;  ///< of the rectangle
};

}  // namespace rt
