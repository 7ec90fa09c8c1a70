#include <gtest/gtest.h>

#include "stability/checker.h"
#include "stability/naive.h"

namespace rt::stability {
namespace {

/// The full suite has 1e6 and more rays a family (bench/stability). Sanitized builds are some
/// fifteen times slower and look for other faults: a tenth of the rays will do.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long rays = 1000;
#else
constexpr long rays = 10000;
#endif

class Families : public ::testing::TestWithParam<Family> {};

TEST_P(Families, MissNothingAndInventNothing) {
  Tally tally = run(GetParam(), own_solver, rays, 1);
  for (const std::string& complaint : complaints(GetParam(), tally)) {
    ADD_FAILURE() << complaint;
  }
}

std::string test_name(const ::testing::TestParamInfo<Family>& family) {
  std::string name = family.param.name();
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Families, ::testing::ValuesIn(families()), test_name);

// The suite must be able to fail.

OptionalHit ferrari(const Shape& shape, const Ray& ray) {
  return naive_ferrari(std::get<Torus>(shape), ray);
}

Family torus_family(Kind kind) { return {"torus", kind, 1e-14}; }

TEST(Suite, RejectsNaiveFerrari) {
  for (const Kind kind : {Kind::grazing, Kind::thin, Kind::far, Kind::equatorial, Kind::double_root,
                          Kind::non_uniform}) {
    const Family family = torus_family(kind);
    Tally tally = run(family, ferrari, 2000, 1);
    EXPECT_FALSE(complaints(family, tally).empty()) << family.name();
  }
}

TEST(Suite, FindsFerrariRightOftenEnoughToTrustTheComparison) {
  const Tally tally = run(torus_family(Kind::random), ferrari, 2000, 1);
  EXPECT_LT(tally.missed + tally.false_hits, 2);
  EXPECT_GT(tally.hits, 1000);
}

TEST(Suite, SeesEachWayToBeWrong) {
  const Family family = torus_family(Kind::random);
  const auto complains = [&](const Solver& solver) {
    Tally tally = run(family, solver, 500, 1);
    return !complaints(family, tally).empty();
  };
  EXPECT_FALSE(complains(own_solver));
  EXPECT_TRUE(complains([](const Shape&, const Ray&) { return OptionalHit{}; }));
  EXPECT_TRUE(complains([](const Shape&, const Ray&) { return OptionalHit(ShapeHit{1}); }));
  EXPECT_TRUE(complains([](const Shape& shape, const Ray& ray) {
    OptionalHit hit = own_solver(shape, ray);
    if (hit) {
      hit->t *= 1 + 1e-12;
    }
    return hit;
  }));
}

}  // namespace
}  // namespace rt::stability
