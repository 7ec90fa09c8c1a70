/// Secondary rays that err, by how they leave the surface and by the scene's scale, as CSV:
///
///   bench_leaving RAYS_A_PLACEMENT
#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "stability/leaving.h"

namespace rt::bench {
namespace {

using stability::LeavingTally;
using stability::Policy;

void print(const char* name, Policy policy, long rays) {
  std::map<double, LeavingTally> by_scale;  // all shapes, at the origin and away from it
  std::uint64_t seed = 1000;
  for (const stability::Placement& placement : stability::placements()) {
    by_scale[placement.scale].add(run_leaving(placement, policy, rays, seed++));
  }
  for (const auto& [scale, t] : by_scale) {
    fmt::print("{},{:.0e},{},{},{},{},{}\n", name, scale, t.rays, t.false_hits, t.leaks, t.wrong,
               t.below_resolution);
  }
}

}  // namespace
}  // namespace rt::bench

int main(int argc, char** argv) {
  const long rays = argc > 1 ? std::atol(argv[1]) : 1000;
  fmt::print("policy,scale,rays,false_hits,leaks,wrong,below_resolution\n");
  using rt::stability::Policy;
  rt::bench::print("side (this program)", Policy::side, rays);
  rt::bench::print("touching shape (this program)", Policy::touching, rays);
  rt::bench::print("rounding-bound offset", Policy::offset, rays);
  rt::bench::print("t > 1e-6", Policy::epsilon, rays);
}
