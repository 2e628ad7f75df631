// SPDX-License-Identifier: Apache-2.0
// The geometry that every system leans on, at 1e5 points.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "libstyle/geometry/cubic_fit.h"
#include "libstyle/geometry/gaussian.h"
#include "libstyle/geometry/junctions.h"
#include "libstyle/geometry/sampled_curve.h"
#include "libstyle/geometry/segment_grid.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

constexpr std::size_t kPoints = 100000;

Polyline shaky_stroke(double noise) {
  RandomValues random(1);
  return with_noise(random_stroke(random, kPoints), random, noise);
}

// Strokes of 100 points strewn so that each meets some others.
std::vector<Polyline> many_strokes() {
  RandomValues random(2);
  std::vector<Polyline> curves;
  for (std::size_t i = 0; i < kPoints / 100; ++i) {
    Polyline stroke = random_stroke(random, 100);
    const Vector offset{random.uniform(0, 700), random.uniform(0, 700)};
    for (Point& point : stroke.points) point += offset;
    curves.push_back(std::move(stroke));
  }
  return curves;
}

// Noise in hundredths of the spacing.
void BM_FitCubics(benchmark::State& state) {
  const Polyline stroke = shaky_stroke(0.01 * static_cast<double>(state.range(0)));
  std::size_t segments = 0;
  for (auto _ : state) segments = fit_cubics(stroke, {.tolerance = 0.5}).points.size() - 1;
  state.counters["segments"] = static_cast<double>(segments);
}
BENCHMARK(BM_FitCubics)->Arg(0)->Arg(10)->Unit(benchmark::kMillisecond);

// Sigma in tenths of the spacing.
void BM_GaussianBlur(benchmark::State& state) {
  const Polyline stroke = shaky_stroke(0.1);
  const double sigma = 0.1 * static_cast<double>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(gaussian_blur(stroke, sigma));
}
BENCHMARK(BM_GaussianBlur)->Arg(1)->Arg(10)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond);

void BM_Resample(benchmark::State& state) {
  const SampledCurve curve = with_length_parameter(shaky_stroke(0.1));
  for (auto _ : state) benchmark::DoNotOptimize(resample(curve, 1));
}
BENCHMARK(BM_Resample)->Unit(benchmark::kMillisecond);

void BM_Crossings(benchmark::State& state) {
  const std::vector<Polyline> curves = many_strokes();
  std::size_t crossings = 0;
  for (auto _ : state) crossings = SegmentGrid(curves).crossings().size();
  state.counters["crossings"] = static_cast<double>(crossings);
}
BENCHMARK(BM_Crossings)->Unit(benchmark::kMillisecond);

void BM_Nearest(benchmark::State& state) {
  const std::vector<Polyline> curves = many_strokes();
  const SegmentGrid grid(curves);
  RandomValues random(3);
  for (auto _ : state) {
    const double x = random.uniform(0, 700);
    benchmark::DoNotOptimize(grid.nearest({x, random.uniform(0, 700)}));
  }
}
BENCHMARK(BM_Nearest)->Unit(benchmark::kMicrosecond);

void BM_Junctions(benchmark::State& state) {
  const std::vector<Polyline> curves = many_strokes();
  for (auto _ : state) benchmark::DoNotOptimize(find_junctions(curves));
}
BENCHMARK(BM_Junctions)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace libstyle
