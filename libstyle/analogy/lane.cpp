// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/lane.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace libstyle {

Lane::Lane(std::vector<Sample> samples, std::vector<std::vector<double>> features,
           std::optional<double> period)
    : strokes_({Stroke{}}),
      first_samples_({0}),
      samples_(std::move(samples)),
      features_(std::move(features)),
      period_(period) {}

void Lane::append_stroke(std::span<const Sample> samples,
                         std::span<const std::vector<double>> features) {
  strokes_.push_back({samples.front().length, samples.back().length});
  first_samples_.push_back(samples_.size());
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  features_.resize(features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    features_[i].insert(features_[i].end(), features[i].begin(), features[i].end());
  }
}

void Lane::extend_to_ends(double length, double near) {
  if (strokes_.empty()) return;
  if (strokes_.front().begin < near) strokes_.front().begin = Stroke{}.begin;
  if (strokes_.back().end > length - near) strokes_.back().end = Stroke{}.end;
}

bool Lane::is_down(double length) const {
  const auto after = std::ranges::upper_bound(strokes_, length, {}, &Stroke::begin);
  return after != strokes_.begin() && length <= std::prev(after)->end;
}

std::span<const Lane::Sample> Lane::samples_of(std::size_t stroke) const {
  const std::size_t first = first_samples_[stroke];
  const bool is_last = stroke + 1 == first_samples_.size();
  const std::size_t end = is_last ? samples_.size() : first_samples_[stroke + 1];
  return samples().subspan(first, end - first);
}

Lane::Between Lane::between(double length) const {
  if (period_) length -= std::floor(length / *period_) * *period_;
  const auto above = std::ranges::upper_bound(samples_, length, {}, &Sample::length);
  const auto after = static_cast<std::size_t>(above - samples_.begin());
  if (after == 0) return {0, 0, 0};
  if (after == samples_.size()) return {after - 1, after - 1, 0};
  const double start = samples_[after - 1].length, end = samples_[after].length;
  return {after - 1, after, (length - start) / (end - start)};
}

Lane::Sample Lane::at(double length) const {
  if (samples_.empty()) return {};
  const auto [before, after, share] = between(length);
  if (before == after) return samples_[before];
  const Sample &a = samples_[before], &b = samples_[after];
  const Vector tangent = normalized(lerp(a.tangent, b.tangent, share));
  return {std::lerp(a.length, b.length, share), lerp(a.offset, b.offset, share),
          tangent == Vector{} ? a.tangent : tangent, std::lerp(a.blur, b.blur, share)};
}

std::vector<double> Lane::features_at(double length) const {
  if (features_.empty()) return {};
  const auto [before, after, share] = between(length);
  std::vector<double> result;
  for (const std::vector<double>& values : features_) {
    result.push_back(std::lerp(values[before], values[after], share));
  }
  return result;
}

}  // namespace libstyle
