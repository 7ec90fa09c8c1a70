#pragma once
#include <memory>
#include <string>
#include <vector>

#include "rt/geometry/shape.h"
#include "rt/math/transform.h"
#include "rt/scene/instance_list.h"
#include "rt/scene/material.h"
#include "rt/scene/motion.h"
#include "rt/scene/texture_set.h"

namespace rt {

/// A node of the authoring graph. Nodes are shared: one child under two parents is instancing.
struct Node {
  Node() = default;
  /// Lets go of the children in a loop: a chain of a million nodes would overflow the stack if each
  /// destroyed the next.
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  std::string name;
  /// script:line of its making, for messages; null: not known. Nodes of one line share it.
  std::shared_ptr<const std::string> where;
  Affine parent_from_node;               ///< maps this node's space into its parent's
  std::shared_ptr<const Motion> motion;  ///< of the node so placed, in its parent's space; or null
  std::shared_ptr<const Material> material;  ///< null: inherit the nearest ancestor's
  /// Of `material` where that is set here, else of the inherited material, on top of the textures
  /// inherited with it. Inherited together with the material. Null: none.
  std::shared_ptr<const TextureSet> textures;
  std::shared_ptr<const Shape> shape;  ///< null: groups its children only
  std::vector<std::shared_ptr<Node>> children;
  bool has_parent = false;  ///< has been added under some node; kept by add_child
};

/// The node's name in quotes and, where it is known, the place of its making: 'arm' (scene.lua:12).
std::string name_and_place(const Node& node);

/// How a node's transforms add up. Pre-multiplied, as in the course framework, a rotation after a
/// translation turns the translated node about its parent's origin; post-multiplied, as in its
/// older versions, about the node's own.
enum class TransformOrder { pre, post };

/// The methods of a script's nodes. Each throws SceneError with the node's name when an argument is
/// not finite, or (scale) when it would make the transform singular.
void translate(Node& node, const Vec3& by, TransformOrder order = TransformOrder::pre);
void rotate(Node& node, int axis, double degrees, TransformOrder order = TransformOrder::pre);
void scale(Node& node, const Vec3& factors, TransformOrder order = TransformOrder::pre);
/// Appends a child. Throws SceneError when that would make `parent` a descendant of itself.
void add_child(Node& parent, std::shared_ptr<Node> child);

/// Every shape under `root`, depth first, in the order of add_child; a value copy that later edits
/// of the graph do not touch.
struct Flattened {
  InstanceList instances;
  std::vector<std::string> warnings;  ///< of missing materials, of textures that will not be seen
};

/// What flatten() is to expect of memory: bytes for each instance, the renderer's share included.
/// One with a map of its own takes 130 here and 320 of the renderer while that builds its
/// hierarchy.
inline constexpr std::size_t instance_bytes = 512;

/// Throws SceneError naming the node for a singular or non-finite accumulated transform, and when
/// the graph is deeper than 10 000 nodes; UserError with ExitCode::limit when it comes to more than
/// `max_instances` shapes, or to movements of nested nodes that take as much memory.
Flattened flatten(const Node& root, std::size_t max_instances = 20'000'000);

}  // namespace rt
