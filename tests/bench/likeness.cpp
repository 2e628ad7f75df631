// SPDX-License-Identifier: Apache-2.0
// How like its example a style comes out, and how freely: a table for each example that is named.
//
//   likeness fixtures/styles/*.svg
//
// Columns: the distance of turning angles between what was drawn and the example (mean and largest
// of the seeds), and between the halves of the example; the median and the longest run and the
// least coverage, in shares of the example; walks that go round in circles. "new" is a line of
// twice the length of the example made from nothing, "along" an S of 1,200 px drawn again.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

#include "converters/svg/document_input.h"
#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/drawing_measures.h"
#include "libstyle/analogy/example_document.h"
#include "libstyle/analogy/synthesis.h"
#include "libstyle/analogy/synthesis_document.h"
#include "libstyle/base/parallel.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/path_segments.h"
#include "tests/support/curves.h"
#include "tests/support/repetition.h"

namespace libstyle {
namespace {

constexpr std::size_t kSeeds = 20;
constexpr double kInCircles = 0.5;

struct Trial {
  StyleMeasures measures;
  double repetition = 0;
};

Trial trial(CurveMeasure measure, const Example& example) {
  Trial result;
  result.repetition = repetition(measure.runs);
  result.measures = summarize({&measure, 1}, example);
  return result;
}

void print_row(const std::string& name, const char* kind, const std::vector<Trial>& trials) {
  double sum = 0, most = 0, median = 0, longest = 0, coverage = 1;
  int circles = 0;
  for (const Trial& one : trials) {
    const double distance = one.measures.turning_distance.value_or(0);
    sum += distance / kSeeds;
    most = std::max(most, distance);
    median += one.measures.median_run_share / kSeeds;
    longest = std::max(longest, one.measures.longest_run_share);
    coverage = std::min(coverage, one.measures.coverage);
    circles += one.repetition > kInCircles ? 1 : 0;
  }
  std::printf("%-24s %-6s %6.3f %6.3f %6.3f  %6.3f %6.3f  %5.2f  %2d\n", name.c_str(), kind, sum,
              most, trials[0].measures.turning_distance_of_halves.value_or(0), median, longest,
              coverage, circles);
}

CurveAnalogyParameters with_seed(std::size_t seed, Invariance invariance) {
  CurveAnalogyParameters parameters;
  parameters.seed = seed + 1;
  parameters.invariance = invariance;
  return parameters;
}

Trial make_new(const std::vector<ExamplePair>& examples, std::size_t seed) {
  double length = 0;
  for (const ExamplePair& example : examples) length += arc_length(example.filtered.polyline);
  const CurveSynthesis style(examples, with_seed(seed, Invariance::kTranslate));
  const SynthesizedCurve drawn = style.draw(2 * length, 0);
  StyledCurve curve;
  curve.curve = drawn.curve;
  curve.runs = drawn.runs;
  return trial(measure_new_curve(curve, to_path(drawn.curve)), style.example());
}

// Two half circles, 1,200 px.
Polyline s_curve() {
  constexpr double kPi = std::numbers::pi;
  const double radius = 600 / kPi;
  Polyline curve = arc({0, 0}, radius, kPi, 0, 200);
  const Polyline second = arc({2 * radius, 0}, radius, kPi, 2 * kPi, 200);
  curve.points.insert(curve.points.end(), second.points.begin() + 1, second.points.end());
  return curve;
}

Trial draw_along(const std::vector<ExamplePair>& pairs, std::size_t seed) {
  const CurveAnalogy style(pairs, with_seed(seed, Invariance::kRotate));
  const Polyline plain = s_curve();
  const StyledCurve drawn = style.draw(plain, {});
  return trial(measure_curve(plain, {}, drawn, to_path(drawn.curve)), style.example());
}

template <typename Try>
std::vector<Trial> all_seeds(Try attempt) {
  std::vector<Trial> trials(kSeeds);
  parallel_for(kSeeds, 0, [&](std::size_t seed) { trials[seed] = attempt(seed); });
  return trials;
}

void measure(const std::string& file) {
  DocumentInput input(file, {});
  Document document;
  input.read(document);
  const std::vector<ExamplePair> pairs = example_pairs(nullptr, document);
  const std::vector<ExamplePair> examples = synthesis_examples(pairs);
  print_row(document.header.name, "new",
            all_seeds([&](std::size_t seed) { return make_new(examples, seed); }));
  print_row(document.header.name, "along",
            all_seeds([&](std::size_t seed) { return draw_along(pairs, seed); }));
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  try {
    std::puts(
        "example                  kind     mean   most halves  median longest  seen  circles");
    for (int i = 1; i < argc; ++i) libstyle::measure(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "likeness: %s\n", error.what());
    return 1;
  }
}
