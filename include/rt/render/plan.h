#pragma once
/// What is rendered: a RenderJob compiled to flat arrays, in render space.
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rt/math/lobe.h"
#include "rt/render/placement.h"
#include "rt/render/trace.h"
#include "rt/scene/render_job.h"

namespace rt {

class BoxList;
class BoxTree;
class Grid;
struct ThinThings;

/// The triangles of one mesh, shared by all its instances.
struct PlannedMesh {
  std::shared_ptr<const MeshData> data;
  std::unique_ptr<const BoxTree> tree;  ///< over triangles; null: try them one by one
};

/// What a surface reflects and lets through at a point, textures resolved.
struct Reflectances {
  Rgb kd;
  Rgb ks;
  double opacity;
};

/// A material with what follows from it, options considered.
struct PlannedMaterial : Material {
  Reflectances plain{};                 ///< where no texture drives any of it
  bool transmissive = false;            ///< opacity < 1: glass
  double least_r_dot_v = 0.0;           ///< below it no highlight reaches negligible_light()
  std::optional<PowerCosineLobe> lobe;  ///< spreads reflection and transmission; none: perfect
};

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

/// One shape placed in render space; where it moves, as it is when the shutter opens.
struct PlannedInstance : Placement {
  std::shared_ptr<const Shape> shape;
  std::shared_ptr<const TextureSet> textures;  ///< those in force; null: none
  std::uint32_t material = 0;
  Shadow shadow = Shadow::blocks;
  const PlannedMesh* mesh = nullptr;
  bool convex = false;  ///< a ray that has left it outward never meets it again
  std::unique_ptr<const PlannedMotion> motion;  ///< null: it stands still
};

/// Where an instance is at a time.
class PlacementAt {
 public:
  PlacementAt(const PlannedInstance& instance, double time) : placement_(&instance) {
    if (instance.motion) {
      placement_ = &moving_.emplace(instance.motion->at(time));
    }
  }
  PlacementAt(const PlacementAt&) = delete;
  PlacementAt& operator=(const PlacementAt&) = delete;
  const Placement& operator*() const { return *placement_; }
  const Placement* operator->() const { return placement_; }

 private:
  const Placement* placement_;
  std::optional<Placement> moving_;
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

  std::vector<PlannedInstance> instances;
  std::vector<std::unique_ptr<const PlannedMesh>> meshes;
  std::vector<std::uint32_t> unbounded;  ///< instances no box can hold
  std::vector<std::uint32_t> bounded;    ///< the others: what the tree's boxes stand for
  /// Over `bounded`: a hierarchy, for a few a list, on request a grid; none: try them one by one.
  std::unique_ptr<const BoxTree> tree;
  std::unique_ptr<const BoxList> list;
  std::unique_ptr<const Grid> grid;
  /// The same boxes where it is none of the first two, for extended lights: what may stand before
  /// them decides how they are sampled, so it must not depend on how rays are traced.
  std::unique_ptr<const BoxList> shaft_list;
  std::unique_ptr<const ThinThings> thin;  ///< null: nothing is narrower than pixels
  std::vector<PlannedMaterial> materials;
  std::vector<Light> lights;  ///< positions in render space
  CameraFrame camera;         ///< when the shutter opens
  /// Set where the camera moves: the path of its frame, and of its eye in render space.
  std::unique_ptr<const Camera> moving_camera;
  Rgb ambient{0.0};
  RenderOptions options;

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

/// Compiles a job. The job's options are those in force.
RenderPlan make_plan(const RenderJob& job);

}  // namespace rt
