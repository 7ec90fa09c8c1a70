#include "unit/geometry/rays.h"

namespace rt::testing {
namespace {

/// t of every crossing, walking from surface to surface.
std::vector<double> crossings(const Torus& torus, Ray ray) {
  std::vector<double> out;
  RayStart start;
  double travelled = 0;
  while (const OptionalHit h = intersect(torus, ray, infinity, start)) {
    const SurfacePoint p = surface_point(torus, ray, *h);
    travelled += h->t;
    out.push_back(travelled);
    ray.origin = p.position;
    start = leaving(glm::dot(p.normal, ray.direction) < 0 ? Leaving::inward : Leaving::outward);
  }
  return out;
}

void expect_crossings(const Torus& torus, const Ray& ray, const std::vector<double>& expected) {
  const std::vector<double> found = crossings(torus, ray);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 4e-15 * (1 + expected[i]));
  }
}

TEST(Torus, IsMetFourTimesAcross) {
  expect_crossings(Torus{}, {{3, 0, 0}, {-1, 0, 0}}, {1.75, 2.25, 3.75, 4.25});
  expect_crossings(Torus{}, {{3, 0, 0}, {-2, 0, 0}}, {0.875, 1.125, 1.875, 2.125});
}

TEST(Torus, IsMetTwiceThroughTheTube) {
  expect_crossings(Torus{}, {{1, 3, 0}, {0, -1, 0}}, {2.75, 3.25});
  expect_crossings(Torus{}, {{0, 3, -1}, {0, -1, 0}}, {2.75, 3.25});
}

TEST(Torus, LetsTheAxisThrough) {
  expect_crossings(Torus{}, {{0, 3, 0}, {0, -1, 0}}, {});
  expect_crossings(Torus{}, {{0.7, 3, 0}, {0, -1, 0}}, {});
}

TEST(Torus, TouchesItsTopPlaneOnlyWithinReach) {
  EXPECT_EQ(t_of(Torus{}, {3, 0.2500000001, 0}, {-1, 0, 0}), -1);
  EXPECT_NEAR(t_of(Torus{}, {3, 0.2499999, 0}, {-1, 0, 0}), 2 - std::sqrt(4.99999e-8), 1e-9);
}

TEST(Torus, IsLeftFromInsideTheTube) {
  EXPECT_DOUBLE_EQ(t_of(Torus{}, {1, 0, 0}, {1, 0, 0}), 0.25);
  EXPECT_DOUBLE_EQ(t_of(Torus{}, {1, 0, 0}, {-1, 0, 0}), 0.25);
  EXPECT_DOUBLE_EQ(t_of(Torus{}, {1, 0, 0}, {0, 0.5, 0}), 0.5);
}

TEST(Torus, HornReachesTheCentre) {
  expect_crossings(Torus{1, 1}, {{3, 0, 0.5}, {-1, 0, 0}},
                   {3 - std::sqrt(3.75), 3 + std::sqrt(3.75)});
}

TEST(Torus, SpindleHasAHollowLemon) {
  // R = 1/2, r = 1: across the equator the solid is 1/2 < rho < 3/2.
  expect_crossings(Torus{0.5, 1}, {{3, 0, 0}, {-1, 0, 0}}, {1.5, 2.5, 3.5, 4.5});
  // Down the axis the ray touches the lemon's tips, where apple and lemon meet, and no more.
  const SurfacePoint lemon = point_of(Torus{0.5, 1}, {0, 0, 0}, {1, 0, 0});
  expect_near(lemon.position, {0.5, 0, 0}, 1e-15);
  expect_near(lemon.normal, {-1, 0, 0}, 1e-15);  // out of the solid, into the lemon
  const SurfacePoint apple = point_of(Torus{0.5, 1}, {3, 0, 0}, {-1, 0, 0});
  expect_near(apple.normal, {1, 0, 0}, 1e-15);
}

TEST(Torus, ThinRingIsMetOnItsTube) {
  const double r = 1e-6;
  const SurfacePoint p = point_of(Torus{1, r}, {3, 0, 0.5 * r}, {-1, 0, 0});
  EXPECT_NEAR(glm::length(Vec3(p.position.x, 0, p.position.z)), 1 + r, 1e-15);
  EXPECT_NEAR(glm::length(p.normal), 1, 1e-15);
}

