#pragma once
#include <algorithm>
#include <ctime>
#include <span>
#include <vector>

namespace rt::bench {

/// Nanoseconds of processor time per call of each of several functions over the same items. The
/// functions take turns on slices of the items, short enough to be interrupted seldom, so that a
/// busy machine is unfair to none; the median over slices and rounds counts. Many slices keep the
/// processor from learning by heart how the branches of each item go.
template <class Item, class Function>
std::vector<double> nanoseconds(const std::vector<Item>& items,
                                const std::vector<Function>& functions, int rounds) {
  constexpr std::size_t slice = 4096;
  std::vector<std::vector<double>> times(functions.size());
  long sum = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t begin = 0; begin + slice <= items.size(); begin += slice) {
      for (std::size_t k = 0; k < functions.size(); ++k) {
        const std::clock_t start = std::clock();
        for (const Item& item : std::span(items).subspan(begin, slice)) {
          sum += functions[k](item) ? 1 : 0;
        }
        const double spent = 1e9 / CLOCKS_PER_SEC * static_cast<double>(std::clock() - start);
        times[k].push_back(spent / static_cast<double>(slice));
      }
    }
  }
  volatile long keep = sum;
  static_cast<void>(keep);
  std::vector<double> medians;
  for (std::vector<double>& t : times) {
    const auto middle = t.begin() + static_cast<std::ptrdiff_t>(t.size() / 2);
    std::nth_element(t.begin(), middle, t.end());
    medians.push_back(*middle);
  }
  return medians;
}

}  // namespace rt::bench
