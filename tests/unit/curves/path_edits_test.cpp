// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/path_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/geometry/bezier.h"
#include "libstyle/geometry/path_data.h"
#include "libstyle/geometry/path_segments.h"
#include "tests/support/seeds.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;

PathRecord path(std::string_view data, std::string id = "a") {
  PathRecord record;
  record.id = std::move(id);
  record.path = parse_path_data(data);
  return record;
}

const PathRecord& path_at(const Document& document, std::size_t place) {
  return std::get<PathRecord>(document.records[place]);
}

// --- Splitting ----------------------------------------------------------------------------------

TEST(SplitSubpaths, MakesARecordOfEach) {
  Document document = {{}, {path("M0 0 L1 1 M2 2 C3 3 4 4 5 5 Z M6 6")}};
  split_subpaths(document);
  ASSERT_EQ(document.records.size(), 3u);
  EXPECT_EQ(to_path_data(path_at(document, 0).path), "M0 0 L1 1");
  EXPECT_EQ(to_path_data(path_at(document, 1).path), "M2 2 C3 3 4 4 5 5 Z");
  EXPECT_EQ(to_path_data(path_at(document, 2).path), "M6 6");
}

TEST(SplitSubpaths, LeavesSinglePathsAndOtherRecordsAlone) {
  const Document before = {{}, {GroupRecord(), path("M0 0 L1 1 Z"), PathRecord()}};
  Document after = before;
  split_subpaths(after);
  EXPECT_EQ(after, before);
}

TEST(SplitSubpaths, GivesEachPieceTheStyleAndItsShareOfTheValues) {
  PathRecord whole = path("M0 0 L1 1 M2 2 C3 3 4 4 5 5 Z M6 6");
  whole.style.stroke_width = 7;
  whole.parent = "g";
  whole.along.channels = {{"width", {1, 2, 3, 4, 5}}};
  whole.along.colors = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}};
  Document document = {{}, {whole}};
  split_subpaths(document);
  EXPECT_THAT(path_at(document, 0).along.channels[0].values, ElementsAre(1, 2));
  EXPECT_THAT(path_at(document, 1).along.channels[0].values, ElementsAre(3, 4));
  EXPECT_THAT(path_at(document, 2).along.colors, ElementsAre(Color{5, 0, 0}));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(path_at(document, i).style.stroke_width, 7);
    EXPECT_EQ(path_at(document, i).parent, "g");
  }
}

TEST(SplitSubpaths, MakesIdsThatAreFree) {
  Document document = {{},
                       {path("M0 0 M1 1 M2 2", "a"), path("M3 3", "a~3"), path("M4 4 M5 5", "")}};
  split_subpaths(document);
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < document.records.size(); ++i) ids.push_back(path_at(document, i).id);
  EXPECT_THAT(ids, ElementsAre("a", "a~2", "a~4", "a~3", "", ""));
}

// --- Flattening ---------------------------------------------------------------------------------

TEST(FlattenPaths, LeavesLinesAlone) {
  const Document before = {{}, {path("M0 0 L1 1 L2 0 Z M5 5 L6 6"), path("M3 3")}};
  Document after = before;
  flatten_paths(after, 0.1, "");
  EXPECT_EQ(after, before);
}

double distance_to(Point p, const Path& lines) {
  double nearest = 1e300;
  for (const Subpath& subpath : subpaths(lines)) {
    for (const PathSegment& segment : subpath.segments) {
      const Vector along = segment.curve.p3 - segment.curve.p0, to = p - segment.curve.p0;
      const double t = std::clamp(dot(to, along) / squared_norm(along), 0.0, 1.0);
      nearest = std::min(nearest, norm(to - t * along));
    }
  }
  return nearest;
}

TEST(FlattenPaths, StaysWithinTheTolerance) {
  for_each_seed(30, [](std::uint64_t seed) {
    RandomValues random(seed);
    const auto point = [&] { return Point{random.uniform(0, 100), random.uniform(0, 100)}; };
    PathRecord record;
    record.path.move_to(point());
    for (int i = 0; i < 3; ++i) record.path.cubic_to(point(), point(), point());
    const double tolerance = random.uniform(0.01, 2);
    Document document = {{}, {record}};
    flatten_paths(document, tolerance, "");
    const Path& flat = path_at(document, 0).path;
    EXPECT_TRUE(std::ranges::none_of(
        flat.commands(), [](PathCommand command) { return command == PathCommand::kCubic; }));
    const Subpath whole = subpaths(record.path)[0];
    for (const PathSegment& segment : whole.segments) {
      for (double t = 0; t <= 1; t += 1.0 / 64) {
        EXPECT_LE(distance_to(point_at(segment.curve, t), flat), tolerance);
      }
    }
  });
}

TEST(FlattenPaths, InterpolatesTheValuesAlong) {
  PathRecord record = path("M0 0 C0 10 10 10 10 0 L20 0");
  record.along.channels = {{"width", {0, 8, 9}}};
  record.along.colors = {{0, 0, 0}, {200, 100, 0}, {0, 0, 255}};
  Document document = {{}, {record}};
  flatten_paths(document, 0.5, "");
  const PathRecord& flat = path_at(document, 0);
  const std::size_t vertices = flat.path.vertex_count();
  ASSERT_GT(vertices, 4u);
  ASSERT_EQ(flat.along.channels[0].values.size(), vertices);
  ASSERT_EQ(flat.along.colors.size(), vertices);
  EXPECT_TRUE(std::ranges::is_sorted(flat.along.channels[0].values));
  EXPECT_EQ(flat.along.channels[0].values.back(), 9);
  EXPECT_EQ(flat.along.colors[vertices - 2], (Color{200, 100, 0}));
  const double step = 8.0 / static_cast<double>(vertices - 2);
  EXPECT_NEAR(flat.along.channels[0].values[1], step, 1e-12);
  EXPECT_EQ(flat.along.colors[1].red, std::lround(200 * step / 8));
}

TEST(FlattenPaths, FlattensClipsToo) {
  ClipRecord clip;
  clip.parts = {{parse_path_data("M0 0 C0 10 10 10 10 0 Z"), FillRule::kNonZero, "", {}}};
  Document document = {{}, {clip}};
  flatten_paths(document, 1, "");
  const auto& flat = std::get<ClipRecord>(document.records[0]).parts[0].path;
  EXPECT_EQ(std::ranges::count(flat.commands(), PathCommand::kCubic), 0);
  EXPECT_EQ(flat.commands().back(), PathCommand::kClose);
}

TEST(FlattenPaths, NamesThePathThatIsTooLarge) {
  PathRecord record = path("M0 0 C1e15 0 0 1e15 1 1");
  record.line = 12;
  Document document = {{}, {record}};
  try {
    flatten_paths(document, 1e-9, "plan.svg");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("plan.svg:12: a curve would need more than"));
  }
}

}  // namespace
}  // namespace libstyle
