#pragma once
/// Scenes of a given number of primitives, as a job and as Embree's own, and rays through them.
#include <vector>

#include "rt/geometry/sphere.h"
#include "rt/render/plan.h"
#include "rt/render/trace.h"
#include "rt/scene/render_job.h"

namespace rt::bench {

/// Balls in a cloud about the origin, or one mesh: a sheet of ripples.
struct Subject {
  std::vector<Sphere> balls;
  std::shared_ptr<const MeshData> mesh;
};

Subject cloud_of_balls(int count);
Subject rippled_sheet(int triangles);

/// Looks at the subject from its side.
RenderJob job_of(const Subject& subject, int edge);

/// One kind of rays. Shadow rays end at `reach`.
struct Rays {
  const char* kind;
  std::vector<TraceRay> rays;
  std::vector<double> reach;
};

/// Rays of the camera through a square picture, row by row; from what they hit one diffuse bounce
/// each, and one shadow ray to a light.
std::vector<Rays> rays_through(const RenderPlan& plan, int edge);

}  // namespace rt::bench
