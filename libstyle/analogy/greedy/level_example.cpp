// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/level_example.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

constexpr double kLeastNeighborhoods = 3;  // that an example holds

bool is_whole(const NeighborhoodView& view, const NeighborhoodShape& shape) {
  return view.begin == 0 && view.end == shape.size();
}

}  // namespace

LevelExample::LevelExample(std::vector<ExampleCurves> curves, std::vector<double> source_weights,
                           double spacing, bool has_floor, const SearchParameters& parameters)
    : spacing_(spacing),
      shape_(binomial_weights(parameters.binomial_order, parameters.neighborhood_samples),
             spacing * parameters.sample_spacing),
      source_weights_(std::move(source_weights)),
      filtered_(shape_.size()),
      sources_(source_weights_.size(), NeighborhoodTable(shape_.size())) {
  double source_length = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    add_places(i, curves[i], shortest_curve(spacing, parameters));
    length_ += along_[i].total();
    if (!source_weights_.empty()) source_length += arc_length(curves[i].sources[0].polyline);
  }
  if (source_length > 0) growth_ = length_ / source_length;

  std::vector<Screen::Part> parts = {{&filtered_, 1, false}};
  for (std::size_t p = 0; p < sources_.size(); ++p) {
    if (source_weights_[p] > 0) parts.push_back({&sources_[p], source_weights_[p], true});
  }
  screen_.emplace(parts, shape_, parameters.tangent_weight, parameters.rotate);
  if (has_floor) floor_ = measure_floor(parameters);
}

double LevelExample::shortest_curve(double spacing, const SearchParameters& parameters) {
  return kLeastNeighborhoods * (parameters.neighborhood_samples - 1) * parameters.sample_spacing *
         spacing;
}

void LevelExample::add_places(std::size_t curve, const ExampleCurves& curves, double shortest) {
  const SampledCurve& filtered = curves.filtered;
  curves_.push_back(filtered);
  along_.emplace_back(filtered.polyline);
  first_places_.push_back(places_.size());
  if (along_.back().total() < shortest) {
    throw Error(
        "an example is too short for the neighborhoods that are compared: give a longer "
        "one, fewer levels, or fewer samples of a neighborhood");
  }
  Neighborhood neighborhood(shape_.size());
  for (std::size_t i = 0; i < filtered.size(); ++i) {
    const double length = along_.back().cumulative()[i], t = filtered.t[i];
    places_.push_back({curve, length, t});
    const bool last = !filtered.polyline.closed && i + 1 == filtered.size();
    neighborhood.sample(filtered.polyline, last ? PolylinePlace{i - 1, 1} : PolylinePlace{i, 0},
                        shape_);
    filtered_.add(neighborhood.view());
    for (std::size_t p = 0; p < sources_.size(); ++p) {
      const SampledCurve& source = curves.sources[p];
      neighborhood.sample(source.polyline, place_at_parameter(source, t), shape_);
      sources_[p].add(neighborhood.view());
    }
  }
}

std::size_t LevelExample::place_near(std::size_t curve, double length) const {
  const auto lengths = along_[curve].cumulative();
  const std::size_t count = curves_[curve].size();
  const auto after = std::ranges::lower_bound(lengths, length);
  auto i = static_cast<std::size_t>(after - lengths.begin());
  if (i > 0 && (i == lengths.size() || length - lengths[i - 1] < lengths[i] - length)) --i;
  // The whole length of a closed curve is its first vertex again.
  return first_places_[curve] + (i < count ? i : 0);
}

std::optional<double> LevelExample::length_between(std::size_t from, std::size_t to) const {
  if (curve_of(from) != curve_of(to)) return std::nullopt;
  const double length = length_of(to) - length_of(from);
  const ArcLength& along = along_[curve_of(from)];
  if (!along.polyline().closed) return length;
  // Round a closed curve the shorter way is meant.
  return length - along.total() * std::round(length / along.total());
}

std::optional<double> LevelExample::copied_length(std::size_t from, std::size_t to,
                                                  double drawn) const {
  const std::optional<double> length = length_between(from, to);
  const bool copied =
      length && *length > 0 && *length >= kShortestCopy * drawn && *length <= kLongestCopy * drawn;
  return copied ? length : std::nullopt;
}

bool LevelExample::is_near_end(std::size_t j, bool backward) const {
  const ArcLength& along = along_[curve_of(j)];
  if (along.polyline().closed) return false;
  const double rest = backward ? length_of(j) : along.total() - length_of(j);
  return rest < shape_.half_width();
}

// The quantile, over the places with whole neighborhoods, of the shape cost of the best other place
// that shares no part with it.
double LevelExample::measure_floor(const SearchParameters& parameters) const {
  const double window = 2 * shape_.half_width();
  std::vector<std::size_t> whole;
  for (std::size_t j = 0; j < size(); ++j) {
    if (is_whole(filtered_[j], shape_)) whole.push_back(j);
  }
  std::vector<double> nearest(whole.size(), std::numeric_limits<double>::infinity());
  for (std::size_t a = 0; a < whole.size(); ++a) {
    for (std::size_t b = a + 1; b < whole.size(); ++b) {
      const std::optional<double> apart = length_between(whole[a], whole[b]);
      if (apart && std::abs(*apart) < window) continue;
      const NeighborhoodView from = filtered_[whole[a]], to = filtered_[whole[b]];
      const Match both = match(from, to, shape_, parameters.tangent_weight);
      const double distance =
          std::max(0.0, both.distance_for(best_rotation(both.twist, parameters.rotate)));
      nearest[a] = std::min(nearest[a], distance);
      nearest[b] = std::min(nearest[b], distance);
    }
  }
  std::erase_if(nearest, [](double distance) { return !std::isfinite(distance); });
  if (nearest.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(parameters.floor_quantile *
                                                static_cast<double>(nearest.size() - 1));
  std::ranges::nth_element(nearest, nearest.begin() + rank);
  return nearest[static_cast<std::size_t>(rank)];
}

}  // namespace libstyle
