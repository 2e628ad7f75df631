// SPDX-License-Identifier: Apache-2.0
// All neighbourhoods of the examples, ordered for a search of those like a given one.
//
// Neighbourhoods, weighted, are projected onto their first principal components. What is left of
// each is known by its length alone, which is one more coordinate: by the triangle inequality,
// squared distances of projections are never more than those of neighbourhoods. A balanced k-d tree
// halves them at the median along the widest side of their box until 16 are left; every node keeps
// its box. A query descends to the nearest box first and goes on with the nearest of those passed
// by (best bin first: Beis and Lowe, 1997), until the boxes that are left lie further away than
// what has been found, than the limit it was given, or as many leaves as allowed have been seen.
//
// The limit is what makes it quick: a match that is worth leaving a copied piece for must be nearer
// than d_coh / (1 + kappa), so a query stops as soon as no box can hold one. Where pieces fit well
// that is at once, and nothing is decided differently for it.
//
// Cost: O(n log n) to build; a query O(log n) at most for a set number of leaves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libstyle/image/feature_plane.h"
#include "libstyle/image/neighborhood.h"

namespace libstyle::image {

struct IndexSettings {
  int most_components = 15;
  double kept_variance = 0.99;
  int leaves = 24;  // that a query looks at
  int threads = 0;
};

// A place that looks near in the projection.
struct NearPlace {
  float distance = 0;
  PixelIndex place = 0;
};

class WindowIndex {
 public:
  // windows_of(place) gives the neighbourhood of one of the places.
  template <typename WindowsOf>
  WindowIndex(const Neighborhood& neighborhood, const RowSteps& rows,
              const std::vector<PixelIndex>& places, WindowsOf windows_of,
              const IndexSettings& settings)
      : settings_(settings) {
    std::vector<Windows> windows;
    windows.reserve(places.size());
    for (const PixelIndex place : places) windows.push_back(windows_of(place));
    build(neighborhood, rows, places, windows);
  }

  // The places whose projections are nearest to that of `query`, nearer than `limit`, nearest
  // first, equal ones by index; fills the front of `found` and returns how many.
  std::size_t nearest(const Windows& query, const RowSteps& rows, float limit,
                      std::span<NearPlace> found) const;

 private:
  static constexpr int kLeafPlaces = 16;
  static constexpr int kMostCoordinates = 16;

  // Samples of a window that count, side by side in one of its rows.
  struct Run {
    std::int32_t row;
    std::int32_t first;
    std::int32_t count;
  };

  struct Node {
    std::int32_t second = 0;  // child; the first is the next node; 0 for a leaf
    std::int32_t leaf = 0;    // number of the leaf, for a leaf
  };

  void build(const Neighborhood& neighborhood, const RowSteps& rows,
             const std::vector<PixelIndex>& places, const std::vector<Windows>& windows);
  void choose_components(const Neighborhood& neighborhood, const RowSteps& rows,
                         const std::vector<Windows>& windows);
  // Calls add(sample) for all samples that count, in a set order.
  template <typename Add>
  void for_each_sample(const Windows& windows, const RowSteps& rows, Add add) const;
  void project(const Windows& windows, const RowSteps& rows, float* projection) const;
  template <int kGroups>
  void project_groups(const Windows& windows, const RowSteps& rows, float* projection) const;
  void divide(std::int32_t node, std::size_t first_leaf, std::size_t leaves,
              std::span<std::int32_t> order, const std::vector<float>& projections, int depth);
  void keep_leaf(std::size_t leaf, std::span<const std::int32_t> order,
                 const std::vector<float>& projections);
  class FoundPlaces;
  void look_into(std::int32_t leaf, const float* point, FoundPlaces& places) const;
  float box_distance(std::int32_t node, const float* query) const;

  IndexSettings settings_;
  int width_ = 0;  // coordinates, in whole lanes
  std::vector<Run> fine_runs_;
  std::vector<Run> coarse_runs_;
  std::vector<float> means_;  // of each sample, and the roots of their weights
  std::vector<float> roots_;
  std::vector<float> basis_;  // [sample * width_ + component]
  int rest_ = 0;              // the coordinate that is the length of what is left
  std::vector<Node> nodes_;
  std::vector<float> boxes_;        // [node * 2 * width_]: lower corner, then upper
  std::vector<float> leaf_values_;  // [leaf][component][place]
  std::vector<PixelIndex> leaf_places_;
  std::vector<PixelIndex> places_;  // while it is built
};

}  // namespace libstyle::image
