#pragma once
/// What is rendered: a RenderJob compiled to flat arrays, in render space.
#include <memory>
#include <vector>

#include "rt/render/trace.h"
#include "rt/scene/render_job.h"

namespace rt {

class BoxTree;

/// The triangles of one mesh, shared by all its instances.
struct PlannedMesh {
  std::shared_ptr<const MeshData> data;
  std::unique_ptr<const BoxTree> tree;  ///< over triangles; null: try them one by one
};

/// One shape placed in render space.
struct PlannedInstance {
  Affine render_from_model;
  Affine model_from_render;
  double model_per_render = 1.0;  ///< norm of model_from_render: bounds how errors grow
  double render_per_model = 1.0;
  std::shared_ptr<const Shape> shape;
  std::uint32_t material = 0;
  const PlannedMesh* mesh = nullptr;
};

/// The camera as the vectors that span its picture. Its eye is the origin of render space.
struct CameraFrame {
  Vec3 forward, right, down;  ///< right and down reach to the picture's edges at distance 1
  /// The ray direction through picture coordinates in [0,1]^2, top left at (0,0). Not normalised.
  Vec3 direction(double x, double y) const {
    return forward + (2.0 * x - 1.0) * right + (2.0 * y - 1.0) * down;
  }
};

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
  std::unique_ptr<const BoxTree> tree;   ///< over `bounded`; null: try them one by one
  std::vector<Material> materials;
  std::vector<Light> lights;  ///< positions in render space
  CameraFrame camera;
  Rgb ambient{0.0};
  RenderOptions options;
};

/// Compiles a job. The job's options are those in force.
RenderPlan make_plan(const RenderJob& job);

}  // namespace rt
