#pragma once
/// Pictures out of the program and, for comparisons, in. OpenImageIO lives in a module of its own
/// that is opened on a thread of its own: loading it takes longer than rendering a small scene.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "rt/scene/options.h"

namespace rt::io {

/// Linear RGB, row by row from the top, three floats a pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;  ///< 3 * width * height
};

/// Begins to load OpenImageIO on a thread of its own; later calls do nothing. Optional: the
/// functions below load it if nobody has.
void preload();
/// Waits for that to end (some 0.3 s), if it has begun. A process must not exit before: what the
/// libraries that are loaded by then have to do at an exit would meet constructors that still run.
void end_preload();

/// Throws FileError when no picture can be written under that name: an extension that is none of
/// .png .bmp .exr .tga .jpg .jpeg (any case), a size that the format cannot hold, or a place where
/// no file can be (check_place). Does not need OpenImageIO, so that a mistake shows before the
/// rendering, not after.
void check_output(const std::filesystem::path& path, int width, int height);

/// Writes a picture: under a temporary name in the same folder, renamed once complete; on failure
/// the temporary is removed and FileError thrown. PNG, BMP, TGA and JPEG are 8-bit, encoded as
/// asked, NaN as 0; JPEG at quality 95; EXR is 32-bit float, linear, zip-compressed. `metadata`
/// becomes text attributes (PNG, EXR); no date is written: equal inputs give equal bytes.
void write_image(const std::filesystem::path& path, const Image& image, Encoding encoding,
                 const std::map<std::string, std::string>& metadata);

/// A picture as the bytes of a PNG file, without metadata.
std::vector<unsigned char> encode_png(const Image& image, Encoding encoding);

/// Reads a picture in one of these formats, recognised by what it holds, as stored values in 0..1
/// (8-bit) or float (EXR), without any decoding of sRGB. Grey becomes three equal channels; alpha
/// is dropped. Throws FileError.
Image read_image(const std::filesystem::path& path);

}  // namespace rt::io
