#include "rays/scenes.h"

#include <cmath>
#include <random>

#include "rt/math/sampler.h"
#include "rt/math/warp.h"
#include "rt/render/query.h"
#include "rt/render/shading.h"

namespace rt::bench {
namespace {

constexpr double side = 4.0;  ///< of the cube that the subjects fill
const Vec3 light(3.0, 8.0, 5.0);

Instance instance_of(std::shared_ptr<const Shape> shape, std::shared_ptr<const Material> material) {
  return {{}, std::move(shape), std::move(material), nullptr, "thing"};
}

}  // namespace

Subject cloud_of_balls(int count) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<> u(-0.5 * side, 0.5 * side);
  const double radius = 0.3 * side / std::cbrt(count);
  Subject subject;
  for (int i = 0; i < count; ++i) {
    const double x = u(engine);
    const double y = u(engine);
    subject.balls.push_back({{x, y, u(engine)}, radius});
  }
  return subject;
}

Subject rippled_sheet(int triangles) {
  const auto n = static_cast<std::uint32_t>(std::sqrt(triangles / 2.0));
  auto mesh = std::make_shared<MeshData>();
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) {
      const double x = side * (static_cast<double>(i) / n - 0.5);
      const double z = side * (static_cast<double>(j) / n - 0.5);
      mesh->positions.emplace_back(x, 0.4 * std::sin(5.0 * x) * std::cos(4.0 * z), z);
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j;
      mesh->triangles.push_back({a, a + 1, a + n + 1});
      mesh->triangles.push_back({a + 1, a + n + 2, a + n + 1});
    }
  }
  arrange(*mesh);
  return {{}, mesh};
}

RenderJob job_of(const Subject& subject, int edge) {
  RenderJob job;
  const auto material = std::make_shared<const Material>();
  for (const Sphere& ball : subject.balls) {
    job.instances.push_back(instance_of(std::make_shared<const Shape>(ball), material));
  }
  if (subject.mesh) {
    job.instances.push_back(
        instance_of(std::make_shared<const Shape>(Mesh{subject.mesh}), material));
  }
  job.camera.eye = {0.5, 3.0, 6.0};
  job.camera.view = -job.camera.eye;
  job.camera.fov = 40.0;
  job.options.width = job.options.height = edge;
  Light lamp;
  lamp.position = light;
  job.lights.push_back(lamp);
  return job;
}

std::vector<Rays> rays_through(const RenderPlan& plan, int edge) {
  std::vector<Rays> found{{"camera", {}, {}}, {"diffuse", {}, {}}, {"shadow", {}, {}}};
  for (int i = 0; i < edge * edge; ++i) {
    const int x = i % edge;
    const int y = i / edge;
    const TraceRay ray{Vec3(0.0),
                       glm::normalize(plan.camera.direction((x + 0.5) / edge, (y + 0.5) / edge))};
    found[0].rays.push_back(ray);
    const auto hit = closest_hit(plan, ray);
    if (!hit) {
      continue;
    }
    const ShadingPoint point = shading_point(plan, ray, *hit);
    const Vec3 bounce = to_cosine_hemisphere(Sampler(1, x, y, 0).lobe());
    found[1].rays.push_back(leave(point, frame_about(point.normal).to_world(bounce)));
    const Vec3 way = plan.lights[0].position - point.position;
    const double reach = glm::length(way);
    if (glm::dot(way, point.normal) > 0.0) {
      found[2].rays.push_back(leave(point, way / reach));
      found[2].reach.push_back(reach);
    }
  }
  return found;
}

}  // namespace rt::bench
