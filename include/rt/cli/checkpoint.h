#pragma once
/// The file that lets an interrupted run go on: which pictures are finished, and how far the one at
/// hand is. A header, counted texts, a rendering's state, and a digest of it all; for the very
/// program that wrote it.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rt/cli/identity.h"
#include "rt/render/rendering.h"

namespace rt::cli {

struct Checkpoint {
  struct Finished {
    std::string picture;
    Facts options;
    std::uint64_t digest = 0;  ///< of the picture's file once written; 0: it could not be read
  };
  struct Current {
    std::string picture;
    Facts options;  ///< with the scene's
  };

  Facts run;  ///< of the program, the command line, the files
  std::vector<Finished> finished;
  std::optional<Current> current;
  std::vector<unsigned char> state;  ///< Rendering::save()'s, of `current`
};

/// The bytes of a checkpoint; its state is that of `rendering`.
std::vector<unsigned char> encode(const Checkpoint& checkpoint, const Rendering* rendering);

/// Throws FileError when the file cannot be read, or is not a whole checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace rt::cli
