#include "rt/math/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {
namespace {

// x87's 64-bit significand: products of doubles sum with 11 guard bits, so a composed or inverted
// map is as good as its rounding to double.
using Wide = long double;

Wide dot3(double a0, double b0, double a1, double b1, double a2, double b2) {
  return Wide(a0) * b0 + Wide(a1) * b1 + Wide(a2) * b2;
}

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
void exact_cos_sin(double degrees, double& c, double& s) {
  const double turn = std::remainder(degrees, 360.0);  // exact, in [-180, 180]
  const double quarter = std::nearbyint(turn / 90.0);
  const double rest = (turn - 90.0 * quarter) * (std::numbers::pi / 180.0);
  const double cr = std::cos(rest);
  const double sr = std::sin(rest);
  switch ((static_cast<int>(quarter) + 4) % 4) {
    case 0:
      c = cr, s = sr;
      break;
    case 1:
      c = -sr, s = cr;
      break;
    case 2:
      c = -cr, s = -sr;
      break;
    default:
      c = sr, s = -cr;
      break;
  }
}

bool all_finite(const Affine& a) {
  return rt::all_finite(a.linear[0]) && rt::all_finite(a.linear[1]) &&
         rt::all_finite(a.linear[2]) && rt::all_finite(a.offset);
}

}  // namespace

Affine Affine::translation(const Vec3& by) { return {Mat3(1.0), by}; }

Affine Affine::scaling(const Vec3& factors) {
  Affine a;
  for (int i = 0; i < 3; ++i) {
    a.linear[i][i] = factors[i];
  }
  return a;
}

Affine Affine::rotation(int axis, double degrees) {
  double c = 1.0;
  double s = 0.0;
  exact_cos_sin(degrees, c, s);
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Affine a;
  a.linear[i][i] = c;
  a.linear[i][j] = s;  // GLM's matrices are column-major: linear[column][row]
  a.linear[j][i] = -s;
  a.linear[j][j] = c;
  return a;
}

Affine operator*(const Affine& outer, const Affine& inner) {
  Affine a;
  const Mat3& m = outer.linear;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const Vec3& v = inner.linear[column];
      a.linear[column][row] =
          static_cast<double>(dot3(m[0][row], v.x, m[1][row], v.y, m[2][row], v.z));
    }
    const Vec3& o = inner.offset;
    a.offset[row] = static_cast<double>(dot3(m[0][row], o.x, m[1][row], o.y, m[2][row], o.z) +
                                        outer.offset[row]);
  }
  return a;
}

std::optional<Affine> inverse(const Affine& a) {
  if (!all_finite(a)) {
    return std::nullopt;
  }
  Wide m[3][3];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[row][column] = a.linear[column][row];
    }
  }
  Wide cofactor[3][3];
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      cofactor[i][j] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  }
  const Wide det = m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
  if (det == 0) {
    return std::nullopt;
  }
  Affine r;
  for (int row = 0; row < 3; ++row) {
    Wide offset = 0;
    for (int column = 0; column < 3; ++column) {
      const Wide entry = cofactor[column][row] / det;
      r.linear[column][row] = static_cast<double>(entry);
      offset -= entry * a.offset[column];
    }
    r.offset[row] = static_cast<double>(offset);
  }
  if (!all_finite(r)) {
    return std::nullopt;
  }
  return r;
}

double norm(const Mat3& m) {
  double largest = 0.0;
  for (int row = 0; row < 3; ++row) {
    largest = std::max(largest, std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]));
  }
  return largest;
}

}  // namespace rt
