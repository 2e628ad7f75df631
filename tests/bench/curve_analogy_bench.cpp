// SPDX-License-Identifier: Apache-2.0
// The search and the chain against the listings of the paper, on one analogy: a wave on a hill, all
// of `range(0)` spacings long. "cost" is E(B') of Eq. 6 at the finest level, by the listings, for
// each vertex; "turning" how far the turning angles of B' are from those of A', in radians. The
// style is prepared in the time too.
#include <benchmark/benchmark.h>

#include <cmath>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/greedy/greedy_search.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian_pyramid.h"
#include "libstyle/geometry/turning_statistics.h"
#include "tests/bench/literal/literal_search.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

struct Analogy {
  SampledCurve a, a_filtered, b;

  explicit Analogy(double spacings) {
    const double length = spacings * kFinestSpacing;
    a_filtered = wave(0.6 * length, 12, 2, 3000);
    const double factor = length / arc_length(a_filtered.polyline);
    for (Point& p : a_filtered.polyline.points) p *= factor;
    a = straight(a_filtered.polyline.points.back().x, 400);
    b = with_length_parameter(wave(a.polyline.points.back().x, 200, 15, 400).polyline);
  }

  double cost_for_vertex(const SampledCurve& drawn) const {
    const GaussianPyramidParams finest{kFinestSpacing, 1.2, 1};
    literal::Level level;
    level.filtered = gaussian_pyramid(a_filtered, finest)[0].curve;
    level.sources = {
        {gaussian_pyramid(a, finest)[0].curve, gaussian_pyramid(b, finest)[0].curve, 0}};
    level.offset_weight = paper_parameters().offset_weight;
    return literal::curve_cost(level, drawn, paper_parameters()) /
           static_cast<double>(drawn.size());
  }
};

void count_turning(benchmark::State& state, const Analogy& analogy, const Polyline& drawn) {
  state.counters["turning"] = turning_distance(drawn, analogy.a_filtered.polyline, kFinestSpacing);
}

void draw_literally(benchmark::State& state) {
  const Analogy analogy(static_cast<double>(state.range(0)));
  literal::CopiedCurve drawn;
  for (auto _ : state) {
    drawn = literal::synthesize_analogy_multires(analogy.a, analogy.a_filtered, analogy.b, {},
                                                 paper_parameters());
  }
  state.counters["cost"] = analogy.cost_for_vertex(drawn.curve);
  count_turning(state, analogy, drawn.curve.polyline);
}

void search(benchmark::State& state, SearchParameters parameters) {
  parameters.finest_spacing = kFinestSpacing;
  const Analogy analogy(static_cast<double>(state.range(0)));
  const SearchExample example{analogy.a, analogy.a_filtered};
  SearchedCurve drawn;
  for (auto _ : state) drawn = GreedySearch({&example, 1}, parameters).draw(analogy.b);
  state.counters["cost"] = analogy.cost_for_vertex(drawn.curve);
  count_turning(state, analogy, drawn.curve.polyline);
}

void draw_faithfully(benchmark::State& state) { search(state, paper_parameters()); }
void draw_greedily(benchmark::State& state) { search(state, SearchParameters{}); }

void draw_by_chain(benchmark::State& state) {
  const Analogy analogy(static_cast<double>(state.range(0)));
  const ExamplePair pair{
      .unfiltered = analogy.a, .filtered = analogy.a_filtered, .same_parameter = true};
  Polyline drawn;
  for (auto _ : state) drawn = draw_by_analogy(pair, analogy.b.polyline).curve;
  count_turning(state, analogy, drawn);
}

BENCHMARK(draw_literally)->Arg(300)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_faithfully)->Arg(300)->Arg(1200)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_greedily)->Arg(300)->Arg(1200)->Unit(benchmark::kMillisecond);
BENCHMARK(draw_by_chain)->Arg(300)->Arg(1200)->Arg(4800)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace libstyle
