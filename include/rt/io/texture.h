#pragma once
/// Pictures in, for textures: checked before anything decodes them, filtered by OpenImageIO's
/// TextureSystem. Nothing of that is loaded until the first is opened.
#include <cstdint>
#include <filesystem>
#include <memory>

#include "rt/scene/texture_image.h"

namespace rt::io {

/// What textures may use up.
struct TextureLimits {
  int largest_side = 16384;                              ///< pixels of width or height
  std::uint64_t decoded_bytes = std::uint64_t{1} << 30;  ///< of one picture, as its reader makes it
  int cache_megabytes = 512;  ///< of decoded tiles in memory, all textures together; 2 or more
};

/// Opens a PNG, JPEG, BMP, TGA, TIFF, EXR or HDR picture, recognised by what it holds. Its header
/// is checked against the limits (texture_header.h), then all of it is decoded once, tile by tile,
/// into a pyramid of ever smaller pictures in a temporary file without a name (in $TMPDIR or /tmp),
/// from which lookups read through the cache. So a broken file is found out here, and never later.
///
/// Pictures of 8 and 16 bits a channel are linearised (IEC 61966-2-1) before they are averaged. Of
/// several frames, parts or levels the first counts; of the channels the first three, or one where
/// there are fewer; alpha, orientation and colour profiles are not looked at. Texels that are not
/// finite are 0. For raw lookups of encoded pictures a second pyramid is made when the first comes.
///
/// Throws FileError. All textures share one cache, whose size the latest call sets.
std::shared_ptr<const TextureImage> open_texture(const std::filesystem::path& path,
                                                 const TextureLimits& limits = {});

struct TextureStatistics {
  std::uint64_t lookups = 0;     ///< of all threads
  std::uint64_t files = 0;       ///< opened so far
  std::uint64_t cache_peak = 0;  ///< most bytes of tiles in memory, for the limit in force
  double load_seconds = 0.0;     ///< spent on checking and decoding, and on loading what does it
};

/// Since the program's start. All zero, and nothing is loaded, when no texture was opened.
TextureStatistics texture_statistics();

}  // namespace rt::io
