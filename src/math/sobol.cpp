#include "rt/math/sobol.h"

#include "rt/math/hash.h"

namespace rt {
namespace {

/// A primitive polynomial over GF(2) and the initial direction numbers m_1..m_degree.
struct Row {
  unsigned degree;
  unsigned a;  ///< the polynomial's inner coefficients, highest power first
  std::array<std::uint32_t, 6> m;
};

// Facts from new-joe-kuo-6.21201, rows d = 2..15: Joe and Kuo, "Constructing Sobol sequences with
// better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008).
constexpr std::array<Row, sobol_dimensions - 1> rows{{{1, 0, {1}},
                                                      {2, 1, {1, 3}},
                                                      {3, 1, {1, 3, 1}},
                                                      {3, 2, {1, 1, 1}},
                                                      {4, 1, {1, 1, 3, 3}},
                                                      {4, 4, {1, 3, 5, 13}},
                                                      {5, 2, {1, 1, 5, 5, 17}},
                                                      {5, 4, {1, 1, 5, 5, 5}},
                                                      {5, 7, {1, 1, 7, 11, 19}},
                                                      {5, 11, {1, 1, 5, 1, 1}},
                                                      {5, 13, {1, 1, 1, 3, 11}},
                                                      {5, 14, {1, 3, 5, 5, 31}},
                                                      {6, 1, {1, 3, 3, 9, 7, 49}},
                                                      {6, 13, {1, 1, 1, 15, 21, 21}}}};

using Directions = std::array<std::uint32_t, 32>;

constexpr Directions van_der_corput() {
  Directions v{};
  for (unsigned k = 0; k < 32; ++k) {
    v[k] = 1u << (31 - k);
  }
  return v;
}

/// Sobol's recurrence (Bratley and Fox, ACM TOMS 14(1), 1988) for the direction numbers v_k, scaled
/// by 2^32: v_k = a_1 v_{k-1} ^ ... ^ a_{s-1} v_{k-s+1} ^ v_{k-s} ^ (v_{k-s} >> s).
constexpr Directions directions(const Row& row) {
  const unsigned s = row.degree;
  Directions v{};
  for (unsigned k = 0; k < 32; ++k) {
    if (k < s) {
      v[k] = row.m[k] << (31 - k);
      continue;
    }
    v[k] = v[k - s] ^ (v[k - s] >> s);
    for (unsigned i = 1; i < s; ++i) {
      if ((row.a >> (s - 1 - i)) & 1u) {
        v[k] ^= v[k - i];
      }
    }
  }
  return v;
}

constexpr SobolTable make_table() {
  SobolTable table{};
  for (unsigned d = 0; d < sobol_dimensions; ++d) {
    const Directions v = d == 0 ? van_der_corput() : directions(rows[d - 1]);
    for (unsigned nibble = 0; nibble < 8; ++nibble) {
      for (unsigned value = 0; value < 16; ++value) {
        std::uint32_t x = 0;
        for (unsigned bit = 0; bit < 4; ++bit) {
          x ^= (value >> bit) & 1u ? v[4 * nibble + bit] : 0u;
        }
        table[d][nibble][value] = reverse_bits(x);
      }
    }
  }
  return table;
}

}  // namespace

constinit const SobolTable sobol_table = make_table();

}  // namespace rt
