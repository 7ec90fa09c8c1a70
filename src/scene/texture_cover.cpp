#include "texture_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rt {
namespace {

bool has_picture(const TextureSet& textures) {
  return std::ranges::any_of(textures.entries, [](const TextureSet::Entry& entry) {
    return entry.texture && std::holds_alternative<ImageTexture>(*entry.texture);
  });
}

bool lacks_coordinates(const Shape& shape) {
  const auto* mesh = std::get_if<Mesh>(&shape);
  return mesh != nullptr && mesh->data->triangle_uvs.empty();
}

}  // namespace

std::shared_ptr<const TextureCover::Group> TextureCover::enter(
    const Node& node, std::shared_ptr<const Group> inherited) {
  std::shared_ptr<const Group> above = node.material ? nullptr : std::move(inherited);
  if (!node.textures || node.shape) {
    return above;
  }
  if (known_.insert(&node).second) {
    groups_.push_back(&node);
  }
  return std::make_shared<const Group>(Group{&node, std::move(above)});
}

void TextureCover::show(const Node& node, const TextureSet* textures, const Group* group) {
  for (; group != nullptr && !group->shown; group = group->above.get()) {
    group->shown = true;
    shown_.insert(group->node);
  }
  if (mesh_without_coordinates_ == nullptr && textures != nullptr &&
      lacks_coordinates(*node.shape) && has_picture(*textures)) {
    mesh_without_coordinates_ = &node;
  }
}

std::vector<std::string> TextureCover::warnings() const {
  std::vector<std::string> texts;
  std::vector<const Node*> unseen;
  std::ranges::copy_if(groups_, std::back_inserter(unseen),
                       [this](const Node* node) { return !shown_.contains(node); });
  if (!unseen.empty()) {
    texts.push_back(fmt::format(
        "the texture of node {} covers nothing{}: it has no shape, nor is there one below it that "
        "takes its material and textures from it",
        name_and_place(*unseen.front()),
        unseen.size() > 1 ? fmt::format(" (nor do those of {} more)", unseen.size() - 1) : ""));
  }
  if (mesh_without_coordinates_ != nullptr) {
    texts.push_back(fmt::format(
        "mesh {} has no texture coordinates, so that a picture on it shows one colour; an OBJ file "
        "gives them in lines 'vt' and faces 'f v/vt ...'",
        name_and_place(*mesh_without_coordinates_)));
  }
  return texts;
}

}  // namespace rt
