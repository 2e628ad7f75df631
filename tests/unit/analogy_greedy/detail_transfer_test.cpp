// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/detail_transfer.h"

#include <gtest/gtest.h>

#include "libstyle/geometry/gaussian_pyramid.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

SearchParameters parameters() {
  SearchParameters p;
  p.binomial_order = 21;
  p.neighborhood_samples = 11;
  return p;
}

// Two levels of one example, the coarse one much blurred.
struct TwoLevels {
  SearchParameters p = parameters();
  std::vector<GaussianPyramidLevel> pyramid;
  LevelExample coarse, fine;

  explicit TwoLevels(const SampledCurve& curve)
      : pyramid(gaussian_pyramid(curve, {kFinestSpacing, 3, 2})),
        coarse({{pyramid[0].curve, {}}}, {}, pyramid[0].spacing, false, p),
        fine({{pyramid[1].curve, {}}}, {}, pyramid[1].spacing, false, p) {}

  // Places [begin, end) of the coarse example, copied as they are.
  DrawnLevel copy(std::size_t begin, std::size_t end) const {
    DrawnLevel drawn;
    for (std::size_t j = begin; j < end; ++j) {
      drawn.curve.polyline.points.push_back(pyramid[0].curve.polyline.points[j]);
      drawn.curve.t.push_back(pyramid[0].curve.t[j]);
      drawn.sources.push_back(j);
      drawn.rotations.push_back({1, 0});
    }
    return drawn;
  }
};

TEST(DetailTransfer, MakesTheFineExampleOfTheCoarseOne) {
  const TwoLevels levels(wave(60, 12, 2));
  const DrawnLevel drawn = levels.copy(0, levels.coarse.size());
  const DrawnLevel fine = transfer_detail(levels.coarse, levels.fine, drawn, {});
  for (std::size_t i = 0; i < fine.curve.size(); ++i) {
    EXPECT_THAT(fine.curve.polyline.points[i],
                PointNear(point_at_parameter(levels.pyramid[1].curve, fine.curve.t[i]), 1e-9));
    EXPECT_NEAR(levels.fine.parameter_of(fine.sources[i]), fine.curve.t[i], 0.01);
  }
  EXPECT_NEAR(arc_length(fine.curve.polyline), levels.fine.length(), 0.01 * levels.fine.length());
}

TEST(DetailTransfer, TurnsDetailAsThePieceIsTurned) {
  const TwoLevels levels(wave(60, 12, 2));
  DrawnLevel drawn = levels.copy(3, levels.coarse.size() - 3);
  const DrawnLevel straight = transfer_detail(levels.coarse, levels.fine, drawn, {});
  drawn.curve = turned(drawn.curve, 1);
  for (Vector& rotation : drawn.rotations) rotation = {std::cos(1.0), std::sin(1.0)};
  const DrawnLevel all = transfer_detail(levels.coarse, levels.fine, drawn, {});
  ASSERT_EQ(all.curve.size(), straight.curve.size());
  EXPECT_LT(greatest_distance(all.curve.polyline, turned(straight.curve, 1).polyline), 1e-9);
}

TEST(DetailTransfer, HasAVertexAtEveryKeptParameter) {
  const TwoLevels levels(wave(60, 12, 2));
  const double kept[] = {0.7, 0, 0.123, 1};
  const DrawnLevel fine =
      transfer_detail(levels.coarse, levels.fine, levels.copy(0, levels.coarse.size()), kept);
  for (const double t : kept) {
    EXPECT_EQ(std::ranges::count(fine.curve.t, t), 1) << t;
  }
  EXPECT_TRUE(std::ranges::is_sorted(fine.curve.t));
}

// Two pieces that do not continue each other: no vertex is far from both.
TEST(DetailTransfer, FadesBetweenPieces) {
  const TwoLevels levels(wave(60, 12, 2));
  DrawnLevel drawn = levels.copy(5, 10);
  DrawnLevel other = levels.copy(20, 25);
  const Vector shift = drawn.curve.polyline.points.back() - other.curve.polyline.points[0] +
                       Vector{levels.coarse.spacing(), 0};
  for (std::size_t i = 0; i < other.curve.size(); ++i) {
    drawn.curve.polyline.points.push_back(other.curve.polyline.points[i] + shift);
    drawn.curve.t.push_back(drawn.curve.t[4] + 0.02 * static_cast<double>(i + 1));
    drawn.sources.push_back(other.sources[i]);
    drawn.rotations.push_back({1, 0});
  }
  const DrawnLevel fine = transfer_detail(levels.coarse, levels.fine, drawn, {});
  for (std::size_t i = 0; i + 1 < fine.curve.size(); ++i) {
    EXPECT_LT(distance(fine.curve.polyline.points[i], fine.curve.polyline.points[i + 1]),
              3 * levels.fine.spacing());
  }
}

TEST(DetailTransfer, KeepsClosedCurvesClosed) {
  const TwoLevels levels(with_length_parameter(circle({}, 12, 300)));
  DrawnLevel drawn = levels.copy(0, levels.coarse.size());
  drawn.curve.polyline.closed = true;
  const DrawnLevel fine = transfer_detail(levels.coarse, levels.fine, drawn, {});
  EXPECT_TRUE(fine.curve.polyline.closed);
  for (std::size_t i = 0; i < segment_count(fine.curve.polyline); ++i) {
    EXPECT_NEAR(
        distance(segment_start(fine.curve.polyline, i), segment_end(fine.curve.polyline, i)),
        levels.fine.spacing(), 0.2 * levels.fine.spacing());
  }
}

}  // namespace
}  // namespace libstyle
