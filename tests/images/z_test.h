#pragma once
/// Whether a picture with noise is a fair draw of what it should be: against the mean and variance
/// of each pixel over many seeds, instead of a fixed tolerance on noise.
#include <string>
#include <vector>

#include "rt/io/image.h"

namespace rt::images {

/// Each value's mean over pictures of different seeds, and the variance of one picture.
struct Reference {
  io::Image mean;
  io::Image variance;
};

/// Of at least two pictures of one size. Throws std::invalid_argument.
Reference reference_of(const std::vector<io::Image>& pictures);

struct ZVerdict {
  bool fair = false;
  std::string text;
};

/// `count`: how many pictures the reference was made of. Per value z = (x - mean) / sqrt(variance
/// (1 + 1/count)) follows Student's distribution of nu = count - 1 degrees of freedom where the
/// noise is normal, and has mean 0 and variance near nu / (nu - 2) in any case. Values of different
/// pixels are independent, so that over a channel's n values sums are normal:
///
///   mean of z        times sqrt(n): standard normal. Finds a picture too bright or too dark.
///   mean of z^2      less nu / (nu - 2), over its own standard error: standard normal. Finds what
///                    lies elsewhere than it should.
///
/// Each fails beyond 4 standard deviations: together in one of 2600 fair pictures of three
/// channels. A surprise is |z| > 6, or any difference (beyond the rounding of floats) where no seed
/// made one. An event of probability q a picture is unseen by the reference and seen now with q
/// (1-q)^count, at most 1 / (e count): surprises fail beyond that share of the values.
ZVerdict z_test(const io::Image& picture, const Reference& reference, int count);

}  // namespace rt::images
