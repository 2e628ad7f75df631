// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/neighborhood.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace libstyle {
namespace {

constexpr double kEndTolerance = 1e-9;  // spacings; a sample on the end point exists

// Goes along a curve from a place, one way or the other.
class Walker {
 public:
  Walker(const Polyline& curve, PolylinePlace place, bool forward)
      : curve_(curve), forward_(forward), segment_(place.segment) {
    const double size = distance(near_end(), far_end());
    before_ = -(forward ? place.fraction : 1 - place.fraction) * size;
    after_ = before_ + size;
  }

  // The point at a distance from the start; distances rise. False beyond the end, when `tolerance`
  // is not enough.
  bool go_to(double distance_from_start, double tolerance, Point& point) {
    while (after_ < distance_from_start) {
      if (!next_segment()) {
        if (distance_from_start > after_ + tolerance) return false;
        point = far_end();
        return true;
      }
    }
    const double size = after_ - before_;
    point =
        size > 0 ? lerp(near_end(), far_end(), (distance_from_start - before_) / size) : far_end();
    return true;
  }

 private:
  Point near_end() const {
    return forward_ ? segment_start(curve_, segment_) : segment_end(curve_, segment_);
  }
  Point far_end() const {
    return forward_ ? segment_end(curve_, segment_) : segment_start(curve_, segment_);
  }

  bool next_segment() {
    const std::size_t last = segment_count(curve_) - 1;
    if (!curve_.closed && segment_ == (forward_ ? last : 0)) return false;
    if (forward_) {
      segment_ = segment_ == last ? 0 : segment_ + 1;
    } else {
      segment_ = segment_ == 0 ? last : segment_ - 1;
    }
    before_ = after_;
    after_ += distance(near_end(), far_end());
    return true;
  }

  const Polyline& curve_;
  bool forward_;
  std::size_t segment_;
  double before_, after_;  // the segment's ends, as distances from the start
};

}  // namespace

std::vector<double> binomial_weights(int order, int count) {
  const int n = order - 1, middle = n / 2, half = count / 2;
  std::vector<double> weights(static_cast<std::size_t>(count));
  double weight = 1;
  for (int k = 0; k <= half; ++k) {
    weights[static_cast<std::size_t>(half + k)] = weight;
    weights[static_cast<std::size_t>(half - k)] = weight;
    weight *= static_cast<double>(n - middle - k) / static_cast<double>(middle + k + 1);
  }
  return weights;
}

NeighborhoodShape::NeighborhoodShape(std::vector<double> weights, double spacing)
    : weights_(std::move(weights)), sums_(weights_.size() + 1), spacing_(spacing) {
  std::partial_sum(weights_.begin(), weights_.end(), sums_.begin() + 1);
}

void Neighborhood::sample(const Polyline& curve, PolylinePlace place,
                          const NeighborhoodShape& shape, bool with_middle) {
  const std::size_t middle = shape.middle();
  const double tolerance = kEndTolerance * shape.spacing();
  origin_ = point_at(curve, place);
  has_middle_ = with_middle;
  positions_[middle] = {};
  Walker back(curve, place, false), ahead(curve, place, true);
  Point point;
  for (begin_ = middle; begin_ > 0; --begin_) {
    const double to = shape.spacing() * static_cast<double>(middle - begin_ + 1);
    if (!back.go_to(to, tolerance, point)) break;
    positions_[begin_ - 1] = point - origin_;
  }
  for (end_ = middle + 1; end_ < shape.size(); ++end_) {
    const double to = shape.spacing() * static_cast<double>(end_ - middle);
    if (!ahead.go_to(to, tolerance, point)) break;
    positions_[end_] = point - origin_;
  }
  if (!with_middle && end_ - begin_ == 1) begin_ = end_ = 0;
  finish(shape);
}

void Neighborhood::sample_beyond_end(const Polyline& curve, double gap,
                                     const NeighborhoodShape& shape) {
  const std::size_t middle = shape.middle();
  const double tolerance = kEndTolerance * shape.spacing();
  begin_ = end_ = 0;
  has_middle_ = false;
  if (curve.points.empty()) return;
  origin_ = curve.points.back();
  const bool single = curve.points.size() < 2;
  const auto first =
      static_cast<std::size_t>(std::max(1.0, std::ceil((gap - tolerance) / shape.spacing())));
  if (first > middle) return;
  begin_ = end_ = middle - first + 1;
  if (single) {
    const double off = std::abs(static_cast<double>(first) * shape.spacing() - gap);
    if (off <= tolerance) positions_[--begin_] = {};
  } else {
    Walker back(curve, {curve.points.size() - 2, 1}, false);
    Point point;
    for (; begin_ > 0; --begin_) {
      const double to = shape.spacing() * static_cast<double>(middle - begin_ + 1) - gap;
      if (!back.go_to(to, tolerance, point)) break;
      positions_[begin_ - 1] = point - origin_;
    }
  }
  if (begin_ == end_) begin_ = end_ = 0;
  finish(shape);
}

void Neighborhood::finish(const NeighborhoodShape& shape) {
  NeighborhoodSums sum;
  for (std::size_t k = begin_; k < end_; ++k) {
    const double w = shape.weight(k);
    sums_[k] = sum;
    sum.positions += w * positions_[k];
    sum.position_squares += w * squared_norm(positions_[k]);
    if (k == begin_) continue;
    tangents_[k] = normalized(positions_[k] - positions_[k - 1]);
    sum.tangent_squares += w * squared_norm(tangents_[k]);
  }
  sums_[end_] = sum;
}

void Neighborhood::reverse(const NeighborhoodShape& shape) {
  const std::size_t size = positions_.size(), begin = begin_;
  std::ranges::reverse(positions_);
  begin_ = size - end_;
  end_ = size - begin;
  if (begin_ == end_) begin_ = end_ = 0;
  finish(shape);
}

void NeighborhoodTable::add(const NeighborhoodView& neighborhood) {
  const std::size_t at = positions_.size();
  positions_.resize(at + stride_);
  tangents_.resize(at + stride_);
  const std::size_t sums_at = sums_.size();
  sums_.resize(sums_at + stride_ + 1);
  for (std::size_t k = neighborhood.begin; k < neighborhood.end; ++k) {
    positions_[at + k] = neighborhood.positions[k];
    if (k > neighborhood.begin) tangents_[at + k] = neighborhood.tangents[k];
  }
  for (std::size_t k = neighborhood.begin; k <= neighborhood.end; ++k) {
    sums_[sums_at + k] = neighborhood.sums[k];
  }
  origins_.push_back(neighborhood.origin);
  begins_.push_back(neighborhood.begin);
  ends_.push_back(neighborhood.end);
}

}  // namespace libstyle
