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
  void take_centres(const Crop& tile, const Crop& crop, Film& film, RenderStatistics& statistics,
                    SightCache& sight);

 private:
  /// Whether camera rays do not all start in one place at one time.
  bool own_rays() const { return plan_.camera.lens_radius > 0.0 || plan_.moves; }
  void take_packet(std::span<const PixelSample> wanted, std::span<std::optional<Rgb>> values,
                   RenderStatistics& statistics, std::span<std::uint8_t> quadrants,
                   SightCache& sight);
  void take_block(const Crop& block, const Candidates& candidates, const Crop& crop, Film& film,
                  RenderStatistics& statistics);
  Wide3 traced(const Wide2& places, unsigned active, const WideSampler& sampler,
               const Candidates& candidates, RenderStatistics& statistics);
  Candidates sight_of(SightCache& sight, const Wide2& places, unsigned count);

  const RenderPlan& plan_;
  PacketTracer tracer_;
  std::vector<std::uint32_t> union_;  ///< of what several blocks show
};

}  // namespace rt
