#pragma once
#include "rt/render/packet/packet_tracer.h"
#include "rt/render/sample.h"

namespace rt {

/// Takes samples several at a time: what PixelSampler would take one by one, bit for bit.
class PacketSampler {
 public:
  explicit PacketSampler(const RenderPlan& plan) : plan_(plan), tracer_(plan) {}

  void take(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
            RenderStatistics& statistics, std::span<std::uint8_t> quadrants, SightCache& sight);

 private:
  /// All at their pixels' centres, or none.
  void take_packet(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
                   RenderStatistics& statistics, std::span<std::uint8_t> quadrants,
                   SightCache& sight);
  Candidates sight_of(SightCache& sight, const Wide2& places, unsigned count);

  const RenderPlan& plan_;
  PacketTracer tracer_;
  std::vector<std::uint32_t> union_;  ///< of what several blocks show
};

}  // namespace rt
