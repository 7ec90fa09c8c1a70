#pragma once
#include <cmath>

#include "rt/geometry/exact.h"

namespace rt {

/// About 31 decimal digits: the unevaluated sum of two doubles (Dekker 1971; the sum as in Li et
/// al. 2002, "accurate" variant, the quotient by three steps of long division). Some twenty times
/// slower than a double: for decisions that rounding would otherwise take.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  DoubleDouble(double value) : high_(value) {}
  explicit operator double() const { return high_; }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high_, -a.low_}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoublePair high = exact_difference(a.high_, -b.high_);
    const DoublePair low = exact_difference(a.low_, -b.low_);
    const DoubleDouble sum = normalised(high.high, high.low + low.high);
    return normalised(sum.high_, sum.low_ + low.low);
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoublePair p = exact_product(a.high_, b.high_);
    return normalised(p.high, p.low + (a.high_ * b.low_ + a.low_ * b.high_));
  }
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high_ / b.high_;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high_ / b.high_;
    const DoubleDouble last = rest - b * DoubleDouble(second);
    return normalised(first, second) + DoubleDouble(last.high_ / b.high_);
  }
  DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }

  friend DoubleDouble sqrt(const DoubleDouble& a) {
    if (!(a.high_ > 0)) {
      return {std::sqrt(a.high_)};
    }
    const double root = std::sqrt(a.high_);
    const DoubleDouble rest = a - DoubleDouble(root) * DoubleDouble(root);
    return DoubleDouble(root) + DoubleDouble(rest.high_ / (2 * root));
  }

  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
  friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) { return !(b < a); }
  friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return !(a < b); }

 private:
  DoubleDouble(double high, double low) : high_(high), low_(low) {}
  static DoubleDouble normalised(double high, double low) {
    const double sum = high + low;
    return {sum, low - (sum - high)};
  }

  double high_ = 0;
  double low_ = 0;
};

}  // namespace rt
