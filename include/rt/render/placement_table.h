#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "rt/math/rounding.h"
#include "rt/math/arranged.h"
#include "rt/render/placement.h"

namespace rt {

/// What a placement's maps are, which decides how many bytes are kept of them.
enum class MapKind : std::uint8_t {
  moved,   ///< their linear parts are identities
  scaled,  ///< multiples of the identity
  turned,  ///< multiples of a rotation or reflection
  linear,  ///< any; equal linear parts are mostly kept once
  moving,  ///< changing with time
};

// The maps of each kind. Their numbers are those of Placement's full matrices, but for rounding.
//
// render_covector(): up to a positive factor, a normal's way to render space, or that of its change.
// model_normal(): a unit normal of render space in model space.
// model_offset(): at least what the way to model space adds to a point, in the maximum norm.
// roundings: the way to model space errs by at most gamma(roundings) of the point's and the offset's
// size in model space, and so does what the map says of it to the way back.

struct MovedMap {
  Vec3 offset;  ///< of render space
  static constexpr int roundings = 12;

  Vec3 model_point(const Vec3& p) const { return p - offset; }
  Ray model_ray(const Ray& r) const { return {model_point(r.origin), r.direction}; }
  Vec3 render_point(const Vec3& p) const { return p + offset; }
  Vec3 render_vector(const Vec3& v) const { return v; }
  Vec3 model_vector(const Vec3& v) const { return v; }
  Vec3 render_covector(const Vec3& n) const { return n; }
  Vec3 render_normal(const Vec3& n) const { return n; }
  Vec3 model_normal(const Vec3& n) const { return n; }
  double model_per_render() const { return 1.0; }
  double render_per_model() const { return 1.0; }
  double model_offset() const { return max_abs(offset); }
  Placement placement() const;
  bool operator==(const MovedMap&) const = default;
};

struct ScaledMap {
  Vec3 offset;  ///< of render space
  double render_factor, model_factor;
  static constexpr int roundings = 12;

  Vec3 model_point(const Vec3& p) const { return model_factor * (p - offset); }
  Ray model_ray(const Ray& r) const { return {model_point(r.origin), model_factor * r.direction}; }
  Vec3 render_point(const Vec3& p) const { return render_factor * p + offset; }
  Vec3 render_vector(const Vec3& v) const { return render_factor * v; }
  Vec3 model_vector(const Vec3& v) const { return model_factor * v; }
  Vec3 render_covector(const Vec3& n) const { return n * model_factor; }
  Vec3 render_normal(const Vec3& n) const { return scaled_to_unit(render_covector(n)); }
  Vec3 model_normal(const Vec3& n) const { return scaled_to_unit(n * render_factor); }
  double model_per_render() const { return std::abs(model_factor); }
  double render_per_model() const { return std::abs(render_factor); }
  double model_offset() const { return model_per_render() * max_abs(offset); }
  Placement placement() const;
};

/// A matrix M whose transpose, times the square of `model_factor`, is its inverse but for 12 u in
/// any entry of their product. That moves a point by 36 u of its size; eight roundings come on top.
struct TurnedMap {
  Vec3 offset;  ///< of render space
  Mat3 to_render;
  double model_factor;  ///< > 0
  static constexpr int roundings = 48;

  // v * m is transpose(m) v.
  Vec3 model_vector(const Vec3& v) const { return (model_factor * model_factor) * (v * to_render); }
  Vec3 model_point(const Vec3& p) const { return model_vector(p - offset); }
  Ray model_ray(const Ray& r) const { return {model_point(r.origin), model_vector(r.direction)}; }
  Vec3 render_point(const Vec3& p) const { return to_render * p + offset; }
  Vec3 render_vector(const Vec3& v) const { return to_render * v; }
  Vec3 render_covector(const Vec3& n) const { return to_render * n; }
  Vec3 render_normal(const Vec3& n) const { return scaled_to_unit(render_covector(n)); }
  Vec3 model_normal(const Vec3& n) const { return scaled_to_unit(n * to_render); }
  // Three numbers with a sum of squares s^2 add up to at most 3^(1/2) s; what M lacks of a turn, and
  // rounding, come on top.
  double model_per_render() const { return most_of_row * model_factor; }
  double render_per_model() const { return most_of_row / model_factor; }
  double model_offset() const { return model_per_render() * max_abs(offset); }
  Placement placement() const;

