#pragma once
#include "rt/math/vec.h"

namespace rt {

/// How a pixel weighs the picture around its centre. All are positive, so a filter is sampled as a
/// density and every sample counts alike: no pixel needs its neighbour's samples.
///
///   box              1 on the pixel: |x|, |y| < 1/2
///   tent             (1-|x|)(1-|y|), radius 1
///   gaussian         exp(-(x^2+y^2) / 2 sigma^2), sigma = 1/2 pixel, isotropic;
///                    cut off at radius 3/2, which is 3 sigma
///                    and drops 1.1% of the mass
///   blackman_harris  the 4-term window of Harris (Proc. IEEE 66(1), 1978) in x times in y, radius
///                    3/2; standard deviation 0.42 pixel
enum class Filter { box, tent, gaussian, blackman_harris };

/// Offset from the pixel's centre, in pixels, distributed as the filter. Continuous in u.
Vec2 filter_offset(Filter filter, const Vec2& u);

/// The filter at an offset, normalised to integrate to 1.
double filter_density(Filter filter, const Vec2& offset);

/// No offset has a coordinate beyond this.
double filter_radius(Filter filter);

}  // namespace rt
