// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace libstyle {
namespace {

int sign(double value) { return (value > 0) - (value < 0); }

// A number and the rounding error that it leaves: value + error is exact.
struct Rounded {
  double value, error;
};

// Knuth.
Rounded exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// Dekker: halves of 26 bits multiply without error.
Rounded halves(double a) {
  const double scaled = 134217729.0 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

Rounded exact_product(double a, double b) {
  const double product = a * b;
  const auto [a_high, a_low] = halves(a);
  const auto [b_high, b_low] = halves(b);
  return {product,
          a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

// A sum kept without error as parts that do not overlap, smallest first (Shewchuk's
// GROW-EXPANSION): the last part that is not zero has the sign of the whole.
class ExactSum {
 public:
  void add(double term) {
    for (std::size_t i = 0; i < size_; ++i) {
      const auto [sum, error] = exact_sum(term, parts_[i]);
      parts_[i] = error;
      term = sum;
    }
    parts_[size_++] = term;
  }

  void add_product(double a, double b) {
    const auto [product, error] = exact_product(a, b);
    add(error);
    add(product);
  }

  int sign_of_sum() const {
    for (std::size_t i = size_; i > 0; --i) {
      if (parts_[i - 1] != 0) return sign(parts_[i - 1]);
    }
    return 0;
  }

 private:
  std::array<double, 12> parts_{};
  std::size_t size_ = 0;
};

int exact_orientation(Point a, Point b, Point c) {
  ExactSum sum;
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign_of_sum();
}

}  // namespace

int orientation(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  // Shewchuk's bound for ORIENT2D, (3 + 16 eps) eps with eps = 2^-53.
  constexpr double kEpsilon = 1.0 / 9007199254740992.0;
  constexpr double kErrorBound = (3 + 16 * kEpsilon) * kEpsilon;
  if (std::abs(determinant) > kErrorBound * (std::abs(left) + std::abs(right))) {
    return sign(determinant);
  }
  return exact_orientation(a, b, c);
}

}  // namespace libstyle
