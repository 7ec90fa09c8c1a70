#pragma once
/// Things so narrow that the pilot samples of a pixel fall beside them: wires, beads, edges of
/// sheets, in sight or as shadows. Their boxes say where they are; pixels whose beam meets one take
/// so many pilots that some hit it. The number follows from geometry alone, before any sample is
/// taken: it favours no outcome, and the mean stays unbiased.
///
/// Not found are thin things in mirrors and glass, single triangles of a mesh (which counts as one
/// thing), and shadows from lights with an extent.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"

namespace rt {

struct RenderPlan;

/// A ray with a radius: r at its origin, changing evenly to r + slope t, never below 0.
struct Beam {
  Ray axis;  ///< unit direction
  double radius;
  double slope;

  double radius_at(double t) const;
  /// A cube about its disc at t.
  Bounds cube_at(double t) const;
  /// Whether such a cube at some t up to t_max meets the box.
  bool meets(const Bounds& box, double t_max) const;
};

/// A box in any position, by its centre and half its edges.
struct ThinBox {
  using Edges = std::array<Vec3, 3>;
  Vec3 centre;
  Edges edges;

  /// No corner is further from the centre.
  double reach() const;
  Bounds bounds() const;
  /// How much it covers of a disc of the beam's radius as seen along the beam, where that meets it
  /// before t_max; else 0.
  double coverage(const Beam& beam, double t_max) const;
};

enum class ThinKind : std::uint8_t { in_sight = 1, as_shadow = 2 };

/// The thin things of a plan. A byte an instance: all else follows from the plan when a beam comes
/// near one.
struct ThinThings {
  std::vector<std::uint8_t> kinds;  ///< of each bounded instance, ThinKinds as bits
  unsigned any = 0;                 ///< those that some instance is of

  bool has(ThinKind kind) const { return (any & static_cast<unsigned>(kind)) != 0; }
  bool is(ThinKind kind, std::uint32_t instance) const {
    return (kinds[instance] & static_cast<unsigned>(kind)) != 0;
  }
};

/// Null when the plan has none.
std::unique_ptr<const ThinThings> find_thin(const RenderPlan& plan);

/// The pilots that pixel (x, y) should take for the sake of thin things; 0: none in particular.
int thin_pilots(const RenderPlan& plan, int x, int y);

}  // namespace rt
