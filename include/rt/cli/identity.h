#pragma once
/// What a picture depends on, as facts that a checkpoint keeps: going on from it makes sense only
/// where they are the same.
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "rt/cli/command_line.h"
#include "rt/scene/render_job.h"

namespace rt::cli {

struct Fact {
  std::string name;   ///< "the option samples", "the file vase.obj"
  std::string value;  ///< as shown, or a digest
};
using Facts = std::vector<Fact>;

/// The first of `now` that `then` does not have, in words ("the option samples is 16, and was 4"),
/// or empty.
std::string first_difference(const Facts& now, const Facts& then);

/// Files that were read. Their contents are looked at only when somebody wants to know.
class InputFiles {
 public:
  void note(const std::filesystem::path& file);
  /// One fact a file. A file that has changed since it was noted is like no other.
  Facts facts() const;

 private:
  struct Stamp {
    std::uintmax_t size;
    std::filesystem::file_time_type changed;
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stamp_of(const std::filesystem::path& file);
  std::map<std::filesystem::path, Stamp> inputs_;
};

/// 64 bits of a file's contents; 0 when it cannot be read.
std::uint64_t digest_of_file(const std::filesystem::path& file);

/// The program (version and build), and what the command line says to the script.
Facts facts_of_run(const CommandLine& line);
/// Size, crop, and every option but the time limit, which the next run may change.
Facts facts_of_options(const RenderOptions& options, const Crop& crop);
/// What the script has made: it may depend on more than its files, on the time for one. Places,
/// shapes' extents, materials, lights and camera, as one digest.
Fact fact_of_scene(const RenderJob& job);

}  // namespace rt::cli
