#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "rt/render/placement.h"

namespace rt {

/// What a placement's maps are, which decides how many bytes are kept of them.
enum class MapKind : std::uint8_t {
  moved,   ///< their linear parts are identities
  scaled,  ///< multiples of the identity
  linear,  ///< any; equal linear parts are mostly kept once
  moving,  ///< changing with time
};

/// The maps of each kind, as views of a PlacementTable. Their numbers are those that Placement's
/// full matrices give, but for the sign of zeros.
struct MovedMap {
  Vec3 to_render, to_model;  ///< offsets

  Ray model_ray(const Ray& r) const { return {r.origin + to_model, r.direction}; }
  Vec3 render_point(const Vec3& p) const { return p + to_render; }
  Vec3 render_vector(const Vec3& v) const { return v; }
  Vec3 model_vector(const Vec3& v) const { return v; }
  Vec3 render_normal(const Vec3& n) const { return n; }
  double model_per_render() const { return 1.0; }
  double render_per_model() const { return 1.0; }
  Placement placement() const;
  bool operator==(const MovedMap&) const = default;
};

struct ScaledMap {
  Vec3 to_render, to_model;  ///< offsets
  double render_factor, model_factor;

  Ray model_ray(const Ray& r) const {
    return {model_factor * r.origin + to_model, model_factor * r.direction};
  }
  Vec3 render_point(const Vec3& p) const { return render_factor * p + to_render; }
  Vec3 render_vector(const Vec3& v) const { return render_factor * v; }
  Vec3 model_vector(const Vec3& v) const { return model_factor * v; }
  Vec3 render_normal(const Vec3& n) const { return scaled_to_unit(n * model_factor); }
  double model_per_render() const { return std::abs(model_factor); }
  double render_per_model() const { return std::abs(render_factor); }
  Placement placement() const;
};

struct LinearParts {
  Mat3 to_render, to_model;
  double render_per_model, model_per_render;  ///< their norms
};

struct LinearMap {
  const Vec3& to_render;  ///< offsets
  const Vec3& to_model;
  const LinearParts& parts;

  Ray model_ray(const Ray& r) const {
    return {parts.to_model * r.origin + to_model, parts.to_model * r.direction};
  }
  Vec3 render_point(const Vec3& p) const { return parts.to_render * p + to_render; }
  Vec3 render_vector(const Vec3& v) const { return parts.to_render * v; }
  Vec3 model_vector(const Vec3& v) const { return parts.to_model * v; }
  Vec3 render_normal(const Vec3& n) const { return scaled_to_unit(n * parts.to_model); }
  double model_per_render() const { return parts.model_per_render; }
  double render_per_model() const { return parts.render_per_model; }
  Placement placement() const;
};

/// Where the instances of a plan are.
class PlacementTable {
 public:
  struct Id {
    MapKind kind;
    std::uint32_t index;  ///< among those of its kind
  };

  Id add(const Placement& placement);
  /// `at_open`: where it is when the shutter opens.
  Id add(const Placement& at_open, PlannedMotion motion);

  /// f(map) of a placement at a time: a MovedMap, ScaledMap or LinearMap.
  template <class F>
  auto visit(MapKind kind, std::uint32_t index, double time, F&& f) const {
    switch (kind) {
      case MapKind::moved:
        return f(moved_[index]);
      case MapKind::scaled:
        return f(scaled_[index]);
      case MapKind::linear: {
        const Linear& map = linear_[index];
        return f(LinearMap{map.to_render, map.to_model, parts_[map.parts]});
      }
      default:
        return visit_moving(index, time, f);
    }
  }

  /// In full. Of what moves: when the shutter opens.
  Placement at_open(MapKind kind, std::uint32_t index) const;
  Placement at(MapKind kind, std::uint32_t index, double time) const;
  /// Of MapKind::moving.
  const PlannedMotion& motion(std::uint32_t index) const { return moving_[index].motion; }

  std::size_t bytes() const;

 private:
  struct Linear {
    Vec3 to_render, to_model;
    std::uint32_t parts;
  };
  struct Moving {
    Placement at_open;
    PlannedMotion motion;
  };

  template <class F>
  auto visit_moving(std::uint32_t index, double time, F& f) const {
    const Placement there = moving_[index].motion.at(time);
    const Affine& to_render = there.render_from_model;
    const Affine& to_model = there.model_from_render;
    if (there.moved_only) {
      return f(MovedMap{to_render.offset, to_model.offset});
    }
    const LinearParts parts{to_render.linear, to_model.linear, there.render_per_model,
                            there.model_per_render};
    return f(LinearMap{to_render.offset, to_model.offset, parts});
  }

  std::uint32_t parts_of(const Placement& placement);

  std::vector<MovedMap> moved_;
  std::vector<ScaledMap> scaled_;
  std::vector<Linear> linear_;
  std::vector<LinearParts> parts_;
  std::vector<Moving> moving_;
  /// Where in parts_ linear parts of some hash were last seen; only to find equal ones.
  std::vector<std::uint32_t> recent_parts_;
};

}  // namespace rt
