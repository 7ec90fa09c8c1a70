#include "rt/render/statistics.h"

#include <tuple>

namespace rt {

void RenderStatistics::add_bad(int x, int y) {
  if (bad_samples == 0 || std::tie(y, x) < std::tie(first_bad_y, first_bad_x)) {
    first_bad_x = x;
    first_bad_y = y;
  }
  ++bad_samples;
}

RenderStatistics& RenderStatistics::operator+=(const RenderStatistics& other) {
  if (other.bad_samples > 0) {
    add_bad(other.first_bad_x, other.first_bad_y);
    bad_samples += other.bad_samples - 1;
  }
  samples += other.samples;
  cpu_seconds += other.cpu_seconds;
  rays += other.rays;
  return *this;
}

}  // namespace rt
