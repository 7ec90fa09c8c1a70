#pragma once
#include <cstdint>
#include <vector>

#include "rt/math/ray.h"
#include "rt/render/placement.h"

namespace rt {

/// What a placement's maps are, which decides how many bytes are kept of them.
enum class MapKind : std::uint8_t {
  moved,   ///< their linear parts are identities
  scaled,  ///< multiples of the identity
  linear,  ///< any; equal linear parts are mostly kept once
  moving,  ///< changing with time
};

/// Where the instances of a plan are. Every kind of map gives the same numbers as the Placement it
/// was made from, but for the sign of zeros in model rays.
class PlacementTable {
 public:
  struct Id {
    MapKind kind;
    std::uint32_t index;  ///< among those of its kind
  };

  Id add(const Placement& placement);
  /// `at_open`: where it is when the shutter opens.
  Id add(const Placement& at_open, PlannedMotion motion);

  /// In full. Of what moves: when the shutter opens.
  Placement at_open(MapKind kind, std::uint32_t index) const;
  Placement at(MapKind kind, std::uint32_t index, double time) const {
    return kind == MapKind::moving ? moving_[index].motion.at(time) : at_open(kind, index);
  }
  /// Of MapKind::moving.
  const PlannedMotion& motion(std::uint32_t index) const { return moving_[index].motion; }

  /// A ray in model space, with the same parameter t, and how errors grow on the way there.
  struct ModelRay {
    Ray ray;
    double model_per_render;  ///< norm of the map
    double offset;            ///< the largest component of its offset
  };
  ModelRay to_model(MapKind kind, std::uint32_t index, const Ray& ray, double time) const;

  std::size_t bytes() const;

 private:
  struct Offsets {
    Vec3 to_render, to_model;
    bool operator==(const Offsets&) const = default;
  };
  struct Scaled {
    Offsets offsets;
    double to_render, to_model;
  };
  struct LinearParts {
    Mat3 to_render, to_model;
    double model_per_render, render_per_model;
  };
  struct Linear {
    Offsets offsets;
    std::uint32_t parts;
  };
  struct Moving {
    Placement at_open;
    PlannedMotion motion;
  };

  std::uint32_t parts_of(const Placement& placement);

  std::vector<Offsets> moved_;
  std::vector<Scaled> scaled_;
  std::vector<Linear> linear_;
  std::vector<LinearParts> parts_;
  std::vector<Moving> moving_;
  /// Where in parts_ linear parts of some hash were last seen; only to find equal ones.
  std::vector<std::uint32_t> recent_parts_;
};

inline PlacementTable::ModelRay PlacementTable::to_model(MapKind kind, std::uint32_t index,
                                                         const Ray& ray, double time) const {
  switch (kind) {
    case MapKind::moved: {
      const Vec3& offset = moved_[index].to_model;
      return {{ray.origin + offset, ray.direction}, 1.0, max_abs(offset)};
    }
    case MapKind::scaled: {
      const Scaled& map = scaled_[index];
      const Vec3& offset = map.offsets.to_model;
      return {{map.to_model * ray.origin + offset, map.to_model * ray.direction},
              std::abs(map.to_model),
              max_abs(offset)};
    }
    case MapKind::linear: {
      const Linear& map = linear_[index];
      const LinearParts& parts = parts_[map.parts];
      const Vec3& offset = map.offsets.to_model;
      return {{parts.to_model * ray.origin + offset, parts.to_model * ray.direction},
              parts.model_per_render,
              max_abs(offset)};
    }
    default: {
      const Placement there = moving_[index].motion.at(time);
      return {there.ray(ray), there.model_per_render, max_abs(there.model_from_render.offset)};
    }
  }
}

}  // namespace rt
