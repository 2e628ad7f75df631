// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/gaussian.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

// --- Exactly: a sum over kinks ------------------------------------------------------------------

// g of the header is below 3e-13 sigma beyond this many sigma.
constexpr double kKinkReach = 7;

// A jump of the unit tangent.
struct Kink {
  double length;
  Vector jump;
};

double blurred_ramp_excess(double distance, double sigma) {
  const double a = std::abs(distance) / sigma;
  const double density = std::exp(-0.5 * a * a) / std::sqrt(2 * std::numbers::pi);
  const double tail = 0.5 * std::erfc(a / std::numbers::sqrt2);
  return sigma * (density - a * tail);
}

// The kinks of the polyline, without the ends of an open one: those are straight after reflection.
std::vector<Kink> find_kinks(const Polyline& polyline, std::span<const double> lengths) {
  std::vector<Kink> kinks;
  std::optional<Vector> first, previous;
  for (std::size_t i = 0; i < segment_count(polyline); ++i) {
    const Vector step = segment_end(polyline, i) - segment_start(polyline, i);
    if (!(norm(step) > 0)) continue;
    const Vector tangent = step / norm(step);
    if (previous) kinks.push_back({lengths[i], tangent - *previous});
    if (!first) first = tangent;
    previous = tangent;
  }
  if (polyline.closed && first) kinks.push_back({lengths.back(), *first - *previous});
  return kinks;
}

// The kinks within `reach` <= total of the curve, rising, those beyond its ends included: turned by
// the point reflection at open ends, repeated on closed curves.
std::vector<Kink> with_images(const std::vector<Kink>& kinks, bool closed, double total,
                              double reach) {
  std::vector<Kink> result;
  const std::size_t count = kinks.size();
  const auto before = [&](std::size_t i) {
    return closed ? Kink{kinks[i].length - total, kinks[i].jump}
                  : Kink{-kinks[count - 1 - i].length, -kinks[count - 1 - i].jump};
  };
  const auto after = [&](std::size_t i) {
    return closed ? Kink{kinks[i].length + total, kinks[i].jump}
                  : Kink{2 * total - kinks[count - 1 - i].length, -kinks[count - 1 - i].jump};
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (before(i).length >= -reach) result.push_back(before(i));
  }
  result.insert(result.end(), kinks.begin(), kinks.end());
  for (std::size_t i = 0; i < count && after(i).length <= total + reach; ++i) {
    result.push_back(after(i));
  }
  return result;
}

// Calls visit(i, kinks within reach of vertex i).
template <typename Visit>
void for_each_vertex_and_kinks(std::span<const double> lengths, const std::vector<Kink>& kinks,
                               double reach, const Visit& visit) {
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    while (begin < kinks.size() && kinks[begin].length < lengths[i] - reach) ++begin;
    while (end < kinks.size() && kinks[end].length <= lengths[i] + reach) ++end;
    visit(i, std::span(kinks).subspan(begin, end - begin));
  }
}

void blur_by_kinks(Polyline& polyline, std::span<const double> lengths,
                   const std::vector<Kink>& kinks, double sigma) {
  for_each_vertex_and_kinks(
      lengths, kinks, kKinkReach * sigma, [&](std::size_t i, std::span<const Kink> near) {
        Vector sum;
        for (const Kink& kink : near) {
          sum += blurred_ramp_excess(kink.length - lengths[i], sigma) * kink.jump;
        }
        polyline.points[i] += sum;
      });
}

// --- On a grid ----------------------------------------------------------------------------------

constexpr double kStepsPerSigma = 8;
constexpr double kGridReach = 6;          // sigmas; the Gaussian is below 1.6e-8 of its top beyond
constexpr std::size_t kLeastSteps = 64;   // for a curve of few sigmas
constexpr std::size_t kInterpolated = 6;  // points of the interpolation
constexpr double kSplineVariance = 1.0 / 3;  // of the cubic B-spline, in steps

// The straight motion in a polyline, which no blur changes: from first to last point if open, none
// but an offset if closed. The rest is periodic: over the length of a closed curve, over twice that
// of an open one, where the second half is the first one reflected.
class StraightPart {
 public:
  StraightPart(const Polyline& polyline, double total)
      : origin_(polyline.points.front()),
        slope_(polyline.closed ? Vector{} : (polyline.points.back() - origin_) / total) {}

  Point at(double length) const { return origin_ + length * slope_; }

 private:
  Point origin_;
  Vector slope_;
};

