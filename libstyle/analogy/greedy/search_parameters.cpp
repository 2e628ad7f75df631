// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/search_parameters.h"

#include <cmath>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

void require(bool holds, const char* member, double value, const char* range) {
  if (holds && std::isfinite(value)) return;
  std::string given = "not a finite number";
  if (std::isfinite(value)) {
    given.clear();
    append_number(given, value);
  }
  throw Error(std::string("SearchParameters.") + member + " is " + given + "; give " + range);
}

void validate_neighborhoods(const SearchParameters& p) {
  require(p.binomial_order >= 3 && p.binomial_order <= 401 && p.binomial_order % 2 == 1,
          "binomial_order", p.binomial_order, "an odd number, 3 to 401");
  require(p.neighborhood_samples >= 3 && p.neighborhood_samples <= p.binomial_order &&
              p.neighborhood_samples % 2 == 1,
          "neighborhood_samples", p.neighborhood_samples, "an odd number, 3 to binomial_order");
  require(p.sample_spacing > 0, "sample_spacing", p.sample_spacing, "more than 0");
  require(p.least_overlap > 0 && p.least_overlap <= 1, "least_overlap", p.least_overlap,
          "more than 0, at most 1");
}

void validate_pyramid(const SearchParameters& p) {
  if (p.finest_spacing) {
    require(*p.finest_spacing > 0, "finest_spacing", *p.finest_spacing, "more than 0 px");
  }
  require(p.samples >= 100 && p.samples <= 20000, "samples", p.samples, "100 to 20000");
  if (p.levels) require(*p.levels >= 1 && *p.levels <= 64, "levels", *p.levels, "1 to 64");
  require(p.coarsest_samples >= 20 && p.coarsest_samples <= 10000, "coarsest_samples",
          p.coarsest_samples, "20 to 10000");
  require(p.level_ratio > 1 && p.level_ratio <= 4, "level_ratio", p.level_ratio,
          "more than 1, at most 4");
}

void validate_cost(const SearchParameters& p) {
  require(p.tangent_weight >= 0, "tangent_weight", p.tangent_weight, "0 or more");
  require(p.shape_weight >= 0, "shape_weight", p.shape_weight, "0 or more");
  require(p.coarse_weight > 0, "coarse_weight", p.coarse_weight, "more than 0");
  require(p.offset_weight > 0, "offset_weight", p.offset_weight, "more than 0");
  require(p.synthesis_offset_weight >= 0, "synthesis_offset_weight", p.synthesis_offset_weight,
          "0 or more");
  require(p.position_weight > 0, "position_weight", p.position_weight, "more than 0");
  require(p.coherence >= 0, "coherence", p.coherence, "0 or more");
}

void validate_search(const SearchParameters& p) {
  require(p.step > 0, "step", p.step, "more than 0");
  require(p.epsilon >= 0, "epsilon", p.epsilon, "0 or more");
  require(p.floor_quantile >= 0 && p.floor_quantile <= 1, "floor_quantile", p.floor_quantile,
          "0 to 1");
  require(p.random_levels >= 0 && p.random_levels <= 64, "random_levels", p.random_levels,
          "0 to 64");
  require(p.fine_epsilon >= 0, "fine_epsilon", p.fine_epsilon, "0 or more");
  require(p.coarsest_passes >= 0 && p.coarsest_passes <= 100, "coarsest_passes", p.coarsest_passes,
          "0 to 100");
  require(p.passes >= 1 && p.passes <= 100, "passes", p.passes, "1 to 100");
  require(p.longest_growth > 1, "longest_growth", p.longest_growth, "more than 1");
}

}  // namespace

SearchParameters paper_parameters() {
  SearchParameters p;
  p.finest_spacing = 0.5;
  p.levels = 8;
  p.neighborhood_samples = p.binomial_order;
  p.sample_spacing = 0.25;
  p.least_overlap = 0.6;
  p.coherence = 0.5;
  p.coherence_of_finest = false;
  p.coherence_both_ways = false;
  p.random_levels = 1;
  p.fine_epsilon = p.epsilon;
  p.passes = 1;
  p.alternate_passes = false;
  p.detail_transfer = false;
  return p;
}

void validate(const SearchParameters& parameters) {
  validate_pyramid(parameters);
  validate_neighborhoods(parameters);
  validate_cost(parameters);
  validate_search(parameters);
}

}  // namespace libstyle
