#include "rt/math/noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "rt/math/hash.h"

namespace rt {
namespace {

// A fact: the permutation of Perlin's reference implementation (mrl.nyu.edu/~perlin/noise, 2002).
constexpr std::array<std::uint8_t, 256> perlin_permutation{
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

struct Direction {
  double x, y, z;
};

/// The edges of a cube from its centre; the last four repeat some, which makes a power of two.
constexpr Direction directions[16] = {
    {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1}};

/// 6t^5 - 15t^4 + 10t^3: 0 and 1 at the ends with first and second derivatives 0, hence continuity
/// across cells.
double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
double fade_slope(double t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); }

double mix(double t, double a, double b) { return a + t * (b - a); }

/// A coordinate's cell number modulo 256 and the position within the cell. Each step is exact:
/// scaling by powers of two, floor, and the difference of a double and a floor of it.
unsigned wrap(double x, double& fraction) {
  const double cell = std::floor(x);
  fraction = x - cell;
  return static_cast<unsigned>(cell - 256.0 * std::floor(cell * (1.0 / 256.0)));
}

double ramp(const Direction& g, double x, double y, double z) {
  return g.x * x + g.y * y + g.z * z;
}

/// Any infinity, NaN or overflow of the sum; where the sum overflows all points are lattice points.
bool beyond_reach(const Vec3& p) { return !std::isfinite(p.x + p.y + p.z); }

}  // namespace

/// The gradients of a cell's corners (bit 0: x, bit 1: y, bit 2: z) and the position within.
struct Noise::Cell {
  const Direction* corner[8];
  double x, y, z;
  double ramps[8];
};

Noise::Noise(std::uint64_t seed) {
  std::array<std::uint8_t, 256> table = perlin_permutation;
  if (seed != 0) {
    std::iota(table.begin(), table.end(), std::uint8_t{0});
    for (std::uint64_t i = 255; i > 0; --i) {  // Fisher and Yates
      std::swap(table[i], table[(combine(seed, i) >> 32) * (i + 1) >> 32]);
    }
  }
  for (std::size_t i = 0; i < perm_.size(); ++i) {
    perm_[i] = table[i % 256];
  }
}

inline Noise::Cell Noise::cell_of(const Vec3& p) const {
  Cell c;
  const unsigned i = wrap(p.x, c.x);
  const unsigned j = wrap(p.y, c.y);
  const unsigned k = wrap(p.z, c.z);
  const unsigned a = perm_[i] + j;
  const unsigned b = perm_[i + 1] + j;
  const unsigned columns[4] = {perm_[a] + k, perm_[b] + k, perm_[a + 1] + k, perm_[b + 1] + k};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Direction& g = directions[perm_[columns[corner & 3u] + (corner >> 2)] & 15u];
    c.corner[corner] = &g;
    c.ramps[corner] = ramp(g, c.x - (corner & 1u), c.y - ((corner >> 1) & 1u), c.z - (corner >> 2));
  }
  return c;
}

double Noise::value(const Vec3& p) const {
  if (beyond_reach(p)) {
    return 0.0;
  }
  const Cell c = cell_of(p);
  const double u = fade(c.x);
  const double v = fade(c.y);
  const double* r = c.ramps;
  const double low = mix(v, mix(u, r[0], r[1]), mix(u, r[2], r[3]));
  const double high = mix(v, mix(u, r[4], r[5]), mix(u, r[6], r[7]));
  return std::clamp(mix(fade(c.z), low, high), -1.0, 1.0);
}

// value = sum over corners of weight * ramp, so its derivative is the interpolated gradient plus,
// along each axis, the fade's slope times the difference of the two faces' interpolated ramps.
NoiseSample Noise::sample(const Vec3& p) const {
  if (beyond_reach(p)) {
    return {0.0, Vec3(0.0)};
  }
  const Cell c = cell_of(p);
  const double u = fade(c.x);
  const double v = fade(c.y);
  const double w = fade(c.z);
  const double* r = c.ramps;
  const double x00 = mix(u, r[0], r[1]);
  const double x10 = mix(u, r[2], r[3]);
  const double x01 = mix(u, r[4], r[5]);
  const double x11 = mix(u, r[6], r[7]);
  const double low = mix(v, x00, x10);
  const double high = mix(v, x01, x11);
  const auto across = [&](auto component) {
    return mix(w, mix(v, mix(u, component(0), component(1)), mix(u, component(2), component(3))),
               mix(v, mix(u, component(4), component(5)), mix(u, component(6), component(7))));
  };
  Vec3 gradient{across([&](int i) { return c.corner[i]->x; }),
                across([&](int i) { return c.corner[i]->y; }),
                across([&](int i) { return c.corner[i]->z; })};
  gradient.x +=
      fade_slope(c.x) * mix(w, mix(v, r[1] - r[0], r[3] - r[2]), mix(v, r[5] - r[4], r[7] - r[6]));
  gradient.y += fade_slope(c.y) * mix(w, x10 - x00, x11 - x01);
  gradient.z += fade_slope(c.z) * (high - low);
  const double value = mix(w, low, high);
  if (std::abs(value) > 1.0) {
    return {std::copysign(1.0, value), Vec3(0.0)};
  }
  return {value, gradient};
}

}  // namespace rt
