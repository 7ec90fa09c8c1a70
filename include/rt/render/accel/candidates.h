#pragma once
#include <cstdint>
#include <span>

namespace rt {

/// The instances that some rays can meet, when they are known to be few.
struct Candidates {
  bool known = false;  ///< false: ask the whole scene
  bool dims = false;   ///< some of them dim shadow rays
  std::span<const std::uint32_t> instances;
};

}  // namespace rt
