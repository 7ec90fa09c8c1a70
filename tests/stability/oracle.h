#pragma once
/// What a ray meets, computed with as many digits as the number type T has and no tricks: every
/// double of ray and shape is taken as exact.
#include <array>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <optional>

#include "rt/geometry/double_double.h"
#include "rt/geometry/shape.h"

namespace rt::stability {

using Decimal = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                              boost::multiprecision::et_off>;

/// The distance to which a root is refined, with lengths of the order of one.
template <class T>
double resolution();
template <>
inline double resolution<double>() {
  return 1e-15;
}
template <>
inline double resolution<DoubleDouble>() {
  return 1e-29;
}
template <>
inline double resolution<Decimal>() {
  return 1e-46;
}

template <class T>
struct Wide3 {
  T x{0.0}, y{0.0}, z{0.0};
  T& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
  const T& operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
  friend Wide3 operator+(const Wide3& a, const Wide3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Wide3 operator-(const Wide3& a, const Wide3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Wide3 operator*(const T& s, const Wide3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class T>
T dot(const Wide3<T>& a, const Wide3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Wide3<T> cross(const Wide3<T>& a, const Wide3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
Wide3<T> widened(const Vec3& v) {
  return {T(v.x), T(v.y), T(v.z)};
}

/// A line from its point nearest to `about`, by arc length s: t = shift + s / length.
template <class T>
struct Line {
  Wide3<T> origin, direction;
  T shift, length, begin;  ///< begin: s of the ray's own origin

  Line(const Ray& ray, const Vec3& about) {
    const Wide3<T> o = widened<T>(ray.origin) - widened<T>(about);
    const Wide3<T> d = widened<T>(ray.direction);
    using std::sqrt;
    length = sqrt(dot(d, d));
    shift = -dot(o, d) / dot(d, d);
    origin = o + shift * d;
    direction = (T(1.0) / length) * d;
    begin = -shift * length;
  }
  T parameter(const T& s) const { return shift + s / length; }
  Wide3<T> at(const T& s) const { return origin + s * direction; }
};

/// The crossings of a line, in order, with the cosine of ray and normal at each.
template <class T>
struct Crossings {
  std::array<T, 4> s;
  std::array<double, 4> cosine;
  int count = 0;

  void add(const T& at, double c) {
    s[static_cast<std::size_t>(count)] = at;
    cosine[static_cast<std::size_t>(count)] = c;
    ++count;
  }
};

/// The first crossing with t > 0, and the one after it.
template <class T>
struct First {
  T t;
  std::optional<T> next;
  double cosine;
};

template <class T>
std::optional<First<T>> first_of(const Line<T>& line, const Crossings<T>& c) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
    if (c.s[i] > line.begin) {
      First<T> first{line.parameter(c.s[i]), {}, c.cosine[i]};
      if (i + 1 < static_cast<std::size_t>(c.count)) {
        first.next = line.parameter(c.s[i + 1]);
      }
      return first;
    }
  }
  return {};
}

}  // namespace rt::stability
