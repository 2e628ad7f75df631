// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/window_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "libstyle/base/parallel.h"
#include "libstyle/image/lanes.h"
#include "libstyle/image/principal_components.h"

namespace libstyle::image {
namespace {

constexpr std::size_t kSampledWindows = 1500;  // that components are found from
constexpr int kParallelDepth = 3;              // 8 parts of the tree are built side by side

// A box that a query has passed by.
struct Passed {
  float distance;
  std::int32_t node;
};

// Those of them that may still be looked into. When there are too many, the furthest is forgotten:
// a query looks into few.
class PassedBoxes {
 public:
  bool empty() const { return count_ == 0; }

  void push(Passed box) {
    std::size_t at = count_;
    if (count_ == boxes_.size()) {
      if (!comes_before(box, boxes_[0])) return;
      std::move(boxes_.begin() + 1, boxes_.end(), boxes_.begin());
      --at;
    } else {
      ++count_;
    }
    for (; at > 0 && comes_before(boxes_[at - 1], box); --at) boxes_[at] = boxes_[at - 1];
    boxes_[at] = box;
  }

  Passed pop() { return boxes_[--count_]; }

 private:
  static bool comes_before(const Passed& a, const Passed& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.node < b.node;
  }

  std::array<Passed, 64> boxes_;  // the nearest last
  std::size_t count_ = 0;
};

}  // namespace

// What a query has found, the nearest first.
class WindowIndex::FoundPlaces {
 public:
  FoundPlaces(std::span<NearPlace> places, float limit) : places_(places), bound_(limit) {}

  // What is not nearer is of no use.
  float bound() const { return bound_; }
  std::size_t count() const { return count_; }

  void insert(NearPlace item) {
    std::size_t at = count_;
    while (at > 0 && comes_before(item, places_[at - 1])) --at;
    if (at > 0 && places_[at - 1].place == item.place) return;
    if (at == places_.size()) return;
    count_ = std::min(count_ + 1, places_.size());
    for (std::size_t i = count_ - 1; i > at; --i) places_[i] = places_[i - 1];
    places_[at] = item;
    if (count_ == places_.size()) bound_ = std::min(bound_, places_.back().distance);
  }

 private:
  static bool comes_before(const NearPlace& a, const NearPlace& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.place < b.place;
  }

