// The samplers of several samples draw what each would draw alone.
#include "rt/math/wide_sampler.h"

#include "unit/math/wide_lanes.h"

namespace rt {
namespace {

using test::Arguments;
using test::same;

constexpr Vertex vertices[] = {{0, 0}, {0, 1}, {0, 7}, {1, 0}, {1, 4}, {3, 0}, {5, 0xffffffffu}};

void expect_same(const WideSampler& wide, const test::Lanes<std::optional<Sampler>>& alone) {
  for (int i = 0; i < lanes; ++i) {
    const Sampler& one = *alone[static_cast<std::size_t>(i)];
    ASSERT_TRUE(same(wide.pixel().lane(i), one.pixel())) << i;
    ASSERT_TRUE(same(wide.lane(i).lens(), one.lens())) << i;
    ASSERT_EQ(wide.lane(i).time(), one.time()) << i;
    for (const Vertex& v : vertices) {
      ASSERT_TRUE(same(wide.lane(i).light(v), one.light(v)))
          << i << ' ' << v.order << ' ' << v.copy;
      ASSERT_TRUE(same(wide.lane(i).lobe(v), one.lobe(v))) << i << ' ' << v.order << ' ' << v.copy;
      ASSERT_EQ(wide.lane(i).lobe_choice(v), one.lobe_choice(v)) << i;
    }
  }
}

/// Lanes of pixels that `pixel_of(lane)` names. One WideSampler serves all, as in the renderer.
template <class PixelOf>
void run(Arguments& random, WideSampler& wide, PixelOf pixel_of) {
  const std::uint64_t seed = random.bits();
  const int base = static_cast<int>(random.bits() % 4000) - 100;
  test::Lanes<std::optional<Sampler>> alone;
  for (int i = 0; i < lanes; ++i) {
    const int x = base + pixel_of(i);
    const int y = 7 * base - pixel_of(i) / 2;
    const auto index = static_cast<std::uint32_t>(random.bits() >> random.bits() % 64);
    wide.set(i, x, y, index);
    alone[static_cast<std::size_t>(i)].emplace(seed, x, y, index);
  }
  wide.begin(seed);
  expect_same(wide, alone);
}

TEST(WideSampler, DrawsWhatEachSampleWouldAlone) {
  Arguments random(1);
  WideSampler wide;
  for (int k = 0; k < 300; ++k) {
    run(random, wide, [](int) { return 0; });
    run(random, wide, [](int i) { return i; });
    run(random, wide, [](int i) { return i / 2; });
    run(random, wide, [](int i) { return i % 2; });  // comes back to a pixel
    run(random, wide, [](int i) { return i == lanes - 1 ? 1 : 0; });
  }
}

}  // namespace
}  // namespace rt
