// SPDX-License-Identifier: Apache-2.0
// The example at one level of the pyramid, ready to be searched: {A, A'_(l-1)} : A'_l.
//
// Places s_j are the vertices of the filtered curves at this level. Several example curves follow
// one another in one list of places; no copied piece reaches from one into the next.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/greedy/matching.h"
#include "libstyle/analogy/greedy/neighborhood.h"
#include "libstyle/analogy/greedy/screen.h"
#include "libstyle/analogy/greedy/search_parameters.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// One example curve at a level. All its curves have the same parameter t.
struct ExampleCurves {
  SampledCurve filtered;              // A'_l
  std::vector<SampledCurve> sources;  // A_l, A'_(l-1): those there are
};

// Steps of the example and of the drawn curve that differ by less are one copy.
inline constexpr double kShortestCopy = 0.5, kLongestCopy = 1.5;

class LevelExample {
 public:
  // How long an example curve has to be at a level.
  static double shortest_curve(double spacing, const SearchParameters& parameters);

  // `source_weights` has a weight >= 0 for each source. Throws Error if an example curve is too
  // short.
  LevelExample(std::vector<ExampleCurves> curves, std::vector<double> source_weights,
               double spacing, bool has_floor, const SearchParameters& parameters);

  // The screen refers to the tables.
  LevelExample(const LevelExample&) = delete;
  LevelExample& operator=(const LevelExample&) = delete;

  std::size_t size() const { return places_.size(); }
  double spacing() const { return spacing_; }
  const NeighborhoodShape& shape() const { return shape_; }

  std::size_t source_count() const { return source_weights_.size(); }
  double source_weight(std::size_t source) const { return source_weights_[source]; }
  NeighborhoodView filtered(std::size_t j) const { return filtered_[j]; }
  NeighborhoodView source(std::size_t source, std::size_t j) const { return sources_[source][j]; }

  std::size_t curve_of(std::size_t j) const { return places_[j].curve; }
  double length_of(std::size_t j) const { return places_[j].length; }  // along the filtered curve
  double parameter_of(std::size_t j) const { return places_[j].t; }
  const ArcLength& curve(std::size_t index) const { return along_[index]; }
  const SampledCurve& sampled_curve(std::size_t index) const { return curves_[index]; }
  // The place nearest to a length along a curve.
  std::size_t place_near(std::size_t curve, double length) const;

  // The length along the example from one place on to another; negative if it lies behind, nothing
  // if no piece of the example leads there.
  std::optional<double> length_between(std::size_t from, std::size_t to) const;
  // The length of the example from one place on to another if a drawn step of that length continues
  // a copied piece: ahead, and half to one and a half times as long.
  std::optional<double> copied_length(std::size_t from, std::size_t to, double drawn) const;
  // Whether place j is so near the end (or, for those who go backwards, the beginning) of its curve
  // that a copy cannot go on for half a neighborhood.
  bool is_near_end(std::size_t j, bool backward) const;

  double length() const { return length_; }  // of the filtered curves
  // The same over that of the first source.
  double growth() const { return growth_; }
  double floor() const { return floor_; }
  // The parts of the screen are the filtered curve and the sources of weight > 0, in this order.
  const Screen& screen() const { return *screen_; }

 private:
  struct Place {
    std::size_t curve;
    double length;
    double t;
  };

  void add_places(std::size_t curve, const ExampleCurves& curves, double shortest);
  double measure_floor(const SearchParameters& parameters) const;

  double spacing_;
  NeighborhoodShape shape_;
  std::vector<double> source_weights_;
  std::vector<SampledCurve> curves_;
  std::vector<ArcLength> along_;
  std::vector<std::size_t> first_places_;
  std::vector<Place> places_;
  NeighborhoodTable filtered_;
  std::vector<NeighborhoodTable> sources_;
  double length_ = 0;
  double growth_ = 1;
  double floor_ = 0;
  std::optional<Screen> screen_;
};

}  // namespace libstyle
