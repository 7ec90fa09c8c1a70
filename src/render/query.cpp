#include "rt/render/query.h"

#include <algorithm>

#include "rt/render/accel/box_list.h"
#include "rt/render/accel/box_tree.h"
#include "rt/render/accel/grid.h"

namespace rt {
namespace {

struct ModelRay {
  Ray ray;
  RayStart start;
};

ModelRay to_model(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray) {
  return plan.map(plan.instances[id], ray.time, [&](const auto& map) {
    ModelRay model{map.model_ray({ray.origin, ray.direction}), {}};
    if (ray.instance != no_instance) {
      // The origin's own error, stretched by the map, and the rounding of the map.
      const double stretch = map.model_per_render();
      const double reach = stretch * max_abs(ray.origin) + map.model_offset();
      model.start.position_error =
          stretch * ray.position_error + gamma(std::decay_t<decltype(map)>::roundings) * reach;
      if (ray.instance == id) {
        model.start.leaving = ray.leaving;
        model.start.feature = ray.feature;
      }
    }
    return model;
  });
}

/// Whether the ray has just left that instance and cannot meet it again.
bool left_for_good(const PlannedInstance& instance, std::uint32_t id, const TraceRay& ray) {
  return ray.instance == id && ray.leaving == Leaving::outward && instance.convex;
}

OptionalHit nearest_triangle(const BoxTree& tree, const MeshData& mesh, const ModelRay& model,
                             double t_max) {
  OptionalHit best;
  tree.walk(model.ray, t_max, [&](std::uint32_t triangle) {
    const OptionalHit hit = intersect_triangle(mesh, triangle, model.ray, t_max, model.start);
    // Equal t: the lower index wins, whatever the order of the walk.
    if (hit && (!best || hit->t < best->t || hit->feature < best->feature)) {
      best = hit;
      t_max = hit->t;
    }
    return t_max;
  });
  return best;
}

OptionalHit intersect_instance(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray,
                               double t_max) {
  const PlannedInstance& instance = plan.instances[id];
  const ModelRay model = to_model(plan, id, ray);
  if (instance.is<Mesh>() && plan.mesh_trees[instance.shape]) {
    return nearest_triangle(*plan.mesh_trees[instance.shape],
                            *plan.shapes.of<Mesh>()[instance.shape].data, model, t_max);
  }
  return plan.visit(
      instance, [&](const auto& shape) { return intersect(shape, model.ray, t_max, model.start); });
}

/// Keeps the winner among the crossings offered, whatever their order.
class Nearest {
 public:
  Nearest(const RenderPlan& plan, const TraceRay& ray, double t_max)
      : plan_(plan), origin_(max_abs(ray.origin)), limit_(t_max) {}

  /// No crossing beyond this can win any more.
  double limit() const { return limit_; }

  void offer(const SceneHit& hit) {
    if (hit.t < nearest_) {
      nearest_ = hit.t;
      limit_ = std::min(limit_, hit.t + tie * (hit.t + origin_));
    }
    if (winner_.t > limit_ || winner_.instance == no_instance ||
        plan_.instances[hit.instance].precedes(plan_.instances[winner_.instance])) {
      winner_ = hit;
    }
  }

  std::optional<SceneHit> winner() const {
    return winner_.instance == no_instance ? std::nullopt : std::optional(winner_);
  }

 private:
  const RenderPlan& plan_;
  double origin_;
  double nearest_ = std::numeric_limits<double>::infinity();
  double limit_;
  SceneHit winner_;
};

/// Calls visit(instance) -> double for all that the ray may cross before t_max; what it returns is
/// the new t_max, a negative one ends the search.
template <class Visit>
void each_candidate(const RenderPlan& plan, const Ray& ray, double t_max, Visit visit) {
  for (const std::uint32_t id : plan.unbounded()) {
    t_max = visit(id);
    if (t_max < 0.0) {
      return;
    }
  }
  if (plan.bounded == 1) {  // its shape tells as fast as its box whether the ray passes by
    visit(0);
  } else if (plan.list) {
    plan.list->walk(ray, t_max, visit);
  } else if (plan.tree) {
    plan.tree->walk_unit(ray, t_max, visit);
  } else if (plan.grid) {
    plan.grid->walk(ray, t_max, visit);
  } else {
    for (std::uint32_t id = 0; id < plan.bounded && t_max >= 0.0; ++id) {
      t_max = visit(id);
    }
  }
}

/// The nearest crossing with t <= t_max among the instances that `counts` accepts.
template <class Counts>
std::optional<SceneHit> nearest_of(const RenderPlan& plan, const TraceRay& ray, double t_max,
                                   Counts counts) {
  Nearest nearest(plan, ray, t_max);
  each_candidate(plan, {ray.origin, ray.direction}, t_max, [&](std::uint32_t id) {
    const PlannedInstance& instance = plan.instances[id];
    if (counts(instance) && !left_for_good(instance, id, ray)) {
      if (const auto hit = intersect_instance(plan, id, ray, nearest.limit())) {
        nearest.offer({hit->t, id, hit->feature});
      }
    }
    return nearest.limit();
  });
  return nearest.winner();
}

bool blocks(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray, double t_max) {
  const PlannedInstance& instance = plan.instances[id];
  return instance.shadow == Shadow::blocks && !left_for_good(instance, id, ray) &&
         intersect_instance(plan, id, ray, t_max).has_value();
}

}  // namespace

Ray model_ray(const RenderPlan& plan, const PlannedInstance& instance, const TraceRay& ray) {
  return plan.map(instance, ray.time, [&](const auto& map) {
    return map.model_ray({ray.origin, ray.direction});
  });
}

std::optional<SceneHit> instance_hit(const RenderPlan& plan, std::uint32_t instance,
                                     const TraceRay& ray, double t_max) {
  const auto hit = intersect_instance(plan, instance, ray, t_max);
  return hit ? std::optional(SceneHit{hit->t, instance, hit->feature}) : std::nullopt;
}

std::optional<SceneHit> closest_hit(const RenderPlan& plan, const TraceRay& ray) {
  return nearest_of(plan, ray, std::numeric_limits<double>::infinity(),
                    [](const PlannedInstance&) { return true; });
}

std::optional<SceneHit> closest_hit_among(const RenderPlan& plan,
                                          std::span<const std::uint32_t> instances,
                                          const TraceRay& ray) {
  Nearest nearest(plan, ray, std::numeric_limits<double>::infinity());
  for (const std::uint32_t id : instances) {
    if (const auto hit = intersect_instance(plan, id, ray, nearest.limit())) {
      nearest.offer({hit->t, id, hit->feature});
    }
  }
  return nearest.winner();
}

std::optional<SceneHit> closest_dimming_hit(const RenderPlan& plan, const TraceRay& ray,
                                            double t_max) {
  return nearest_of(plan, ray, t_max, [](const PlannedInstance& instance) {
    return instance.shadow == Shadow::dims;
  });
}

bool occluded(const RenderPlan& plan, const TraceRay& ray, double t_max) {
  bool found = false;
  each_candidate(plan, {ray.origin, ray.direction}, t_max, [&](std::uint32_t id) {
    found = blocks(plan, id, ray, t_max);
    return found ? -1.0 : t_max;
  });
  return found;
}

bool occluded_by(const RenderPlan& plan, std::span<const std::uint32_t> instances,
                 const TraceRay& ray, double t_max) {
  return std::ranges::any_of(instances,
                             [&](std::uint32_t id) { return blocks(plan, id, ray, t_max); });
}

}  // namespace rt
