#include "rt/render/query.h"

#include "rt/math/rounding.h"
#include "rt/render/accel/box_tree.h"

namespace rt {
namespace {

// Two t of one ray that differ by less than this, relatively, are the same crossing: t carries the
// rounding of some 16 operations, amplified by 1 / |cos| of the angle of incidence, up to 64.
constexpr double tie = gamma(16 * 64);

struct ModelRay {
  Ray ray;
  RayStart start;
};

ModelRay to_model(const RenderPlan& plan, std::uint32_t id, const TraceRay& ray) {
  const PlannedInstance& instance = plan.instances[id];
  ModelRay model{model_ray(instance, ray), {}};
  if (ray.position_error > 0.0) {
    // The origin's own error, stretched by the map, and the rounding of the map (three products and
    // three sums in each of three components).
    const double reach = instance.model_per_render * max_abs(ray.origin) +
                         max_abs(instance.model_from_render.offset);
    model.start.position_error = instance.model_per_render * ray.position_error + gamma(12) * reach;
  }
  if (ray.instance == id) {
    model.start.leaving = ray.leaving;
    model.start.feature = ray.feature;
  }
  return model;
}

OptionalHit nearest_triangle(const PlannedMesh& mesh, const ModelRay& model, double t_max) {
  OptionalHit best;
  mesh.tree->walk(model.ray, t_max, [&](std::uint32_t triangle) {
    const OptionalHit hit = intersect_triangle(*mesh.data, triangle, model.ray, t_max, model.start);
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
  if (instance.mesh != nullptr && instance.mesh->tree) {
    return nearest_triangle(*instance.mesh, model, t_max);
  }
  return std::visit(
      [&](const auto& shape) { return intersect(shape, model.ray, t_max, model.start); },
      *instance.shape);
}

/// Keeps the winner among the crossings offered, whatever their order.
class Nearest {
 public:
  /// No crossing beyond this can win any more.
  double limit() const { return limit_; }

  void offer(const SceneHit& hit) {
    if (hit.t < nearest_) {
      nearest_ = hit.t;
      limit_ = hit.t * (1.0 + tie);
    }
    if (winner_.t > limit_ || hit.instance < winner_.instance) {
      winner_ = hit;
    }
  }

  std::optional<SceneHit> winner() const {
    return winner_.instance == no_instance ? std::nullopt : std::optional(winner_);
  }

 private:
  double nearest_ = std::numeric_limits<double>::infinity();
  double limit_ = std::numeric_limits<double>::infinity();
  SceneHit winner_;
};

}  // namespace

Ray model_ray(const PlannedInstance& instance, const TraceRay& ray) {
  return {instance.model_from_render.point(ray.origin),
          instance.model_from_render.vector(ray.direction)};
}

std::optional<SceneHit> closest_hit(const RenderPlan& plan, const TraceRay& ray) {
  Nearest nearest;
  const auto test = [&](std::uint32_t id) {
    if (const auto hit = intersect_instance(plan, id, ray, nearest.limit())) {
      nearest.offer({hit->t, id, hit->feature});
    }
  };
  for (const std::uint32_t id : plan.unbounded) {
    test(id);
  }
  if (plan.tree) {
    plan.tree->walk({ray.origin, ray.direction}, nearest.limit(), [&](std::uint32_t index) {
      test(plan.bounded[index]);
      return nearest.limit();
    });
  } else {
    for (const std::uint32_t id : plan.bounded) {
      test(id);
    }
  }
  return nearest.winner();
}

bool occluded(const RenderPlan& plan, const TraceRay& ray, double t_max) {
  const auto hit = [&](std::uint32_t id) {
    return intersect_instance(plan, id, ray, t_max).has_value();
  };
  for (const std::uint32_t id : plan.unbounded) {
    if (hit(id)) {
      return true;
    }
  }
  if (plan.tree) {
    bool found = false;
    plan.tree->walk({ray.origin, ray.direction}, t_max, [&](std::uint32_t index) {
      found = hit(plan.bounded[index]);
      return found ? -1.0 : t_max;
    });
    return found;
  }
  for (const std::uint32_t id : plan.bounded) {
    if (hit(id)) {
      return true;
    }
  }
  return false;
}

}  // namespace rt
