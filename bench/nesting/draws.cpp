#include "nesting/draws.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace rt::bench {
namespace {

/// A sample that falls into a cell of its light's square; found by trying.
Sampler sampler_in(int cell, int side, std::uint64_t& tried) {
  for (;;) {
    const Sampler sampler(++tried, 1, 0, 0);
    const Vec2 at = static_cast<double>(side) * sampler.light();
    if (static_cast<int>(at.x) == cell % side && static_cast<int>(at.y) == cell / side) {
      return sampler;
    }
  }
}

}  // namespace

Strata::Strata(int side) : cells_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
  std::mt19937_64 engine(1);
  std::uint64_t tried = 0;
  std::vector<int> order(cells_);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = 0; i < sets; ++i) {
    std::shuffle(order.begin(), order.end(), engine);
    for (const int cell : order) {
      samplers_.push_back(sampler_in(cell, side, tried));
    }
  }
}

}  // namespace rt::bench