  std::span<NearPlace> places_;
  float bound_;
  std::size_t count_ = 0;
};

void WindowIndex::build(const Neighborhood& neighborhood, const RowSteps& rows,
                        const std::vector<PixelIndex>& places,
                        const std::vector<Windows>& windows) {
  choose_components(neighborhood, rows, windows);
  std::vector<float> projections(places.size() * width_);
  constexpr std::size_t kBlock = 1024;
  parallel_for((places.size() + kBlock - 1) / kBlock, settings_.threads, [&](std::size_t block) {
    const std::size_t end = std::min((block + 1) * kBlock, places.size());
    for (std::size_t i = block * kBlock; i < end; ++i) {
      project(windows[i], rows, &projections[i * width_]);
    }
  });

  const std::size_t leaves = (places.size() + kLeafPlaces - 1) / kLeafPlaces;
  nodes_.resize(2 * leaves - 1);
  boxes_.resize(nodes_.size() * 2 * width_);
  leaf_values_.resize(leaves * width_ * kLeafPlaces);
  leaf_places_.resize(leaves * kLeafPlaces);
  places_ = places;
  std::vector<std::int32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  divide(0, 0, leaves, order, projections, 0);
  places_ = {};
}

void WindowIndex::choose_components(const Neighborhood& neighborhood, const RowSteps& rows,
                                    const std::vector<Windows>& windows) {
  const auto add_runs = [&](const WindowWeights& window, std::vector<Run>& runs) {
    for (int row = 0; row <= 2 * window.radius; ++row) {
      bool goes_on = false;
      for (int lane = 0; lane < window.row_lanes; ++lane) {
        const float weight = window.weights[std::size_t(row) * window.row_lanes + lane];
        if (weight > 0) {
          if (!goes_on) runs.push_back({row, lane, 0});
          ++runs.back().count;
          roots_.push_back(std::sqrt(weight));
        }
        goes_on = weight > 0;
      }
    }
  };
  add_runs(neighborhood.fine, fine_runs_);
  if (windows.front().coarse) add_runs(neighborhood.coarse, coarse_runs_);

  const std::size_t length = roots_.size();
  const std::size_t count = std::min(kSampledWindows, windows.size());
  std::vector<float> vectors(count * length);
  for (std::size_t i = 0; i < count; ++i) {
    float* vector = &vectors[i * length];
    const float* root = roots_.data();
    for_each_sample(windows[i * windows.size() / count], rows,
                    [&](float sample) { *vector++ = sample * *root++; });
  }
  const PrincipalComponents components = principal_components(
      vectors, length,
      static_cast<std::size_t>(std::clamp(settings_.most_components, 1, kMostCoordinates - 1)),
      settings_.kept_variance);
  rest_ = static_cast<int>(components.count);
  width_ = whole_lanes(rest_ + 1);
  basis_.resize(length * width_);
  for (std::size_t i = 0; i < length; ++i) {
    means_.push_back(components.mean[i] / roots_[i]);
    std::copy_n(&components.basis[i * components.count], components.count, &basis_[i * width_]);
  }
}

template <typename Add>
void WindowIndex::for_each_sample(const Windows& windows, const RowSteps& rows, Add add) const {
  for (const Run& run : fine_runs_) {
    const float* sample = windows.fine + run.row * rows.fine + run.first;
    for (int i = 0; i < run.count; ++i) add(sample[i]);
  }
  for (const Run& run : coarse_runs_) {
    const float* sample = windows.coarse + run.row * rows.coarse + run.first;
    for (int i = 0; i < run.count; ++i) add(sample[i]);
  }
}

// Each component is summed in the order of the samples, whatever the lanes.
template <int kGroups>
void WindowIndex::project_groups(const Windows& windows, const RowSteps& rows,
                                 float* projection) const {
  std::array<Lanes, kGroups> sums{};
  float rest = 0;  // squared length, less that of the projection
  std::size_t i = 0;
  for_each_sample(windows, rows, [&](float sample) {
    const float value = (sample - means_[i]) * roots_[i];
    const float* basis = &basis_[i++ * kGroups * kLanes];
    const Lanes lanes = all_lanes(value);
    for (int g = 0; g < kGroups; ++g) sums[g] += lanes * load_lanes(basis + g * kLanes);
    rest += value * value;
  });
  for (int g = 0; g < kGroups; ++g) {
    store_lanes(projection + g * kLanes, sums[g]);
    rest -= sum_of_lanes(sums[g] * sums[g]);
  }
  projection[rest_] = std::sqrt(std::max(rest, 0.F));
}

void WindowIndex::project(const Windows& windows, const RowSteps& rows, float* projection) const {
  switch (width_ / kLanes) {
    case 1:
      return project_groups<1>(windows, rows, projection);
    case 2:
      return project_groups<2>(windows, rows, projection);
    case 3:
      return project_groups<3>(windows, rows, projection);
    default:
      return project_groups<4>(windows, rows, projection);
  }
}

void WindowIndex::divide(std::int32_t node, std::size_t first_leaf, std::size_t leaves,
                         std::span<std::int32_t> order, const std::vector<float>& projections,
                         int depth) {
  float* low = &boxes_[static_cast<std::size_t>(node) * 2 * width_];
  float* high = low + width_;
  for (int k = 0; k < width_; k += kLanes) {
    Lanes smallest = load_lanes(&projections[std::size_t(order[0]) * width_ + k]);
    Lanes largest = smallest;
    for (const std::int32_t i : order) {
      const Lanes values = load_lanes(&projections[std::size_t(i) * width_ + k]);
      smallest = smaller(smallest, values);
      largest = larger(largest, values);
    }
    store_lanes(low + k, smallest);
    store_lanes(high + k, largest);
  }
  if (leaves == 1) {
    nodes_[node] = {0, static_cast<std::int32_t>(first_leaf)};
    keep_leaf(first_leaf, order, projections);
    return;
  }
  int widest = 0;
  for (int k = 1; k < width_; ++k) {
    if (high[k] - low[k] > high[widest] - low[widest]) widest = k;
  }
  const std::size_t first_leaves = leaves / 2;
  const std::size_t split = first_leaves * kLeafPlaces;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(split), order.end(),
                   [&](std::int32_t a, std::int32_t b) {
                     const float first = projections[std::size_t(a) * width_ + widest];
                     const float second = projections[std::size_t(b) * width_ + widest];
                     return first != second ? first < second : a < b;
                   });
  const std::int32_t second = node + static_cast<std::int32_t>(2 * first_leaves);
  nodes_[node] = {second, 0};
  const auto divide_half = [&](std::size_t half) {
    if (half == 0) {
      divide(node + 1, first_leaf, first_leaves, order.first(split), projections, depth + 1);
    } else {
      divide(second, first_leaf + first_leaves, leaves - first_leaves, order.subspan(split),
             projections, depth + 1);
    }
  };
  parallel_for(2, depth < kParallelDepth ? settings_.threads : 1, divide_half);
}

