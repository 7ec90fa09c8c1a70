#pragma once
#include <algorithm>
#include <chrono>
#include <vector>

namespace rt::bench {

/// Nanoseconds per call of each of several functions over the same items: the functions take turns,
/// so that a busy machine is unfair to none, and the median of the rounds counts.
template <class Item, class Function>
std::vector<double> nanoseconds(const std::vector<Item>& items,
                                const std::vector<Function>& functions, int rounds) {
  std::vector<std::vector<double>> times(functions.size());
  long sum = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const auto start = std::chrono::steady_clock::now();
      for (const Item& item : items) {
        sum += functions[k](item) ? 1 : 0;
      }
      const std::chrono::duration<double, std::nano> spent =
          std::chrono::steady_clock::now() - start;
      times[k].push_back(spent.count() / static_cast<double>(items.size()));
    }
  }
  volatile long keep = sum;
  static_cast<void>(keep);
  std::vector<double> medians;
  for (std::vector<double>& t : times) {
    std::nth_element(t.begin(), t.begin() + rounds / 2, t.end());
    medians.push_back(t[static_cast<std::size_t>(rounds / 2)]);
  }
  return medians;
}

}  // namespace rt::bench
