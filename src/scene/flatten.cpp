#include <fmt/format.h>

#include <unordered_map>

#include "rt/scene/error.h"
#include "rt/scene/node.h"

namespace rt {
namespace {

constexpr std::size_t max_graph_depth = 10'000;
constexpr std::size_t max_instances = 20'000'000;

class Flattener {
 public:
  Flattened take(const Node& root) {
    // An explicit stack: a chain of nodes is as deep as the script likes.
    std::vector<Visit> open{{&root, Affine{}, nullptr, {}, 1}};
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const Node& node = *visit.node;
      check_depth(node, visit.depth);
      Affine above_from_node = visit.above_from_parent * node.parent_from_node;
      std::shared_ptr<const MotionPath> path = visit.path;
      if (node.motion) {
        path = extended(path, {visit.above_from_parent, nullptr});
        path = extended(path, {node.parent_from_node, node.motion});
        above_from_node = {};
      }
      const Paint paint = painted(node, visit.paint);
      if (node.shape) {
        place(node, above_from_node, path, paint);
      }
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        open.push_back({child->get(), above_from_node, path, paint, visit.depth + 1});
      }
    }
    warn_of_missing_materials();
    return std::move(result_);
  }

 private:
  struct Paint {
    std::shared_ptr<const Material> material;
    std::shared_ptr<const Texture> texture;
  };

  struct Visit {
    const Node* node;
    /// "Above" is the space of the nearest moving node, or the world.
    Affine above_from_parent;
    std::shared_ptr<const MotionPath> path;  ///< from the world to that node; null: none moves
    Paint paint;
    std::size_t depth;
  };

  /// A material set here comes with the texture set here, or none; else both are the parent's, but
  /// for a texture set here.
  static Paint painted(const Node& node, const Paint& inherited) {
    if (node.material) {
      return {node.material, node.texture};
    }
    return {inherited.material, node.texture ? node.texture : inherited.texture};
  }

  static void check_depth(const Node& node, std::size_t depth) {
    if (depth > max_graph_depth) {
      throw SceneError(fmt::format("node '{}' lies deeper than {} nodes below the root", node.name,
                                   max_graph_depth));
    }
  }

  void place(const Node& node, const Affine& above_from_model,
             const std::shared_ptr<const MotionPath>& above, const Paint& paint) {
    const auto path = above ? extended(above, {above_from_model, nullptr}) : nullptr;
    const Affine world_from_model = path ? path->at(0.0) : above_from_model;
    const auto model_from_world = inverse(world_from_model);
    if (!model_from_world) {
      throw SceneError(fmt::format(
          "the transforms above and at node '{}'{} multiply to one that cannot be inverted: "
          "their scales are too extreme or not finite",
          node.name, node.where.empty() ? "" : " (" + node.where + ")"));
    }
    if (result_.instances.size() >= max_instances) {
      throw SceneError(
          fmt::format("node '{}': the scene has more than {} shapes", node.name, max_instances));
    }
    auto& shape = shapes_[&node];
    if (!shape) {
      shape = std::make_shared<const Shape>(*node.shape);
    }
    result_.instances.push_back({world_from_model, *model_from_world, shape,
                                 paint.material ? paint.material : default_material(node),
                                 paint.texture, node.name, path});
  }

  std::shared_ptr<const Material> default_material(const Node& node) {
    if (!default_material_) {
      default_material_ = std::make_shared<const Material>();
      first_without_material_ = node.name;
    }
    ++without_material_;
    return default_material_;
  }

  void warn_of_missing_materials() {
    if (without_material_ > 0) {
      result_.warnings.push_back(fmt::format(
          "node '{}'{} has no material, nor has any node above it; a neutral grey is used",
          first_without_material_,
          without_material_ > 1 ? fmt::format(" (and {} more)", without_material_ - 1) : ""));
    }
  }

  Flattened result_;
  std::unordered_map<const Node*, std::shared_ptr<const Shape>> shapes_;
  std::shared_ptr<const Material> default_material_;
  std::string first_without_material_;
  std::size_t without_material_ = 0;
};

}  // namespace

Flattened flatten(const Node& root) { return Flattener().take(root); }

}  // namespace rt
