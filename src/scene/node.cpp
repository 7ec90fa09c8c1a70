#include "rt/scene/node.h"

#include <fmt/format.h>

#include <unordered_set>

#include "rt/scene/error.h"

namespace rt {
namespace {

void require_finite(const Node& node, const char* method, const Vec3& v) {
  if (!all_finite(v)) {
    throw SceneError(fmt::format("{} of node '{}': expected finite numbers, got ({}, {}, {})",
                                 method, node.name, v.x, v.y, v.z));
  }
}

void apply(Node& node, const Affine& map, TransformOrder order) {
  node.parent_from_node =
      order == TransformOrder::pre ? map * node.parent_from_node : node.parent_from_node * map;
}

bool reaches(const Node& from, const Node& target) {
  std::vector<const Node*> open{&from};
  std::unordered_set<const Node*> seen;
  while (!open.empty()) {
    const Node* node = open.back();
    open.pop_back();
    if (node == &target) {
      return true;
    }
    for (const auto& child : node->children) {
      if (seen.insert(child.get()).second) {
        open.push_back(child.get());
      }
    }
  }
  return false;
}

}  // namespace

Node::~Node() {
  std::vector<std::shared_ptr<Node>> going = std::move(children);
  while (!going.empty()) {
    const std::shared_ptr<Node> last = std::move(going.back());
    going.pop_back();
    if (last.use_count() == 1) {
      for (auto& child : last->children) {
        going.push_back(std::move(child));
      }
      last->children.clear();
    }
  }
}

std::string name_and_place(const Node& node) {
  return node.where ? fmt::format("'{}' ({})", node.name, *node.where)
                    : fmt::format("'{}'", node.name);
}

void translate(Node& node, const Vec3& by, TransformOrder order) {
  require_finite(node, "translate", by);
  if (order == TransformOrder::pre) {
    node.parent_from_node.offset += by;
  } else {
    apply(node, Affine::translation(by), order);
  }
}

void rotate(Node& node, int axis, double degrees, TransformOrder order) {
  require_finite(node, "rotate", Vec3(degrees));
  apply(node, Affine::rotation(axis, degrees), order);
}

void scale(Node& node, const Vec3& factors, TransformOrder order) {
  require_finite(node, "scale", factors);
  if (factors.x == 0.0 || factors.y == 0.0 || factors.z == 0.0) {
    throw SceneError(
        fmt::format("scale of node '{}': a factor of 0 flattens it to nothing, got ({}, {}, {}); "
                    "use a small factor instead",
                    node.name, factors.x, factors.y, factors.z));
  }
  Affine& map = node.parent_from_node;
  if (order == TransformOrder::pre) {
    map = {{map.linear[0] * factors, map.linear[1] * factors, map.linear[2] * factors},
           map.offset * factors};
  } else {
    apply(node, Affine::scaling(factors), order);
  }
}

void add_child(Node& parent, std::shared_ptr<Node> child) {
  // A node that nobody has as a child is in no subtree but its own: most calls end here.
  if (child.get() == &parent || (parent.has_parent && reaches(*child, parent))) {
    throw SceneError(fmt::format(
        "add_child: node '{}' would contain itself, because '{}' is {} it; add a copy instead",
        child->name, parent.name, child.get() == &parent ? "the same node as" : "below"));
  }
  child->has_parent = true;
  parent.children.push_back(std::move(child));
}

}  // namespace rt
