#include "rt/render/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "material_plan.h"
#include "media_plan.h"
#include "rt/geometry/image_bounds.h"
#include "rt/math/hash.h"
#include "rt/render/accel/box_list.h"
#include "rt/render/accel/box_tree.h"
#include "rt/render/accel/grid.h"
#include "rt/math/arranged.h"
#include "rt/render/thin.h"

namespace rt {
namespace {

// Up to so many boxes a list is faster than a hierarchy (bench/NOTES.md).
constexpr std::size_t few = 96;

// Triangles are cheaper than the setting out on a walk among so few.
constexpr std::size_t few_triangles = 8;

enum class Search { one_by_one, list, grid, tree };

Search search_for(const RenderOptions& options, std::size_t boxes) {
  if (!options.acceleration || options.accel == AccelChoice::none || boxes == 0) {
    return Search::one_by_one;
  }
  switch (options.accel) {
    case AccelChoice::grid:
      return Search::grid;
    case AccelChoice::bvh:
      return Search::tree;
    case AccelChoice::list:
      return Search::list;
    default:
      return boxes > few ? Search::tree : Search::list;
  }
}

class Planner {
 public:
  explicit Planner(const RenderJob& job) : job_(job) {}

  RenderPlan take() {
    plan_.options = job_.options;
    plan_.ambient = job_.ambient;
    eye_ = at_time(job_.camera, time_at(0.0)).eye;
    plan_.camera = frame_of(at_time(job_.camera, time_at(0.0)), job_.options);
    if (shutter_opens() && job_.camera.to) {
      plan_.moves = true;
      plan_.moving_camera = std::make_unique<const Camera>(job_.camera);
    }
    plan_.instances.reserve(job_.instances.size() + job_.lights.size());
    for (const Instance& instance : job_.instances) {
      place(instance);
    }
    for (const Light& light : job_.lights) {
      place(light);
    }
    plan_.bounded = static_cast<std::uint32_t>(plan_.instances.size());
    plan_.instances.insert(plan_.instances.end(), unbounded_.begin(), unbounded_.end());
    if (plan_.absorbs) {
      let_clear_glass_dim();
    }
    choose_search();
    arrange();
    find_media(plan_);
    if (fixed_samples(plan_.options) == 0 && plan_.options.aa == AntiAliasing::adaptive) {
      plan_.thin = find_thin(plan_);
    }
    make_shaft_list();
    return std::move(plan_);
  }

 private:
  /// The script's time at a time of the rays.
  double time_at(double time) const {
    const RenderOptions& o = plan_.options;
    return std::lerp(o.shutter_open, o.shutter_close, time);
  }

  bool shutter_opens() const {
    return plan_.options.motion_blur && plan_.options.shutter_close > plan_.options.shutter_open;
  }

  std::vector<Bounds> boxes() const {
    std::vector<Bounds> all;
    all.reserve(plan_.bounded);
    for (std::uint32_t i = 0; i < plan_.bounded; ++i) {
      all.push_back(box_of(plan_, plan_.instances[i]));
    }
    return all;
  }

  void choose_search() {
    const auto box = [this](std::uint32_t i) { return box_of(plan_, plan_.instances[i]); };
    switch (search_for(plan_.options, plan_.bounded)) {
      case Search::tree: {
        // Boxes are made again, not kept: ten million of them are half a gigabyte.
        auto tree = std::make_unique<BoxTree>(all_bounded_, plan_.bounded, box);
        const std::vector<std::uint32_t> order = tree->arrange();
        plan_.tree = std::move(tree);
        std::vector<PlannedInstance> arranged;
        arranged.reserve(plan_.instances.size());
        prefer_large_pages(arranged);
        for (const std::uint32_t i : order) {
          arranged.push_back(plan_.instances[i]);
        }
        arranged.insert(arranged.end(), plan_.instances.begin() + plan_.bounded,
                        plan_.instances.end());
        plan_.instances = std::move(arranged);
        break;
      }
      case Search::list:
        plan_.list = std::make_unique<BoxList>(boxes());
        break;
      case Search::grid:
        plan_.grid = std::make_unique<Grid>(boxes());
        break;
      case Search::one_by_one:
        break;
    }
  }

  /// What shafts ask where rays ask neither list nor hierarchy.
  void make_shaft_list() {
    if ((extended_lights_ || plan_.thin) && !plan_.list && !plan_.tree && plan_.bounded > 0) {
      plan_.shaft_list = std::make_unique<BoxList>(boxes());
    }
  }