 private:
  static constexpr double most_of_row = std::numbers::sqrt3 * (1 + gamma(roundings));
};

struct LinearParts {
  Mat3 to_render, to_model;
  double render_per_model, model_per_render;  ///< their norms
};

struct LinearMap {
  const Vec3& offset;    ///< of render space
  const Vec3& to_model;  ///< the offset of model space
  const LinearParts& parts;
  static constexpr int roundings = 12;

  Vec3 model_point(const Vec3& p) const { return parts.to_model * p + to_model; }
  Ray model_ray(const Ray& r) const {
    return {model_point(r.origin), parts.to_model * r.direction};
  }
  Vec3 render_point(const Vec3& p) const { return parts.to_render * p + offset; }
  Vec3 render_vector(const Vec3& v) const { return parts.to_render * v; }
  Vec3 model_vector(const Vec3& v) const { return parts.to_model * v; }
  Vec3 render_covector(const Vec3& n) const { return n * parts.to_model; }
  Vec3 render_normal(const Vec3& n) const { return scaled_to_unit(render_covector(n)); }
  Vec3 model_normal(const Vec3& n) const { return scaled_to_unit(n * parts.to_render); }
  double model_per_render() const { return parts.model_per_render; }
  double render_per_model() const { return parts.render_per_model; }
  double model_offset() const { return max_abs(to_model); }
  Placement placement() const;
};

/// Where the instances of a plan are.
class PlacementTable {
 public:
  struct Id {
    MapKind kind;
    std::uint32_t index;  ///< among those of its kind
  };

  /// `round`: of what is the same however it is turned about its origin. Turns are then left out.
  Id add(const Placement& placement, bool round = false);
  /// `at_open`: where it is when the shutter opens.
  Id add(const Placement& at_open, PlannedMotion motion);

  /// f(map) of a placement at a time: a MovedMap, ScaledMap, TurnedMap or LinearMap.
  template <class F>
  auto visit(MapKind kind, std::uint32_t index, double time, F&& f) const {
    switch (kind) {
      case MapKind::moved:
        return f(moved_[index]);
      case MapKind::scaled:
        return f(scaled_[index]);
      case MapKind::turned:
        return f(turned_[index]);
      case MapKind::linear: {
        const Linear& map = linear_[index];
        return f(LinearMap{map.offset, map.to_model, parts_[map.parts]});
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

  /// Once all are there: renumbers them in the order in which each_use(visit) calls visit(kind,
  /// index), which changes the index.
  template <class EachUse>
  void arrange(EachUse&& each_use) {
    recent_ = {};
    arrange_table(moved_, [&](auto&& visit) { each_use(MapKind::moved, visit); });
    arrange_table(scaled_, [&](auto&& visit) { each_use(MapKind::scaled, visit); });
    arrange_table(turned_, [&](auto&& visit) { each_use(MapKind::turned, visit); });
    arrange_table(linear_, [&](auto&& visit) { each_use(MapKind::linear, visit); });
    arrange_table(parts_, [&](auto&& visit) {
      for (Linear& map : linear_) {
        visit(map.parts);
      }
    });
  }

  std::size_t bytes() const;

 private:
  struct Linear {
    Vec3 offset, to_model;
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
      return f(MovedMap{to_render.offset});
    }
    const LinearParts parts{to_render.linear, to_model.linear, there.render_per_model,
                            there.model_per_render};
    return f(LinearMap{to_render.offset, to_model.offset, parts});
  }

  /// Linear parts met before, and where in parts_ they are once they have come again.
  struct Met {
    Mat3 to_render{0.0}, to_model{0.0};
    std::uint32_t parts = none;
  };
  static constexpr std::uint32_t none = ~0U;

  Id add_linear(const Placement& placement);

  std::vector<MovedMap> moved_;
  std::vector<ScaledMap> scaled_;
  std::vector<TurnedMap> turned_;
  std::vector<Linear> linear_;
  std::vector<LinearParts> parts_;
  std::vector<Moving> moving_;
  std::vector<Met> recent_;  ///< by hash; only to find equal ones
};

}  // namespace rt
