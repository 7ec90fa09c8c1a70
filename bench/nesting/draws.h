#pragma once
/// How older ray tracers spread the samples of one decision, and of one pixel.
#include <vector>

#include "rt/math/sampler.h"

namespace rt::bench {

enum class Spread {
  random,      ///< all of a pixel's samples anywhere
  jittered,    ///< camera samples in the cells of a grid, all else anywhere
  stratified,  ///< and their places on a light in the cells of another, paired by chance
  nets         ///< camera samples in a grid, the samples of each decision well spread
};

/// The samples of one decision.
class Draws {
 public:
  Draws(Spread spread, std::uint64_t set) : first_(set, 0, 0, 0), set_(set), spread_(spread) {}
  /// A decision of one sample.
  explicit Draws(const Sampler& only) : first_(only), set_(0), spread_(Spread::nets) {}

  Sampler operator()(int i) const {
    const auto index = static_cast<std::uint32_t>(i);
    if (i == 0) {
      return first_;
    }
    return spread_ == Spread::nets ? first_.at(index) : Sampler(set_, i, 0, 0);
  }

 private:
  Sampler first_;
  std::uint64_t set_;
  Spread spread_;
};

/// Samples whose light() lies one in each cell of a grid, in an order of chance: some sets of them,
/// made beforehand, so that finding them costs no time that is measured.
class Strata {
 public:
  explicit Strata(int side);
  const Sampler& at(std::uint64_t set, int cell) const {
    return samplers_[set % sets * cells_ + static_cast<std::size_t>(cell)];
  }

 private:
  static constexpr std::size_t sets = 64;
  std::size_t cells_;
  std::vector<Sampler> samplers_;
};

}  // namespace rt::bench
