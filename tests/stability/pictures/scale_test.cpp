// The same picture at any scale, and far from the world's origin.
#include "worlds.h"

namespace rt::test {
namespace {

struct Named {
  const char* name;
  Shape shape;
  Affine place;
};

std::vector<Named> every_primitive() {
  auto data = std::make_shared<MeshData>();
  data->positions = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 1.6, 0}};
  data->triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const Affine up = Affine::translation({0, 1, 0}) * Affine::rotation(1, 20);
  return {{"sphere", Sphere{}, up},
          {"box", Box{{-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7}}, up * Affine::rotation(0, 30)},
          {"cylinder", Cylinder{}, Affine::scaling({0.8, 1.5, 0.8})},
          {"torus", Torus{0.8, 0.3}, up * Affine::rotation(0, 65)},
          {"spindle", Torus{0.4, 0.6}, up},
          {"cone", PointedCone{}, Affine::scaling({0.8, 1.6, 0.8})},
          {"blob", Blob{}, Affine::translation({0, 1, 0})},
          {"square", Square{1.6}, up * Affine::rotation(0, 70)},
          {"mesh", Mesh{data}, Affine::rotation(1, 25)},
          {"capsule", Capsule{1.0, 0.5}, up * Affine::rotation(2, 40)}};
}

/// In the primitive's own space, well inside it.
Vec3 heart_of(const Shape& shape) {
  if (const Torus* torus = std::get_if<Torus>(&shape)) {
    return {torus->major_radius + 0.3 * torus->minor_radius, 0, 0};
  }
  const bool stands = !std::holds_alternative<Sphere>(shape) &&
                      !std::holds_alternative<Box>(shape) && !std::holds_alternative<Blob>(shape);
  return {0, stands ? 0.3 : 0.0, 0};
}

/// The primitive in three materials, on a plane, with shadows of one upon the others.
Film trio(const Named& primitive, const Placement& placement) {
  World world(placement);
  world.look({0, 3, 7}, {0, 0.7, 0}, 36);
  world.light({4, 6, 5});
  world.light({-5, 3, 2}, 0.3);
  world.add(Plane{}, {}, matt({0.6, 0.55, 0.5}));
  const Material materials[] = {matt({0.8, 0.3, 0.2}), mirror(), glass()};
  for (int i = 0; i < 3; ++i) {
    world.add(primitive.shape, Affine::translation({2.0 * (i - 1), 0, 0.3 * i}) * primitive.place,
              materials[i]);
  }
  return world.picture();
}

TEST(Scale, EveryPrimitiveLooksTheSameFrom1e_8To1e8) {
  for (const Named& primitive : every_primitive()) {
    const Film reference = trio(primitive, {});
    ASSERT_TRUE(has_contrast(reference)) << primitive.name;
    for (const double scale : {1e-8, 1e-5, 1e-2, 1e3, 1e6, 1e8}) {
      EXPECT_EQ(differing_pixels(reference, trio(primitive, {scale, Vec3(0.0)})), 0)
          << primitive.name << " at scale " << scale;
    }
  }
}

TEST(Scale, EveryPrimitiveLooksTheSameAMillionSizesOff) {
  for (const Named& primitive : every_primitive()) {
    const Film reference = trio(primitive, {});
    for (const double scale : {1e-8, 1.0, 1e8}) {
      const Vec3 offset = scale * 1e6 * Vec3(1, -1, 1);
      EXPECT_EQ(differing_pixels(reference, trio(primitive, {scale, offset})), 0)
          << primitive.name << " at scale " << scale;
    }
  }
}

TEST(Scale, InsideASphereTheLightAtItsCentreReachesAll) {
  for (const double scale : {1e-8, 1e-3, 1.0, 1e4, 1e8}) {
    World world({scale, Vec3(0.0)}, 40, 30);
    world.look({0.2, 0.1, 0.3}, {1, 0, 0}, 100);
    world.light({0, 0, 0}, 1.0);
    world.add(Sphere{}, {}, matt(Rgb(0.5)));
    // n.l = 1 everywhere: 0.5 (0.25 + 1).
    for (const float p : world.picture().pixels) {
      EXPECT_NEAR(p, 0.625, 1e-6) << scale;  // a float's rounding, times ten
    }
  }
}

