#include "rt/math/filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rt/math/warp.h"
#include "rt/math/wide_functions.h"

namespace rt {
namespace {

constexpr double sigma = 0.5;
constexpr double gaussian_radius = 1.5;
constexpr double harris_radius = 1.5;
/// Harris, table I: minimum 4-term window, -92 dB.
constexpr double harris[] = {0.35875, 0.48829, 0.14128, 0.01168};

double gaussian_mass() {
  return -std::expm1(-gaussian_radius * gaussian_radius / (2.0 * sigma * sigma));
}

// The inverse of the tent's cumulative mass (1+x)^2/2 on the left, mirrored on the right.
double tent_offset(double u) {
  return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 * (1.0 - u));
}

// -log(1 - q) for q in [0, 0.99]. With 1 - q = 2^-k m, m in (1/2, 1], it is k log 2 + 2 artanh(f),
// f = (1 - m)/(1 + m) < 1/3: fourteen terms of its series leave less than 2^-49 of it. For k = 0, f
// = q/(2 - q) keeps the digits of a small q. The library's function would do but for its last bit,
// which differs between its versions, and for its being one at a time.
template <class Real>
Real minus_log1m(const Real& q) {
  using std::fma;
  Real m = 1.0 - q;
  Real sum = 0.0;
  for (int k = 0; k < 6; ++k) {  // 1 - q > 2^-7
    const auto low = m <= 0.5;
    m = select(low, 2.0 * m, m);
    sum = select(low, sum + std::numbers::ln2, sum);
  }
  const Real f = select(sum == 0.0, q / (2.0 - q), (1.0 - m) / (1.0 + m));
  const Real f2 = f * f;
  Real series = 1.0 / 27.0;
  for (int n = 25; n >= 1; n -= 2) {
    series = fma(series, f2, Real(1.0 / n));
  }
  return sum + 2.0 * f * series;
}

// The mass within r is 1 - exp(-r^2 / 2 sigma^2), uniform for a random point, and r^2 of a uniform
// disc point is uniform too: map radius to radius, keep the angle. This is the factor.
template <class Real>
Real gaussian_stretch(const Real& r2) {
  using std::sqrt;
  static const double mass = gaussian_mass();
  return select(r2 == 0.0, Real(0.0), sigma * sqrt(2.0 * minus_log1m(Real(r2 * mass)) / r2));
}

Vec2 gaussian_offset(const Vec2& u) {
  const Vec2 d = to_disc(u);
  return d * gaussian_stretch(glm::dot(d, d));
}

struct Harris {
  double density;
  double mass;  ///< between the centre and x
};

/// The window and its integral; multiple angles by the addition theorems.
Harris harris_at(double x) {
  const double phase = pi * x / harris_radius;
  const double c1 = std::cos(phase);
  const double s1 = std::sin(phase);
  const double c2 = 1.0 - 2.0 * s1 * s1;
  const double s2 = 2.0 * s1 * c1;
  const double c3 = c1 * (4.0 * c1 * c1 - 3.0);
  const double s3 = s1 * (3.0 - 4.0 * s1 * s1);
  const double density = harris[0] + harris[1] * c1 + harris[2] * c2 + harris[3] * c3;
  const double mass =
      harris[0] * phase + harris[1] * s1 + harris[2] / 2.0 * s2 + harris[3] / 3.0 * s3;
  return {density / (2.0 * harris_radius * harris[0]), mass / (2.0 * pi * harris[0])};
}

double harris_density(double x) { return harris_at(x).density; }

/// Where the mass from the centre on is `mass`, between lo and hi: Newton's steps from x on, and
/// bisection where one would leave the bracket.
double harris_quantile(double mass, double lo, double hi, double x) {
  for (;;) {
    const Harris here = harris_at(x);
    const double excess = here.mass - mass;
    (excess > 0.0 ? hi : lo) = x;
    double next = x - excess / here.density;
    if (!(next >= lo && next <= hi)) {
      next = 0.5 * (lo + hi);
    }
    // After Newton's step of 1e-6 the error is of the order of its square; a bisection that small
    // is in the flat tail, and near enough to the truth for any picture.
    if (std::abs(next - x) <= 1e-6 * harris_radius) {
      return next;
    }
    x = next;
  }
}

/// Quantiles of the right half, at even masses. They bracket the answer, and a straight line
/// between them starts so near that one or two steps do.
constexpr int harris_nodes = 256;
std::array<double, harris_nodes + 1> harris_table() {
  std::array<double, harris_nodes + 1> table{};
  for (std::size_t i = 1; i < harris_nodes; ++i) {
    table[i] =
        harris_quantile(0.5 * static_cast<double>(i) / harris_nodes, 0.0, harris_radius, 0.5);
  }
  table[harris_nodes] = harris_radius;
  return table;
}

double harris_offset(double u) {
  static const std::array<double, harris_nodes + 1> table = harris_table();
  const double mass = std::abs(u - 0.5);
  const double position = 2.0 * harris_nodes * mass;
  const auto node = std::min(static_cast<std::size_t>(position), std::size_t{harris_nodes - 1});
  const double lo = table[node];
  const double hi = table[node + 1];
  const double start = lo + (position - static_cast<double>(node)) * (hi - lo);
  return std::copysign(harris_quantile(mass, lo, hi, start), u - 0.5);
}

}  // namespace

Vec2 filter_offset(Filter filter, const Vec2& u) {
  switch (filter) {
    case Filter::box:
      return u - 0.5;
    case Filter::tent:
      return {tent_offset(u.x), tent_offset(u.y)};
    case Filter::gaussian:
      return gaussian_offset(u);
    case Filter::blackman_harris:
      break;
  }
  return {harris_offset(u.x), harris_offset(u.y)};
}

Wide2 filter_offset(Filter filter, const Wide2& u) {
  if (filter == Filter::gaussian) {
    const Wide2 d = to_disc(u);
    const Wide stretch = gaussian_stretch(Wide(d.x * d.x + d.y * d.y));
    return {d.x * stretch, d.y * stretch};
  }
  Wide2 out;
  for (int i = 0; i < lanes; ++i) {
    const Vec2 one = filter_offset(filter, u.lane(i));
    out.x[static_cast<std::size_t>(i)] = one.x;
    out.y[static_cast<std::size_t>(i)] = one.y;
  }
  return out;
}

double filter_density(Filter filter, const Vec2& offset) {
  const double r2 = glm::dot(offset, offset);
  if (std::max(std::abs(offset.x), std::abs(offset.y)) > filter_radius(filter)) {
    return 0.0;
  }
  switch (filter) {
    case Filter::box:
      return 1.0;
    case Filter::tent:
      return (1.0 - std::abs(offset.x)) * (1.0 - std::abs(offset.y));
    case Filter::gaussian:
      return r2 > gaussian_radius * gaussian_radius
                 ? 0.0
                 : std::exp(-r2 / (2.0 * sigma * sigma)) /
                       (2.0 * pi * sigma * sigma * gaussian_mass());
    case Filter::blackman_harris:
      break;
  }
  return harris_density(offset.x) * harris_density(offset.y);
}

double filter_radius(Filter filter) {
  switch (filter) {
    case Filter::box:
      return 0.5;
    case Filter::tent:
      return 1.0;
    case Filter::gaussian:
      return gaussian_radius;
    case Filter::blackman_harris:
      break;
  }
  return harris_radius;
}

}  // namespace rt
