#include "rays/embree.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace rt::bench {
namespace {

// Embree has no notion of the surface a ray leaves: it begins a little off, in terms of the
// subject's size of a few units, as its users do.
constexpr float off_the_surface = 1e-4F;

/// The crossing of a ball nearest beyond tnear, in double precision.
bool crossing(const Sphere& ball, const RTCRay& ray, double& t) {
  const Vec3 d(ray.dir_x, ray.dir_y, ray.dir_z);
  const Vec3 o = Vec3(ray.org_x, ray.org_y, ray.org_z) - ball.centre;
  const double scale = 1.0 / glm::dot(d, d);
  const double middle = -glm::dot(o, d) * scale;
  const Vec3 nearest = o + middle * d;
  const double rest = ball.radius * ball.radius - glm::dot(nearest, nearest);
  if (!(rest >= 0.0)) {
    return false;
  }
  const double half = std::sqrt(rest * scale);
  t = middle - half > double{ray.tnear} ? middle - half : middle + half;
  return t > double{ray.tnear} && t < double{ray.tfar};
}

void bounds_of(const RTCBoundsFunctionArguments* a) {
  const Sphere& ball = static_cast<const Sphere*>(a->geometryUserPtr)[a->primID];
  const auto below = [&](double v) { return std::nextafter(static_cast<float>(v), -INFINITY); };
  const auto above = [&](double v) { return std::nextafter(static_cast<float>(v), INFINITY); };
  const Vec3 lo = ball.centre - ball.radius;
  const Vec3 hi = ball.centre + ball.radius;
  *a->bounds_o = {below(lo.x), below(lo.y), below(lo.z), 0,
                  above(hi.x), above(hi.y), above(hi.z), 0};
}

void intersect_leaf(const RTCIntersectFunctionNArguments* a) {
  auto& both = *reinterpret_cast<RTCRayHit*>(a->rayhit);
  double t = 0.0;
  if (a->valid[0] != 0 &&
      crossing(static_cast<const Sphere*>(a->geometryUserPtr)[a->primID], both.ray, t)) {
    both.ray.tfar = static_cast<float>(t);
    both.hit.primID = a->primID;
    both.hit.geomID = a->geomID;
  }
}

void occluded_leaf(const RTCOccludedFunctionNArguments* a) {
  auto& ray = *reinterpret_cast<RTCRay*>(a->ray);
  double t = 0.0;
  if (a->valid[0] != 0 &&
      crossing(static_cast<const Sphere*>(a->geometryUserPtr)[a->primID], ray, t)) {
    ray.tfar = -std::numeric_limits<float>::infinity();
  }
}

RTCGeometry geometry_of(RTCDevice device, const std::vector<Sphere>& balls) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(balls.size()));
  rtcSetGeometryUserData(geometry, const_cast<Sphere*>(balls.data()));
  rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_leaf);
  rtcSetGeometryOccludedFunction(geometry, occluded_leaf);
  return geometry;
}

RTCGeometry geometry_of(RTCDevice device, const MeshData& mesh, const Vec3& eye) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             mesh.positions.size()));
  for (const Vec3& p : mesh.positions) {
    for (int k = 0; k < 3; ++k) {
      *points++ = static_cast<float>(p[k] - eye[k]);
    }
  }
  void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          sizeof(Corners), mesh.triangles.size());
  std::memcpy(corners, mesh.triangles.data(), mesh.triangles.size() * sizeof(Corners));
  return geometry;
}

RTCRay single(const TraceRay& ray, float reach) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.tnear = ray.leaving == Leaving::nothing ? 0.0F : off_the_surface;
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tfar = reach;
  r.mask = ~0U;
  return r;
}

}  // namespace

RawEmbree::RawEmbree(const Subject& subject, const Vec3& eye)
    : device_(rtcNewDevice("threads=1,set_affinity=0")),
      scene_(rtcNewScene(device_)),
      balls_(subject.balls) {
  for (Sphere& ball : balls_) {
    ball.centre -= eye;
  }
  const RTCGeometry geometry =
      subject.mesh ? geometry_of(device_, *subject.mesh, eye) : geometry_of(device_, balls_);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(scene_);
}

RawEmbree::~RawEmbree() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

float RawEmbree::closest(const TraceRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit both{single(ray, INFINITY), {}};
  both.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &both);
  return both.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : both.ray.tfar;
}

bool RawEmbree::occluded(const TraceRay& ray, double reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay r = single(ray, static_cast<float>(reach) - off_the_surface);
  rtcOccluded1(scene_, &context, &r);
  return r.tfar < 0.0F;
}

}  // namespace rt::bench
