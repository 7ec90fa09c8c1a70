#include "rt/math/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace rt {
namespace {

using Point = std::vector<double>;
using Draw = std::function<Point(const Sampler&)>;

std::vector<Point> first_points(const Draw& draw, int count, int x = 17, int y = 91,
                                std::uint32_t from = 0) {
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(count));
  const Sampler pixel(5, x, y, 0);
  for (int i = 0; i < count; ++i) {
    points.push_back(draw(pixel.at(from + static_cast<std::uint32_t>(i))));
  }
  return points;
}

/// True when all boxes with 2^splits[j] slabs along axis j hold the same number of points.
bool equidistributed(const std::vector<Point>& points, const std::vector<int>& splits) {
  int total = 0;
  for (int s : splits) {
    total += s;
  }
  std::vector<std::size_t> count(std::size_t{1} << total);
  for (const Point& p : points) {
    std::size_t cell = 0;
    for (std::size_t j = 0; j < splits.size(); ++j) {
      cell = (cell << splits[j]) + static_cast<std::size_t>(std::ldexp(p[j], splits[j]));
    }
    ++count[cell];
  }
  for (std::size_t c : count) {
    if (c != points.size() >> total) {
      return false;
    }
  }
  return true;
}

/// True when the points are equidistributed in every way of splitting the axes `total` times.
bool is_net(const std::vector<Point>& points, std::vector<int>& splits, std::size_t axis,
            int total) {
  if (axis + 1 == splits.size()) {
    splits[axis] = total;
    return equidistributed(points, splits);
  }
  for (int k = 0; k <= total; ++k) {
    splits[axis] = k;
    if (!is_net(points, splits, axis + 1, total - k)) {
      return false;
    }
  }
  return true;
}

/// The smallest t for which 2^m points are a (t,m,s)-net.
int t_value(const std::vector<Point>& points, int m) {
  std::vector<int> splits(points[0].size());
  int resolved = 0;
  while (resolved < m && is_net(points, splits, 0, resolved + 1)) {
    ++resolved;
  }
  return m - resolved;
}

std::string t_values(const Draw& draw) {
  std::string all;
  for (int m = 1; m <= 10; ++m) {
    if (m > 1) {
      all += ' ';
    }
    all += std::to_string(t_value(first_points(draw, 1 << m), m));
  }
  return all;
}

Point of(const Vec2& a) { return {a.x, a.y}; }
Point of(const Vec2& a, const Vec2& b) { return {a.x, a.y, b.x, b.y}; }

Point with(Point p, double c) {
  p.push_back(c);
  return p;
}

TEST(Sampler, PixelIsAZeroNetInAnyPixelAndBlock) {
  for (int pixel = 0; pixel < 8; ++pixel) {
    for (int m = 0; m <= 10; ++m) {
      const auto count = 1 << m;
      for (int block : {0, 1, 5, 64}) {
        const auto from = static_cast<std::uint32_t>(block * count);
        const auto points =
            first_points([](const Sampler& s) { return of(s.pixel()); }, count, pixel, 3, from);
        EXPECT_EQ(t_value(points, m), 0) << "m " << m << " block " << block;
      }
    }
  }
}

// The table in sampler.h.
TEST(Sampler, QualityIsAsDocumented) {
  const std::string perfect = "0 0 0 0 0 0 0 0 0 0";
  const std::string pixel_and_pair = "0 1 2 1 2 2 3 2 3 3";
  EXPECT_EQ(t_values([](const Sampler& s) { return of(s.light()); }), perfect);
  EXPECT_EQ(t_values([](const Sampler& s) { return of(s.lobe()); }), perfect);
  EXPECT_EQ(t_values([](const Sampler& s) { return of(s.lens()); }), "0 0 0 1 0 1 1 1 2 2");
  EXPECT_EQ(t_values([](const Sampler& s) { return of(s.pixel(), s.light()); }), pixel_and_pair);
  EXPECT_EQ(t_values([](const Sampler& s) { return of(s.pixel(), s.lobe()); }), pixel_and_pair);
  EXPECT_EQ(t_values([](const Sampler& s) { return of(s.pixel(), s.lens()); }),
            "0 1 2 3 4 2 2 3 3 4");
  EXPECT_EQ(t_values([](const Sampler& s) { return with(of(s.pixel()), s.time()); }),
            "0 1 1 2 2 1 2 2 2 2");
  EXPECT_EQ(t_values([](const Sampler& s) { return with(of(s.pixel(), s.light()), s.time()); }),
            "0 1 2 2 2 3 4 5 3 3");
  EXPECT_EQ(t_values([](const Sampler& s) { return with(of(s.lobe()), s.lobe_choice()); }),
            "0 1 1 2 2 3 4 4 3 4");
}