// Values at the nodes of the grid, 0, step, 2 step and so on; coordinates apart, so that the
// compiler can work on several nodes at once.
struct Nodes {
  std::vector<double> x, y;
};

// Adds the integral of a linear function, given at both ends, times the four B-splines of the nodes
// round a cell. `from` and `to` are fractions of the cell. Three-point Gauss quadrature is exact
// here: the integrand has degree 4.
void add_spline_moments(double* x, double* y, double from, double to, Point start, Point end) {
  constexpr double kPlaces[] = {0.5 - 0.3872983346207417, 0.5, 0.5 + 0.3872983346207417};
  constexpr double kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  for (int i = 0; i < 3; ++i) {
    const double f = from + kPlaces[i] * (to - from), g = 1 - f;
    const Point value = (kWeights[i] * (to - from) / 6) * lerp(start, end, kPlaces[i]);
    const double splines[] = {g * g * g, 4 - 3 * f * f * (1 + g), 4 - 3 * g * g * (1 + f),
                              f * f * f};
    for (int k = 0; k < 4; ++k) {
      x[k] += splines[k] * value.x;
      y[k] += splines[k] * value.y;
    }
  }
}

// The means of the periodic part under the B-spline of each node -1 .. steps + 1, taken over the
// curve itself, without what lies beyond its ends.
Nodes spline_moments(const Polyline& polyline, std::span<const double> lengths,
                     const StraightPart& straight, std::size_t steps, double step) {
  Nodes nodes{std::vector<double>(steps + 3), std::vector<double>(steps + 3)};
  std::size_t cell = 0;
  for (std::size_t i = 0; i + 1 < lengths.size(); ++i) {
    const double segment_length = lengths[i + 1] - lengths[i];
    if (!(segment_length > 0)) continue;
    const Point start = segment_start(polyline, i) - straight.at(lengths[i]);
    const Point end = segment_end(polyline, i) - straight.at(lengths[i + 1]);
    double from = lengths[i];
    while (from < lengths[i + 1]) {
      const double cell_start = static_cast<double>(cell) * step;
      const double cell_end = static_cast<double>(cell + 1) * step;
      const bool last = cell + 1 == steps;
      const double to = last ? lengths[i + 1] : std::min(cell_end, lengths[i + 1]);
      add_spline_moments(&nodes.x[cell], &nodes.y[cell], (from - cell_start) / step,
                         (to - cell_start) / step,
                         lerp(start, end, (from - lengths[i]) / segment_length),
                         lerp(start, end, (to - lengths[i]) / segment_length));
      from = to;
      if (!last && from >= cell_end) ++cell;
    }
  }
  return nodes;
}

// The periodic signal at nodes -margin .. steps + margin, from the moments above: what lies beyond
// an end adds to the nodes next to it.
std::vector<double> with_margin(const std::vector<double>& moments, bool closed,
                                std::size_t margin) {
  const auto steps = static_cast<std::ptrdiff_t>(moments.size()) - 3;
  const auto moment = [&](std::ptrdiff_t node) {
    return node < -1 || node > steps + 1 ? 0 : moments[static_cast<std::size_t>(node + 1)];
  };
  const auto closed_value = [&](std::ptrdiff_t node) {  // 0 .. steps - 1
    return moment(node) + moment(node + steps) + moment(node - steps);
  };
  const auto open_value = [&](std::ptrdiff_t node) {  // 0 .. steps
    return moment(node) - moment(-node) - moment(2 * steps - node);
  };
  const std::ptrdiff_t period = closed ? steps : 2 * steps;
  const auto first = -static_cast<std::ptrdiff_t>(margin);
  std::vector<double> result;
  for (std::ptrdiff_t i = first; i <= steps - first; ++i) {
    const std::ptrdiff_t node = (i % period + period) % period;
    if (closed) {
      result.push_back(closed_value(node));
    } else {
      result.push_back(node <= steps ? open_value(node) : -open_value(period - node));
    }
  }
  return result;
}

