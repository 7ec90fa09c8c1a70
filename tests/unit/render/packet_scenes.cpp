#include "packet_scenes.h"

#include "rt/math/warp.h"

namespace rt::test {
namespace {

constexpr int width = 40;
constexpr int height = 30;

Material frosted(double ior, double opacity, double glossiness) {
  Material m = matt({0.6, 0.3, 0.2});
  m.ks = Rgb(0.4);
  m.shininess = 30;
  m.ior = ior;
  m.opacity = opacity;
  m.glossiness = glossiness;
  return m;
}

Material mirror(double glossiness = 0.0) {
  Material m = matt({0.1, 0.2, 0.1});
  m.reflectivity = {0.8, 0.7, 0.6};
  m.glossiness = glossiness;
  return m;
}

RenderJob room() {
  RenderJob job = job_looking({0, 2, 7}, {0, 0.7, 0}, width, height);
  add(job, Plane{}, {}, matt({0.6, 0.6, 0.5}));
  job.lights.push_back({.position = {4, 7, 5}, .colour = Rgb(0.7), .falloff = {1, 0.01, 0.002}});
  job.lights.push_back({.position = {-6, 5, 3}, .colour = {0.3, 0.2, 0.3}});
  job.ambient = Rgb(0.2);
  job.options.background = {{0.2, 0.3, 0.6}, {0.8, 0.8, 0.9}};
  return job;
}

/// An octahedron with its vertices' normals: far from its faces'.
std::shared_ptr<MeshData> smooth_octahedron() {
  auto data = std::make_shared<MeshData>();
  data->positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  data->triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                     {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  data->normals = data->positions;
  data->triangle_normals = data->triangles;
  return data;
}

/// The unit ball by latitude and longitude, rippled; with its normals where `smooth`. Triangles at the
/// poles have no area, and every tenth comes twice.
std::shared_ptr<MeshData> fine_ball(bool smooth) {
  constexpr std::uint32_t edge = 14;
  auto data = std::make_shared<MeshData>();
  for (std::uint32_t i = 0; i <= edge; ++i) {
    for (std::uint32_t j = 0; j <= edge; ++j) {
      const double down = pi * i / edge;
      const double round = 2.0 * pi * (j % edge) / edge;
      const Vec3 normal(std::sin(down) * std::cos(round), std::cos(down),
                        -std::sin(down) * std::sin(round));
      data->positions.push_back((1.0 + 0.05 * std::sin(5.0 * round)) * normal);
      data->normals.push_back(normal);
      if (i < edge && j < edge) {
        const std::uint32_t a = i * (edge + 1) + j;
        data->triangles.push_back({a, a + edge + 1, a + 1});
        data->triangles.push_back({a + 1, a + edge + 1, a + edge + 2});
        if (data->triangles.size() % 10 < 2) {
          data->triangles.push_back(data->triangles.back());
        }
      }
    }
  }
  if (smooth) {
    data->triangle_normals = data->triangles;
  } else {
    data->normals.clear();
  }
  return data;
}

}  // namespace

RenderJob glass_scene() {
  RenderJob job = room();
  add(job, Sphere{}, Affine::translation({-2, 1, 0}), glass(1.5));
  add(job, Sphere{}, Affine::translation({-2, 1, 0}) * Affine::scaling(Vec3(0.5)), glass(1.2));
  add(job, Box{}, Affine::translation({0, 0, -0.5}), glass(1.4));
  add(job, Box{}, Affine::translation({1, 0, -0.5}), frosted(1.7, 0.5, 0.0));
  add(job, Torus{}, Affine::translation({0, 0.4, 2}) * Affine::rotation(0, 20), glass(1.6));
  add(job, Cylinder{}, Affine::translation({2.4, 0, 0.4}) * Affine::scaling({0.4, 1.2, 0.4}),
      frosted(1.3, 0.2, 0.0));
  add(job, Blob{}, Affine::translation({-0.4, 2, -2}), frosted(1.0, 0.7, 0.0));
  add(job, Square{}, Affine::translation({1, 1.8, 1}) * Affine::rotation(0, 70), glass(1.5));
  return job;
}

RenderJob gloss_scene() {
  RenderJob job = room();
  job.lights[0].radius = 0.8;
  job.lights[1].rectangle = Light::Rectangle{{2, 0, 0}, {0, 0.5, 1}};
  add(job, Sphere{}, Affine::translation({-1.5, 1, 0}), mirror(0.3));
  add(job, Sphere{}, Affine::translation({1.5, 1, 0}), frosted(1.5, 0.1, 0.2));
  add(job, Sphere{}, Affine::translation({1.5, 1, 0}) * Affine::scaling(Vec3(0.4)), glass(1.1));
  add(job, Box{}, Affine::translation({-0.5, 0, -3}) * Affine::scaling({1, 2, 0.2}), mirror());
  add(job, Torus{}, Affine::translation({0, 0.4, 2}), mirror(0.8));
  return job;
}

RenderJob textured_scene() {
  RenderJob job = room();
  paint(job, Checker{{0.8, 0.8, 0.7}, {0.2, 0.3, 0.2}, 0.7});
  const auto put = [&](const Shape& shape, const Vec3& at, const Material& m) {
    add(job, shape, Affine::translation(at) * Affine::rotation(1, 25), m);
  };
  const Texture waves =
      formula([](const Vec2& uv) { return Rgb(std::sin(20 * uv.x) * std::cos(17 * uv.y)); });
  put(Sphere{}, {-2.2, 1, 0}, mirror());
  paint(job, waves, TextureSlot::bump, 0.1);
  paint(job, Checker{Rgb(0.9), Rgb(0.1), 0.3});
  put(Box{}, {-0.5, 0, 0}, matt(Rgb(0.5)));
  paint(job, formula([](const Vec2& uv) { return Rgb(0.5 + 0.3 * uv.x, 0.4, 0.8); }),
        TextureSlot::normal);
  paint(job, coordinates_picture(), TextureSlot::ks);
  put(Sphere{}, {2, 1, 0}, glass(1.4));
  paint(job, Checker{Rgb(1.0), Rgb(0.0), 0.4}, TextureSlot::opacity);
  paint(job, waves, TextureSlot::bump, 0.2);
  put(Cylinder{}, {0.8, 0, 1.8}, matt(Rgb(0.7)));
  paint(job, Checker{Rgb(0.0), {0.9, 0.2, 0.1}, 0.25});  // black in part
  paint(job, Checker{Rgb(0.4), {0.0, 0.2, 0.1}, 0.1}, TextureSlot::ks);
  put(Torus{}, {-1, 0.3, 2.4}, frosted(1.2, 0.5, 0.0));
  paint(job, NoiseTexture{.noise = std::make_shared<const Noise>(3)});
  paint(job, Checker{Rgb(0.9), Rgb(0.2), 0.2}, TextureSlot::opacity);
  return job;
}

RenderJob mesh_scene() {
  RenderJob job = room();
  const Mesh mesh{smooth_octahedron()};
  add(job, mesh, Affine::translation({-2.2, 1, 0}) * Affine::rotation(1, 20), mirror());
  add(job, mesh, Affine::translation({0, 1, 0}) * Affine::rotation(1, 50), glass(1.5));
  add(job, mesh, Affine::translation({2.2, 1, 0}) * Affine::scaling({1, -0.7, 1}),
      frosted(1, 1, 0));
  add(job, PointedCone{}, Affine::translation({1, 0, 2}), frosted(1.4, 0.3, 0.0));
  add(job, PointedCone{}, Affine::translation({-1, 0, 2}) * Affine::scaling({0.5, 1, 0.5}),
      mirror());
  return job;
}

RenderJob fine_mesh_scene() {
  RenderJob job = room();
  job.lights[1].radius = 0.5;
  const Mesh smooth{fine_ball(true)};
  const Mesh flat{fine_ball(false)};
  const auto at = [](const Vec3& place) {
    return Affine::translation(place) * Affine::rotation(0, 20);
  };
  add(job, smooth, at({-2.2, 1, 0}), mirror());
  add(job, flat, at({0, 1, 0}), glass(1.5));
  add(job, flat, at({0, 1, 0}) * Affine::scaling(Vec3(0.5)), matt({0.2, 0.7, 0.3}));
  add(job, smooth, at({2.2, 1, 0}) * Affine::scaling({1, -0.7, 1.2}), frosted(1, 1, 0));
  add(job, smooth, Affine::translation({0.3, 0.5, 2}) * Affine::scaling(Vec3(0.5)),
      frosted(1.4, 0.3, 0.1));
  return job;
}

RenderJob absorbing_scene(double water_level) {
  const auto coloured = [](double ior, const Rgb& absorption) {
    Material m = glass(ior);
    m.absorption = absorption;
    return m;
  };
  RenderJob job = room();
  add(job, Plane{}, Affine::translation({0, water_level, 0}), coloured(1.33, {0.4, 0.1, 0.05}));
  add(job, Sphere{}, Affine::translation({-2, 1, 0}), coloured(1.5, {0.1, 0.8, 0.8}));
  add(job, Sphere{}, Affine::translation({-2, 1, 0}) * Affine::scaling(Vec3(0.5)), glass(1.0));
  add(job, Box{}, Affine::translation({0, 0, -0.5}), coloured(1.4, {0.9, 0.1, 0.9}));
  add(job, Box{}, Affine::translation({0.5, 0.2, -0.3}), coloured(1.4, {0.1, 0.9, 0.9}));
  add(job, Sphere{}, Affine::translation({2, 1, -1}), mirror());
  add(job, Sphere{}, Affine::translation({0.6, 0.5, 0.2}) * Affine::scaling(Vec3(0.2)), mirror());
  Material wine = frosted(1.4, 0.3, 0.2);
  wine.absorption = {0.1, 2.0, 1.5};
  add(job, Cylinder{}, Affine::translation({1.2, 0, 2}) * Affine::scaling(Vec3(0.5)), wine);
  return job;
}

RenderJob moving_scene() {
  RenderJob job = room();
  job.lights[0].travel = {-3, 1, 0};
  job.lights[1].radius = 0.5;
  job.lights[1].travel = {0, 1, 2};
  Pose there;
  there.translate = {0.4, 0.1, -0.3};
  there.degrees = 40;
  there.scale = {1.0, 1.2, 1.0};
  const Shape shapes[] = {Sphere{}, Box{}, Torus{}, Cylinder{}, Mesh{smooth_octahedron()}};
  Material coloured = glass(1.5);
  coloured.absorption = {0.1, 0.8, 0.8};
  const Material materials[] = {mirror(), matt({0.7, 0.3, 0.2}), coloured, mirror(0.3)};
  for (int i = 0; i < 20; ++i) {
    const Affine at = Affine::translation({-3 + 1.2 * (i % 5), 0.7, 2 - 1.5 * (i / 5)}) *
                      Affine::scaling(Vec3(0.5));
    if (i % 3 == 1) {
      add(job, shapes[i % 5], at, materials[i % 4]);
    } else {
      add_moving(job, shapes[i % 5], at, materials[i % 4], moving(there));
    }
    if (i % 4 == 1) {
      paint(job, Checker{Rgb(0.9), Rgb(0.1), 0.3});
    }
  }
  auto to = std::make_shared<Camera>(job.camera);
  to->eye += Vec3(0.3, 0.1, 0);
  to->view += Vec3(0.4, 0, 0);
  job.camera.to = to;
  return job;
}

RenderJob coincident_scene() {
  RenderJob job = room();
  const Affine left = Affine::translation({-1.8, 1, 0}) * Affine::rotation(1, 13);
  add(job, Sphere{}, left, glass(1.5));
  add(job, Sphere{}, left * Affine::rotation(0, 40), frosted(1, 1, 0));
  add(job, Sphere{}, left, matt({0.9, 0.1, 0.1}));
  for (int i = 0; i < 3; ++i) {
    add(job, Box{}, Affine::translation({0.3 + i, 0, 0}),
        i == 1 ? glass(1.5) : frosted(1.3, i == 0 ? 1 : 0.5, 0));
  }
  add(job, Blob{}, Affine::translation({0, 1, 2}) * Affine::scaling(Vec3(0.5)), mirror());
  add(job, Blob{}, Affine::translation({0, 1, 2}) * Affine::scaling(Vec3(0.5)), matt(Rgb(0.3)));
  return job;
}

RenderJob crowded_scene() {
  RenderJob job = room();
  const Shape shapes[] = {Sphere{}, Box{},    Torus{},       Cylinder{},
                          Blob{},   Square{}, PointedCone{}, Mesh{smooth_octahedron()}};
  const Material materials[] = {matt({0.7, 0.3, 0.2}), mirror(), glass(1.3), frosted(1.5, 0.6, 0.0),
                                frosted(1, 1, 0)};
  for (int i = 0; i < 160; ++i) {
    const double place = i;
    const Affine at =
        Affine::translation({-3 + 0.4 * (i % 16), 0.2 + 0.4 * (i / 64), 2 - 0.7 * (i / 16)}) *
        Affine::rotation(i % 3, 17 * place) *
        Affine::scaling({0.2, i % 7 == 0 ? -0.3 : 0.2, i % 5 == 0 ? 0.1 : 0.2});
    add(job, shapes[i % 8], at, materials[i % 5]);
  }
  return job;
}

namespace {

/// The scene moved as a whole: render space stays where the eye is.
RenderJob moved(RenderJob job, const Vec3& by) {
  for (std::size_t i = 0; i < job.instances.size(); ++i) {
    Instance there = job.instances[i];
    there.world_from_model.offset += by;
    job.instances.replace(i, there);
  }
  for (Light& light : job.lights) {
    light.position += by;
  }
  job.camera.eye += by;
  return job;
}

RenderJob seen_from_afar(RenderJob job) {
  job.camera.fov = 0.02;
  job.camera.eye *= 1e3;
  job.camera.view *= 1e3;
  return job;
}

/// Every instance shows the footprints it is looked at with.
RenderJob showing_footprints(RenderJob job) {
  auto set = std::make_shared<TextureSet>();
  (*set)[TextureSlot::kd] = {std::make_shared<const Texture>(
                                 ImageTexture{std::make_shared<const FootprintImage>()}),
                             1.0};
  for (std::size_t i = 0; i < job.instances.size(); ++i) {
    Instance shown = job.instances[i];
    shown.textures = set;
    job.instances.replace(i, shown);
  }
  return job;
}

RenderJob through_a_lens(RenderJob job) {
  job.camera.aperture = 0.4;
  job.camera.focus = 6.0;
  return job;
}

}  // namespace

std::vector<PacketScene> packet_scenes() {
  std::vector<PacketScene> all{{"mixed", mixed_scene(width, height)},
                               {"glass", glass_scene()},
                               {"gloss", gloss_scene()},
                               {"textures", textured_scene()},
                               {"meshes", mesh_scene()},
                               {"fine meshes", fine_mesh_scene()},
                               {"fine meshes from afar", seen_from_afar(fine_mesh_scene())},
                               {"coincident", coincident_scene()},
                               {"crowd", crowded_scene()},
                               {"glass moved", moved(glass_scene(), {1e6, -2e6, 3e5})},
                               {"coincident from afar", seen_from_afar(coincident_scene())},
                               {"crowd from afar", seen_from_afar(crowded_scene())},
                               {"lens", through_a_lens(gloss_scene())},
                               {"absorption", absorbing_scene(0.3)},
                               {"motion", moving_scene()}};
  RenderJob within = gloss_scene();
  within.lights[0].position = {0, 1, 0.5};  // surfaces inside the light
  within.lights[0].radius = 1.2;
  within.lights[1].position = {0, 0, 2};  // cut by the plane
  all.push_back({"lights within", within});
  RenderJob deep = glass_scene();
  deep.options.max_depth = 30;
  deep.options.max_error = 1e-6;
  deep.options.filter = Filter::blackman_harris;
  all.push_back({"deep", deep});
  RenderJob rough = gloss_scene();
  rough.options.max_error = 0.2;  // roulette all the time
  rough.options.filter = Filter::box;
  all.push_back({"roulette", rough});
  RenderJob dull = glass_scene();
  dull.options.reflection = false;
  dull.options.filter = Filter::tent;
  all.push_back({"without reflection", dull});
  RenderJob diving = absorbing_scene(3.0);  // no surface between light and floor
  diving.lights[1].position = {-1, 1.5, 1.5};
  all.push_back({"under water", diving});
  RenderJob unfiltered = textured_scene();
  unfiltered.options.texture_filter = false;
  all.push_back({"unfiltered textures", unfiltered});
  for (const auto& [name, job] : std::vector(all)) {
    all.push_back({"footprints of " + name, showing_footprints(job)});
  }
  return all;
}

}  // namespace rt::test
