#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "rt/io/texture.h"
#include "rt/render/render.h"
#include "rt/scene/options.h"

namespace rt::cli {

/// Seconds of wall time a picture took, by phase.
struct Phases {
  double script = 0.0;  ///< from the start, or the last picture, until gr.render was called
  double plan = 0.0;    ///< compiling the scene and building hierarchies
  double trace = 0.0;
  double trace_cpu = 0.0;  ///< processor time of the threads that traced
  double write = 0.0;      ///< encoding and writing, waiting for OpenImageIO included
};

/// One picture, for --stats and the closing line.
struct PictureReport {
  std::string picture;
  Crop crop;
  RenderOptions options;
  std::size_t instances = 0;
  std::size_t lights = 0;
  RenderStatistics statistics;
  std::optional<ReachedError> reached;
  Phases phases;
};

/// "picture.png: 640x480, 16 samples a pixel, 0.21 s, 3.1 M rays (14.8 M/s)", and the error.
std::string summary(const PictureReport& report);

/// Writes the reports as JSON. Throws FileError.
void write_stats(const std::filesystem::path& file, const std::filesystem::path& scene, int threads,
                 const io::TextureStatistics& textures, const std::vector<PictureReport>& reports);

}  // namespace rt::cli
