#pragma once
/// What is rendered: a RenderJob compiled to flat arrays, in render space.
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <vector>

#include "rt/math/lobe.h"
#include "rt/render/placement_table.h"
#include "rt/render/planned_light.h"
#include "rt/render/shape_table.h"
#include "rt/render/trace.h"
#include "rt/scene/render_job.h"

namespace rt {

class BoxList;
class BoxTree;
class Grid;
struct ThinThings;

/// What a surface reflects and lets through at a point, textures resolved.
struct Reflectances {
  Rgb kd;
  Rgb ks;
  double opacity;
};

/// A material but for its colour kd, and the textures that drive it, with what follows from them,
/// options considered. The numbers are Material's.
struct PlannedMaterial {
  Rgb ks, reflectivity, absorption, emission;
  double shininess, ior, opacity;
  std::shared_ptr<const TextureSet> textures;  ///< those in force; null: none
  bool transmissive = false;                   ///< opacity < 1: glass
  double least_r_dot_v = 0.0;                  ///< below it no highlight reaches negligible_light()
  std::optional<PowerCosineLobe> lobe;  ///< spreads reflection and transmission; none: perfect

  bool operator==(const PlannedMaterial&) const = default;
};

/// What an instance is made of. Many that differ in colour alone share the rest. 28 bytes, for there
/// may be a million.
struct [[gnu::packed, gnu::aligned(4)]] Coat {
  double red, green, blue;  ///< kd
  std::uint32_t material;

  Coat(const Rgb& kd, std::uint32_t other)
      : red(kd.r), green(kd.g), blue(kd.b), material(other) {}
  Rgb kd() const { return {red, green, blue}; }
};
static_assert(sizeof(Coat) == 28);

/// The contribution of one of `count` lights that is left out: all together, a quarter of an 8-bit
/// step where the display is steepest, at the default max_error.
inline double negligible_light(const RenderOptions& options, std::size_t count) {
  return options.max_error / 256.0 / static_cast<double>(count);
}

/// What an instance does to shadow rays.
enum class Shadow : std::uint8_t {
  blocks,
  dims,  ///< lets (1 - opacity) through at every crossing, less what its inside absorbs
  none,  ///< clear glass where nothing absorbs, and the shapes of lights
};

/// One shape placed in render space: where in the plan's tables to find what it is made of.
struct PlannedInstance {
  std::uint32_t placement = 0;  ///< among those of `map`
  std::uint32_t shape = 0;      ///< among those of `kind`
  std::uint32_t coat = 0;
  std::uint32_t order = 0;  ///< in the script: of two clear or two opaque ones the first owns a surface
  MapKind map = MapKind::moved;
  std::uint8_t kind = 0;  ///< the shape's place in the variant Shape
  Shadow shadow = Shadow::blocks;
  bool convex : 1 = false;  ///< a ray that has left it outward never meets it again
  bool clear : 1 = false;   ///< its material is transmissive

  /// Whether it owns a surface that it shares with another: the opaque one does, else the first.
  bool precedes(const PlannedInstance& other) const {
    return clear != other.clear ? other.clear : order < other.order;
  }
  bool moves() const { return map == MapKind::moving; }
  template <class Kind>
  bool is() const {
    return kind == kind_of<Kind>();
  }
};

/// The camera as the vectors that span its picture. Its eye, the lens' centre, is the origin of
/// render space.
struct CameraFrame {
  Vec3 forward, right, down;  ///< right and down reach to the picture's edges at distance 1
  double lens_radius = 0.0;   ///< 0: a pinhole
  double focus = 1.0;         ///< distance of the plane in focus
  /// The ray direction through picture coordinates in [0,1]^2, top left at (0,0). Not normalised.
  Vec3 direction(double x, double y) const {
    return forward + (2.0 * x - 1.0) * right + (2.0 * y - 1.0) * down;
  }
};

/// The frame of a camera that stands still.
CameraFrame frame_of(const Camera& camera, const RenderOptions& options);

/// The scene, ready to be traced. Immutable while rendering; shared by all threads.
struct RenderPlan {
  RenderPlan();
  ~RenderPlan();
  RenderPlan(RenderPlan&&) noexcept;
  RenderPlan& operator=(RenderPlan&&) noexcept;

