#include "rt/render/pixel_results.h"

namespace rt {

void PixelResults::set(int x, int y, const PixelEstimate& e) {
  const std::size_t i = index(x, y);
  result_.film.set(x - crop_.x, y - crop_.y, e.mean());
  result_.errors[i] = e.error;
  result_.samples[i] = e.count;
  result_.pilots[i] = e.pilots;
}

void PixelResults::set_row(int x, int y, int count, const Wide3& means, const Wide& errors,
                           std::uint32_t pilots) {
  const std::size_t begin = index(x, y);
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    result_.film.set(x + i - crop_.x, y - crop_.y, means.lane(i));
    result_.errors[begin + at] = static_cast<float>(errors[at]);
    result_.samples[begin + at] = pilots;
    result_.pilots[begin + at] = pilots;
  }
}

void PixelResults::clear(const Crop& area) {
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) {
      set(x, y, {});
    }
  }
}

}  // namespace rt