// One half of a symmetric kernel of the given standard deviation in steps, middle first.
std::vector<double> gaussian_kernel(double deviation, std::size_t radius) {
  std::vector<double> kernel;
  double sum = 0;
  for (std::size_t i = 0; i <= radius; ++i) {
    const double a = static_cast<double>(i) / deviation;
    kernel.push_back(std::exp(-0.5 * a * a));
    sum += (i == 0 ? 1 : 2) * kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

// Shortens the signal by the kernel's radius at both ends.
std::vector<double> convolve(const std::vector<double>& signal, const std::vector<double>& kernel) {
  const std::size_t radius = kernel.size() - 1;
  std::vector<double> result(signal.size() - 2 * radius);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = kernel[0] * signal[i + radius];
  for (std::size_t k = 1; k <= radius; ++k) {
    const double weight = kernel[k];
    const double* before = signal.data() + radius - k;
    const double* after = signal.data() + radius + k;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += weight * (before[i] + after[i]);
  }
  return result;
}

// Lagrange's polynomial through the values at 0 .. 5, at u between 2 and 3.
double interpolated(const double* values, double u) {
  constexpr double kDenominators[kInterpolated] = {-120, 24, -12, 12, -24, 120};
  double sum = 0;
  for (std::size_t i = 0; i < kInterpolated; ++i) {
    double product = values[i] / kDenominators[i];
    for (std::size_t j = 0; j < kInterpolated; ++j) {
      if (j != i) product *= u - static_cast<double>(j);
    }
    sum += product;
  }
  return sum;
}

void blur_on_grid(Polyline& polyline, std::span<const double> lengths, double sigma) {
  const double total = lengths.back();
  const auto steps =
      std::max(kLeastSteps, static_cast<std::size_t>(std::ceil(kStepsPerSigma * total / sigma)));
  const double step = total / static_cast<double>(steps);
  const double deviation = std::sqrt(sigma / step * (sigma / step) - kSplineVariance);
  const auto radius = static_cast<std::size_t>(std::ceil(kGridReach * deviation));
  const std::vector<double> kernel = gaussian_kernel(deviation, radius);
  const StraightPart straight(polyline, total);
  const Nodes moments = spline_moments(polyline, lengths, straight, steps, step);
  constexpr std::size_t kBorder = kInterpolated / 2;
  const auto blurred = [&](const std::vector<double>& values) {
    return convolve(with_margin(values, polyline.closed, radius + kBorder), kernel);
  };
  const Nodes nodes{blurred(moments.x), blurred(moments.y)};
  for (std::size_t i = 0; i < polyline.points.size(); ++i) {
    const double place = lengths[i] / step + kBorder;  // values begin at node -kBorder
    const std::size_t first =
        std::min(static_cast<std::size_t>(place), steps + kBorder) - (kBorder - 1);
    const double u = place - static_cast<double>(first);
    polyline.points[i] = straight.at(lengths[i]) +
                         Vector{interpolated(&nodes.x[first], u), interpolated(&nodes.y[first], u)};
  }
}

// Time of a grid step and of an interpolation, in exact terms' times, measured; only the balance
// matters.
constexpr double kStepCost = 5;
constexpr double kInterpolationCost = 1;

bool is_exact_cheaper(std::span<const double> lengths, const std::vector<Kink>& kinks,
                      double sigma) {
  const double steps = kStepsPerSigma * lengths.back() / sigma;
  const double limit = kStepCost * steps + kInterpolationCost * static_cast<double>(lengths.size());
  double pairs = 0;
  for_each_vertex_and_kinks(
      lengths, kinks, kKinkReach * sigma,
      [&](std::size_t, std::span<const Kink> near) { pairs += static_cast<double>(near.size()); });
  return pairs <= limit;
}

}  // namespace

Polyline gaussian_blur(const Polyline& polyline, double sigma) {
  assert(sigma >= 0);
  const std::vector<double> lengths = cumulative_lengths(polyline);
  if (sigma == 0 || lengths.empty() || lengths.back() == 0) return polyline;
  if (!std::isfinite(lengths.back())) {
    throw Error("blur: a point is not finite or too far away to measure");
  }
  Polyline result = polyline;
  const double total = lengths.back();
  const std::size_t count = polyline.points.size();
  const auto vertex_lengths = std::span(lengths).first(count);
  const double reach = kKinkReach * sigma;
  std::vector<Kink> kinks;
  if (reach <= total) {
    kinks = with_images(find_kinks(polyline, lengths), polyline.closed, total, reach);
  }
  if (reach <= total && is_exact_cheaper(vertex_lengths, kinks, sigma)) {
    blur_by_kinks(result, vertex_lengths, kinks, sigma);
  } else {
    // At one period of blur nothing but the straight part is left: exp(-2 pi^2) = 3e-9.
    const double period = polyline.closed ? total : 2 * total;
    blur_on_grid(result, lengths, std::min(sigma, period));
  }
  if (!polyline.closed) {
    result.points.front() = polyline.points.front();
    result.points.back() = polyline.points.back();
  }
  return result;
}

}  // namespace libstyle
