// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/feature_size.h"

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"

namespace libstyle {
namespace {

constexpr double kShareKept = 0.1;       // of the extra length
constexpr double kClearlyLonger = 1.05;  // below, the filtered length says little about the style
constexpr double kLeastExtra = 1e-5;     // of the length: a straight line has no features to find
constexpr int kBisections = 24;          // a part in 10^7

double blurred_length(std::span<const Polyline> curves, double sigma) {
  double sum = 0;
  for (const Polyline& curve : curves) sum += arc_length(gaussian_blur(curve, sigma));
  return sum;
}

double plain_length(std::span<const Polyline> filtered, double filtered_length) {
  double sum = 0;
  for (const Polyline& curve : filtered) {
    sum += arc_length(gaussian_blur(curve, arc_length(curve) / 8));
  }
  return sum < filtered_length ? sum : filtered_length;
}

}  // namespace

double find_feature_size(std::span<const Polyline> filtered,
                         std::optional<double> unfiltered_length) {
  const double filtered_length = blurred_length(filtered, 0);
  const bool usable = unfiltered_length && filtered_length >= kClearlyLonger * *unfiltered_length;
  const double plain = usable ? *unfiltered_length : plain_length(filtered, filtered_length);
  const double target = plain + kShareKept * (filtered_length - plain);
  double low = filtered_length / 600, high = filtered_length / 12;
  if (filtered_length - plain < kLeastExtra * filtered_length) return high;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    (blurred_length(filtered, middle) > target ? low : high) = middle;
  }
  return high;
}

}  // namespace libstyle
