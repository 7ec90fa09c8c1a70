#include "rt/scene/texture_set.h"

namespace rt {

std::shared_ptr<const TextureSet> layered(const std::shared_ptr<const TextureSet>& above,
                                          const std::shared_ptr<const TextureSet>& below) {
  if (!above || !below) {
    return below ? below : above;
  }
  auto both = std::make_shared<TextureSet>(*below);
  for (std::size_t i = 0; i < texture_slots; ++i) {
    if (!both->entries[i].texture) {
      both->entries[i] = above->entries[i];
    }
  }
  return both;
}

}  // namespace rt
