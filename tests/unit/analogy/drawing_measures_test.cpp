// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing_measures.h"

#include <gmock/gmock.h>

#include "libstyle/analogy/drawing.h"
#include "libstyle/analogy/style_summary.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/path_segments.h"
#include "tests/support/curves.h"
#include "tests/unit/analogy/wavy_drawing.h"

namespace libstyle {
namespace {

const CurveAnalogy& wavy_style() {
  static const CurveAnalogy style(wavy_pairs(), {});
  return style;
}

StyledCurve as_drawn(const Polyline& curve, std::vector<ChainRun> runs) {
  StyledCurve drawn;
  drawn.curve = curve;
  drawn.lengths = cumulative_lengths(curve);
  drawn.runs = std::move(runs);
  return drawn;
}

StyleMeasures measured(Document document, int threads = 1) {
  std::vector<StyleMeasures> measures;
  StylePlan plan;
  plan.styles.push_back({.analogy = &wavy_style()});
  plan.style_of_record.resize(document.records.size(), 0);
  draw_again(document, plan,
             {.threads = threads, .progress = {}, .warn = {}, .measures = &measures});
  return measures.at(0);
}

TEST(MeasureCurve, OfWhatIsWrittenAsItIsDrawnHasNoDistances) {
  const Polyline plain = polyline("0 0, 50 10, 100 0");
  const double held[] = {20, 70};
  const CurveMeasure measure =
      measure_curve(plain, held, as_drawn(plain, {{0, 1, 0}}), to_path(plain));
  EXPECT_LT(measure.fit_distance + measure.held_distance + measure.end_distance, 1e-9);
  EXPECT_EQ(measure.held, 2u);
  EXPECT_NEAR(measure.length, arc_length(plain), 1e-9);
}

TEST(MeasureCurve, SeesHowFarThingsAre) {
  const Polyline plain = polyline("0 0, 100 0"), drawn = polyline("0 5, 50 7, 100 5");
  const double held[] = {50};
  const CurveMeasure measure =
      measure_curve(plain, held, as_drawn(drawn, {{0, 1, 0}}), to_path(polyline("0 5, 100 5")));
  EXPECT_NEAR(measure.end_distance, 5, 1e-9);
  EXPECT_NEAR(measure.held_distance, 5, 1e-9);
  EXPECT_NEAR(measure.fit_distance, 2, 1e-9);
}

TEST(MeasureCurve, SeesEveryStroke) {
  const Polyline plain = polyline("0 0, 100 0"), first = polyline("0 0, 40 3"),
                 second = polyline("60 5, 100 0");
  StyledCurve drawn = as_drawn(plain, {{0, 1, 0}});
  drawn.strokes = {{first, {}, {}}, {second, {}, {}}};
  Path written = to_path(first);
  written.append(to_path(polyline("60 0, 100 0")));
  const CurveMeasure measure = measure_curve(plain, {}, drawn, written);
  EXPECT_NEAR(measure.fit_distance, 5, 1e-9);
  EXPECT_EQ(measure.end_distance, 0);
  EXPECT_EQ(measure.drawn, (std::vector{first, second}));
}

TEST(MeasureCurve, DoesNotCareWhereANewCurveIsWritten) {
  const Polyline drawn = polyline("0 0, 50 7, 100 0");
  const CurveMeasure measure =
      measure_new_curve(as_drawn(drawn, {{0, 1, 0}}), to_path(polyline("9 3, 59 10, 109 3")));
  EXPECT_LT(measure.fit_distance + measure.end_distance, 1e-9);
}

TEST(SummarizeMeasures, CountsRunsAndWhatIsSeen) {
  const Example& example = wavy_style().example();
  const auto states = static_cast<double>(example.state_count());
  CurveMeasure curve;
  curve.length = 10;
  curve.drawn = {polyline("0 0, 10 0")};
  curve.runs = {{0, 4, 2}, {4, 10, 0}, {14, 6, 20}};
  CurveMeasure kept;
  kept.length = 30;
  kept.is_kept = true;
  const CurveMeasure curves[] = {curve, kept};
  const StyleMeasures measures = summarize(curves, example);
  EXPECT_EQ(measures.runs, 3u);
  EXPECT_DOUBLE_EQ(measures.median_run, 6 * example.step());
  EXPECT_DOUBLE_EQ(measures.longest_run_share, 10 / states);
  EXPECT_DOUBLE_EQ(measures.coverage, 16 / states);
  EXPECT_EQ(measures.kept, 1u);
  EXPECT_DOUBLE_EQ(measures.mean_scale, 0.25);
  EXPECT_DOUBLE_EQ(measures.small_share, 0.75);
  EXPECT_FALSE(measures.turning_distance);  // too short
}

// The claims of the documentation, as the report has them.
TEST(DrawAgain, MeasuresWhatItDraws) {
  Document document;
  document.records.push_back(path_record("wall", "M0 0 L600 0"));
  document.records.push_back(path_record("door", "M110.5 0 C110.5 80 300 90 500 300"));
  document.records.push_back(path_record("dot", "M5 5"));
  const StyleMeasures measures = measured(document);
  EXPECT_EQ(measures.curves, 3u);
  EXPECT_EQ(measures.kept, 1u);
  EXPECT_EQ(measures.vertices_before, 5u);
  EXPECT_EQ(measures.end_distance, 0);
  EXPECT_EQ(measures.held, 1u);
  const double feature = wavy_style().example().feature_size();
  EXPECT_LT(measures.held_distance, 0.02 * feature);
  EXPECT_LT(measures.fit_distance, 0.015 * feature);
  EXPECT_GT(measures.fit_distance, 0);
  EXPECT_LT(measures.longest_run_share, 0.25);
  EXPECT_LT(measures.turning_distance.value(), 0.1);
  EXPECT_EQ(measures.mean_scale, 1);
}

TEST(DrawAgain, MeasuresTheSameOnAnyNumberOfThreads) {
  Document document;
  for (int i = 0; i < 12; ++i) {
    document.records.push_back(
        path_record("p" + std::to_string(i), "M0 " + std::to_string(9 * i) + " L400 7"));
  }
  const StyleMeasures one = measured(document, 1), three = measured(document, 3);
  EXPECT_EQ(one.turning_distance, three.turning_distance);
  EXPECT_EQ(one.fit_distance, three.fit_distance);
  EXPECT_EQ(one.mean_scale, three.mean_scale);
}

TEST(StyleSummary, SaysWhatTheExampleIs) {
  const StyleSummary summary = wavy_style().summary();
  EXPECT_EQ(summary.lines, 1u);
  EXPECT_NEAR(summary.filtered_length, arc_length(wavy_pairs()[0].filtered.polyline),
              0.005 * summary.filtered_length);
  EXPECT_NEAR(summary.unfiltered_length, 400, 15);
  EXPECT_NEAR(summary.feature_along / summary.feature_size,
              summary.unfiltered_length / summary.filtered_length, 0.01);
  EXPECT_DOUBLE_EQ(summary.mean_run, 8);
  EXPECT_NEAR(static_cast<double>(summary.states) * summary.step, summary.unfiltered_length,
              summary.step);
  EXPECT_GT(summary.jumping_share, 0.5);
  EXPECT_FALSE(summary.search);
}

}  // namespace
}  // namespace libstyle
