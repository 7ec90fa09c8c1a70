#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "rt/scene/error.h"
#include "rt/scene/node.h"
#include "texture_cover.h"

namespace rt {
namespace {

constexpr std::size_t max_graph_depth = 10'000;

/// Nodes are visited at most so often for each instance allowed: groups that are shared again and
/// again, and hold nothing, must come to an end too.
constexpr std::size_t visits_per_instance = 8;

/// How many shapes there are under `root`, counted no further than `enough`. Cheap beside placing
/// them, and it lets them be stored without ever moving.
std::size_t count_shapes(const Node& root, std::size_t enough) {
  std::size_t count = 0;
  std::vector<const Node*> open{&root};
  for (std::size_t visits = 0; !open.empty() && count < enough; ++visits) {
    if (visits / visits_per_instance >= enough) {
      break;
    }
    const Node& node = *open.back();
    open.pop_back();
    count += node.shape ? 1 : 0;
    for (const auto& child : node.children) {
      open.push_back(child.get());
    }
  }
  return count;
}

class Flattener {
 public:
  explicit Flattener(std::size_t max_instances) : max_instances_(max_instances) {}

  Flattened take(const Node& root) {
    result_.instances.reserve(count_shapes(root, max_instances_));
    // An explicit stack: a chain of nodes is as deep as the script likes.
    std::vector<Visit> open;
    enter(root, Visit{nullptr, Affine{}, nullptr, {}}, open);
    while (!open.empty()) {
      Visit& visit = open.back();
      if (visit.next < visit.node->children.size()) {
        const Node& child = *visit.node->children[visit.next++];
        enter(child, visit, open);
      } else {
        open.pop_back();
      }
    }
    warn_of_missing_materials();
    std::ranges::move(cover_.warnings(), std::back_inserter(result_.warnings));
    return std::move(result_);
  }

 private:
  struct Paint {
    std::shared_ptr<const Material> material;
    std::shared_ptr<const TextureSet> textures;
    std::shared_ptr<const TextureCover::Group> group;  ///< whose textures are among them
  };

  /// A node whose children are being visited.
  struct Visit {
    const Node* node;
    /// "Above" is the space of the nearest moving node, or the world.
    Affine above_from_node;
    std::shared_ptr<const MotionPath> path;  ///< from the world to that node; null: none moves
    Paint paint;
    std::size_t next = 0;  ///< child to visit
  };

  void enter(const Node& node, const Visit& parent, std::vector<Visit>& open) {
    check_depth(node, open.size() + 1);
    if (++visits_ / visits_per_instance >= max_instances_) {
      refuse(node);
    }
    Affine above_from_node = parent.above_from_node * node.parent_from_node;
    std::shared_ptr<const MotionPath> path = parent.path;
    if (node.motion) {
      path = longer(node, path, {parent.above_from_node, nullptr});
      path = longer(node, path, {node.parent_from_node, node.motion});
      above_from_node = {};
    }
    const Paint paint = painted(node, parent.paint);
    if (node.shape) {
      place(node, above_from_node, path, paint);
    }
    if (!node.children.empty()) {
      open.push_back({&node, above_from_node, path, paint});
    }
  }

  /// A material set here comes with the textures set here, or none; else both are the parent's, but
  /// for textures set here.
  Paint painted(const Node& node, const Paint& inherited) {
    auto group = cover_.enter(node, inherited.group);
    if (node.material) {
      return {node.material, node.textures, std::move(group)};
    }
    return {inherited.material, both(node, inherited.textures), std::move(group)};
  }

  /// Layered once for each pair, however many ways lead to the node.
  std::shared_ptr<const TextureSet> both(const Node& node,
                                         const std::shared_ptr<const TextureSet>& above) {
    if (!above || !node.textures) {
      return layered(above, node.textures);
    }
    auto& known = layers_[{above.get(), node.textures.get()}];
    if (!known) {
      extra_bytes_ +=
          2 * instance_bytes;  // the set, a material planned of it, their places in maps
      if (is_full()) {
        refuse(node);
      }
      known = layered(above, node.textures);
    }
    return known;
  }

  static void check_depth(const Node& node, std::size_t depth) {
    if (depth > max_graph_depth) {
      throw SceneError(fmt::format("node '{}' lies deeper than {} nodes below the root", node.name,
                                   max_graph_depth));
    }
  }

  [[noreturn]] void refuse(const Node& node) const {
    throw UserError(ExitCode::limit,
                    fmt::format("at node '{}' the scene comes to more than {} shapes, for which "
                                "there is no memory (a node counts once for each way that leads "
                                "to it, and moving nodes above it count too)",
                                node.name, max_instances_));
  }

  bool is_full() const {
    return result_.instances.size() + extra_bytes_ / instance_bytes >= max_instances_;
  }

  /// The path with one more link. Each is a copy: moving nodes below each other take memory by the
  /// square of their number.
  std::shared_ptr<const MotionPath> longer(const Node& node,
                                           const std::shared_ptr<const MotionPath>& path,
                                           MotionPath::Link link) {
    extra_bytes_ += ((path ? path->links.size() : 0) + 1) * sizeof(MotionPath::Link);
    if (is_full()) {
      refuse(node);
    }
    return extended(path, std::move(link));
  }

  void place(const Node& node, const Affine& above_from_model,
             const std::shared_ptr<const MotionPath>& above, const Paint& paint) {
    const auto path = above ? longer(node, above, {above_from_model, nullptr}) : nullptr;
    const Affine world_from_model = path ? path->at(0.0) : above_from_model;
    if (!inverse(world_from_model)) {
      throw SceneError(fmt::format(
          "the transforms above and at node {} multiply to one that cannot be inverted: "
          "their scales are too extreme or not finite",
          name_and_place(node)));
    }
    if (is_full()) {
      refuse(node);
    }
    cover_.show(node, paint.textures.get(), paint.group.get());
    result_.instances.push_back({world_from_model, node.shape,
                                 paint.material ? paint.material : default_material(node),
                                 paint.textures, node.name, path});
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

  std::size_t max_instances_;
  std::size_t visits_ = 0;
  std::size_t extra_bytes_ = 0;  ///< of all paths made; counted as if they were instances
  std::map<std::pair<const TextureSet*, const TextureSet*>, std::shared_ptr<const TextureSet>>
      layers_;
  Flattened result_;
  TextureCover cover_;
  std::shared_ptr<const Material> default_material_;
  std::string first_without_material_;
  std::size_t without_material_ = 0;
};

}  // namespace

Flattened flatten(const Node& root, std::size_t max_instances) {
  return Flattener(max_instances).take(root);
}

}  // namespace rt