// Leaves that are not full repeat their last place, which changes no result but that it may be
// found twice.
void WindowIndex::keep_leaf(std::size_t leaf, std::span<const std::int32_t> order,
                            const std::vector<float>& projections) {
  for (std::size_t i = 0; i < kLeafPlaces; ++i) {
    const std::int32_t from = order[std::min(i, order.size() - 1)];
    leaf_places_[leaf * kLeafPlaces + i] = places_[from];
    for (int k = 0; k < width_; ++k) {
      leaf_values_[(leaf * width_ + k) * kLeafPlaces + i] =
          projections[std::size_t(from) * width_ + k];
    }
  }
}

float WindowIndex::box_distance(std::int32_t node, const float* query) const {
  const float* low = &boxes_[static_cast<std::size_t>(node) * 2 * width_];
  Lanes sum = all_lanes(0);
  for (int k = 0; k < width_; k += kLanes) {
    const Lanes value = load_lanes(query + k);
    const Lanes below = load_lanes(low + k) - value;
    const Lanes above = value - load_lanes(low + width_ + k);
    const Lanes outside = larger(larger(below, above), all_lanes(0));
    sum += outside * outside;
  }
  return sum_of_lanes(sum);
}

std::size_t WindowIndex::nearest(const Windows& query, const RowSteps& rows, float limit,
                                 std::span<NearPlace> found) const {
  std::array<float, kMostCoordinates> point;
  project(query, rows, point.data());
  FoundPlaces places(found, limit);
  PassedBoxes passed;
  passed.push({box_distance(0, point.data()), 0});
  for (int leaves = 0; leaves < settings_.leaves && !passed.empty(); ++leaves) {
    Passed nearest = passed.pop();
    while (nearest.distance < places.bound() && nodes_[nearest.node].second != 0) {
      Passed first{0, nearest.node + 1};
      Passed second{0, nodes_[nearest.node].second};
      first.distance = box_distance(first.node, point.data());
      second.distance = box_distance(second.node, point.data());
      if (second.distance < first.distance) std::swap(first, second);
      if (second.distance < places.bound()) passed.push(second);
      nearest = first;
    }
    if (nearest.distance >= places.bound()) continue;
    look_into(nodes_[nearest.node].leaf, point.data(), places);
  }
  return places.count();
}

void WindowIndex::look_into(std::int32_t leaf, const float* point, FoundPlaces& places) const {
  std::array<Lanes, kLeafPlaces / kLanes> sums{};
  const float* values = &leaf_values_[static_cast<std::size_t>(leaf) * width_ * kLeafPlaces];
  for (int k = 0; k < width_; ++k, values += kLeafPlaces) {
    const Lanes value = all_lanes(point[k]);
    for (int g = 0; g < kLeafPlaces / kLanes; ++g) {
      const Lanes difference = load_lanes(values + g * kLanes) - value;
      sums[g] += difference * difference;
    }
  }
  std::array<float, kLeafPlaces> distances;
  for (int g = 0; g < kLeafPlaces / kLanes; ++g) store_lanes(&distances[g * kLanes], sums[g]);
  for (int i = 0; i < kLeafPlaces; ++i) {
    if (distances[i] > places.bound()) continue;
    places.insert({distances[i], leaf_places_[static_cast<std::size_t>(leaf) * kLeafPlaces + i]});
  }
}

}  // namespace libstyle::image
