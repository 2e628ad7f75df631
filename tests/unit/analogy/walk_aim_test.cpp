// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/walk_aim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/jump_model.h"
#include "libstyle/geometry/sampled_curve.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

constexpr std::size_t kSteps = 120;

Example stroke_example() {
  RandomValues random(5);
  const SampledCurve stroke = with_length_parameter(random_stroke(random, 600));
  const ExamplePair pair{stroke, stroke, true};
  CurveAnalogyParameters parameters;
  parameters.samples = 300;
  parameters.feature_size = 6;
  return {{&pair, 1}, parameters};
}

// The move of a walk over two stretches of equal length.
std::vector<Vector> moves_of(const Example& example, const std::vector<ChainState>& walk) {
  std::vector<Vector> moves(2);
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const ExampleLine& line = example.line(walk[i]);
    const double from = example.length_of(walk[i]);
    moves[2 * i / kSteps] += line.filtered_at(from + example.step()) - line.filtered_at(from);
  }
  return moves;
}

TEST(WalkAim, LearnsToGetWhereItShould) {
  const Example example = stroke_example();
  const JumpModel jumps = make_jump_model(example, {.mean_run = 2});
  const double far = 0.3 * kSteps / 2 * example.step();
  const WalkAim::Stretch stretches[] = {{0, kSteps / 2, {far, 0}}, {kSteps / 2, kSteps, {0, -far}}};
  double free = 0, aimed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    WalkAim aim(example, stretches);
    const auto miss = [&](std::uint64_t first_place) {
      ChainTask task;
      task.steps = kSteps;
      task.costs = [&](std::size_t step, std::span<double> costs) { return aim.add(step, costs); };
      const std::vector<Vector> moves =
          moves_of(example, sample_chain(jumps.chain, task, RandomStream(seed, 0), first_place));
      aim.correct(moves);
      return distance(moves[0], stretches[0].move) + distance(moves[1], stretches[1].move);
    };
    free += miss(0);
    for (std::uint64_t i = 1; i < 10; ++i) miss(i << 32);
    aimed += miss(std::uint64_t{10} << 32);
  }
  EXPECT_LT(aimed, 0.8 * free);
}

}  // namespace
}  // namespace libstyle
