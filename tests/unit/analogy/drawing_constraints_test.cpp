// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing_constraints.h"

#include <gmock/gmock.h>

#include "libstyle/analogy/drawing.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy/wavy_drawing.h"

namespace libstyle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

ConstraintRecord constraint(std::string curve, Point position, std::optional<double> t = {},
                            std::optional<double> weight = {}) {
  ConstraintRecord record;
  record.curve = std::move(curve);
  record.position = position;
  record.t = t;
  record.weight = weight;
  return record;
}

std::vector<Point> drawn_vertices(Document document, std::size_t path,
                                  std::vector<AskedConstraint> asked = {},
                                  std::vector<std::string>* warnings = nullptr) {
  static const CurveAnalogy style(wavy_pairs(), {});
  DrawingOptions options;
  options.threads = 1;
  options.constraints = asked;
  options.warn = [&](const Warning& warning) {
    if (warnings) warnings->push_back(warning.message);
  };
  draw_again(document, style, options);
  return std::get<PathRecord>(document.records.at(path)).path.vertices();
}

Document document_of(std::vector<Record> records) {
  Document document;
  document.records.assign(records.begin(), records.end());
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    std::visit([&](auto& record) { record.line = i + 2; }, document.records[i]);
  }
  return document;
}

// ---- Where they are -----------------------------------------------------------------------------

TEST(DrawingConstraints, MakeAPathPassExactly) {
  const Point place = {151.23456789, 7.000001};
  for (const char* line :
       {"M0 0 L300 0", "M0 0 C100 90 200 -90 300 0", "M0 0 L300 0 L300 -200 L0 -200 Z",
        "M150 0 C250 0 250 -200 150 -200 C50 -200 50 0 150 0 Z"}) {
    EXPECT_THAT(drawn_vertices(document_of({path_record("a", line), constraint("a", place)}), 0),
                Contains(place))
        << line;
  }
}

TEST(DrawingConstraints, CountLengthOverAllSubpaths) {
  const auto vertices = [](double t) {
    return drawn_vertices(
        document_of({path_record("a", "M0 0 L100 0 M0 50 L300 50"), constraint("a", {40, 57}, t)}),
        0);
  };
  EXPECT_THAT(vertices(0.5), Contains(Point{40, 57}));
  EXPECT_EQ(vertices(0).front(), (Point{40, 57}));
  EXPECT_EQ(vertices(1).back(), (Point{40, 57}));
  // Where a subpath ends and the next begins: the end.
  const std::vector<Point> between = vertices(0.25);
  EXPECT_THAT(between, Contains(Point{0, 50}));
  EXPECT_THAT(between, Not(Contains(Point{100, 0})));
}

TEST(DrawingConstraints, WithoutTAreAtTheNearestPlaceOfAnySubpath) {
  const auto vertices = drawn_vertices(
      document_of({path_record("a", "M0 0 L300 0 M0 90 L300 90"), constraint("a", {100, 80})}), 0);
  const auto at = std::ranges::find(vertices, Point{100, 80});
  ASSERT_NE(at, vertices.end());
  EXPECT_THAT(std::vector<Point>(vertices.begin(), at), Contains(Point{0, 90}));
}

TEST(DrawingConstraints, HoldForAllPathsThatAreTheSameCurve) {
  const Document document =
      document_of({path_record("fill", "M0 0 L200 0 L200 90 Z"),
                   path_record("edge", "M0 0 L200 0 L200 90 Z"), constraint("edge", {100, -8})});
  EXPECT_THAT(drawn_vertices(document, 0), Contains(Point{100, -8}));
  EXPECT_EQ(drawn_vertices(document, 0), drawn_vertices(document, 1));
}

TEST(DrawingConstraints, LeaveOtherPathsAsTheyWere) {
  const std::vector<Record> two = {path_record("a", "M0 0 L200 0"),
                                   path_record("b", "M0 50 L200 50")};
  std::vector<Record> three = two;
  three.push_back(constraint("a", {100, 9}));
  EXPECT_EQ(drawn_vertices(document_of(three), 1), drawn_vertices(document_of(two), 1));
}

