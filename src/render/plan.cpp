#include "rt/render/plan.h"

#include <cmath>
#include <numbers>
#include <unordered_map>

#include "rt/render/accel/box_tree.h"

namespace rt {
namespace {

// Below this many boxes, trying them one by one costs no more than walking a hierarchy.
constexpr std::size_t few = 8;

bool wants_tree(const RenderOptions& options, std::size_t boxes) {
  if (!options.acceleration || options.accel == AccelChoice::none || boxes == 0) {
    return false;
  }
  return options.accel == AccelChoice::bvh || boxes > few;
}

class Planner {
 public:
  explicit Planner(const RenderJob& job) : job_(job) {}

  RenderPlan take() {
    plan_.options = job_.options;
    plan_.ambient = job_.ambient;
    plan_.camera = frame(job_.camera, job_.options);
    plan_.lights = job_.lights;
    for (Light& light : plan_.lights) {
      light.position -= job_.camera.eye;
    }
    plan_.instances.reserve(job_.instances.size());
    for (const Instance& instance : job_.instances) {
      place(instance);
    }
    if (wants_tree(plan_.options, boxes_.size())) {
      plan_.tree = std::make_unique<BoxTree>(boxes_);
    }
    return std::move(plan_);
  }

 private:
  static CameraFrame frame(const Camera& camera, const RenderOptions& options) {
    const Vec3 forward = glm::normalize(camera.view / max_abs(camera.view));
    const Vec3 right = glm::normalize(glm::cross(forward, camera.up / max_abs(camera.up)));
    const Vec3 up = glm::cross(right, forward);
    const double half = std::tan(0.5 * camera.fov * std::numbers::pi / 180.0);
    const double aspect = static_cast<double>(options.width) / options.height;
    return {forward, right * (half * aspect), up * -half};
  }

  void place(const Instance& from) {
    PlannedInstance to;
    to.render_from_model = from.world_from_model;
    to.render_from_model.offset -= job_.camera.eye;
    // The graph has been checked: if the world's map has an inverse, so has one that is only moved.
    to.model_from_render = from.model_from_world;
    to.model_from_render.offset = from.model_from_world.point(job_.camera.eye);
    if (const auto inverted = inverse(to.render_from_model)) {
      to.model_from_render = *inverted;
    }
    to.model_per_render = norm(to.model_from_render.linear);
    to.render_per_model = norm(to.render_from_model.linear);
    to.shape = from.shape;
    to.material = material(from.material);
    if (const auto* shape = std::get_if<Mesh>(from.shape.get())) {
      to.mesh = mesh(*shape);
    }
    const Bounds model_box = std::visit([](const auto& shape) { return bounds(shape); }, *to.shape);
    const Bounds box = transformed(to.render_from_model, model_box);
    const auto id = static_cast<std::uint32_t>(plan_.instances.size());
    plan_.instances.push_back(std::move(to));
    if (box.finite()) {
      plan_.bounded.push_back(id);
      boxes_.push_back(box);
    } else if (!model_box.empty()) {
      plan_.unbounded.push_back(id);
    }
  }

  std::uint32_t material(const std::shared_ptr<const Material>& from) {
    const auto [entry, added] =
        materials_.try_emplace(from.get(), static_cast<std::uint32_t>(plan_.materials.size()));
    if (added) {
      plan_.materials.push_back(*from);
    }
    return entry->second;
  }

  const PlannedMesh* mesh(const Mesh& from) {
    const PlannedMesh*& entry = meshes_[from.data.get()];
    if (entry == nullptr) {
      auto planned = std::make_unique<PlannedMesh>();
      planned->data = from.data;
      const auto count = static_cast<std::uint32_t>(from.data->triangles.size());
      if (wants_tree(plan_.options, count)) {
        std::vector<Bounds> boxes;
        boxes.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i) {
          boxes.push_back(triangle_bounds(*from.data, i));
        }
        planned->tree = std::make_unique<BoxTree>(boxes);
      }
      entry = planned.get();
      plan_.meshes.push_back(std::move(planned));
    }
    return entry;
  }

  const RenderJob& job_;
  RenderPlan plan_;
  std::vector<Bounds> boxes_;
  std::unordered_map<const Material*, std::uint32_t> materials_;
  std::unordered_map<const MeshData*, const PlannedMesh*> meshes_;
};

}  // namespace

RenderPlan::RenderPlan() = default;
RenderPlan::~RenderPlan() = default;
RenderPlan::RenderPlan(RenderPlan&&) noexcept = default;
RenderPlan& RenderPlan::operator=(RenderPlan&&) noexcept = default;

RenderPlan make_plan(const RenderJob& job) { return Planner(job).take(); }

}  // namespace rt
