#include "stability/leaving.h"

#include <gtest/gtest.h>

namespace rt::stability {
namespace {

LeavingTally total(Policy policy, long count) {
  LeavingTally sum;
  std::uint64_t seed = 1;
  for (const Placement& placement : placements()) {
    sum.add(run_leaving(placement, policy, count, seed++));
  }
  return sum;
}

TEST(LeavingASurface, BySideNeitherShadowsItselfNorLeaks) {
  const LeavingTally tally = total(Policy::side, 400);
  EXPECT_EQ(tally.false_hits, 0);
  EXPECT_EQ(tally.leaks, 0);
  EXPECT_EQ(tally.wrong, 0);
}

TEST(LeavingASurface, AnEqualShapeInTheSamePlaceCountsAsLeft) {
  const LeavingTally tally = total(Policy::touching, 400);
  EXPECT_EQ(tally.false_hits, 0);
  EXPECT_EQ(tally.leaks, 0);
  EXPECT_EQ(tally.wrong, 0);
}

TEST(Suite, RejectsAFixedEpsilon) { EXPECT_GT(total(Policy::epsilon, 100).failures(), 100); }

}  // namespace
}  // namespace rt::stability
