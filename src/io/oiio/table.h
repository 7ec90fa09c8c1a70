#pragma once
/// What rt_oiio.so offers to the rest of src/io. Both sides are built together, so C++ types may
/// cross; exceptions do not: every function returns the reason of its failure, empty for success.
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

struct OiioTable {
  /// Makes the bytes of a file in memory.
  std::string (*encode)(const EncodeRequest& request, std::vector<unsigned char>& file);
  /// Reads a file of the given format, after looking at the size that its header claims.
  std::string (*decode)(const char* format, const std::string& path, DecodedImage& image);
};

/// The symbol that the module exports, of type `const OiioTable`.
inline constexpr const char* kOiioTableSymbol = "rt_oiio_table";

}  // namespace rt::io
