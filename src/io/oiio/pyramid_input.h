#pragma once
#include <OpenImageIO/imagecache.h>

#include <cstdint>

#include "pyramid.h"

namespace rt::io {

/// Lets the cache read a pyramid under a name, as if it were a tiled, mip-mapped file, until the
/// name is invalidated.
bool add_pyramid(OIIO::ImageCache& cache, OIIO::ustring name, const Pyramid& pyramid);

/// The most bytes that the cache has held so far, or since it was forgotten.
std::uint64_t cache_peak(OIIO::ImageCache& cache);
void forget_cache_peak();

}  // namespace rt::io
