// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/carried_values.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

// Values at points of a curve, looked up by length.
class ValuesByLength {
 public:
  ValuesByLength(const FlattenedSubpath& flat)
      : lengths_(cumulative_lengths(flat.polyline)),
        places_(flat.places),
        goes_round_(flat.polyline.closed) {
    if (goes_round_) places_.push_back(flat.places.front());
  }

  std::vector<double> at(std::span<const double> lengths, std::span<const double> values) const {
    const std::vector<double> known = values_along(places_, values);
    if (known.size() == 1) return std::vector(lengths.size(), known.front());
    std::vector<double> result;
    for (double length : lengths) {
      if (goes_round_ && length > lengths_.back()) length -= lengths_.back();
      const auto after = std::ranges::upper_bound(lengths_, length);
      const auto i =
          std::clamp<std::ptrdiff_t>(after - lengths_.begin(), 1, std::ssize(lengths_) - 1);
      const auto b = static_cast<std::size_t>(i), a = b - 1;
      const double gap = lengths_[b] - lengths_[a];
      const double share = gap > 0 ? std::clamp((length - lengths_[a]) / gap, 0.0, 1.0) : 0;
      result.push_back(std::lerp(known[a], known[b], share));
    }
    return result;
  }

 private:
  std::vector<double> lengths_;
  std::vector<PathPlace> places_;
  bool goes_round_;
};

}  // namespace

void append_values(AlongValues& result, const AlongValues& old, const FlattenedSubpath& flat,
                   std::span<const double> lengths) {
  if (old.empty()) return;
  const ValuesByLength along(flat);
  for (std::size_t i = 0; i < old.channels.size(); ++i) {
    const std::vector<double> values = along.at(lengths, old.channels[i].values);
    std::vector<double>& all = result.channels[i].values;
    all.insert(all.end(), values.begin(), values.end());
  }
  if (old.colors.empty()) return;
  const std::vector<Color> colors = map_channels(
      old.colors, [&](std::span<const double> values) { return along.at(lengths, values); });
  result.colors.insert(result.colors.end(), colors.begin(), colors.end());
}

void StyledFeatures::append(const SmoothCurve& fresh) {
  for (std::size_t i = 0; i < features_.size(); ++i) {
    values_[i].insert(values_[i].end(), fresh.features[i].begin(), fresh.features[i].end());
  }
}

void StyledFeatures::append_kept(const AlongValues& along, const StyledCurve& kept,
                                 std::size_t vertices) {
  for (std::size_t i = 0; i < features_.size(); ++i) {
    const std::vector<double> own = feature_values(along, features_[i]);
    if (own.empty()) {
      values_[i].insert(values_[i].end(), vertices, kept.features[i].front());
    } else {
      values_[i].insert(values_[i].end(), own.end() - static_cast<std::ptrdiff_t>(vertices),
                        own.end());
    }
  }
}

}  // namespace libstyle
