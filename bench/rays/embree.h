#pragma once
/// What Embree does with a subject when nothing of ours stands about it: the rays per second that
/// can be had.
#include <embree3/rtcore.h>

#include "rays/scenes.h"

namespace rt::bench {

/// A subject as a scene of Embree's, in render space: triangles its own, balls as user geometry
/// whose leaves compute in double precision.
class RawEmbree {
 public:
  /// `eye`: what lies at render space's origin.
  RawEmbree(const Subject& subject, const Vec3& eye);
  ~RawEmbree();
  RawEmbree(const RawEmbree&) = delete;
  RawEmbree& operator=(const RawEmbree&) = delete;

  /// Distance to the nearest crossing; infinite where there is none.
  float closest(const TraceRay& ray) const;
  bool occluded(const TraceRay& ray, double reach) const;

 private:
  RTCDevice device_;
  RTCScene scene_;
  std::vector<Sphere> balls_;
};

}  // namespace rt::bench
