#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "rt/cli/checkpoint.h"
#include "rt/cli/command_line.h"
#include "rt/cli/identity.h"
#include "rt/cli/rescue.h"

namespace rt::cli {

/// Keeps what a run has done: writes its checkpoint, and goes on from one.
///
/// A run has one checkpoint, named after its first picture unless --checkpoint-file says otherwise.
/// It is written when a signal interrupts the run, every --checkpoint seconds, and then also after
/// each picture; it is removed when the run has come to its end. One that this run neither read nor
/// wrote is left alone.
class Keeper {
 public:
  explicit Keeper(const CommandLine& line) : line_(line) {}

  /// A file that the pictures depend on.
  void reads(const std::filesystem::path& file) { files_.note(file); }

  /// A picture is going to be rendered. True when it is there already, as the checkpoint says that
  /// --resume goes on from. Throws FileError when that is of something else.
  bool begin(const std::filesystem::path& picture, const RenderOptions& options, const Crop& crop);
  /// Takes the rendering of that picture up where the checkpoint left it, if it did.
  void take_up(Rendering& rendering, const RenderJob& job);
  /// The picture is on the disk.
  void finished();

  /// Writes the checkpoint, elsewhere if need be; unless it still holds what --resume has not come
  /// to yet. With a rendering it is that of the picture begun.
  Saved save(const Rendering* rendering, const RenderJob* job);
  /// Whether there is anything to keep beside a picture begun.
  bool has_finished() const { return !done_.finished.empty(); }

  /// The run has come to its end.
  void end() const;

  /// The command that goes on from the checkpoint.
  std::string command(const std::filesystem::path& checkpoint) const;

 private:
  Facts facts_of_run_now();
  void check(const Facts& options, const Facts& then);
  void open();

  const CommandLine& line_;
  InputFiles files_;
  std::filesystem::path file_;           ///< the checkpoint's; empty before the first picture
  std::optional<Checkpoint> earlier_;    ///< what --resume goes on from
  Checkpoint done_;                      ///< what this run has done
  std::filesystem::path picture_;        ///< the one begun
  Facts options_;                        ///< its
  std::set<std::filesystem::path> own_;  ///< checkpoints that this run has read or written
};

}  // namespace rt::cli
