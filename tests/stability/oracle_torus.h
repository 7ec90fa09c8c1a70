#pragma once
#include "stability/oracle.h"

namespace rt::stability {

/// A polynomial, highest coefficient first.
template <class T, std::size_t N>
struct WidePolynomial {
  std::array<T, N> c;

  T operator()(const T& s) const {
    T value = c[0];
    for (std::size_t i = 1; i < N; ++i) {
      value = value * s + c[i];
    }
    return value;
  }
  WidePolynomial<T, N - 1> derivative() const {
    WidePolynomial<T, N - 1> d;
    for (std::size_t i = 0; i + 1 < N; ++i) {
      d.c[i] = T(static_cast<double>(N - 1 - i)) * c[i];
    }
    return d;
  }
};

/// The root in [a, b], f having different signs there: Newton from s, kept in its bracket by
/// bisection. Only f takes all digits. The slope takes a double's: a step is then wrong by some
/// 1e-15 of its length, which the next one puts right.
template <class T, std::size_t N, std::size_t M>
T bracketed_root(const WidePolynomial<T, N>& f, const WidePolynomial<double, M>& slope, bool rising,
                 T a, T b, T s, int most_steps) {
  const double tolerance = resolution<T>();
  for (int i = 0; i < most_steps; ++i) {
    const T value = f(s);
    ((value < T(0.0)) == rising ? a : b) = s;
    const double step = static_cast<double>(value) / slope(static_cast<double>(s));
    const T newton = s - T(step);
    if (newton > a && newton < b) {
      s = newton;
      if (std::abs(step) <= tolerance) {
        return s;
      }
    } else {
      s = T(0.5) * (a + b);
      if (static_cast<double>(b - a) <= tolerance) {
        return s;
      }
    }
  }
  return s;
}

/// The same, from where doubles find it: all but the last few steps need no more digits.
template <class T, std::size_t N>
T bracketed_root(const WidePolynomial<T, N>& f, bool rising, const T& a, const T& b) {
  WidePolynomial<double, N> rough;
  for (std::size_t i = 0; i < N; ++i) {
    rough.c[i] = static_cast<double>(f.c[i]);
  }
  const auto slope = rough.derivative();
  const auto lo = static_cast<double>(a);
  const auto hi = static_cast<double>(b);
  const T near(bracketed_root(rough, slope, rising, lo, hi, 0.5 * (lo + hi), 20));
  return bracketed_root(f, slope, rising, a, b, near > a && near < b ? near : T(0.5) * (a + b),
                        400);
}

/// The sign changes of f between consecutive ends, between which f is monotone.
template <class T, std::size_t N, std::size_t M>
std::array<T, M + 1> roots_between(const WidePolynomial<T, N>& f, const std::array<T, M>& ends,
                                   int used, int& found) {
  std::array<T, M + 1> roots;
  found = 0;
  bool negative = f(ends[0]) < T(0.0);
  for (std::size_t i = 1; i < static_cast<std::size_t>(used); ++i) {
    const bool rising = negative;
    negative = f(ends[i]) < T(0.0);
    if (negative != rising) {
      roots[static_cast<std::size_t>(found++)] = bracketed_root(f, rising, ends[i - 1], ends[i]);
    }
  }
  return roots;
}

/// All crossings of a torus whose tube is `offset` thicker.
template <class T>
Crossings<T> crossings(const Torus& torus, const Line<T>& line, double offset) {
  const T R(torus.major_radius);
  const T r = T(torus.minor_radius) + T(offset);
  const Wide3<T>& o = line.origin;
  const Wide3<T>& d = line.direction;
  const T m = dot(o, o) - R * R - r * r;
  const T R4 = T(4.0) * R * R;
  const WidePolynomial<T, 5> f{{T(1.0), T(0.0), T(2.0) * m + R4 * d.y * d.y,
                                T(2.0) * R4 * o.y * d.y, m * m - R4 * (r * r - o.y * o.y)}};
  const WidePolynomial<T, 4> slope = f.derivative();
  const T reach = T(1.01) * (R + r);
  using std::sqrt;
  std::array<T, 4> turns{-reach, T(0.0), T(0.0), reach};
  int used = 0;
  const T inflection = f.c[2] < T(0.0) ? sqrt(-f.c[2] / T(6.0)) : T(0.0);
  turns[static_cast<std::size_t>(used++)] = -reach;
  if (inflection > T(0.0) && inflection < reach) {
    turns[static_cast<std::size_t>(used++)] = -inflection;
    turns[static_cast<std::size_t>(used++)] = inflection;
  }
  turns[static_cast<std::size_t>(used++)] = reach;
  int found = 0;
  const auto extrema = roots_between(slope, turns, used, found);
  std::array<T, 5> ends;
  used = 0;
  ends[static_cast<std::size_t>(used++)] = -reach;
  for (int i = 0; i < found; ++i) {
    ends[static_cast<std::size_t>(used++)] = extrema[static_cast<std::size_t>(i)];
  }
  ends[static_cast<std::size_t>(used++)] = reach;
  const auto roots = roots_between(f, ends, used, found);
  Crossings<T> out;
  for (int i = 0; i < found; ++i) {
    const T& s = roots[static_cast<std::size_t>(i)];
    const Wide3<T> p = line.at(s);
    const T k = dot(p, p) - R * R - r * r;
    const Wide3<T> gradient{k * p.x, (k + T(2.0) * R * R) * p.y, k * p.z};
    const T size = sqrt(dot(gradient, gradient));
    out.add(s, static_cast<double>(dot(gradient, d)) / static_cast<double>(size));
  }
  return out;
}

}  // namespace rt::stability
