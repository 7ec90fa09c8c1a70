#pragma once
#include <memory>

#include "rt/math/vec.h"

namespace rt {

/// A camera, pinhole unless it has an aperture. Pixel (0,0) is top left.
struct Camera {
  Vec3 eye{0.0};
  Vec3 view{0.0, 0.0, -1.0};  ///< direction, any length but zero
  Vec3 up{0.0, 1.0, 0.0};     ///< any vector not parallel to view
  double fov = 50.0;          ///< vertical field of view, degrees in (0,180)
  double aperture = 0.0;      ///< the lens' diameter, world units; 0: a pinhole
  /// Distance of the plane in focus, along the view direction, world units; > 0. Matters when there
  /// is an aperture.
  double focus = 1.0;
  std::shared_ptr<const Camera> to;  ///< where it is at time 1: eye, view, up and fov; null: still
};

/// The camera at a time in [0,1]: eye and fov change evenly, view and up turn between their
/// directions.
Camera at_time(const Camera& camera, double time);

/// Throws SceneError when the camera cannot make a picture: an up vector parallel to the view
/// direction, a zero view direction, a field of view outside (0,180), or a number not finite.
void check(const Camera& camera);

}  // namespace rt
