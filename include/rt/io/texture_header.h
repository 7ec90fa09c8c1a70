#pragma once
/// The gate before the decoders: a picture's header, read by this program itself, so that a file
/// that claims more than it may have never reaches a library that would believe it.
#include <cstdint>
#include <filesystem>

#include "rt/io/texture.h"

namespace rt::io {

/// What a header claims.
struct PictureHeader {
  const char* format = "";  ///< for messages: "PNG"
  const char* reader = "";  ///< OpenImageIO's name of the format
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t channels = 0;
  std::uint64_t channel_bytes = 1;     ///< of one channel of a pixel, decoded
  std::uint64_t least_file_bytes = 0;  ///< no complete file with this header can be smaller
  /// How much of the file its reader is shown: TGA's footer leads to thumbnails, which are not
  /// wanted and which readers have got wrong (CVE-2023-24473).
  std::uint64_t readable_bytes = 0;
};

/// A regular file, open for reading.
class PictureFile {
 public:
  /// Throws FileError when there is none to be read: a folder, a device, a pipe, an empty file.
  explicit PictureFile(std::filesystem::path path);
  ~PictureFile();
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  int descriptor() const { return descriptor_; }
  std::uint64_t size() const { return size_; }
  /// Reads from `offset`; returns how many bytes there were.
  std::size_t read(std::uint64_t offset, void* bytes, std::size_t count) const;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// Recognises the format by the file's first bytes (TGA, which has no mark, by a header that makes
/// sense and a footer or a name that ends in .tga), reads the header and checks it. Throws
/// FileError: what it is not, what it claims, or that it is cut short. Takes a few KB of memory
/// whatever it holds, and reads a few KB, but for JPEG, whose end is looked for.
PictureHeader check_picture(const PictureFile& file, const TextureLimits& limits);

}  // namespace rt::io
