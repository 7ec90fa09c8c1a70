#include "rt/render/packet/packet_footprint.h"

#include "wide_maps.h"

namespace rt {
namespace {

void set_lane(WideRayDifferential& all, int i, const RayDifferential& one) {
  all.dp_dx.set(i, one.dp_dx);
  all.dp_dy.set(i, one.dp_dy);
  all.dd_dx.set(i, one.dd_dx);
  all.dd_dy.set(i, one.dd_dy);
}

template <class S, class Map>
WideNormalDifferential change_on(const S& shape, const Map& map, const WideShadingPoint& point,
                                 const WideRayDifferential& at) {
  const Wide sign = select(mask_of(point.from_outside), Wide(1.0), Wide(-1.0));
  const WideSurfacePoint p{model_points(map, point.position),
                           model_normals(map, sign * point.normal)};
  const Wide3 from = render_covectors(map, model_normals(map, sign * point.shading_normal));
  const auto change = [&](const Wide3& step) {
    const Wide3 in_model = normal_change(shape, p, point.feature, model_vectors(map, step));
    return unit_change(from, sign * render_covectors(map, in_model));
  };
  return {point.shading_normal, change(at.dp_dx), change(at.dp_dy)};
}

/// The lanes of `bits`, all on instance `id`; the others hold anything.
WideNormalDifferential normal_differential(const RenderPlan& plan, std::uint32_t id,
                                           const WideShadingPoint& point, unsigned bits,
                                           const WideRayDifferential& at) {
  const PlannedInstance& instance = plan.instances[id];
  return plan.visit(instance, [&](const auto& shape) -> WideNormalDifferential {
    if constexpr (WideShape<std::decay_t<decltype(shape)>>) {
      if (!instance.moves()) {
        return plan.map(instance, 0.0,
                        [&](const auto& map) { return change_on(shape, map, point, at); });
      }
    }
    WideNormalDifferential out{point.shading_normal, Wide3(Wide(0.0)), Wide3(Wide(0.0))};
    each_lane(bits, [&](int i) {
      const NormalDifferential one = normal_differential(plan, point.lane(i), lane_of(at, i));
      out.dn_dx.set(i, one.dn_dx);
      out.dn_dy.set(i, one.dn_dy);
    });
    return out;
  });
}

}  // namespace

PacketFootprints::PacketFootprints(const RenderPlan& plan)
    : plan_(plan), spacing_(sample_spacing(plan.options)) {}

void PacketFootprints::begin(const WideRay& camera_rays, unsigned active, const Wide* time) {
  open_.clear();
  open_.push_back(
      camera_differential(plan_.camera, plan_.options, spacing_, camera_rays.direction));
  if (plan_.moving_camera) {
    each_lane(active, [&](int i) {
      TraceRay ray{camera_rays.origin.lane(i), camera_rays.direction.lane(i)};
      ray.time = (*time)[static_cast<std::size_t>(i)];
      set_lane(open_.back(), i, camera_differential(plan_, spacing_, ray));
    });
  }
}

void PacketFootprints::arrive(std::size_t open, const Wide3& direction, const Wide& t,
                              WideShadingPoint& point) {
  // What lies above is of paths that met nothing.
  here_ = arrived(open_[open], direction, t, point.normal);
  open_.resize(open);
  known_ = 0;
  point.footprint = sqrt(length(here_.dp_dx) * length(here_.dp_dy));
}

void PacketFootprints::branch(const WideShadingPoint& point, unsigned bits, const Wide3& incoming,
                              const Wide3& direction, bool reflect, const Wide& eta,
                              const PowerCosineLobe* lobe) {
  each_instance(point.instance, bits & ~known_, [&](std::uint32_t id, unsigned same) {
    const WideNormalDifferential n = normal_differential(plan_, id, point, same, here_);
    normal_.dn_dx = select(mask_of(same), n.dn_dx, normal_.dn_dx);
    normal_.dn_dy = select(mask_of(same), n.dn_dy, normal_.dn_dy);
  });
  known_ |= bits;
  normal_.normal = point.shading_normal;
  open_.push_back(reflect ? reflected(here_, incoming, normal_)
                          : refracted(here_, incoming, normal_, eta));
  if (lobe == nullptr) {
    return;
  }
  WideRayDifferential& next = open_.back();
  each_lane(bits, [&](int i) {
    set_lane(next, i, widened(lane_of(next, i), direction.lane(i), *lobe, spacing_));
  });
}

}  // namespace rt
