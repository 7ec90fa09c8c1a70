#include "rt/scene/motion.h"

#include <algorithm>
#include <cmath>

#include "rt/math/warp.h"

namespace rt {
namespace {

/// Rotation about an axis through the origin, right-handed (Rodrigues' formula).
Mat3 rotation_about(const Vec3& axis, double degrees) {
  const Vec3 a = glm::normalize(axis / max_abs(axis));
  const double angle = degrees * pi / 180.0;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Mat3 cross(0.0, a.z, -a.y, -a.z, 0.0, a.x, a.y, -a.x, 0.0);
  return c * Mat3(1.0) + (1.0 - c) * glm::outerProduct(a, a) + s * cross;
}

}  // namespace

Affine Pose::affine() const {
  const Affine turned{degrees == 0.0 ? Mat3(1.0) : rotation_about(axis, degrees), Vec3(0.0)};
  return Affine::translation(translate + about) * (turned * Affine::scaling(scale)) *
         Affine::translation(-about);
}

Pose between(const Pose& a, const Pose& b, double share) {
  // The same turn told about the opposite axis: axes no more than a right angle apart do not mix to
  // nothing.
  const bool both = a.degrees != 0.0 && b.degrees != 0.0;
  const double side = both && glm::dot(a.axis, b.axis) < 0.0 ? -1.0 : 1.0;
  Pose p;
  p.translate = glm::mix(a.translate, b.translate, share);
  p.axis = a.degrees == 0.0   ? b.axis
           : b.degrees == 0.0 ? a.axis
           : a.axis == b.axis ? a.axis
                              : glm::mix(a.axis, side * b.axis, share);
  p.degrees = std::lerp(a.degrees, side * b.degrees, share);
  p.scale = glm::mix(a.scale, b.scale, share);
  p.about = glm::mix(a.about, b.about, share);
  return p;
}

Affine Motion::at(double time) const {
  const auto after = std::find_if(keys.begin() + 1, keys.end() - 1,
                                  [&](const MotionKey& key) { return key.time >= time; });
  const MotionKey& a = *(after - 1);
  const MotionKey& b = *after;
  return between(a.pose, b.pose, (time - a.time) / (b.time - a.time)).affine();
}

Affine MotionPath::at(double time) const {
  Affine all;
  for (const Link& link : links) {
    all = all * (link.motion ? link.motion->at(time) * link.fixed : link.fixed);
  }
  return all;
}

std::shared_ptr<const MotionPath> extended(const std::shared_ptr<const MotionPath>& path,
                                           MotionPath::Link link) {
  auto longer = std::make_shared<MotionPath>();
  if (path) {
    longer->links.reserve(path->links.size() + 1);
    longer->links = path->links;
  }
  longer->links.push_back(std::move(link));
  return longer;
}

}  // namespace rt
