#pragma once
/// What rt_oiio.so offers to the rest of src/io. Both sides are built together, so C++ types may
/// cross; exceptions do not: a function that can fail returns the reason, empty for success, or
/// false.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rt::io {

/// A picture on its way into a file format. Rows from the top, three channels a pixel.
struct EncodeRequest {
  const char* format = "";  ///< OpenImageIO's name of the format: png bmp targa jpeg openexr
  int width = 0;
  int height = 0;
  const void* pixels = nullptr;  ///< unsigned char where not is_float, else float
  bool is_float = false;
  bool is_srgb = false;  ///< tells viewers, where the format can say so
  const std::map<std::string, std::string>* metadata = nullptr;
};

struct DecodedImage {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;  ///< 3 * width * height, stored values
};

/// A picture on its way into the texture system; its header has been checked.
struct TextureRequest {
  const char* reader = "";  ///< OpenImageIO's name of the format
  const char* name = "";    ///< the file's, for messages
  int descriptor = -1;      ///< open for reading; not closed
  std::uint64_t readable_bytes = 0;
  std::uint64_t decoded_bytes = 0;  ///< that the picture may take
  int largest_side = 0;             ///< pixels of width or height that it may have
  bool raw = false;                 ///< values as stored
};

/// What lookups read: made, used and dropped by the module.
class ReadyTexture;

enum class TextureWrap { repeat, clamp, mirror, black };

/// Where to look a texture up: t goes down the picture. All finite.
struct TextureLookup {
  float s, t;
  float ds_dx, dt_dx, ds_dy, dt_dy;
  TextureWrap wrap;
};

/// Three channels, and their changes by s and t.
struct TextureResult {
  float value[3];
  float d_ds[3];
  float d_dt[3];
};

struct TextureCounts {
  std::uint64_t lookups = 0;
  std::uint64_t cache_peak = 0;  ///< bytes
};

struct OiioTable {
  /// Makes the bytes of a file in memory.
  std::string (*encode)(const EncodeRequest& request, std::vector<unsigned char>& file);
  /// Reads a file of the given format, after looking at the size that its header claims.
  std::string (*decode)(const char* format, const std::string& path, DecodedImage& image);

  /// Decodes a picture whole. `is_encoded` tells whether its values were linearised, or would be.
  std::string (*make_texture)(const TextureRequest& request, ReadyTexture*& texture,
                              bool& is_encoded);
  void (*drop_texture)(ReadyTexture* texture);
  /// Filters over a footprint. With derivatives a magnified picture is a cubic B-spline, whose
  /// slopes have no jumps; without, texels are interpolated linearly. False when what is decoded
  /// cannot be read back.
  bool (*look_up)(const ReadyTexture& texture, const TextureLookup& lookup, bool derivatives,
                  TextureResult& result);
  void (*set_texture_memory)(int megabytes);
  TextureCounts (*texture_counts)();
};

/// The symbol that the module exports, of type `const OiioTable`.
inline constexpr const char* oiio_table_symbol = "rt_oiio_table";

}  // namespace rt::io
