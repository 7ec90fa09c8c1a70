#pragma once
/// The recursive shader (tracer.h) for several samples at a time.
#include <optional>
#include <vector>

#include "rt/render/accel/candidates.h"
#include "rt/render/packet/packet_footprint.h"
#include "rt/render/packet/packet_medium.h"
#include "rt/render/packet/packet_shading.h"

namespace rt {

/// Follows the paths of as many samples as a register holds doubles. What they meet is lit together,
/// whatever it is; where they part in glass, the packet divides. Each sample's radiance is that of
/// Tracer, bit for bit: the same operations in the same order.
class PacketTracer {
 public:
  explicit PacketTracer(const RenderPlan& plan);

  /// The radiance that arrives along those camera rays (of any length) that are `active`. `time`:
  /// theirs, null where nothing moves. `y`: as for Tracer, `sampler`: theirs.
  Wide3 radiance(const WideRay& camera, unsigned active, const Wide* time, const Wide& y,
                 const WideSampler& sampler, RayCounts& counts, const Candidates& sight);

 private:
  struct Path {
    Packet packet;
    Wide3 throughput;
    Vertex vertex;
    int depth;
  };
  struct Surfaces;
  struct Scatter;

  void follow(Path& path);
  void miss(Path& path, unsigned bits);
  void shade(Path& path, const PacketHits& hits, unsigned bits);
  void resolve_textures(Surfaces& at, const PacketHits& hits, std::uint32_t id, unsigned bits);
  Wide3 surface(const Surfaces& at, unsigned bits);
  void scatter_glass(Scatter& at);
  void divide(Scatter& at, const Wide& reflected, const Wide& transmitted);
  void reflect(const Scatter& at, unsigned bits, const Wide3& throughput);
  void transmit(const Scatter& at, unsigned bits, const Wide3& throughput);
  void add(const Scatter& at, unsigned bits, const Wide3& direction, const Wide3& throughput,
           bool drawn);
  void push(const Scatter& at, unsigned bits, const Wide3& direction, const Wide3& throughput,
            const Vertex& vertex, bool outward, bool drawn);

  const RenderPlan& plan_;
  double negligible_;
  ShadowCache shadow_cache_;
  std::vector<Path> open_;
  std::optional<PacketFootprints> footprints_;  ///< beside open_, where textures want them

  // Of the samples being taken.
  Wide3 sum_;
  Wide y_;
  Candidates sight_;
  const WideSampler* sampler_ = nullptr;
  RayCounts* counts_ = nullptr;
};

}  // namespace rt
