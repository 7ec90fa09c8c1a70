// Surfaces that touch, coincide or nearly do.
#include "worlds.h"

namespace rt::test {
namespace {

const double scales[] = {1e-8, 1e-4, 1.0, 1e4, 1e8};

World stage(double scale) {
  World world({scale, Vec3(0.0)});
  world.look({2, 3, 6}, {0, 0.6, 0}, 36);
  world.light({4, 6, 5});
  world.light({-3, 4, 5}, 0.3);
  return world;
}

TEST(Contact, OfTwoEqualToriTheFirstIsSeenEverywhere) {
  const Affine place = Affine::translation({0.1, 0.9, 0.2}) * Affine::rotation(0, 50);
  for (const double scale : scales) {
    for (const bool reflecting : {false, true}) {
      const Material first = reflecting ? mirror() : matt({0.8, 0.2, 0.2});
      World one = stage(scale);
      one.add(Plane{}, {}, matt(Rgb(0.6)));
      one.add(Torus{}, place, first);
      World two = stage(scale);
      two.add(Plane{}, {}, matt(Rgb(0.6)));
      two.add(Torus{}, place, first);
      two.add(Torus{}, place, matt({0.1, 0.9, 0.1}));
      EXPECT_EQ(one.picture().pixels, two.picture().pixels) << scale << " " << reflecting;
    }
  }
}

TEST(Contact, StackedCylindersLookLikeOne) {
  for (const double scale : scales) {
    const Material paint = matt({0.7, 0.6, 0.3});
    World one = stage(scale);
    one.add(Cylinder{}, Affine::scaling({0.8, 2, 0.8}), paint);
    World two = stage(scale);
    two.add(Cylinder{}, Affine::scaling({0.8, 1.25, 0.8}), paint);
    two.add(Cylinder{}, Affine::translation({0, 1.25, 0}) * Affine::scaling({0.8, 0.75, 0.8}),
            paint);
    EXPECT_EQ(differing_pixels(one.picture(), two.picture()), 0) << scale;
  }
}

TEST(Contact, ABoxOnAPlaneLooksLikeABoxThroughIt) {
  for (const double scale : scales) {
    World on = stage(scale);
    on.add(Plane{}, {}, matt(Rgb(0.6)));
    on.add(Box{{-0.6, 0, -0.6}, {0.6, 1.2, 0.6}}, Affine::rotation(1, 33), matt({0.2, 0.4, 0.8}));
    World through = stage(scale);
    through.add(Plane{}, {}, matt(Rgb(0.6)));
    through.add(Box{{-0.6, -1, -0.6}, {0.6, 1.2, 0.6}}, Affine::rotation(1, 33),
                matt({0.2, 0.4, 0.8}));
    EXPECT_EQ(differing_pixels(on.picture(), through.picture()), 0) << scale;
  }
}

TEST(Contact, FacesInOnePlaneBelongToTheFirst) {
  // From below, the plane and the box's base coincide: whichever stands first is seen, without a
  // speck of the other. The plane is turned and the box is not, so that their t differ in rounding.
  for (const double scale : scales) {
    for (const bool plane_first : {true, false}) {
      World world({scale, Vec3(0.0)});
      world.look({0.3, -4, 0.2}, {0, 0, 0}, 20, {0, 0, 1});
      const Affine tilt = Affine::rotation(2, 37);
      const auto add_plane = [&] { world.add(Plane{}, tilt, matt({1, 0, 0})); };
      const auto add_box = [&] {
        world.add(Box{{-9, 0, -9}, {9, 1, 9}}, tilt * Affine::rotation(1, 12), matt({0, 1, 0}));
      };
      plane_first ? add_plane() : add_box();
      plane_first ? add_box() : add_plane();
      const Film film = world.picture();
      for (std::size_t i = 0; i < film.pixels.size(); i += 3) {
        ASSERT_EQ(film.pixels[i] > 0.0F, plane_first) << scale << " pixel " << i / 3;
        ASSERT_EQ(film.pixels[i + 1] > 0.0F, !plane_first) << scale << " pixel " << i / 3;
      }
    }
  }
}

TEST(Contact, ThroughAGlassBoxTheFloorItStandsOnIsSeen) {
  for (const double scale : scales) {
    const auto picture = [&](bool floor_first) {
      World world = stage(scale);
      const Affine turned = Affine::rotation(1, 33);
      const Box box{{-0.6, 0, -0.6}, {0.6, 1.2, 0.6}};
      if (floor_first) {
        world.add(Plane{}, {}, matt({0.7, 0.2, 0.1}));
      }
      world.add(box, turned, glass());
      if (!floor_first) {
        world.add(Plane{}, {}, matt({0.7, 0.2, 0.1}));
      }
      return world.picture();
    };
    EXPECT_EQ(picture(true).pixels, picture(false).pixels) << scale;
  }
}

TEST(Contact, TouchingSpheresLookLikeNearlyTouchingOnes) {
  const auto pair = [](double scale, double gap) {
    World world = stage(scale);
    world.add(Sphere{}, Affine::translation({-1 - gap, 1, 0}), matt({0.8, 0.4, 0.2}));
    world.add(Sphere{}, Affine::translation({1, 1, 0}), mirror());
    world.add(Plane{}, {}, matt(Rgb(0.6)));
    return world.picture();
  };
  // A gap of 1e-11 moves nothing by a pixel; sampled silhouettes move by 1e-9 pixels.
  const Film reference = pair(1.0, 1e-11);
  for (const double scale : scales) {
    EXPECT_EQ(differing_pixels(reference, pair(scale, 0.0)), 0) << scale;
  }
}

TEST(Contact, AGapOfAMillionthIsDarkInside) {
  // The eye lies in the gap between a box and the floor, and looks at the floor.
  for (const double scale : scales) {
    World world({scale, Vec3(0.0)}, 60, 40);
    world.look({0, 5e-7, 0}, {1, 5e-7 - 1e-3, 0}, 0.05);
    world.light({0.3, 5, 0.2});
    world.add(Plane{}, {}, matt(Rgb(1.0)));
    world.add(Box{{-1, 1e-6, -1}, {1, 2, 1}}, {}, matt(Rgb(1.0)));
    for (const float p : world.picture().pixels) {
      ASSERT_FLOAT_EQ(p, 0.25F) << scale;  // ambient alone
    }
  }
}

TEST(Contact, ALightAHairInsideAShellLightsItAndOneOutsideDoesNot) {
  // Shadow rays end at the light: 1e-12 short of the shell, or beyond it.
  for (const double scale : scales) {
    for (const double off : {-1e-12, 1e-12}) {
      World world({scale, Vec3(0.0)}, 40, 30);
      world.look({0, 0, 0}, {0, 0, -1}, 60);
      world.light({0, 0, 1 + off}, 1.0);
      world.add(Sphere{}, {}, matt(Rgb(1.0)));
      for (const float p : world.picture().pixels) {
        // Seen at an angle of at most 39 degrees to the far pole: n . l is at least cos(39 / 2).
        ASSERT_EQ(p > 0.25F + 0.9F, off < 0) << scale << " " << off;
        ASSERT_EQ(p == 0.25F, off > 0) << scale << " " << off;
      }
    }
  }
}

TEST(Contact, TheEyeAHairsBreadthFromATorus) {
  // 5e-5 from the outer equator. All it sees is the tube, lit from behind the eye.
  for (const double scale : scales) {
    World world({scale, Vec3(0.0)}, 60, 40);
    world.look({1.25 + 5e-5, 0, 0}, {0, 0, 0}, 60);
    world.light({100, 0, 0}, 1.0);
    world.add(Torus{}, {}, matt(Rgb(1.0)));
    for (const float p : world.picture().pixels) {
      ASSERT_NEAR(p, 1.25, 1e-6) << scale;  // n.l = 1 to 1e-7 over so small a patch
    }
  }
}

}  // namespace
}  // namespace rt::test
