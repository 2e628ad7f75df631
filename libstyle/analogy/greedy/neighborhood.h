// SPDX-License-Identifier: Apache-2.0
// What surrounds a place of a curve: samples at equal distances along it, weighted by nearness.
//
// Source: section 3.1 and 3.6 of the paper. Sample k = 0 .. n-1 lies (k - (n-1)/2) spacings along
// the curve from the middle. Samples beyond the ends of an open curve do not exist; closed curves
// go round. Weights are w_k = C(n-1, k) / C(n-1, (n-1)/2), a Gaussian in all but name; the printed
// C(n, k) has two maxima and leans to one side.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// The middle `count` of the weights of that order; both odd, count <= order.
std::vector<double> binomial_weights(int order, int count);

// What all neighborhoods of a level share.
class NeighborhoodShape {
 public:
  // An odd number of weights, the middle one 1; the distance between samples.
  NeighborhoodShape(std::vector<double> weights, double spacing);

  std::size_t size() const { return weights_.size(); }
  std::size_t middle() const { return weights_.size() / 2; }
  double spacing() const { return spacing_; }
  double half_width() const { return spacing_ * static_cast<double>(middle()); }
  double weight(std::size_t k) const { return weights_[k]; }
  // Of samples [begin, end).
  double weight_between(std::size_t begin, std::size_t end) const {
    return begin < end ? sums_[end] - sums_[begin] : 0;
  }

 private:
  std::vector<double> weights_;
  std::vector<double> sums_;  // of the weights before k
  double spacing_;
};

// Weighted sums over the samples before one: the difference of two of them is that of the samples
// between. Of positions, of their squared norms and of those of tangents.
struct NeighborhoodSums {
  Point positions;
  double position_squares = 0;
  double tangent_squares = 0;
};

// Samples [begin, end) exist, but for the middle one if `has_middle` is false. Tangents are unit
// vectors from sample k - 1 to k, or 0 where both lie at one place; the one at `begin` is not used.
// Positions are relative to `origin`. Points to memory of somebody else.
struct NeighborhoodView {
  const Point* positions = nullptr;
  const Vector* tangents = nullptr;
  const NeighborhoodSums* sums = nullptr;  // one more than samples
  Point origin;
  std::size_t begin = 0, end = 0;
  bool has_middle = true;

  bool empty() const { return begin == end; }
};

// The weight of the samples that exist in [begin, end) of a neighborhood with or without its
// middle.
inline double weight_of(const NeighborhoodShape& shape, std::size_t begin, std::size_t end,
                        bool with_middle) {
  const bool lacks_middle = !with_middle && begin <= shape.middle() && shape.middle() < end;
  return shape.weight_between(begin, end) - (lacks_middle ? 1 : 0);
}

// One neighborhood with memory of its own, to be filled again and again.
class Neighborhood {
 public:
  explicit Neighborhood(std::size_t size) : positions_(size), tangents_(size), sums_(size + 1) {}

  NeighborhoodView view() const {
    return {positions_.data(), tangents_.data(), sums_.data(), origin_, begin_, end_, has_middle_};
  }

  // Around a place of a curve that has a length. The middle may be left out: it is the vertex that
  // is looked for.
  void sample(const Polyline& curve, PolylinePlace place, const NeighborhoodShape& shape,
              bool with_middle = true);

  // Around a place `gap` beyond the last point of a curve that is being made. A curve of fewer than
  // two points has no samples but that point.
  void sample_beyond_end(const Polyline& curve, double gap, const NeighborhoodShape& shape);

  // As seen by one who goes along the curve the other way.
  void reverse(const NeighborhoodShape& shape);

 private:
  // Tangents and sums from the positions.
  void finish(const NeighborhoodShape& shape);

  std::vector<Point> positions_;
  std::vector<Vector> tangents_;
  std::vector<NeighborhoodSums> sums_;
  Point origin_;
  std::size_t begin_ = 0, end_ = 0;
  bool has_middle_ = true;
};

// The neighborhoods of all places of an example, in one piece of memory.
class NeighborhoodTable {
 public:
  explicit NeighborhoodTable(std::size_t neighborhood_size) : stride_(neighborhood_size) {}

  void add(const NeighborhoodView& neighborhood);

  std::size_t size() const { return origins_.size(); }
  NeighborhoodView operator[](std::size_t j) const {
    return {&positions_[j * stride_],
            &tangents_[j * stride_],
            &sums_[j * (stride_ + 1)],
            origins_[j],
            begins_[j],
            ends_[j],
            true};
  }

 private:
  std::size_t stride_;
  std::vector<Point> positions_;
  std::vector<Vector> tangents_;
  std::vector<NeighborhoodSums> sums_;
  std::vector<Point> origins_;
  std::vector<std::size_t> begins_, ends_;
};

}  // namespace libstyle
