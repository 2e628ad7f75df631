// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/search_parameters.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "libstyle/analogy/greedy/softened_weight.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

TEST(SearchParameters, OfBothKindsAreValid) {
  EXPECT_NO_THROW(validate(SearchParameters{}));
  EXPECT_NO_THROW(validate(paper_parameters()));
}

TEST(SearchParameters, NameTheMemberThatIsOutOfRange) {
  using Change = std::function<void(SearchParameters&)>;
  const std::pair<const char*, Change> changes[] = {
      {"finest_spacing", [](auto& p) { p.finest_spacing = 0; }},
      {"samples", [](auto& p) { p.samples = 99; }},
      {"levels", [](auto& p) { p.levels = 65; }},
      {"coarsest_samples", [](auto& p) { p.coarsest_samples = 1; }},
      {"level_ratio", [](auto& p) { p.level_ratio = 1; }},
      {"binomial_order", [](auto& p) { p.binomial_order = 100; }},
      {"neighborhood_samples", [](auto& p) { p.neighborhood_samples = 103; }},
      {"sample_spacing", [](auto& p) { p.sample_spacing = 0; }},
      {"least_overlap", [](auto& p) { p.least_overlap = 1.1; }},
      {"tangent_weight", [](auto& p) { p.tangent_weight = -1; }},
      {"shape_weight", [](auto& p) { p.shape_weight = std::numeric_limits<double>::quiet_NaN(); }},
      {"coarse_weight", [](auto& p) { p.coarse_weight = 0; }},
      {"offset_weight", [](auto& p) { p.offset_weight = 0; }},
      {"synthesis_offset_weight", [](auto& p) { p.synthesis_offset_weight = -1; }},
      {"position_weight", [](auto& p) { p.position_weight = 0; }},
      {"coherence", [](auto& p) { p.coherence = std::numeric_limits<double>::infinity(); }},
      {"step", [](auto& p) { p.step = 0; }},
      {"epsilon", [](auto& p) { p.epsilon = -0.1; }},
      {"floor_quantile", [](auto& p) { p.floor_quantile = 2; }},
      {"random_levels", [](auto& p) { p.random_levels = -1; }},
      {"fine_epsilon", [](auto& p) { p.fine_epsilon = -1; }},
      {"coarsest_passes", [](auto& p) { p.coarsest_passes = -1; }},
      {"passes", [](auto& p) { p.passes = 0; }},
      {"longest_growth", [](auto& p) { p.longest_growth = 1; }}};
  for (const auto& [name, change] : changes) {
    SearchParameters p;
    change(p);
    try {
      validate(p);
      ADD_FAILURE() << name << " passes";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(std::string("SearchParameters.") + name + " "));
    }
  }
}

// With L = 7: 1/7 at the coarsest, 1 next to the finest, and hard at the finest.
TEST(SoftenedWeight, FallsTowardsTheCoarseLevels) {
  EXPECT_DOUBLE_EQ(*softened_weight(std::nullopt, 7), 1.0 / 7);
  EXPECT_DOUBLE_EQ(*softened_weight(std::nullopt, 1), 1);
  EXPECT_FALSE(softened_weight(std::nullopt, 0));
  EXPECT_DOUBLE_EQ(*softened_weight(4, 0), 4);
  EXPECT_DOUBLE_EQ(*softened_weight(4, 1), 0.8);
  EXPECT_LT(*softened_weight(4, 2), *softened_weight(4, 1));
}

TEST(PassRandom, TellsPlacesLevelsAndPassesApart) {
  const std::uint64_t first = pass_random(1, 0, 0, 0).bits(0);
  EXPECT_NE(first, pass_random(2, 0, 0, 0).bits(0));
  EXPECT_NE(first, pass_random(1, 1, 0, 0).bits(0));
  EXPECT_NE(first, pass_random(1, 0, 1, 0).bits(0));
  EXPECT_NE(first, pass_random(1, 0, 0, 1).bits(0));
}

}  // namespace
}  // namespace libstyle
