#pragma once
#include <limits>

#include "stability/oracle.h"

namespace rt::stability {

/// The chord of a line in a convex solid, cut down constraint by constraint.
template <class T>
struct WideChord {
  T in{-1e300}, out{1e300};
  double cosine_in = 0, cosine_out = 0;
  bool empty = false;

  void clip(const T& a, double cosine_a, const T& b, double cosine_b) {
    if (a > in) {
      in = a;
      cosine_in = cosine_a;
    }
    if (b < out) {
      out = b;
      cosine_out = cosine_b;
    }
  }
  void slab(const T& o, const T& d, const T& lo, const T& hi) {
    const auto cosine = static_cast<double>(d);
    if (d > T(0.0)) {
      clip((lo - o) / d, cosine, (hi - o) / d, cosine);
    } else if (d < T(0.0)) {
      clip((hi - o) / d, cosine, (lo - o) / d, cosine);
    } else if (o < lo || o > hi) {
      empty = true;
    }
  }
  bool none() const { return empty || out < in; }
  Crossings<T> crossings() const {
    Crossings<T> c;
    if (!none()) {
      c.add(in, cosine_in);
      c.add(out, cosine_out);
    }
    return c;
  }
};

/// q.x^2 terms chosen by `use_y`: the ball, or the infinite cylinder about the y axis.
template <class T>
void clip_round(WideChord<T>& chord, const Line<T>& line, const T& radius, bool use_y) {
  Wide3<T> o = line.origin;
  Wide3<T> d = line.direction;
  if (!use_y) {
    o.y = d.y = T(0.0);
  }
  const T a = dot(d, d);
  const T b = dot(o, d);
  const T c = dot(o, o) - radius * radius;
  if (!(a > T(0.0))) {
    chord.empty = chord.empty || c > T(0.0);
    return;
  }
  const T discriminant = b * b - a * c;
  if (discriminant < T(0.0)) {
    chord.empty = true;
    return;
  }
  using std::sqrt;
  const T root = sqrt(discriminant);
  const double cosine = static_cast<double>(root) / static_cast<double>(radius);
  chord.clip((-b - root) / a, cosine, (-b + root) / a, cosine);
}

template <class T>
Crossings<T> crossings(const Sphere& sphere, const Line<T>& line, double offset) {
  WideChord<T> chord;
  clip_round(chord, line, T(sphere.radius) + T(offset), true);
  return chord.crossings();
}

template <class T>
Crossings<T> crossings(const Box& box, const Line<T>& line, double offset) {
  WideChord<T> chord;
  for (int i = 0; i < 3; ++i) {
    chord.slab(line.origin[i], line.direction[i], T(box.lo[i]) - T(offset),
               T(box.hi[i]) + T(offset));
  }
  return chord.crossings();
}

template <class T>
Crossings<T> crossings(const Cylinder&, const Line<T>& line, double offset) {
  WideChord<T> chord;
  clip_round(chord, line, T(1.0) + T(offset), false);
  chord.slab(line.origin.y, line.direction.y, -T(offset), T(1.0) + T(offset));
  return chord.crossings();
}

/// The nappe of a cone below its apex, which falls by `steepness` for each unit that it widens,
/// moved outward by `offset` along its normals.
template <class T>
void clip_cone(WideChord<T>& chord, const Line<T>& line, const T& apex_height, double steepness,
               double offset) {
  using std::sqrt;
  const T length = sqrt(T(steepness * steepness + 1));  // the normal's y is 1 / length
  const T apex = apex_height + T(offset) * length;
  const Wide3<T>& o = line.origin;
  const Wide3<T>& d = line.direction;
  const T width = (apex - o.y) / T(steepness);
  const T growth = -d.y / T(steepness);
  const T a = d.x * d.x + d.z * d.z - growth * growth;
  const T b = o.x * d.x + o.z * d.z - width * growth;
  const T c = o.x * o.x + o.z * o.z - width * width;
  const T discriminant = b * b - a * c;
  if (discriminant < T(0.0)) {
    chord.empty = true;
    return;
  }
  const T root = sqrt(discriminant);
  const T sum = b > T(0.0) ? -b - root : root - b;
  const T first = sum / a;
  const T second = c / sum;
  const T lo = first < second ? first : second;
  const T hi = first < second ? second : first;
  // Half the gradient's length is width * length / steepness.
  const auto cosine = [&](const T& s) {
    return static_cast<double>(root) * steepness /
           (std::abs(static_cast<double>(width + s * growth)) * static_cast<double>(length));
  };
  const T far(1e290);
  if (a > T(0.0)) {
    chord.empty = chord.empty || o.y + second * d.y > apex;
    chord.clip(lo, cosine(lo), hi, cosine(hi));
  } else if (d.y < T(0.0)) {
    chord.clip(hi, cosine(hi), far, 0);
  } else {
    chord.clip(-far, 0, lo, cosine(lo));
  }
}

template <class T>
Crossings<T> crossings(const PointedCone&, const Line<T>& line, double offset) {
  WideChord<T> chord;
  clip_cone(chord, line, T(1.0), 1, offset);
  chord.slab(line.origin.y, line.direction.y, -T(offset), T(2.0));
  return chord.crossings();
}

/// The chord of two parts that join at a plane across the y axis.
template <class T>
WideChord<T> joined(const WideChord<T>& first, const WideChord<T>& second) {
  if (first.none() || second.none()) {
    return first.none() ? second : first;
  }
  WideChord<T> both = first;
  both.out = second.out;
  both.cosine_out = second.cosine_out;
  return both;
}

template <class T>
Crossings<T> crossings(const Capsule& capsule, const Line<T>& line, double offset) {
  const T radius = T(capsule.radius) + T(offset);
  const T length(capsule.length);
  const T far(1e290);
  const T& oy = line.origin.y;
  const T& dy = line.direction.y;
  WideChord<T> lower;
  clip_round(lower, line, radius, true);
  lower.slab(oy, dy, -far, T(0.0));
  WideChord<T> body;
  clip_round(body, line, radius, false);
  body.slab(oy, dy, T(0.0), length);
  Line<T> from_upper = line;
  from_upper.origin.y = oy - length;
  WideChord<T> upper;
  clip_round(upper, from_upper, radius, true);
  upper.slab(oy, dy, length, far);
  return (dy > T(0.0) ? joined(joined(lower, body), upper) : joined(joined(upper, body), lower))
      .crossings();
}

template <class T>
Crossings<T> crossings(const Blob&, const Line<T>& line, double offset) {
  using std::sqrt;
  const T& oy = line.origin.y;
  const T& dy = line.direction.y;
  const T join = (T(1.0) + T(offset)) / sqrt(T(26.0));
  WideChord<T> head;
  clip_round(head, line, T(1.0) + T(offset), true);
  head.slab(oy, dy, join, T(2.0));
  WideChord<T> body;
  clip_cone(body, line, sqrt(T(26.0)), 5, offset);
  body.slab(oy, dy, T(-1.0) - T(offset), join);
  return (dy > T(0.0) ? joined(body, head) : joined(head, body)).crossings();
}

}  // namespace rt::stability