TEST(DrawingConstraints, BendEvenPathsThatAreTooSmallForTheStyle) {
  EXPECT_THAT(
      drawn_vertices(document_of({path_record("a", "M0 0 L2 0"), constraint("a", {1, 1}, 0.5)}), 0),
      Contains(Point{1, 1}));
}

// ---- What has no effect -------------------------------------------------------------------------

TEST(DrawingConstraints, ThatNameNothingHaveNoEffect) {
  const Record line = path_record("a", "M0 0 L200 0"), dot = path_record("dot", "M5 5");
  const auto plain = drawn_vertices(document_of({line, dot}), 0);
  const auto with = [&](Record record) {
    return drawn_vertices(document_of({line, dot, std::move(record)}), 0);
  };
  EXPECT_EQ(with(constraint("b", {100, 9})), plain);
  EXPECT_EQ(with(constraint("dot", {100, 9})), plain);
  EXPECT_EQ(with(constraint("a", {100, 9}, {}, 0)), plain);
  // References look back.
  EXPECT_EQ(drawn_vertices(document_of({constraint("a", {100, 9}), line}), 1), plain);
}

TEST(DrawingConstraints, ThatWereAskedForAndHaveNoEffectAreWarnedAbout) {
  std::vector<std::string> warnings;
  drawn_vertices(document_of({path_record("a", "M0 0 L200 0")}), 0,
                 {{constraint("a", {100, 9}), "first"}, {constraint("b", {100, 9}), "second"}},
                 &warnings);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("second moves no line")));
}

// ---- Contradictions -----------------------------------------------------------------------------

std::string refusal(std::vector<Record> records, std::vector<AskedConstraint> asked = {}) {
  try {
    drawn_vertices(document_of(std::move(records)), 0, std::move(asked));
  } catch (const Error& error) {
    return std::to_string(error.place().line) + ": " + error.message();
  }
  return "";
}

TEST(DrawingConstraints, ThatContradictEachOtherAreNamed) {
  const PathRecord line = path_record("a", "M0 0 L200 0"),
                   ring = path_record("a", "M0 0 L200 0 L200 90 Z");
  EXPECT_EQ(refusal({line, constraint("a", {1, 2}, 0.5), constraint("a", {3, 4}, 0.5)}),
            "4: #a cannot be in two places at once, 1,2 (line 3) and 3,4 (line 4); take one away "
            "or give it a weight");
  EXPECT_THAT(refusal({ring, constraint("a", {1, 2}, 1), constraint("a", {3, 4}, 0)}),
              HasSubstr("1,2 (line 3) and 3,4 (line 4)"));
  EXPECT_THAT(refusal({line, constraint("a", {1, 2}, 0.5)}, {{constraint("a", {3, 4}, 0.5), "it"}}),
              HasSubstr("1,2 (line 3) and 3,4 (it)"));
}

TEST(DrawingConstraints, ThatAgreeAreNoContradiction) {
  const PathRecord line = path_record("a", "M0 0 L200 0"),
                   ring = path_record("a", "M0 0 L200 0 L200 90 Z");
  const auto at = [](double t, Point p, std::optional<double> w = {}) {
    return constraint("a", p, t, w);
  };
  EXPECT_EQ(refusal({line, at(0.5, {1, 2}), at(0.5, {1, 2})}), "");
  EXPECT_EQ(refusal({line, at(0.5, {1, 2}), at(0.5, {3, 4}, 1)}), "");
  EXPECT_EQ(refusal({line, at(0, {1, 2}), at(1, {3, 4})}), "");
  EXPECT_EQ(refusal({ring, at(0, {1, 2}), at(1, {1, 2})}), "");
}

}  // namespace
}  // namespace libstyle
