// Every lane gives what the scalar function gives, bit for bit.
#include "rt/math/wide_functions.h"

#include "rt/math/fresnel.h"
#include "rt/math/warp.h"
#include "unit/math/wide_lanes.h"

namespace rt {
namespace {

using test::Arguments;
using test::drawn;
using test::packed;
using test::same;

constexpr int packets = 20000;
const std::vector<double> indices{1.0, 1.5, 1.0 + 0x1p-52, 1.33};

TEST(WideFunctions, Fresnel) {
  Arguments random(1);
  const std::vector<double> cosines{0.0, 1.0, 0x1p-1000, 1 - 0x1p-53, std::sqrt(5.0) / 3.0};
  int total = 0;
  for (int k = 0; k < packets; ++k) {
    const auto cos_i = drawn([&] { return random.pick(cosines, 0, 1); });
    const auto n1 = drawn([&] { return random.pick(indices, 0.5, 2.5); });
    const auto n2 = drawn([&] { return random.pick(indices, 0.5, 2.5); });
    const Wide wide = fresnel(packed(cos_i), packed(n1), packed(n2));
    for (std::size_t i = 0; i < lanes; ++i) {
      const double one = fresnel(cos_i[i], n1[i], n2[i]);
      total += one == 1.0;
      ASSERT_TRUE(same(wide[i], one)) << cos_i[i] << ' ' << n1[i] << ' ' << n2[i];
    }
  }
  EXPECT_GT(total, packets / 10);
}

TEST(WideFunctions, ReflectAndRefract) {
  Arguments random(2);
  int reflected = 0;
  for (int k = 0; k < packets; ++k) {
    const auto n = drawn([&] { return random.direction_or_axis(); });
    auto d = drawn([&] { return random.direction_or_axis(); });
    for (std::size_t i = 0; i < lanes; ++i) {
      d[i] = random.bits() % 8 == 0 ? -n[i] : d[i];
    }
    const auto n1 = drawn([&] { return random.pick(indices, 0.5, 2.5); });
    const auto n2 = drawn([&] { return random.pick(indices, 0.5, 2.5); });
    const Wide3 mirror = reflect(packed(d), packed(n));
    WideMask through;
    const Wide3 ahead = refract(packed(d), packed(n), packed(n1), packed(n2), through);
    for (int i = 0; i < lanes; ++i) {
      const auto at = static_cast<std::size_t>(i);
      ASSERT_TRUE(same(mirror.lane(i), reflect(d[at], n[at])));
      const auto one = refract(d[at], n[at], n1[at], n2[at]);
      ASSERT_EQ(bool{through[at]}, one.has_value());
      ASSERT_TRUE(!one || same(ahead.lane(i), *one)) << n1[at] << ' ' << n2[at];
      reflected += !one;
    }
  }
  EXPECT_GT(reflected, packets / 10);
}

TEST(WideFunctions, ToDisc) {
  Arguments random(3);
  for (int k = 0; k < packets; ++k) {
    const auto u = drawn([&] { return random.square(); });
    const Wide2 disc = to_disc(packed(u));
    for (int i = 0; i < lanes; ++i) {
      const auto at = static_cast<std::size_t>(i);
      ASSERT_TRUE(same(disc.lane(i), to_disc(u[at]))) << u[at].x << ' ' << u[at].y;
    }
  }
}

TEST(WideFunctions, FilterOffset) {
  Arguments random(5);
  for (const Filter filter :
       {Filter::box, Filter::tent, Filter::gaussian, Filter::blackman_harris}) {
    for (int k = 0; k < packets / 4; ++k) {
      const auto u = drawn([&] { return random.square(); });
      const Wide2 wide = filter_offset(filter, packed(u));
      for (int i = 0; i < lanes; ++i) {
        const auto at = static_cast<std::size_t>(i);
        ASSERT_TRUE(same(wide.lane(i), filter_offset(filter, u[at])))
            << static_cast<int>(filter) << ": " << u[at].x << ' ' << u[at].y;
      }
    }
  }
}

}  // namespace
}  // namespace rt