  /// What instances are made of, in their order.
  void arrange() {
    const auto each = [this](auto&& visit) {
      for (PlannedInstance& instance : plan_.instances) {
        visit(instance);
      }
    };
    plan_.placements.arrange([&](MapKind kind, auto&& visit) {
      each([&](PlannedInstance& i) { i.map == kind ? visit(i.placement) : void(); });
    });
    plan_.shapes.arrange([&](std::size_t kind, auto&& visit) {
      each([&](PlannedInstance& i) { i.kind == kind ? visit(i.shape) : void(); });
    });
    arrange_table(plan_.coats, [&](auto&& visit) {
      each([&](PlannedInstance& i) { visit(i.coat); });
    });
  }

  void place(Light light) {
    if (!plan_.options.soft_shadows) {
      light.radius = 0.0;
      light.rectangle.reset();
    }
    PlannedLight planned(light);
    plan_.random |= planned.extended();
    extended_lights_ |= planned.extended();
    if (planned.extended() && light.visible) {
      place(shape_of(light), true);
    }
    planned.position += time_at(0.0) * light.travel - eye_;
    planned.travel *= shutter_opens() ? time_at(1.0) - time_at(0.0) : 0.0;
    plan_.moves |= planned.travel != Vec3(0.0);
    plan_.lights.push_back(std::move(planned));
  }

  /// The movement of a light's shape; null when it stands still.
  static std::shared_ptr<const MotionPath> path_of(const Light& light, const Affine& still) {
    if (light.travel == Vec3(0.0)) {
      return nullptr;
    }
    Pose end;
    end.translate = light.travel;
    auto travel = std::make_shared<Motion>();
    travel->keys = {{0.0, Pose{}}, {1.0, end}};
    return extended(nullptr, {still, travel});
  }

  /// A visible light as a shape that shines.
  static Instance shape_of(const Light& light) {
    Affine world_from_model = Affine::translation(light.position);
    Shape shape = Sphere{Vec3(0.0), light.radius};
    if (light.rectangle) {
      const auto& [u, v] = *light.rectangle;
      shape = Square{1.0};
      world_from_model.linear = Mat3(u, glm::normalize(glm::cross(v, u)), v);
    }
    auto shine = std::make_shared<Material>();
    shine->kd = Rgb(0.0);
    shine->emission = light.colour;
    return {world_from_model, std::make_shared<const Shape>(shape), shine, nullptr,
            light.where,      path_of(light, world_from_model)};
  }

  void place(const Instance& from, bool is_light = false) {
    PlannedInstance to;
    to.order = placed_++;
    to.kind = static_cast<std::uint8_t>(from.shape->index());
    to.shape = shape(from.shape);
    to.convex = convex(*from.shape);
    to.coat = materials_.coat_of(from);
    to.clear = plan_.material_of(to).transmissive;
    to.shadow = is_light ? Shadow::none : shadow_of(plan_.material_of(to));
    plan_.dims |= to.shadow == Shadow::dims;
    const Bounds model_box = model_box_of(plan_, to);
    if (model_box.empty()) {
      return;  // a mesh without triangles
    }
    locate(from, model_box, to);
    const Bounds box = box_of(plan_, to);
    if (box.finite()) {
      all_bounded_.extend(box);
      plan_.instances.push_back(to);
    } else {
      unbounded_.push_back(to);
    }
  }

  void locate(const Instance& from, const Bounds& model_box, PlannedInstance& to) {
    const bool moves = from.motion && shutter_opens();
    plan_.moves |= moves;
    const PlacementTable::Id id = moves
                                      ? plan_.placements.add(at_open(from), moving(from, model_box))
                                      : plan_.placements.add(at_open(from), round(from, to));
    to.map = id.kind;
    to.placement = id.index;
  }

  /// A ball about its origin, of one look all over.
  bool round(const Instance& from, const PlannedInstance& to) const {
    const auto* ball = std::get_if<Sphere>(from.shape.get());
    return ball != nullptr && ball->centre == Vec3(0.0) && !plan_.material_of(to).textures;
  }

  Placement at_open(const Instance& from) const {
    const Affine in_world = from.motion ? from.motion->at(time_at(0.0)) : from.world_from_model;
    const Affine to_render{in_world.linear, in_world.offset - eye_};
    if (const auto to_model = inverse(to_render)) {
      return {to_render, *to_model};
    }
    // The graph has been checked: its own map has an inverse, though one moved so far has none.
    Affine to_model = inverse(in_world).value_or(Affine{});
    to_model.offset = to_model.point(eye_);
    return {to_render, to_model};
  }

