// Prisms, lenses and images: rays come to the place that geometrical optics computes.
#include <gtest/gtest.h>

#include <numbers>

#include "probe.h"

namespace rt {
namespace {

using test::add;
using test::bare_job;
using test::fresnel_by_angles;
using test::glass;
using test::Probe;
using test::with_mark;

constexpr double degree = std::numbers::pi / 180.0;

// Some ten interfaces at most, of some 30 roundings each.
constexpr double chain_rounding = 1e-12;

/// A bar along z, from -1 to 1, over the triangle abc of the plane z = 0, counter-clockwise.
Shape bar(const Vec2& a, const Vec2& b, const Vec2& c) {
  auto data = std::make_shared<MeshData>();
  for (const double z : {-1.0, 1.0}) {
    for (const Vec2& p : {a, b, c}) {
      data->positions.push_back({p, z});
    }
  }
  data->triangles = {{0, 2, 1}, {3, 4, 5}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t j = (i + 1) % 3;
    data->triangles.push_back({i, j, j + 3});
    data->triangles.push_back({i, j + 3, i + 3});
  }
  return Mesh{data};
}

TEST(Prism, DeviatesLeastWhereTheRayCrossesItSymmetrically) {
  // sin((A + D) / 2) = n sin(A / 2): the ray goes level inside, and leaves as it came, mirrored.
  for (const double n : {1.33, 1.5, 1.7}) {
    const double apex = 60.0 * degree;
    const double deviation = 2.0 * std::asin(n * std::sin(apex / 2)) - apex;
    const double height = std::cos(apex / 2);  // sides of length 1
    RenderJob job = bare_job();
    job.options.max_depth = 2;  // without what goes round inside
    add(job, bar({-0.5, 0}, {0.5, 0}, {0, height}), {}, glass(n));
    const Vec3 entry{-0.25, height / 2, 0.1};
    const Vec3 exit{0.25, height / 2, 0.1};
    const Vec3 in{std::cos(deviation / 2), std::sin(deviation / 2), 0};
    const Vec3 out{in.x, -in.y, 0};
    const double f = fresnel_by_angles(std::cos((apex + deviation) / 2), 1.0, n);
    Probe probe(with_mark(job, exit + out));
    EXPECT_NEAR(probe(entry - in, in).r, (1 - f) * (1 - f), chain_rounding) << n;
  }
}

TEST(Prism, ReflectsTotallyBeyondTheCriticalAngle) {
  // In through one leg, reflected at 45 degrees by the long side, out through the other leg.
  for (const double n : {1.45, 1.5, 2.4}) {
    RenderJob job = bare_job();
    job.options.max_depth = 3;
    add(job, bar({0, 0}, {1, 0}, {0, 1}), {}, glass(n));
    const double f = fresnel_by_angles(1.0, 1.0, n);
    // Along +x at y = 0.4 to (0.6, 0.4), then down.
    Probe probe(with_mark(job, {0.6, -0.5, 0.1}));
    EXPECT_NEAR(probe({-1, 0.4, 0.1}, {1, 0, 0}).r, (1 - f) * (1 - f), chain_rounding);
  }
  // Under the critical angle (n < sqrt 2) only a part takes that way.
  RenderJob job = bare_job();
  job.options.max_depth = 3;
  add(job, bar({0, 0}, {1, 0}, {0, 1}), {}, glass(1.4));
  const double f = fresnel_by_angles(1.0, 1.0, 1.4);
  Probe probe(with_mark(job, {0.6, -0.5, 0.1}));
  EXPECT_NEAR(probe({-1, 0.4, 0.1}, {1, 0, 0}).r,
              (1 - f) * (1 - f) * fresnel_by_angles(std::sqrt(0.5), 1.4, 1.0), chain_rounding);
}

/// By which angle a ball of index n turns a ray that passes its centre at b radii.
double turned_by_ball(double b, double n) { return 2.0 * (std::asin(b) - std::asin(b / n)); }

TEST(Lens, ABallFocusesADistantPoint) {
  // A ray at height b leaves turned, again at distance b from the centre: it meets the axis at
  // b / sin(turned) from the centre, for b -> 0 at n R / (2 (n - 1)).
  constexpr double n = 1.5;
  const Vec3 centre{0, 0, -10};
  RenderJob job = bare_job();
  add(job, Sphere{centre, 1}, {}, glass(n));
  for (const double b : {1e-3, 0.1, 0.5, 0.9}) {
    const double focus = b / std::sin(turned_by_ball(b, n));
    Probe probe(with_mark(job, centre - Vec3(0, 0, focus)));
    const double f = fresnel_by_angles(std::sqrt(1 - b * b), 1.0, n);
    for (int turn = 0; turn < 8; ++turn) {
      const Vec3 origin{b * std::cos(turn), b * std::sin(turn), 0};
      EXPECT_NEAR(probe(origin, {0, 0, -1}).r, (1 - f) * (1 - f), chain_rounding) << b;
    }
  }
  // The bundle of height 0.01 passes the focus n R / (2 (n-1)) = 1.5 within its third-order
  // aberration: the axis is met dz ~ b^2 earlier, at a slope of b / 1.5.
  Probe spot(with_mark(job, centre - Vec3(0, 0, 1.5), 1e-6));
  for (double b = 0; b < 0.0101; b += 0.001) {
    EXPECT_GT(spot({b, 0, 0}, {0, 0, -1}).r, 0.9) << b;
  }
}

TEST(Lens, APlanoConvexLensFocusesADistantPoint) {
  // A dome on a slab of the same glass: a ball that overlaps the slab's front face. Inside it the
  // face is no interface. Convex side first, the back focal distance is R / (n - 1) - thickness/n.
  constexpr double n = 1.5;
  constexpr double back = -12.0;
  const Vec3 centre{0, 0, -11};
  constexpr double radius = 2.0;
  RenderJob job = bare_job();
  add(job, Sphere{centre, radius}, {}, glass(n));
  add(job, Box{{-5, -5, back}, {5, 5, -10.5}}, {}, glass(n));
  // The ball's far side sticks out of the slab's back; this trims it: a void behind the slab.
  add(job, Box{{-0.9, -0.9, back - 1.5}, {0.9, 0.9, back}}, {}, glass(1.0));
  const double paraxial = radius / (n - 1) - (centre.z + radius - back) / n;
  for (const double h : {1e-3, 0.2, 0.6}) {
    const double slope1 = std::asin(h / radius) - std::asin(h / radius / n);
    const double z1 = centre.z + std::sqrt(radius * radius - h * h);
    const double y2 = h - (z1 - back) * std::tan(slope1);
    const double slope2 = std::asin(n * std::sin(slope1));
    const double focus = y2 / std::tan(slope2);
    if (h < 0.01) {
      EXPECT_NEAR(focus, paraxial, 1e-5);  // third order: h^2 times a number near 1
    }
    const double f1 = fresnel_by_angles(z1 / radius - centre.z / radius, 1.0, n);
    const double f2 = fresnel_by_angles(std::cos(slope1), n, 1.0);
    Probe probe(with_mark(job, {0, 0, back - focus}));
    EXPECT_NEAR(probe({0, h, 0}, {0, 0, -1}).r, (1 - f1) * (1 - f2), chain_rounding) << h;
    EXPECT_NEAR(probe({-h, 0, 0}, {0, 0, -1}).r, (1 - f1) * (1 - f2), chain_rounding) << h;
  }
}

/// The direction, as an angle from the axis, in which an eye sees a point at height y and depth
/// `far` through a unit ball at distance `near`. Negative: on the other side.
double seen_through_ball(double near, double far, double y, double n) {
  // Where the ray at angle a (downward) comes to at depth `far`; it rises with a.
  const auto height_at = [&](double a) {
    const double b = near * std::sin(a);
    const double turned = turned_by_ball(b, n);
    const double out = turned - a;  // upward
    // The line leaves at distance b below the centre, along (cos out, sin out).
    return -b / std::cos(out) + (far - near) * std::tan(out);
  };
  double lo = 0.0;
  double hi = std::asin(1.0 / near);
  for (int i = 0; i < 200; ++i) {
    const double mid = 0.5 * (lo + hi);
    (height_at(mid) < y ? lo : hi) = mid;
  }
  return -lo;
}

TEST(Lens, ABallShowsAnInvertedImageAtTheComputedPlace) {
  constexpr double near = 8.0;
  constexpr double far = 20.0;
  constexpr double n = 1.5;
  RenderJob job = bare_job();
  constexpr int size = 401;
  job.options.width = job.options.height = size;
  job.camera.fov = 16.0;
  add(job, Sphere{{0, 0, -near}, 1}, {}, glass(n));
  // Out of direct sight: the ball covers 7 degrees to either side, they stand at 14.
  struct Lamp {
    Vec2 at;
    int channel;
  };
  const Lamp lamps[] = {{{0, 5}, 0}, {{-5, 0}, 1}, {{4, -3}, 2}};
  for (const Lamp& lamp : lamps) {
    Rgb colour(0.0);
    colour[lamp.channel] = 1.0;
    add(job, Sphere{{lamp.at, -far}, 0.2}, {}, test::glowing(colour));
  }
  const Film film = test::rendered(job).film;
  const double pixels_per_slope = 0.5 * size / std::tan(8.0 * degree);
  for (const Lamp& lamp : lamps) {
    // The image's centre of gravity, on the other side than the lamp. (On its own side the ball's
    // rim mirrors it.)
    Vec2 sum(0.0);
    double count = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const Vec2 from_middle(x + 0.5 - 0.5 * size, 0.5 * size - y - 0.5);
        if (test::pixel(film, x, y)[lamp.channel] > 0.5 && glm::dot(from_middle, lamp.at) < 0.0) {
          sum += from_middle;
          ++count;
        }
      }
    }
    ASSERT_GT(count, 10.0);
    const double distance = glm::length(lamp.at);
    const double angle = seen_through_ball(near, far, distance, n);
    const Vec2 expected = std::tan(angle) * pixels_per_slope * lamp.at / distance;
    // Half a pixel, for the lamp's extent and the pixels that its outline cuts.
    EXPECT_NEAR(sum.x / count, expected.x, 0.5) << lamp.channel;
    EXPECT_NEAR(sum.y / count, expected.y, 0.5) << lamp.channel;
    // The lamp's middle to the last digit.
    RenderJob marked = with_mark(job, {lamp.at, -far + 0.3});
    const double exact = seen_through_ball(near, far - 0.3, distance, n);
    const Vec3 way{std::tan(exact) * lamp.at / distance, -1.0};
    EXPECT_GT(Probe(marked)({0, 0, 0}, way)[(lamp.channel + 1) % 3], 0.5);
  }
}

}  // namespace
}  // namespace rt
