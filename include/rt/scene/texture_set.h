#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "rt/scene/texture.h"

namespace rt {

/// What a texture may drive.
enum class TextureSlot : std::uint8_t {
  kd,       ///< replaces the material's
  ks,       ///< likewise
  opacity,  ///< likewise, by its grey value; makes the surface transmissive
  bump,     ///< its grey value times the strength is a height above the surface, model units
  normal,   ///< a normal map in the tangent frame: x along u, y along v, z outward
};
inline constexpr std::size_t texture_slots = 5;

/// The textures of a node, one a slot.
struct TextureSet {
  struct Entry {
    std::shared_ptr<const Texture> texture;  ///< null: the slot is empty
    /// Height of a bump of value 1, in model units; a factor to the tilt of a normal map.
    double strength = 1.0;
    std::shared_ptr<const Entry> under;  ///< of bumps: further heights, added up; or null
  };

  const Entry& operator[](TextureSlot slot) const {
    return entries[static_cast<std::size_t>(slot)];
  }
  Entry& operator[](TextureSlot slot) { return entries[static_cast<std::size_t>(slot)]; }
  bool empty() const {
    for (const Entry& entry : entries) {
      if (entry.texture) {
        return false;
      }
    }
    return true;
  }

  std::array<Entry, texture_slots> entries;
};

/// `below`, with the slots that it leaves empty taken from `above`; either may be null.
std::shared_ptr<const TextureSet> layered(const std::shared_ptr<const TextureSet>& above,
                                          const std::shared_ptr<const TextureSet>& below);

}  // namespace rt
