#include "rt/render/accel/box_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

namespace rt {
namespace {

// How far a float walk over [-1,1]^3 can be off, in units of the cube's half-edge, per axis:
//   the box's face, rounded to float                                     2^-24
//   the ray's origin, below 2 in size once clipped, rounded               2^-24
//   the direction, rounded: over a path of at most 2 sqrt(3) < 4          2^-22
//   the slab test (face - origin) * (1 / direction), a reciprocal and two
//   roundings at most 4 units in the last place of a number below 4       2^-20
//   moving and clipping the ray in double, from at most 2^27 half-edges   2^-23
// All of it together is below 2^-19: boxes are enlarged by that much.
constexpr double slack = 0x1p-19;
// Rays are clipped to a cube a little larger than any enlarged box.
constexpr double cube = 1.0 + 0x1p-10;

struct Walk {
  RTCIntersectContext embree;
  void* context;
  double (*visit)(void*, std::uint32_t);
  double per_t;  // float parameter = t * per_t - entry
  double entry;
};

/// The float ray's end for a limit in t, rounded upward by more than float arithmetic can err.
float far_end(const Walk& walk, double t_max) {
  const double far = t_max * walk.per_t - walk.entry;
  return static_cast<float>(std::min(far + slack * (1.0 + std::abs(far)), 16.0));
}

void visit_box(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] == 0) {
    return;
  }
  auto* walk = reinterpret_cast<Walk*>(args->context);
  auto* ray_hit = reinterpret_cast<RTCRayHit*>(args->rayhit);
  const double t_max = walk->visit(walk->context, args->primID);
  // Embree skips what lies behind tfar; an interval that is empty ends the walk.
  ray_hit->ray.tfar = t_max < 0.0 ? -1.0F : far_end(*walk, t_max);
}

/// Clips to the cube; false when the ray passes it by. Comparisons are written so that NaN fails.
bool clip(const Vec3& origin, const Vec3& direction, double& t0, double& t1) {
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0.0) {
      if (!(std::abs(origin[k]) <= cube)) {
        return false;
      }
      continue;
    }
    const double a = (-cube - origin[k]) / direction[k];
    const double b = (cube - origin[k]) / direction[k];
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 <= t1;
}

RTCDevice device() {
  // One for the process; it holds no scene's data. It keeps the number of threads that it finds
  // when it is first wanted (with_threads), for building only.
  static RTCDevice shared = rtcNewDevice("set_affinity=0");
  return shared;
}

}  // namespace

struct BoxTree::Implementation {
  Vec3 centre{0.0};
  double half_edge = 1.0;
  RTCScene scene = nullptr;
};

BoxTree::BoxTree(const std::vector<Bounds>& boxes)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  Bounds all;
  for (const Bounds& b : boxes) {
    all.extend(b);
  }
  if (!boxes.empty()) {
    self.centre = all.centre();
    const double reach = 0.5 * max_abs(all.extent());
    self.half_edge = reach > 0.0 ? reach : 1.0;
  }
  struct Source {
    const std::vector<Bounds>* boxes;
    const Implementation* self;
  } source{&boxes, &self};

  RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, &source);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* args) {
        const auto& from = *static_cast<const Source*>(args->geometryUserPtr);
        const Bounds& b = (*from.boxes)[args->primID];
        const Vec3 lo = (b.lo - from.self->centre) / from.self->half_edge - slack;
        const Vec3 hi = (b.hi - from.self->centre) / from.self->half_edge + slack;
        *args->bounds_o = {
            static_cast<float>(lo.x), static_cast<float>(lo.y), static_cast<float>(lo.z), 0.0F,
            static_cast<float>(hi.x), static_cast<float>(hi.y), static_cast<float>(hi.z), 0.0F};
      },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, visit_box);
  rtcCommitGeometry(geometry);
  self.scene = rtcNewScene(device());
  rtcSetSceneFlags(self.scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(self.scene, geometry);
  rtcCommitScene(self.scene);
  rtcReleaseGeometry(geometry);
  if (rtcGetDeviceError(device()) != RTC_ERROR_NONE) {
    rtcReleaseScene(self.scene);
    throw std::bad_alloc();
  }
}

BoxTree::~BoxTree() { rtcReleaseScene(implementation_->scene); }

void BoxTree::walk_candidates(const Ray& ray, double t_max, void* context,
                              VisitFunction visit) const {
  const Implementation& self = *implementation_;
  const double length = glm::length(ray.direction);
  const Vec3 origin = (ray.origin - self.centre) / self.half_edge;
  const Vec3 direction = ray.direction / length;
  double entry = 0.0;
  double exit = std::numeric_limits<double>::infinity();
  if (!(length > 0.0) || !clip(origin, direction, entry, exit)) {
    return;
  }
  Walk walk{{}, context, visit, length / self.half_edge, entry};
  rtcInitIntersectContext(&walk.embree);
  const Vec3 start = origin + entry * direction;
  RTCRayHit r{};
  r.ray.org_x = static_cast<float>(start.x);
  r.ray.org_y = static_cast<float>(start.y);
  r.ray.org_z = static_cast<float>(start.z);
  r.ray.dir_x = static_cast<float>(direction.x);
  r.ray.dir_y = static_cast<float>(direction.y);
  r.ray.dir_z = static_cast<float>(direction.z);
  r.ray.tnear = 0.0F;
  r.ray.tfar = far_end(walk, t_max);
  r.ray.mask = ~0U;
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  if (r.ray.tfar >= 0.0F) {
    rtcIntersect1(self.scene, &walk.embree, &r);
  }
}

}  // namespace rt
