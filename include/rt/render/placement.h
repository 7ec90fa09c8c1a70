#pragma once
/// Where an instance is: once for all, or at a time.
#include <functional>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"
#include "rt/math/transform.h"

namespace rt {

/// v made a unit vector. Scaled by its largest entry first: a world 1e200 times smaller or larger
/// still has unit normals.
inline Vec3 scaled_to_unit(const Vec3& v) { return glm::normalize(v / max_abs(v)); }

struct Placement {
  Affine render_from_model;
  Affine model_from_render;
  bool moved_only = false;        ///< the linear parts are identities
  double model_per_render = 1.0;  ///< norm of model_from_render: bounds how errors grow
  double render_per_model = 1.0;

  Placement() = default;
  Placement(const Affine& to_render, const Affine& to_model);

  /// A ray of render space in model space, with the same parameter t.
  Ray ray(const Ray& in_render) const {
    return moved_only ? Ray{in_render.origin + model_from_render.offset, in_render.direction}
                      : Ray{model_from_render.point(in_render.origin),
                            model_from_render.vector(in_render.direction)};
  }
  /// A model's unit normal in render space: normals map by the inverse transpose.
  Vec3 render_normal(const Vec3& n) const {
    // n * m is transpose(m) n.
    return moved_only ? n : scaled_to_unit(n * model_from_render.linear);
  }
};

/// Render space from model space at even times over the open shutter; linear between. The corners
/// of the model's box are nowhere off their true path by more than a tenth of a pixel.
struct PlannedMotion {
  std::vector<Affine> keys;  ///< at least 2

  /// At a time in [0,1].
  Placement at(double time) const;
  /// Holds the box at all times: what is linear between keys stays in the hull of their boxes.
  Bounds bounds(const Bounds& model_box) const;
};

/// Keys dense enough that a point of the model's box is off by at most `tolerance` times its
/// distance from the origin, the eye. `path(t)` is render space from model space, t in [0,1].
PlannedMotion planned_motion(const std::function<Affine(double)>& path, const Bounds& model_box,
                             double tolerance);

}  // namespace rt