TEST(Torus, LeavingDividesTheStartOut) {
  const Torus torus;
  EXPECT_EQ(t_of(torus, {1.25, 0, 0}, {1, 0, 0}, leaving(Leaving::outward)), -1);
  EXPECT_NEAR(t_of(torus, {1.25, 0, 0}, {-1, 0, 0}, leaving(Leaving::inward)), 0.5, 1e-15);
  EXPECT_NEAR(t_of(torus, {0.75, 0, 0}, {-1, 0, 0}, leaving(Leaving::outward)), 1.5, 1e-15);
  // Along the hole's waist the surface curves towards the ray: out by a hair, soon in again.
  EXPECT_EQ(t_of(torus, {0.75, 0, 0}, {-1e-3, 1, 0}, leaving(Leaving::outward)), -1);
  EXPECT_GT(t_of(torus, {0.75, 0, 0}, {-1e-3, 0, 1}, leaving(Leaving::outward)), 1e-4);
}

TEST(Torus, EqualTorusCountsAsLeft) {
  EXPECT_EQ(t_of(Torus{}, {1.25 - 1e-16, 0, 0}, {1, 0, 0}, near_start(1e-15)), -1);
  EXPECT_NEAR(t_of(Torus{}, {1.25, 0, 0}, {-1, 0, 0}, near_start(1e-15)), 0.5, 1e-15);
}

/// The search looks at both ends of the chord; a limit puts the far one inside the solid, on the
/// stretch about the axis where the form is concave, or before the ring's far side.
TEST(Torus, ALimitTakesAwayOnlyWhatLiesBeyond) {
  const Ray rays[] = {{{0.7, 0, 0}, {0, 0, 1}},     {{0.7, 0, -0.1}, {0, 0, 1}},
                      {{0.6, 0, 0}, {0, 0.2, 1}},   {{0, 0, 0}, {1, 0.1, 0}},
                      {{3, 0.1, 0.7}, {-1, 0, 0}},  {{0.5, 2, 0.1}, {0.1, -1, 0.2}},
                      {{2, 0.4, 0}, {-1, -0.2, 0}}, {{0.74, 0.1, -0.5}, {0, 0, 1}}};
  for (const Ray& ray : rays) {
    const double t = t_of(Torus{}, ray.origin, ray.direction);
    ASSERT_GT(t, 0);
    for (const double part : {0.01, 0.5, 0.9, 0.999, 1.001, 1.01, 1.1, 1.5, 3.0}) {
      const OptionalHit hit = intersect(Torus{}, ray, part * t, {});
      ASSERT_EQ(hit.has_value(), part > 1) << t << " " << part;
      if (hit) {
        EXPECT_NEAR(hit->t, t, 1e-14 * (1 + t));
      }
    }
  }
}

TEST(Torus, ThroughTheHoleTheFarSideIsMet) {
  // Into the slab over the hole, on either side of the axis, and out of the hole below the waist.
  EXPECT_NEAR(t_of(Torus{}, {-0.5, 1, 0}, {1, -0.8, 0}), 1.25, 1e-15);  // at (0.75, 0, 0)
  EXPECT_NEAR(t_of(Torus{}, {0.25, 1, 0}, {0.5, -1, 0}), 1, 1e-15);
  EXPECT_EQ(t_of(Torus{}, {-0.5, 1, 0}, {0.7, -0.8, 0}), -1);  // out of the slab before the waist
  EXPECT_EQ(t_of(Torus{}, {0.25, 1, 0}, {0.2, -1, 0.1}), -1);
}

TEST(Torus, TheWaistIsGrazedOnOneSideOnly) {
  for (const double off : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double x = 0.75 + off;
    const double height = std::sqrt(0.0625 - (x - 1) * (x - 1));
    EXPECT_NEAR(t_of(Torus{}, {x, 3, 0}, {0, -1, 0}), 3 - height, 1e-16 / height + 1e-15);
    EXPECT_EQ(t_of(Torus{}, {0.75 - off, 3, 0}, {0, -1, 0}), -1);
    EXPECT_EQ(t_of(Torus{}, {0, 3, 0.75 - off}, {0, -1, 0}), -1);
  }
}

