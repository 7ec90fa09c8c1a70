#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "rt/scene/node.h"

namespace rt {

/// Finds textures that will not be seen, while the graph is walked.
class TextureCover {
 public:
  /// A node without a shape that has textures, and the one whose textures it adds to.
  struct Group {
    const Node* node;
    std::shared_ptr<const Group> above;
    mutable bool shown = false;  ///< and so are all above
  };

  /// To be called for each node: the groups whose textures hold for it and for what is below it,
  /// where those of `inherited` would if it had none of its own.
  std::shared_ptr<const Group> enter(const Node& node, std::shared_ptr<const Group> inherited);
  /// The shape of `node` shows `textures`, those of `group` among them.
  void show(const Node& node, const TextureSet* textures, const Group* group);

  /// At most one for groups none of whose textures is shown, one for meshes.
  std::vector<std::string> warnings() const;

 private:
  std::vector<const Node*> groups_;
  std::unordered_set<const Node*> known_;
  std::unordered_set<const Node*> shown_;
  const Node* mesh_without_coordinates_ = nullptr;  ///< the first
};

}  // namespace rt
