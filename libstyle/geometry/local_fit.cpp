// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/local_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace libstyle {
namespace {

constexpr int kMaxTerms = 4;

// How much the residual may grow with the window before it is the curve that bends, not noise.
constexpr double kNoiseGrowth = 1.2;

struct Window {
  std::size_t first, last;  // samples, inclusive
  std::size_t size() const { return last - first + 1; }
};

struct PolynomialFit {
  LocalFit at_sample;
  double deviation;  // root mean square residual, corrected for the terms fitted
};

// At least two samples on either side, as far as there are, and all within `reach`.
Window window_within(std::span<const ArcSample> samples, std::size_t at, double reach) {
  Window window{at >= 2 ? at - 2 : 0, std::min(at + 2, samples.size() - 1)};
  const double low = samples[at].length - reach, high = samples[at].length + reach;
  while (window.first > 0 && samples[window.first - 1].length >= low) --window.first;
  while (window.last + 1 < samples.size() && samples[window.last + 1].length <= high) ++window.last;
  return window;
}

int term_count(std::size_t samples) {
  if (samples >= 6) return kMaxTerms;
  return samples >= 3 ? 3 : 2;
}

// Sums over a window of w u^k, and of w u^k times the offset from the sample it is about, for
// u = (length - origin) / scale.
struct Moments {
  double powers[2 * kMaxTerms - 1] = {};
  Vector offsets[kMaxTerms];
  double squares = 0;  // of the offsets' lengths
};

Moments sum_moments(std::span<const ArcSample> window, const ArcSample& origin, double scale) {
  Moments sums;
  for (const ArcSample& sample : window) {
    const double u = (sample.length - origin.length) / scale;
    const Vector offset = sample.position - origin.position;
    double power = sample.weight;
    for (int k = 0; k < kMaxTerms; ++k, power *= u) {
      sums.powers[k] += power;
      sums.offsets[k] += power * offset;
    }
    for (int k = kMaxTerms; k < 2 * kMaxTerms - 1; ++k, power *= u) sums.powers[k] += power;
    sums.squares += sample.weight * squared_norm(offset);
  }
  return sums;
}

// The least-squares polynomial; without its constant term where the position is fixed.
PolynomialFit fit_polynomial(std::span<const ArcSample> samples, std::size_t at, Window window,
                             bool fixed) {
  using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxTerms, kMaxTerms>;
  using Sides = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMaxTerms, 2>;
  const ArcSample& origin = samples[at];
  const double scale = std::max(samples[window.last].length - origin.length,
                                origin.length - samples[window.first].length);
  const Moments sums = sum_moments(samples.subspan(window.first, window.size()), origin, scale);
  const int first = fixed ? 1 : 0;
  const int terms = term_count(window.size()) - first;
  Gram gram(terms, terms);
  Sides sides(terms, 2);
  for (int i = 0; i < terms; ++i) {
    for (int j = 0; j < terms; ++j) gram(i, j) = sums.powers[2 * first + i + j];
    sides.row(i) << sums.offsets[first + i].x, sums.offsets[first + i].y;
  }
  const Sides solution = gram.ldlt().solve(sides);
  const double residual = std::max(sums.squares - solution.cwiseProduct(sides).sum(), 0.0);
  const auto count = static_cast<double>(window.size());
  const double freedom = count - terms;
  const Point position =
      fixed ? origin.position : origin.position + Vector{solution(0, 0), solution(0, 1)};
  const Vector tangent = {solution(1 - first, 0), solution(1 - first, 1)};
  return {{position, normalized(tangent)},
          freedom > 0 ? std::sqrt(residual / sums.powers[0] * count / freedom) : 0};
}

}  // namespace

LocalFit fit_locally(std::span<const ArcSample> samples, std::size_t at,
                     const LocalFitParams& params) {
  assert(samples.size() >= 2);
  const bool fixed = at == 0 || at + 1 == samples.size();
  double reach = params.least_reach;
  Window window = window_within(samples, at, reach);
  PolynomialFit fit = fit_polynomial(samples, at, window, fixed);
  while (window.size() < samples.size()) {
    reach *= 2;
    const Window wider = window_within(samples, at, reach);
    if (wider.size() > kMaxLocalSamples) break;
    if (wider.size() == window.size()) continue;
    const PolynomialFit next = fit_polynomial(samples, at, wider, fixed);
    if (next.deviation > std::max(params.tolerance / 8, kNoiseGrowth * fit.deviation)) break;
    fit = next;
    window = wider;
  }
  LocalFit result = fit.at_sample;
  const Point position = samples[at].position;
  // Not <=, so that NaN is caught as well.
  if (!(distance(result.position, position) <= params.tolerance / 2)) result.position = position;
  if (result.tangent == Vector{} || !is_finite(result.tangent)) {
    const std::size_t before = at > 0 ? at - 1 : at, after = std::min(at + 1, samples.size() - 1);
    result.tangent = normalized(samples[after].position - samples[before].position);
  }
  return result;
}

}  // namespace libstyle
