#pragma once
#include "torus_form.h"

namespace rt {

/// The next hit of a ray that starts on the torus and leaves it to a side.
OptionalHit leave_torus(const Torus& torus, const Ray& ray, double t_max, Leaving side);

/// The side to which a ray leaves whose origin lies on the torus within `error`; nothing if it does
/// not.
Leaving coincidence(const Torus& torus, const Ray& ray, double error);

}  // namespace rt
