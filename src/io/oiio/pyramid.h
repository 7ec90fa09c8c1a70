#pragma once
/// A picture and its ever smaller averages, tile by tile in a temporary file.
#include <OpenImageIO/imageio.h>

#include <memory>
#include <vector>

namespace rt::io {

/// Level 0 is the picture; each further level has half its predecessor's width and height, rounded
/// down, to one pixel. Once complete it may be read by any number of threads.
class Pyramid {
 public:
  static constexpr int tile = 64;  ///< edge of a tile, in pixels

  struct Level {
    int width, height;
    std::int64_t offset;  ///< of its first tile in the file
    int tiles_across() const { return (width + tile - 1) / tile; }
    int tiles_down() const { return (height + tile - 1) / tile; }
  };

  /// `type` is HALF or FLOAT. Throws std::runtime_error when there is no room for the file.
  Pyramid(int width, int height, int channels, OIIO::TypeDesc type);
  ~Pyramid();
  Pyramid(const Pyramid&) = delete;
  Pyramid& operator=(const Pyramid&) = delete;

  /// The next row of level 0, finite. Throws std::runtime_error when it cannot be written.
  void push_row(const float* row);

  int channels() const { return channels_; }
  OIIO::TypeDesc type() const { return type_; }
  const std::vector<Level>& levels() const { return levels_; }
  std::size_t tile_bytes() const;
  /// The tile whose corner is the pixel (x, y). False when the file cannot be read.
  bool read_tile(std::size_t level, int x, int y, void* pixels) const;

 private:
  /// What is under way at a level while rows come.
  struct Progress {
    int rows = 0;              ///< that have come
    std::vector<float> strip;  ///< the rows of the tiles being filled, as wide as the tiles
    std::vector<float> sum;    ///< of the narrowed rows for the next level's row
    std::vector<float> narrow;
  };

  void push_row(std::size_t level, const float* row);
  void write_strip(std::size_t level);
  void narrow_row(const Level& from, const Level& to, const float* row, float* out) const;

  int channels_;
  OIIO::TypeDesc type_;
  std::vector<Level> levels_;
  std::vector<Progress> progress_;
  std::vector<unsigned char> packed_;  ///< a tile on its way into the file
  int file_ = -1;
};

}  // namespace rt::io
