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

/// The root in [a, b], f having different signs there: Newton, kept in its bracket by bisection.
template <class T, std::size_t N>
T bracketed_root(const WidePolynomial<T, N>& f, T a, T b) {
  const WidePolynomial<T, N - 1> slope = f.derivative();
  const bool rising = f(a) < T(0.0);
  const T tolerance(resolution<T>());
  T s = T(0.5) * (a + b);
  for (int i = 0; i < 400; ++i) {
    const T value = f(s);
    ((value < T(0.0)) == rising ? a : b) = s;
    const T newton = s - value / slope(s);
    const bool inside = newton > a && newton < b;
    const T next = inside ? newton : T(0.5) * (a + b);
    const T step = next > s ? next - s : s - next;
    s = next;
    if (step <= tolerance) {
      return s;
    }
  }
  return s;
}

/// The sign changes of f between consecutive ends, between which f is monotone.
template <class T, std::size_t N, std::size_t M>
std::array<T, M + 1> roots_between(const WidePolynomial<T, N>& f, const std::array<T, M>& ends,
                                   int used, int& found) {
  std::array<T, M + 1> roots;
  found = 0;
  for (int i = 0; i + 1 < used; ++i) {
    const T& a = ends[static_cast<std::size_t>(i)];
    const T& b = ends[static_cast<std::size_t>(i) + 1];
    if ((f(a) < T(0.0)) != (f(b) < T(0.0))) {
      roots[static_cast<std::size_t>(found++)] = bracketed_root(f, a, b);
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