  PlannedMotion moving(const Instance& from, const Bounds& model_box) const {
    constexpr double pixels = 0.1;  // that a moving point may be off
    const double pixel = 2.0 * glm::length(plan_.camera.down) / plan_.options.height;
    const auto path = [&](double time) {
      Affine there = from.motion->at(time_at(time));
      there.offset -= eye_;
      return there;
    };
    return planned_motion(path, model_box, pixels * pixel);
  }

  /// Where some medium absorbs, clear glass displaces it: shadow rays have to meet its surface.
  void let_clear_glass_dim() {
    for (PlannedInstance& instance : plan_.instances) {
      if (instance.clear) {
        instance.shadow = Shadow::dims;
      }
    }
  }

  /// Its index in the table of its kind.
  std::uint32_t shape(const std::shared_ptr<const Shape>& from) {
    if (const auto* mesh = std::get_if<Mesh>(from.get())) {
      const auto [entry, added] = meshes_.try_emplace(
          mesh->data.get(), static_cast<std::uint32_t>(plan_.mesh_trees.size()));
      if (added) {
        plan_.shapes.add(*from);
        plan_.mesh_trees.push_back(tree_of(*mesh->data));
        plan_.mesh_boxes.push_back(bounds(*mesh));
      }
      return entry->second;
    }
    // Nodes made alike share their shape. It is enough to know of those met last.
    auto& [seen, index] =
        recent_shapes_[mix64(reinterpret_cast<std::uintptr_t>(from.get())) % recent_shapes_.size()];
    if (seen != from) {
      seen = from;
      index = plan_.shapes.add(*from);
    }
    return index;
  }

  std::unique_ptr<const BoxTree> tree_of(const MeshData& mesh) const {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    if (!plan_.options.acceleration || plan_.options.accel == AccelChoice::none ||
        count <= few_triangles) {
      return nullptr;
    }
    std::vector<Bounds> boxes;
    boxes.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      boxes.push_back(triangle_bounds(mesh, i));
    }
    return std::make_unique<const BoxTree>(boxes);
  }

  const RenderJob& job_;
  Vec3 eye_{0.0};  ///< when the shutter opens
  RenderPlan plan_;
  MaterialPlanner materials_{job_, plan_};
  std::uint32_t placed_ = 0;
  bool extended_lights_ = false;
  std::vector<PlannedInstance> unbounded_;  ///< they come behind the others
  Bounds all_bounded_;  ///< holds what is bounded
  std::array<std::pair<std::shared_ptr<const Shape>, std::uint32_t>, 64> recent_shapes_{};
  std::unordered_map<const MeshData*, std::uint32_t> meshes_;
};

}  // namespace

Bounds model_box_of(const RenderPlan& plan, const PlannedInstance& instance) {
  return instance.is<Mesh>() ? plan.mesh_boxes[instance.shape]
                             : plan.visit(instance, [](const auto& s) { return bounds(s); });
}

Bounds box_of(const RenderPlan& plan, const PlannedInstance& instance) {
  if (instance.moves()) {
    return plan.placements.motion(instance.placement).bounds(model_box_of(plan, instance));
  }
  const Affine map = plan.placement(instance).render_from_model;
  return instance.is<Mesh>()
             ? transformed(map, plan.mesh_boxes[instance.shape])
             : plan.visit(instance, [&](const auto& s) { return image_bounds(map, s); });
}

CameraFrame frame_of(const Camera& camera, const RenderOptions& options) {
  const Vec3 forward = glm::normalize(camera.view / max_abs(camera.view));
  const Vec3 right = glm::normalize(glm::cross(forward, camera.up / max_abs(camera.up)));
  const Vec3 up = glm::cross(right, forward);
  const double half = std::tan(0.5 * camera.fov * std::numbers::pi / 180.0);
  const double aspect = static_cast<double>(options.width) / options.height;
  return {forward, right * (half * aspect), up * -half, 0.5 * camera.aperture, camera.focus};
}

RenderPlan::RenderPlan() = default;
RenderPlan::~RenderPlan() = default;
RenderPlan::RenderPlan(RenderPlan&&) noexcept = default;
RenderPlan& RenderPlan::operator=(RenderPlan&&) noexcept = default;

RenderPlan make_plan(const RenderJob& job) { return Planner(job).take(); }

}  // namespace rt
