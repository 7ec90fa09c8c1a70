#pragma once
/// Functions of fresnel.h, warp.h and filter.h for several arguments at a time: lane by lane the
/// same results, bit for bit.
#include "rt/math/filter.h"
#include "rt/math/wide.h"

namespace rt {

Wide fresnel(const Wide& cos_i, const Wide& n1, const Wide& n2);

inline Wide3 reflect(const Wide3& d, const Wide3& n) { return d - 2.0 * dot(d, n) * n; }

/// `through`: the lanes where not all is reflected; the others hold nothing.
Wide3 refract(const Wide3& d, const Wide3& n, const Wide& n1, const Wide& n2, WideMask& through);

Wide2 to_disc(const Wide2& u);

Wide2 filter_offset(Filter filter, const Wide2& u);

}  // namespace rt
