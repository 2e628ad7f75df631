// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/jump_costs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

TEST(JumpCosts, FindThePhaseOfAWave) {
  const ExamplePair pair = wave_pair(400);
  const Example example({&pair, 1}, {});
  JumpCosts costs(example);
  std::vector<double> row(example.state_count());
  const auto whole_wave = static_cast<std::size_t>(std::lround(20 / example.step()));
  const std::size_t from = example.state_count() / 2;
  costs.from_start_of(from, row);
  EXPECT_EQ(row[from], 0);
  EXPECT_LT(row[from - whole_wave], 1);
  EXPECT_GT(row[from - whole_wave / 2], 25);
}

TEST(JumpCosts, EndsAreComparedByWhatIsThere) {
  const ExamplePair pair = wave_pair(400);
  const Example example({&pair, 1}, {});
  JumpCosts costs(example);
  std::vector<double> row(example.state_count());
  costs.from_end_of(example.state_count() - 1, row);
  // The end of the wave has the phase of the places whole waves before it.
  const auto best = std::ranges::min_element(row.begin(), row.end() - 10) - row.begin();
  const double waves = (400 - example.length_of(static_cast<std::size_t>(best))) / 20;
  EXPECT_NEAR(waves, std::round(waves), 0.1);
}

TEST(JumpCosts, WidthsThatDifferCostAsMuchAsTheySpread) {
  ExamplePair pair = wave_pair(400);
  pair.features = {{"width", FeatureKind::kLength}};
  std::vector<double>& widths = pair.filtered.channels.emplace_back();
  // Whole waves in turn thin and thick.
  for (const Point p : pair.filtered.polyline.points) {
    widths.push_back(3 + std::sin(2 * std::numbers::pi * p.x / 40));
  }
  const auto costs_of = [](const ExamplePair& from_pair, int waves) {
    const Example example({&from_pair, 1}, {});
    std::vector<double> row(example.state_count());
    JumpCosts(example).from_start_of(example.state_count() / 2, row);
    const auto steps = static_cast<std::size_t>(std::lround(20 * waves / example.step()));
    return row[example.state_count() / 2 - steps];
  };
  EXPECT_GT(costs_of(pair, 1), 5 * costs_of(pair, 2));
  const double thin = costs_of(pair, 1);
  for (double& width : widths) width = 100 * width + 7;
  EXPECT_NEAR(costs_of(pair, 1), thin, 1e-6 * thin);
  for (double& width : widths) width = 5;
  EXPECT_LT(costs_of(pair, 1), 1);
}

// The definition, sample by sample, from place a along one line to place b along another.
double literal_cost(const Example& example, const ExampleLine& line_a, double a,
                    const ExampleLine& line_b, double b, int fine) {
  const double spacing = example.step() / fine;
  double sum = 0, weights = 0;
  for (int tap = -100; tap <= 100; ++tap) {
    const double off = tap * spacing;
    if (std::abs(off) > 2 * example.feature_along() + 1e-9) continue;
    const auto is_there = [&](const ExampleLine& line, double length) {
      const double slack = 1e-9 * line.length();
      return line.goes_round() || (length >= -slack && length <= line.length() + slack);
    };
    if (!is_there(line_a, a + off) || !is_there(line_b, b + off)) continue;
    const ExampleLine::Sample p = line_a.at(a + off), q = line_b.at(b + off);
    const double size = example.feature_size();
    const double weight = std::exp(-0.5 * std::pow(off / example.feature_along(), 2));
    sum += weight *
           (squared_norm(p.offset - q.offset) + size * size * squared_norm(p.tangent - q.tangent));
    weights += weight;
  }
  return sum / weights;
}

// All starts and ends of some states against all states.
void expect_literal_costs(const Example& example, int fine) {
  JumpCosts costs(example);
  std::vector<double> row(example.state_count());
  const double largest = 10 * squared_norm(Vector{example.reach(), example.feature_size()});
  for (std::size_t j = 0; j < row.size(); j += 1 + row.size() / 40) {
    for (const double after : {0.0, example.step()}) {
      after == 0 ? costs.from_start_of(j, row) : costs.from_end_of(j, row);
      const double place = example.length_of(j) + after;
      for (std::size_t k = 0; k < row.size(); ++k) {
        const double literal = literal_cost(example, example.line(j), place, example.line(k),
                                            example.length_of(k), fine);
        ASSERT_NEAR(row[k], literal, 1e-9 * largest) << j << " + " << after << " -> " << k;
      }
    }
  }
}

TEST(JumpCosts, AreThoseOfTheDefinition) {
  const ExamplePair pairs[] = {wave_pair(300), wave_pair(160, 1)};
  expect_literal_costs(Example(pairs, {}), 1);
  ExamplePair ring{std::nullopt, with_length_parameter(circle({0, 0}, 60, 200))};
  RandomValues random(3);
  ring.filtered.polyline = with_noise(ring.filtered.polyline, random, 1);
  expect_literal_costs(Example({&ring, 1}, {}), 1);
}

// So many features that a step is longer than the distance between samples.
TEST(JumpCosts, AreThoseOfTheDefinitionOnAFinerGrid) {
  CurveAnalogyParameters parameters;
  parameters.feature_size = 0.5;
  const ExamplePair pair = wave_pair(2500);
  const Example example({&pair, 1}, parameters);
  const int fine = static_cast<int>(std::lround(4 * example.step() / example.feature_along()));
  ASSERT_GT(fine, 2);
  expect_literal_costs(example, fine);
}

}  // namespace
}  // namespace libstyle