/// From inside, the light with us: walls of the material, and what is seen past them through glass.
Film inside(const Named& primitive, const Material& material, const Placement& placement) {
  World world(placement, 60, 45);
  const Vec3 eye = primitive.place.point(heart_of(primitive.shape));
  world.look(eye, eye + Vec3(1, 0.3, 0.4), 100);
  world.light(eye + Vec3(0.01, 0.05, -0.02));
  world.light({4, 6, 5});
  world.add(Plane{}, Affine::translation({0, -1.5, 0}), matt({0.6, 0.55, 0.5}));
  world.add(primitive.shape, primitive.place, material);
  return world.picture();
}

TEST(Scale, InsideEveryClosedPrimitiveItLooksTheSame) {
  Material polished = matt({0.5, 0.4, 0.3});
  polished.reflectivity = Rgb(0.4);
  for (const Named& primitive : every_primitive()) {
    if (std::holds_alternative<Square>(primitive.shape)) {
      continue;
    }
    for (const Material& material : {matt({0.8, 0.3, 0.2}), polished, glass()}) {
      const Film reference = inside(primitive, material, {});
      ASSERT_TRUE(has_contrast(reference)) << primitive.name;
      for (const Placement& placement :
           {Placement{1e-8, Vec3(0.0)}, Placement{1e-3, Vec3(0.0)}, Placement{1e8, Vec3(0.0)},
            Placement{1.0, 1e6 * Vec3(1, -1, 1)}}) {
        EXPECT_EQ(differing_pixels(reference, inside(primitive, material, placement)), 0)
            << primitive.name << " at scale " << placement.scale << ", off by "
            << placement.offset.x;
      }
    }
  }
}

TEST(Scale, AHugeSpheresTerminatorHasNoAcne) {
  // Seen from above the terminator; a convex solid shadows nothing but its far half, so the value
  // is kd (ambient + n.l) in closed form.
  for (const double scale : {1e-8, 1e-4, 1.0, 1e4, 1e8}) {
    World world({scale, Vec3(0.0)}, 120, 90);
    world.look({0, 1.5, 0}, {0, 0, 0}, 60, {0, 0, -1});
    world.light({1e3, 0, 0}, 1.0);
    world.add(Sphere{}, {}, matt(Rgb(1.0)));
    const Film film = world.picture();
    const double edge = std::tan(30.0 * std::numbers::pi / 180.0);
    for (int y = 0; y < 90; ++y) {
      for (int x = 0; x < 120; ++x) {
        const double px = (2.0 * (x + 0.5) / 120 - 1.0) * edge * 120 / 90;
        const double pz = (2.0 * (y + 0.5) / 90 - 1.0) * edge;
        const Vec3 d = glm::normalize(Vec3(px, -1.0, pz));
        const double b = 1.5 * -d.y;
        const double discriminant = b * b - 1.25;
        if (discriminant <= 0.0) {
          continue;
        }
        const Vec3 n = Vec3(0, 1.5, 0) + (b - std::sqrt(discriminant)) * d;
        const Vec3 l = glm::normalize(Vec3(1e3, 0, 0) - n);
        const double expected = 0.25 + std::max(0.0, glm::dot(n, l));
        // Lights below max_error / 256 are left out.
        EXPECT_NEAR(film.pixels[static_cast<std::size_t>(3 * (120 * y + x))], expected, 0.02 / 256)
            << scale << " " << x << " " << y;
      }
    }
  }
}

TEST(Scale, ASphereSeenFromTwentyMillionRadii) {
  const auto seen_from = [](double distance) {
    World world({}, 120, 120);
    world.look({0, 0, distance}, {0, 0, 0}, 2.4 / distance * 180.0 / std::numbers::pi);
    world.light({3e9, 4e9, 5e9});
    world.add(Sphere{}, {}, matt({0.8, 0.5, 0.3}));
    return world.picture();
  };
  // From 2e5 radii perspective moves a hit's normal by 1e-5 at most, which is less than 1/255 even
  // where the display is steepest (13).
  const Film near = seen_from(2e5);
  ASSERT_TRUE(has_contrast(near));
  EXPECT_EQ(differing_pixels(near, seen_from(2e7)), 0);
}

}  // namespace
}  // namespace rt::test