TEST(Sampler, PixelAndLightAreAZeroNetInBaseFour) {
  for (int m : {2, 4, 6, 8}) {
    const auto points =
        first_points([](const Sampler& s) { return of(s.pixel(), s.light()); }, 1 << m);
    for (int a = 0; a <= m; a += 2) {
      for (int b = 0; a + b <= m; b += 2) {
        for (int c = 0; a + b + c <= m; c += 2) {
          EXPECT_TRUE(equidistributed(points, {a, b, c, m - a - b - c}));
        }
      }
    }
  }
}

TEST(Sampler, CopiesOfALightStayJointWithThePixel) {
  EXPECT_EQ(t_values([](const Sampler& s) {
              return of(s.pixel(), s.light({0, 7}));
            }),
            "0 1 2 1 2 2 3 2 3 3");
}

TEST(Sampler, PaddedSetsAreNetsAmongThemselves) {
  for (std::uint32_t order : {1u, 2u, 9u}) {
    EXPECT_EQ(t_values([=](const Sampler& s) {
                return of(s.light({order, 3}));
              }),
              "0 0 0 0 0 0 0 0 0 0");
    EXPECT_EQ(t_values([=](const Sampler& s) {
                return of(s.light({order, 0}), s.lobe({order, 0}));
              }),
              "0 1 2 1 2 2 3 2 3 3");
  }
}

/// Pearson's correlation of two draws over samples and pixels.
double correlation(const std::function<Vec2(const Sampler&, int)>& draw) {
  constexpr int pixels = 1024;
  constexpr int spp = 16;
  double xy = 0;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    for (std::uint32_t i = 0; i < spp; ++i) {
      const Vec2 v = draw(Sampler(1, pixel % 32, pixel / 32, i), pixel);
      xy += (v.x - 0.5) * (v.y - 0.5);
    }
  }
  return 12 * xy / (pixels * spp);  // the variance of a uniform variable is 1/12
}

// Of independent numbers it has standard deviation 1/sqrt(16384) = 0.0078; 4 of them are allowed.
TEST(Sampler, DecisionsPixelsAndSeedsAreUncorrelated) {
  const double bound = 4.0 / 128.0;
  EXPECT_LT(std::abs(correlation([](const Sampler& s, int) {
              return Vec2(s.light().x, s.light({1, 0}).x);
            })),
            bound);
  EXPECT_LT(std::abs(correlation([](const Sampler& s, int) {
              return Vec2(s.lobe({2, 0}).y, s.lobe({1, 0}).y);
            })),
            bound);
  EXPECT_LT(std::abs(correlation([](const Sampler& s, int) {
              return Vec2(s.light({0, 1}).x, s.light({0, 2}).x);
            })),
            bound);
  EXPECT_LT(std::abs(correlation([](const Sampler& s, int p) {
              return Vec2(s.pixel().x, Sampler(1, p % 32 + 1, p / 32, 3).pixel().x);
            })),
            bound);
  EXPECT_LT(std::abs(correlation([](const Sampler& s, int p) {
              return Vec2(s.time(), Sampler(2, p % 32, p / 32, 3).time());
            })),
            bound);
}

// A number printed by any machine, thread or build must be this one: pictures are compared by
// bytes.
TEST(Sampler, IsTheSameEverywhere) {
  static_assert(reverse_bits(1u) == 0x80000000u);
  static_assert(owen_reversed(0u, 0x12345678u) != owen_reversed(1u, 0x12345678u));
  const Sampler s(42, 100, 200, 7);
  const Sampler again = Sampler(42, 100, 200, 0).at(7);
  EXPECT_EQ(s.pixel(), again.pixel());
  EXPECT_EQ(s.light({3, 1}), again.light({3, 1}));
  EXPECT_NE(s.pixel(), Sampler(43, 100, 200, 7).pixel());
  EXPECT_NE(s.pixel(), Sampler(42, 200, 100, 7).pixel());
  EXPECT_NE(s.pixel(), Sampler(42, -100, 200, 7).pixel());
  EXPECT_EQ(std::llround(std::ldexp(s.pixel().x, 33)), 3446691167);
  EXPECT_EQ(std::llround(std::ldexp(s.light({1, 0}).y, 33)), 4726469771);
}

TEST(Sampler, NumbersAreInsideTheOpenUnitInterval) {
  static_assert(unit_interval(0) > 0.0);
  static_assert(unit_interval(0xffffffffu) < 1.0);
  for (std::uint32_t i = 0xfffffff0u; i != 0; ++i) {  // the last indices there are
    const Sampler s(0, 0, 0, i);
    for (double u : {s.pixel().x, s.pixel().y, s.time(), s.lobe_choice({4, 0})}) {
      EXPECT_GT(u, 0.0);
      EXPECT_LT(u, 1.0);
    }
  }
}

TEST(Sampler, LateIndicesAreNewPoints) {
  std::set<double> seen;
  for (std::uint32_t i : {0u, 1u, 65535u, 65536u, 65537u, 1u << 20, 1u << 31}) {
    seen.insert(Sampler(0, 0, 0, i).pixel().x);
  }
  EXPECT_EQ(seen.size(), 7u);
}

}  // namespace
}  // namespace rt