  /// What boxes can hold first; where there is a hierarchy over them, in its order.
  std::vector<PlannedInstance> instances;
  std::uint32_t bounded = 0;  ///< so many of them: what the boxes of tree, list or grid stand for
  PlacementTable placements;
  ShapeTable shapes;
  /// Over the triangles of each mesh in `shapes`; null: try them one by one.
  std::vector<std::unique_ptr<const BoxTree>> mesh_trees;
  std::vector<Bounds> mesh_boxes;        ///< of each mesh in `shapes`: its triangles may be many
  /// Over what is bounded: a hierarchy, for a few a list, on request a grid; none: try them one by one.
  std::unique_ptr<const BoxTree> tree;
  std::unique_ptr<const BoxList> list;
  std::unique_ptr<const Grid> grid;
  /// The same boxes where it is none of the first two, for extended lights and thin things: what may
  /// stand before them decides how they are sampled, so it must not depend on how rays are traced.
  std::unique_ptr<const BoxList> shaft_list;
  std::unique_ptr<const ThinThings> thin;  ///< null: nothing is narrower than pixels
  std::vector<PlannedMaterial> materials;
  std::vector<Coat> coats;
  std::vector<PlannedLight> lights;
  CameraFrame camera;  ///< when the shutter opens
  /// Set where the camera moves: the path of its frame, and of its eye in render space.
  std::unique_ptr<const Camera> moving_camera;
  Rgb ambient{0.0};
  RenderOptions options;

  /// Where an instance is; what moves: when the shutter opens.
  Placement placement(const PlannedInstance& instance) const {
    return placements.at_open(instance.map, instance.placement);
  }
  /// f(map) of where an instance is at a time: a MovedMap, ScaledMap, TurnedMap or LinearMap.
  template <class F>
  auto map(const PlannedInstance& instance, double time, F&& f) const {
    return placements.visit(instance.map, instance.placement, time, f);
  }
  /// f(shape) of an instance, as std::visit.
  template <class F>
  auto visit(const PlannedInstance& instance, F&& f) const {
    return shapes.visit(instance.kind, instance.shape, f);
  }
  const PlannedMaterial& material_of(const PlannedInstance& instance) const {
    return materials[coats[instance.coat].material];
  }
  /// Where no texture drives any of it.
  Reflectances plain(const PlannedInstance& instance) const {
    const PlannedMaterial& material = material_of(instance);
    return {coats[instance.coat].kd(), material.ks, material.opacity};
  }
  /// Those that no box can hold.
  auto unbounded() const {
    return std::views::iota(bounded, static_cast<std::uint32_t>(instances.size()));
  }

  // What this scene needs. What it does not need costs nothing.
  bool random = false;      ///< extended lights or gloss: paths take random decisions
  bool dims = false;        ///< some instance dims shadow rays
  bool absorbs = false;     ///< some medium absorbs
  bool moves = false;       ///< something moves: rays have a time
  bool footprints = false;  ///< textures are filtered: rays have differentials

  /// The transmissive instances whose boxes meet that of `instance`, itself included if it is one;
  /// smallest box first. Filled for transmissive instances, and for all where a medium absorbs.
  std::span<const std::uint32_t> media_about(std::uint32_t instance) const {
    const auto [begin, end] = media_ranges[instance];
    return {media.data() + begin, media.data() + end};
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> media_ranges;
  std::vector<std::uint32_t> media;
};

/// The box of the instance's shape, in model space.
Bounds model_box_of(const RenderPlan& plan, const PlannedInstance& instance);

/// The instance's box in render space; where it moves, for all times.
Bounds box_of(const RenderPlan& plan, const PlannedInstance& instance);

/// Compiles a job. The job's options are those in force.
RenderPlan make_plan(const RenderJob& job);

}  // namespace rt
