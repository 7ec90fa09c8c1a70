#pragma once
#include "rt/math/srgb.h"
#include "rt/math/wide.h"

namespace rt {

/// As for one value.
inline Wide srgb_displayed(const Wide& linear) {
  using Ints = stdx::rebind_simd_t<std::int32_t, Wide>;
  const Wide position = srgb_intervals * sqrt(min(max(Wide(0.0), linear), Wide(1.0)));
  const Ints at = stdx::static_simd_cast<Ints>(position);
  const auto node = [&](int next) {
    return Wide([&](auto i) { return double{srgb_table[static_cast<std::size_t>(at[i] + next)]}; });
  };
  const Wide low = node(0);
  return low + (position - stdx::static_simd_cast<Wide>(at)) * (node(1) - low);
}

}  // namespace rt
