// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/geometry/arc_length.h"
#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

// The wave in a width that wanders too, and with the length along the line.
ExamplePair brush_pair() {
  ExamplePair pair = wavy_pair();
  pair.features = {{"width", FeatureKind::kLength}, {"x", FeatureKind::kNumber}};
  pair.filtered.channels.resize(2);
  for (const Point p : pair.filtered.polyline.points) {
    pair.filtered.channels[0].push_back(3 + std::sin(p.x / 17) + 0.5 * std::sin(p.x / 7));
    pair.filtered.channels[1].push_back(p.x);
  }
  return pair;
}

TEST(CurveAnalogy, AnExampleThatChangesNothingGivesBackItsFeatures) {
  RandomValues random(8);
  ExamplePair pair;
  pair.filtered = with_length_parameter(random_stroke(random, 600));
  pair.unfiltered = pair.filtered;
  pair.same_parameter = true;
  pair.features = {{"width", FeatureKind::kLength}};
  pair.filtered.channels = {{}};
  for (const double t : pair.filtered.t) {
    pair.filtered.channels[0].push_back(3 + 2 * std::sin(40 * t));
  }
  CurveAnalogyParameters parameters;
  parameters.shape_weight = 2;
  parameters.smallest_scale = 1;
  const StyledCurve drawn = draw_by_analogy(pair, pair.filtered.polyline, parameters);
  ASSERT_EQ(drawn.runs.size(), 1u);
  ASSERT_EQ(drawn.features[0].size(), drawn.curve.points.size());
  const double length = drawn.lengths.back();
  for (std::size_t i = 0; i < drawn.lengths.size(); ++i) {
    EXPECT_NEAR(drawn.features[0][i], 3 + 2 * std::sin(40 * drawn.lengths[i] / length), 0.05);
  }
}

TEST(CurveAnalogy, FeaturesComeFromWhereTheShapeComesFrom) {
  const ExamplePair pair = brush_pair();
  const CurveAnalogy style({&pair, 1}, {});
  const Example& example = style.example();
  const Polyline line = polyline("0 0, 1000 0");
  for_each_seed(10, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(line, {seed});
    const double step =
        1000 / static_cast<double>(drawn.runs.back().first + drawn.runs.back().steps);
    for (const ChainRun& run : drawn.runs) {
      // In the middle of a run nothing fades.
      if (run.steps < 6) continue;
      const double middle = static_cast<double>(run.steps) / 2;
      const double length = (static_cast<double>(run.first) + middle) * step;
      const auto i = std::ranges::lower_bound(drawn.lengths, length) - drawn.lengths.begin();
      const double x = example.length_of(run.origin) + middle * example.step();
      EXPECT_NEAR(drawn.features[1][static_cast<std::size_t>(i)], x, 1);
    }
  });
}

// The mean difference of the widths of the example where one run follows another.
double mean_leap(const CurveAnalogy& style) {
  const Example& example = style.example();
  const auto width = [](double x) { return 3 + std::sin(x / 17) + 0.5 * std::sin(x / 7); };
  double sum = 0, count = 0;
  for (std::uint64_t place = 0; place < 20; ++place) {
    const std::vector<ChainRun> runs = style.draw(polyline("0 0, 1500 0"), {place}).runs;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      const double from = example.length_of(runs[i - 1].origin) +
                          example.step() * static_cast<double>(runs[i - 1].steps);
      sum += std::abs(width(from) - width(example.length_of(runs[i].origin)));
      count += 1;
    }
  }
  return sum / count;
}

TEST(CurveAnalogy, WidthsDoNotLeap) {
  const ExamplePair brush = brush_pair();
  ExamplePair plain = brush;
  plain.features.clear();
  plain.filtered.channels.clear();
  EXPECT_LT(mean_leap(CurveAnalogy({&brush, 1}, {})),
            0.6 * mean_leap(CurveAnalogy({&plain, 1}, {})));
}

TEST(CurveAnalogy, WidthsAreThoseOfTheExample) {
  const ExamplePair pair = brush_pair();
  const CurveAnalogy style({&pair, 1}, {});
  const FeatureStatistics& widths = style.example().statistics(0);
  for_each_seed(10, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(polyline("0 0, 1500 0"), {seed});
    const std::vector<double>& own = drawn.features[0];
    double sum = 0;
    for (std::size_t i = 1; i < own.size(); ++i) {
      sum += own[i] * (drawn.lengths[i] - drawn.lengths[i - 1]);
    }
    EXPECT_NEAR(sum / 1500, widths.mean, 0.3 * widths.spread);
    EXPECT_LE(std::ranges::max(own), widths.extent);
  });
}

TEST(CurveAnalogy, WidthsHaveTheSizeOfTheStyleAndNumbersNone) {
  const ExamplePair pair = brush_pair();
  CurveAnalogyParameters large;
  large.scale = 3;
  const StyledCurve once = draw_by_analogy(pair, polyline("0 0, 500 0"));
  const StyledCurve thrice = draw_by_analogy(pair, polyline("0 0, 1500 0"), large);
  ASSERT_EQ(once.curve.points.size(), thrice.curve.points.size());
  for (std::size_t i = 0; i < once.curve.points.size(); ++i) {
    EXPECT_NEAR(thrice.features[0][i], 3 * once.features[0][i], 1e-6);
    EXPECT_NEAR(thrice.features[1][i], once.features[1][i], 1e-6);
  }
  // A line without room has all of the style smaller.
  const StyledCurve small = draw_by_analogy(pair, polyline("0 0, 10 0"));
  ASSERT_LT(small.mean_scale, 0.5);
  for (const double width : small.features[0]) {
    EXPECT_LE(width, small.mean_scale * 4.5);
    EXPECT_GE(width, small.mean_scale * 1.5);
  }
}

TEST(CurveAnalogy, TheGreedySearchCopiesFeaturesToo) {
  const ExamplePair pair = brush_pair();
  CurveAnalogyParameters parameters;
  parameters.method = AnalogyMethod::kGreedy;
  const StyledCurve drawn = draw_by_analogy(pair, polyline("0 0, 300 0"), parameters);
  ASSERT_EQ(drawn.features[0].size(), drawn.curve.points.size());
  for (std::size_t i = 0; i < drawn.curve.points.size(); ++i) {
    const double x = drawn.features[1][i];
    EXPECT_NEAR(drawn.features[0][i], 3 + std::sin(x / 17) + 0.5 * std::sin(x / 7), 0.05);
  }
}

// ---- Values along closed examples ---------------------------------------------------------------

TEST(ExampleLine, ValuesAlongAClosedExampleGoRound) {
  ExamplePair pair{std::nullopt, with_length_parameter(circle({0, 0}, 40, 120))};
  pair.features = {{"pressure", FeatureKind::kNumber}};
  pair.filtered.channels.resize(1);
  for (const double t : pair.filtered.t) pair.filtered.channels[0].push_back(t * (1 - t));
  const Example example({&pair, 1}, {});
  const ExampleLine& line = example.lines()[0];
  ASSERT_TRUE(line.goes_round());
  for (const double length : {1.0, 100.0, line.length() - 1}) {
    for (const double turn : {-1.0, 1.0, 2.0}) {
      EXPECT_NEAR(line.lane(0).features_at(length + turn * line.length())[0],
                  line.lane(0).features_at(length)[0], 1e-9);
    }
  }
  EXPECT_GT(line.lane(0).features_at(1.5 * line.length())[0], 0.2);
}

}  // namespace
}  // namespace libstyle
