#pragma once
/// A rendering that can be left off and taken up again, in this process or, by way of its bytes, in
/// another. Wherever it was left off, the picture is the same in the end.
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "rt/math/bytes.h"
#include "rt/render/adaptive.h"
#include "rt/render/render.h"

namespace rt {

/// When to leave off before the end.
struct Until {
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: at once, within a tile if need be
  /// At this time, but only between tiles, or where that loses nothing.
  std::optional<Deadline::Clock::time_point> pause = std::nullopt;
};

class Rendering {
 public:
  /// Nothing is traced yet. The plan must outlive it.
  Rendering(const RenderPlan& plan, const Crop& crop);
  ~Rendering();
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;

  /// Goes on until the picture is done (true) or it is time to leave off (false). Every call that
  /// does not stop takes the picture further. A time limit counts the time of all calls.
  bool run(const ProgressFunction& progress, const Until& until);

  /// How much of the picture is done, in [0,1].
  double fraction() const { return done_; }
  /// Time spent in run(), of all that it was left off from.
  double seconds() const { return spent_; }
  /// The picture as far as it is: pixels that no tile has reached are black.
  RenderResult take();

  /// What load() needs to go on from here: 12 bytes a pixel, or, adaptive, 24 and another 168 for
  /// those in work (with a time limit, all) that their first samples did not settle.
  void save(ByteWriter& out) const;
  /// How many bytes save() writes.
  std::size_t state_bytes() const;
  /// Throws std::out_of_range when the bytes cannot be of a rendering of this plan and crop.
  void load(ByteReader& in);

 private:
  struct Samplers;
  bool adaptive() const { return fixed_ == 0; }
  double share(std::size_t tile) const;
  void count_done();
  template <class Work>
  void for_open_tiles(const Until& until, const Work& work);
  void plain(const Until& until);
  bool plain_tile(const Crop& tile, PixelSampler& sampler, RenderStatistics& statistics,
                  const Until& until);
  void tile_by_tile(const Deadline& deadline, const Until& until);
  void progressive(const Deadline& deadline, const Until& until);
  ReachedError reached() const;

  const RenderPlan& plan_;
  Crop crop_;
  double pixels_;
  int fixed_;  ///< samples of each pixel; -1: the classic scheme; 0: adaptive
  std::vector<Crop> areas_;
  std::vector<std::uint8_t> finished_;  ///< by tile
  std::vector<AdaptiveTile> open_;      ///< by tile; holds pixels while in work
  RenderResult result_;
  PixelResults results_;  ///< in `result_`
  double spent_ = 0.0;  ///< seconds in run()
  bool out_of_time_ = false;

  std::unique_ptr<Samplers> samplers_;

  std::mutex mutex_;  ///< of what follows, and of `result_.statistics`
  double done_ = 0.0;
  const ProgressFunction* progress_ = nullptr;
};

}  // namespace rt
