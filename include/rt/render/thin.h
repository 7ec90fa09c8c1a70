#pragma once
/// Things so narrow that the pilot samples of a pixel fall beside them: wires, beads, edges of
/// sheets, in sight or as shadows. Their boxes say where they are; pixels whose beam meets one take
/// so many pilots that some hit it. The number follows from geometry alone, before any sample is
/// taken: it favours no outcome, and the mean stays unbiased.
///
/// Not found are thin things in mirrors and glass, single triangles of a mesh (which counts as one
/// thing), and shadows from lights with an extent.
#include <array>
#include <memory>
#include <vector>

#include "rt/math/bounds.h"
#include "rt/math/ray.h"

namespace rt {

struct RenderPlan;
class BoxTree;

/// A ray with a radius: r at its origin, changing evenly to r + slope t.
struct Beam {
  Ray axis;  ///< unit direction
  double radius;
  double slope;
};

/// Boxes in any position that may be met by beams.
class ThinBoxes {
 public:
  /// A box by its centre and half its edges, not parallel.
  struct Box {
    Vec3 centre;
    std::array<Vec3, 3> edges;
    std::array<Vec3, 3> normals;  ///< dot products with these are coordinates in units of the edges
  };

  ThinBoxes();
  ~ThinBoxes();
  void add(const Vec3& centre, const std::array<Vec3, 3>& edges, double largest_beam);
  void build();
  bool empty() const { return boxes_.empty(); }

  /// How much the boxes that the beam meets before t_max cover of a disc of its radius, each as
  /// seen along the beam, all together; 0 when it meets none.
  double coverage(const Beam& beam, double t_max) const;

 private:
  std::vector<Box> boxes_;
  std::vector<Bounds> bounds_;  ///< with room for the largest beam
  std::unique_ptr<const BoxTree> tree_;
};

struct ThinThings {
  ThinBoxes in_sight;
  ThinBoxes as_shadows;
};

/// The thin things of a plan; null when it has none.
std::unique_ptr<const ThinThings> find_thin(const RenderPlan& plan);

/// The pilots that pixel (x, y) should take for the sake of thin things; 0: none in particular.
int thin_pilots(const RenderPlan& plan, int x, int y);

}  // namespace rt