TEST(Torus, BoundsThatAreMissedAreNotTouchedByRounding) {
  // Lines that touch the bounding sphere or slab to within rounding, from near and from far.
  for (const double distance : {2.0, 1e3, 1e6, 1e9}) {
    EXPECT_NEAR(t_of(Torus{}, {-distance, 0, 1.25 - 1e-12}, {1, 0, 0}), distance,
                1.6e-6 + 1e-15 * distance);
    EXPECT_NEAR(t_of(Torus{}, {-distance, 0.25 - 1e-12, 0}, {1, 0, 0}), distance - 1,
                7.2e-7 + 1e-15 * distance);
    EXPECT_EQ(t_of(Torus{}, {-distance, 0, 1.25 + 1e-12}, {1, 0, 0}), -1);
    EXPECT_EQ(t_of(Torus{}, {-distance, 0.25 + 1e-12, 0}, {1, 0, 0}), -1);
  }
}

TEST(Torus, IsNeverHitByNanOrByNothing) {
  for (const double bad : {nan, infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      Vec3 origin(3, 0.1, 0);
      Vec3 direction(-1, 0, 0.1);
      origin[i] = bad;
      EXPECT_FALSE(hit(Torus{}, origin, direction).has_value());
      EXPECT_FALSE(hit(Torus{}, origin, direction, near_start(1e-15)).has_value());
      origin = {3, 0.1, 0};
      direction[i] = bad;
      EXPECT_FALSE(hit(Torus{}, origin, direction).has_value());
      EXPECT_FALSE(hit(Torus{}, origin, direction, near_start(1e-15)).has_value());
    }
  }
  EXPECT_FALSE(hit(Torus{}, {3, 0, 0}, {0, 0, 0}).has_value());
  EXPECT_FALSE(hit(Torus{}, {1, 0, 0}, {0, 0, 0}).has_value());
  EXPECT_FALSE(hit(Torus{}, {3, 0, 0}, {-1e200, 0, 0}).has_value());
  EXPECT_FALSE(hit(Torus{}, {3, nan, 0}, {-1, 0, 0}).has_value());
  EXPECT_FALSE(hit(Torus{}, {3, 0, 0}, {-1, 0, nan}).has_value());
  EXPECT_FALSE(hit(Torus{}, {1.25, 0, 0}, {0, 0, 0}, leaving(Leaving::inward)).has_value());
}

// Along an asymptote of the inner side three roots nearly coincide where the line goes in, and a
// deep chord follows. t as 50 digits give it; next to a triple root rounding moves it by the cube
// root.
TEST(Torus, LinesThatEnterAlongAnAsymptoteAreNotMissed) {
  struct {
    Vec3 origin, direction;
    double t;
  } const cases[] = {
      {{3.0259696149042656, 0.25070929929270336, -1.0365173779119958},
       {-0.085874270918959578, -2.5617434187203503e-05, 0.064907803530220895},
       27.869594799363547},
      {{-2.0128830874297026, -1.5015184153712557, -1.9759612439673861},
       {0.1329468617526165, 0.083796069275062876, 0.073827002343635428},
       17.27829683532207},
      {{1.089244926201216, -0.78970175226326089, -3.1368110605169965},
       {-0.051000590711567081, 0.11989440980898676, 0.60894954338198104},
       4.817502458338752},
      {{1.627771327077973, -0.56942797109345666, 2.9323553844072681},
       {-2.2491747802506898, 1.0516127049343156, -9.0224066081799705},
       0.32059434593121611},
      {{2.281163030541129, -1.0826953545505251, 2.2586341978721336},
       {-0.26739296341701085, 0.098702585470567109, -0.15839627409529466},
       9.2001444192596686},
      {{-2.6572721063464622, -0.256131543805874, -1.8451530930492515},
       {0.068182299230476404, 0.00023255688230034718, 0.089182934071484157},
       26.72355922445891},
  };
  for (const auto& c : cases) {
    const OptionalHit h = hit(Torus{1, 0.25}, c.origin, c.direction);
    ASSERT_TRUE(h.has_value());
    EXPECT_NEAR(h->t * glm::length(c.direction), c.t * glm::length(c.direction), 2e-5);
  }
}

}  // namespace
}  // namespace rt::testing
