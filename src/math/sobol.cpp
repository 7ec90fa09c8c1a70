#include "rt/math/sobol.h"

#include "rt/math/hash.h"

namespace rt {
namespace {

using Directions = std::array<std::uint32_t, 32>;  ///< bit 0 is worth 1/2

/// The product in the field of four elements {0, 1, w, w+1}, w^2 = w + 1; bit 1 counts w.
constexpr std::uint32_t gf4_product(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t p = (b & 1u ? a : 0u) ^ (b & 2u ? a << 1 : 0u);
  return p & 4u ? p ^ 7u : p;
}

/// One dimension of the (0,4)-sequence in base 4 that Faure's construction gives over that field
/// (Niederreiter, "Point sets and sequences with small discrepancy", Monatsh. Math. 104, 1987): the
/// generator matrix is the power `alpha` of Pascal's, with entries binom(j,i) alpha^(j-i), one for
/// each field element. A base-4 digit is two bits, and an invertible map of a digit's bits changes
/// nothing in base 4; adding the second to the first (`mixed`) in one of two dimensions makes these
/// two a (0,2)-sequence in base 2, which is more. That such pairs exist is due to Ahmed et al., "SZ
/// sequences: binary-based (0,2^q)-sequences"; these were found by trying, and are verified by
/// test.
constexpr Directions base4(std::uint32_t alpha, bool mixed) {
  Directions v{};
  for (unsigned k = 0; k < 32; ++k) {
    const unsigned j = k / 2;
    std::uint32_t digit = 1u << (k % 2);
    for (unsigned i = j + 1; i-- > 0; digit = gf4_product(digit, alpha)) {
      if ((i & j) == i) {  // binom(j, i) is odd (Lucas)
        v[k] |= (mixed ? digit ^ (digit >> 1) : digit) << (2 * i);
      }
    }
  }
  return v;
}

/// A primitive polynomial over GF(2) and the initial direction numbers m_1..m_degree.
struct Row {
  unsigned degree;
  unsigned a;  ///< the polynomial's inner coefficients, highest power first
  std::array<std::uint32_t, 5> m;
};

/// Sobol's recurrence (Bratley and Fox, ACM TOMS 14(1), 1988) for the direction numbers v_k, scaled
/// by 2^32: v_k = a_1 v_{k-1} ^ ... ^ a_{s-1} v_{k-s+1} ^ v_{k-s} ^ (v_{k-s} >> s).
constexpr Directions joe_kuo(const Row& row) {
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
  for (std::uint32_t& x : v) {
    x = reverse_bits(x);
  }
  return v;
}

// The rows are facts from new-joe-kuo-6.21201: Joe and Kuo, "Constructing Sobol sequences with
// better two-dimensional projections", SIAM J. Sci. Comput. 30 (2008).
constexpr std::array<Directions, sobol_dimensions> all_directions{
    base4(0, false),
    base4(1, true),
    base4(2, false),
    base4(3, true),
    joe_kuo({3, 1, {1, 3, 1}}),          // d = 4
    joe_kuo({4, 4, {1, 3, 5, 13}}),      // d = 7
    joe_kuo({5, 4, {1, 1, 5, 5, 5}}),    // d = 9
    joe_kuo({5, 13, {1, 1, 1, 3, 11}}),  // d = 12
    joe_kuo({5, 14, {1, 3, 5, 5, 31}})   // d = 13
};

constexpr SobolTable make_table() {
  SobolTable table{};
  for (unsigned d = 0; d < sobol_dimensions; ++d) {
    const Directions& v = all_directions[d];
    for (unsigned nibble = 0; nibble < 8; ++nibble) {
      for (unsigned value = 0; value < 16; ++value) {
        std::uint32_t x = 0;
        for (unsigned bit = 0; bit < 4; ++bit) {
          x ^= (value >> bit) & 1u ? v[4 * nibble + bit] : 0u;
        }
        table[d][nibble][value] = x;
      }
    }
  }
  return table;
}

}  // namespace

constinit const SobolTable sobol_table = make_table();

}  // namespace rt
