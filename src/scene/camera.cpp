#include "rt/scene/camera.h"

#include <fmt/format.h>

#include <cmath>

#include "rt/math/rounding.h"
#include "rt/scene/error.h"

namespace rt {
namespace {

std::string text(const Vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

/// The direction so far on the arc from one to the other, evenly.
Vec3 turned(const Vec3& from, const Vec3& to, double share) {
  const Vec3 a = glm::normalize(from / max_abs(from));
  const Vec3 b = glm::normalize(to / max_abs(to));
  const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  if (angle < gamma(8)) {  // the same, as far as rounding can tell
    return a;
  }
  return std::sin((1.0 - share) * angle) * a + std::sin(share * angle) * b;
}

}  // namespace

Camera at_time(const Camera& camera, double time) {
  if (!camera.to) {
    return camera;
  }
  const Camera& to = *camera.to;
  Camera at = camera;
  at.to = nullptr;
  at.eye = glm::mix(camera.eye, to.eye, time);
  at.view = turned(camera.view, to.view, time);
  at.up = turned(camera.up, to.up, time);
  at.fov = std::lerp(camera.fov, to.fov, time);
  return at;
}

void check(const Camera& camera) {
  if (!all_finite(camera.eye) || !all_finite(camera.view) || !all_finite(camera.up)) {
    throw SceneError(fmt::format("camera: expected finite numbers, got eye {}, view {}, up {}",
                                 text(camera.eye), text(camera.view), text(camera.up)));
  }
  const double view_size = max_abs(camera.view);
  const double up_size = max_abs(camera.up);
  if (view_size == 0.0) {
    throw SceneError("camera: the view direction is (0, 0, 0); give the direction to look in");
  }
  if (up_size == 0.0) {
    throw SceneError("camera: the up vector is (0, 0, 0); (0, 1, 0) is the usual one");
  }
  // Scaled first, so that neither tiny nor huge vectors under- or overflow. Below the rounding
  // error of the cross product the two are parallel as far as their numbers can tell.
  const Vec3 right = glm::cross(camera.view / view_size, camera.up / up_size);
  if (max_abs(right) <= gamma(4)) {
    throw SceneError(
        fmt::format("camera: the up vector {} is parallel to the view direction {}; choose another",
                    text(camera.up), text(camera.view)));
  }
  if (!(camera.fov > 0.0 && camera.fov < 180.0)) {
    throw SceneError(fmt::format(
        "camera: expected a vertical field of view between 0 and 180 degrees, got {}", camera.fov));
  }
  if (!(camera.aperture >= 0.0 && std::isfinite(camera.aperture))) {
    throw SceneError(fmt::format(
        "camera: expected an aperture (the lens' diameter) of 0 or more, got {}", camera.aperture));
  }
  if (!(camera.focus > 0.0 && std::isfinite(camera.focus))) {
    throw SceneError(
        fmt::format("camera: expected a focus (a distance) above 0, got {}", camera.focus));
  }
  if (camera.to) {
    check(*camera.to);
    // Halfway nothing may have vanished: directions that are opposite have no arc between them.
    check(at_time(camera, 0.5));
  }
}

}  // namespace rt
