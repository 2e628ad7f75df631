// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/svg_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>

#include "converters/svg/carried_keys.h"
#include "converters/svg/path_grammar.h"
#include "converters/svg/transform_list.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/path_data.h"
#include "tests/unit/curves/any_document.h"

namespace libstyle::svg {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Written {
  std::string text;
  std::vector<std::string> warnings;  // "id: message"
};

Written write(const Document& document) {
  Written written;
  TextSink sink;
  write_svg(sink, document, [&](const Warning& warning) {
    written.warnings.push_back(warning.id + ": " + warning.message);
  });
  written.text = std::move(sink.text);
  return written;
}

// What is written for records, without the first line and the last.
std::string body(Records records) {
  const Written written = write({{}, std::move(records)});
  EXPECT_TRUE(written.warnings.empty()) << written.warnings.front();
  const std::size_t begin = written.text.find('\n') + 1;
  return written.text.substr(begin, written.text.rfind("</svg>") - begin);
}

PathRecord path_record(const std::string& id, const std::string& parent = "") {
  PathRecord path;
  path.id = id;
  path.parent = parent;
  path.path = parse_path_data("M0 0 L5 0 L5 5");
  path.style.fill = NoPaint{};
  path.style.stroke = Color{255, 0, 0, 255};
  return path;
}

GroupRecord group_record(const std::string& id, const std::string& parent = "") {
  GroupRecord group;
  group.id = id;
  group.parent = parent;
  return group;
}

TEST(SvgWriter, WritesThePageInItsOriginalUnit) {
  Document document;
  document.header.width = 96;
  document.header.height = 48;
  document.header.page_width = "1in";
  EXPECT_THAT(write(document).text,
              HasSubstr("width=\"1in\" height=\"48\" viewBox=\"0 0 96 48\"/>\n"));
}

TEST(SvgWriter, ShowsADrawingWithoutPageThatLiesBeforeTheOrigin) {
  PathRecord path = path_record("");
  EXPECT_THAT(write({{}, {path}}).text, Not(HasSubstr("viewBox")));
  path.path = parse_path_data("M-5 1 L5 11");
  EXPECT_THAT(write({{}, {path}}).text, HasSubstr(" viewBox=\"-5 1 10 10\" "));
}

TEST(SvgWriter, NestsGroupsAgain) {
  GroupRecord layer = group_record("layer");
  layer.layer = true;
  layer.label = "Ink & paper";
  layer.opacity = 0.5;
  GroupRecord hidden = group_record("~1", "layer");
  hidden.hidden = true;
  EXPECT_EQ(body({layer, path_record("a", "layer"), hidden, path_record("b", "~1"),
                  path_record("c", "layer"), path_record("d"), group_record("empty")}),
            "  <g id=\"layer\" inkscape:label=\"Ink &amp; paper\" inkscape:groupmode=\"layer\" "
            "opacity=\"0.5\">\n"
            "    <path id=\"a\" fill=\"none\" stroke=\"#ff0000\" d=\"M0 0 L5 0 L5 5\"/>\n"
            "    <g display=\"none\">\n"
            "      <path id=\"b\" fill=\"none\" stroke=\"#ff0000\" d=\"M0 0 L5 0 L5 5\"/>\n"
            "    </g>\n"
            "    <path id=\"c\" fill=\"none\" stroke=\"#ff0000\" d=\"M0 0 L5 0 L5 5\"/>\n"
            "  </g>\n"
            "  <path id=\"d\" fill=\"none\" stroke=\"#ff0000\" d=\"M0 0 L5 0 L5 5\"/>\n"
            "  <g id=\"empty\"/>\n");
}

TEST(SvgWriter, WritesBlendingAsStyle) {
  GroupRecord group = group_record("g");
  group.blend_mode = BlendMode::kColorDodge;
  group.isolated = true;
  EXPECT_EQ(body({group}),
            "  <g id=\"g\" style=\"mix-blend-mode:color-dodge;isolation:isolate\"/>\n");
}

TEST(SvgWriter, WritesPaintAsAttributes) {
  PathRecord path = path_record("");
  path.path = parse_path_data("M0 0 L5 0");
  Style& style = path.style;
  style.fill = Color{1, 2, 3, 255};
  style.fill_opacity = 0.25;
  style.fill_rule = FillRule::kEvenOdd;
  style.stroke_opacity = 0.5;
  style.stroke_width = 2;
  style.line_cap = LineCap::kRound;
  style.line_join = LineJoin::kBevel;
  style.miter_limit = 7;
  style.dash_array = {1, 2.5};
  style.dash_offset = 3;
  style.stroke_first = true;
  style.opacity = 0.75;
  style.hidden = true;
  EXPECT_EQ(body({path}),
            "  <path fill=\"#010203\" fill-opacity=\"0.25\" fill-rule=\"evenodd\" "
            "stroke=\"#ff0000\" stroke-opacity=\"0.5\" stroke-width=\"2\" "
            "stroke-linecap=\"round\" stroke-linejoin=\"bevel\" stroke-miterlimit=\"7\" "
            "stroke-dasharray=\"1,2.5\" stroke-dashoffset=\"3\" paint-order=\"stroke\" "
            "opacity=\"0.75\" visibility=\"hidden\" d=\"M0 0 L5 0\"/>\n");
}

TEST(SvgWriter, DrawsABareCurveInBlack) {
  PathRecord path;
  path.path = parse_path_data("M0 0 L5 0");
  EXPECT_EQ(body({path}), "  <path fill=\"none\" stroke=\"#000000\" d=\"M0 0 L5 0\"/>\n");
}

TEST(SvgWriter, KeepsHowAStrokeWouldBeThatIsNotThere) {
  PathRecord path = path_record("");
  path.style.stroke.reset();
  path.style.stroke_opacity = 0.5;
  path.style.stroke_width = 3;
  EXPECT_THAT(body({path}),
              HasSubstr("<path fill=\"none\" stroke-opacity=\"0.5\" stroke-width=\"3\" d="));
}

TEST(SvgWriter, WritesShapesAsWhatTheyWere) {
  PathRecord path = path_record("r");
  path.path = parse_path_data("M1 2 L4 2 L4 6 L1 6 Z");
  path.shape = "rect";
  EXPECT_EQ(body({path}),
            "  <rect id=\"r\" fill=\"none\" stroke=\"#ff0000\" x=\"1\" y=\"2\" width=\"3\" "
            "height=\"4\"/>\n");
  path.path = parse_path_data("M1 2 L4 3 L4 6 L1 6 Z");
  EXPECT_EQ(body({path}),
            "  <path id=\"r\" fill=\"none\" stroke=\"#ff0000\" "
            "curves:keys='{\"type\":\"path\",\"shape\":\"rect\"}' "
            "d=\"M1 2 L4 3 L4 6 L1 6 Z\"/>\n");
}

TEST(SvgWriter, KeepsNotes) {
  PathRecord path = path_record("a");
  path.classes = "thin ink";
  path.label = "A \"line\"";
  path.extras = {{"data-pen", "\"3 \\u0026 \\\"4\\\"\""}};
  EXPECT_THAT(body({path}), HasSubstr("<path id=\"a\" class=\"thin ink\" inkscape:label='A "
                                      "\"line\"' data-pen='3 &amp; \"4\"' "));
}

TEST(SvgWriter, DefinesGradients) {
  GradientRecord linear;
  linear.id = "g";
  linear.geometry = LinearGeometry{{0, 1}, {2, 3}};
  linear.page_from_gradient = {1, 0, 0, 1, 5, 6};
  linear.spread = Spread::kReflect;
  linear.stops = {{0, {255, 0, 0, 255}, 1}, {1, {0, 0, 255, 255}, 0.5}};
  GradientRecord radial;
  radial.id = "g~2";
  radial.geometry = RadialGeometry{{5, 5}, {4, 5}, 3, 0};
  PathRecord path = path_record("a");
  path.style.fill = PaintReference{"g"};
  path.style.stroke = PaintReference{"g~2"};
  EXPECT_EQ(body({linear, radial, path}),
            "  <defs>\n"
            "    <linearGradient id=\"g\" gradientUnits=\"userSpaceOnUse\" x1=\"0\" y1=\"1\" "
            "x2=\"2\" y2=\"3\" gradientTransform=\"matrix(1 0 0 1 5 6)\" "
            "spreadMethod=\"reflect\">\n"
            "      <stop offset=\"0\" stop-color=\"#ff0000\"/>\n"
            "      <stop offset=\"1\" stop-color=\"#0000ff\" stop-opacity=\"0.5\"/>\n"
            "    </linearGradient>\n"
            "    <radialGradient id=\"g-2\" curves:id=\"g~2\" gradientUnits=\"userSpaceOnUse\" "
            "cx=\"5\" cy=\"5\" "
            "r=\"3\" fx=\"4\" fy=\"5\"/>\n"
            "  </defs>\n"
            "  <path id=\"a\" fill=\"url(#g)\" stroke=\"url(#g-2)\" d=\"M0 0 L5 0 L5 5\"/>\n");
}

TEST(SvgWriter, DefinesClips) {
  ClipRecord inner;
  inner.id = "~1";
  inner.parts = {{parse_path_data("M0 0 L1 0 L1 1 Z"), FillRule::kEvenOdd, ""}};
  ClipRecord outer;
  outer.id = "c";
  outer.clip = "~1";
  outer.parts = {{parse_path_data("M0 0 L2 0 L2 2 Z"), FillRule::kNonZero, "~1"}};
  PathRecord path = path_record("a");
  path.clip = "c";
  EXPECT_EQ(body({inner, outer, path}),
            "  <defs>\n"
            "    <clipPath id=\"clip-1\" curves:id=\"~1\">\n"
            "      <path clip-rule=\"evenodd\" d=\"M0 0 L1 0 L1 1 Z\"/>\n"
            "    </clipPath>\n"
            "    <clipPath id=\"c\" clip-path=\"url(#clip-1)\" curves:parts=\"united\">\n"
            "      <path clip-path=\"url(#clip-1)\" d=\"M0 0 L2 0 L2 2 Z\"/>\n"
            "    </clipPath>\n"
            "  </defs>\n"
            "  <path id=\"a\" clip-path=\"url(#c)\" fill=\"none\" stroke=\"#ff0000\" d=\"M0 0 L5 0 "
            "L5 5\"/>\n");
}

TEST(SvgWriter, TransformsThePathToThePen) {
  PathRecord path = path_record("a");
  path.style.stroke_transform = Transform{2, 0, 0, 4, 0, 0};
  EXPECT_EQ(body({path}),
            "  <path id=\"a\" transform=\"matrix(2 0 0 4 0 0)\" fill=\"none\" stroke=\"#ff0000\" "
            "d=\"M0 0 L2.5 0 L2.5 1.25\"/>\n");
}

TEST(SvgWriter, DrawsWithARoundPenWhereItsSpaceIsBeyondAllNumbers) {
  PathRecord path = path_record("a");
  path.style.stroke_transform = Transform{1e-200, 0, 0, 1, 0, 0};
  path.path = parse_path_data("M0 0 L1e200 0");
  const Written written = write({{}, {path}});
  EXPECT_THAT(written.text, HasSubstr("d=\"M0 0 L1e"));
  EXPECT_THAT(written.warnings, ::testing::ElementsAre(HasSubstr("too extreme")));
}

TEST(SvgWriter, BringsGradientsAndClipsToTheTransformedPath) {
  GradientRecord gradient;
  gradient.id = "g";
  gradient.geometry = LinearGeometry{{0, 0}, {8, 0}};
  ClipRecord clip;
  clip.id = "c";
  PathRecord path = path_record("a");
  path.clip = "c";
  path.style.stroke = PaintReference{"g"};
  path.style.stroke_transform = Transform{2, 0, 0, 4, 0, 0};
  EXPECT_THAT(
      body({gradient, clip, path}),
      HasSubstr("  <g curves:for=\"path\" clip-path=\"url(#c)\">\n"
                "    <defs>\n"
                "      <linearGradient id=\"g-1\" curves:id=\"g\" gradientUnits=\"userSpaceOnUse\" "
                "x1=\"0\" y1=\"0\" x2=\"8\" y2=\"0\" "
                "gradientTransform=\"matrix(0.5 0 0 0.25 0 0)\"/>\n"
                "    </defs>\n"
                "    <path id=\"a\" transform=\"matrix(2 0 0 4 0 0)\" fill=\"none\" "
                "stroke=\"url(#g-1)\" d=\"M0 0 L2.5 0 L2.5 1.25\"/>\n"
                "  </g>\n"));
}

TEST(SvgWriter, DrawsVaryingStrokesWithTheirMeanAndSaysSoOnce) {
  PathRecord path = path_record("a");
  path.along.channels = {{"width", {1, 2, 6}}};
  path.along.colors = {{255, 0, 0, 255}, {0, 0, 0, 255}, {0, 255, 0, 255}};
  PathRecord second = path;
  second.id = "b";
  const Written written = write({{}, {path, second}});
  EXPECT_THAT(written.warnings, ::testing::ElementsAre(HasSubstr("a: SVG has no strokes")));
  EXPECT_THAT(written.text, HasSubstr("stroke=\"#555500\" stroke-width=\"3\" curves:keys="));
  EXPECT_THAT(written.text, HasSubstr("[1,2,6]"));
}

TEST(SvgWriter, CarriesWhatDrawsNothingInMetadata) {
  ConstraintRecord constraint;
  constraint.curve = "a~2";
  constraint.position = {1, 2};
  LabelRecord label;
  label.of = "a~2";
  label.style = "<tree>";
  const UnknownRecord unknown = {"{\"type\":\"spline\"}", 0};
  Document document = {{}, {path_record("a"), path_record("a~2"), constraint, label, unknown}};
  document.header.name = "plan";
  document.header.history = {"svg2curves plan.svg"};
  EXPECT_THAT(
      write(document).text,
      HasSubstr("  <metadata>\n"
                "    <curves:records>\n"
                "      {\"curves\":1,\"name\":\"plan\",\"history\":[\"svg2curves plan.svg\"]}\n"));
  pugi::xml_document tree;
  ASSERT_TRUE(tree.load_string(write(document).text.c_str()));
  const auto carried = restore_carried_records(
      tree.child("svg").child("metadata").child(kCarriedRecords).text().get());
  ASSERT_TRUE(carried);
  EXPECT_EQ(carried->records, (Records{constraint, label, unknown}));
  EXPECT_THAT(write(document).text, HasSubstr("<path id=\"a-2\" curves:id=\"a~2\" "));
}

TEST(SvgWriter, SaysWhatIsNotThere) {
  PathRecord path = path_record("a", "nowhere");
  path.clip = "no clip";
  path.style.fill = PaintReference{"no gradient"};
  const Written written = write({{}, {path, path}});
  EXPECT_EQ(written.warnings.size(), 3u);
  EXPECT_THAT(written.text, HasSubstr("fill=\"none\""));
  EXPECT_THAT(written.text, Not(HasSubstr("clip-path")));
}

TEST(SvgWriter, WritesScatteredMembersInOrder) {
  const Written written = write(
      {{}, {group_record("g"), path_record("a", "g"), path_record("b"), path_record("c", "g")}});
  EXPECT_EQ(written.warnings.size(), 1u);
  EXPECT_LT(written.text.find("\"a\""), written.text.find("\"b\""));
  EXPECT_LT(written.text.find("\"b\""), written.text.find("\"c\""));
  EXPECT_EQ(written.text.find("<g id=\"g\""), written.text.rfind("<g id=\"g\""));
}

TEST(SvgWriter, NestsDeeperThanAnyStack) {
  Document document;
  for (int i = 0; i < 20000; ++i) {
    document.records.push_back(
        group_record("g" + std::to_string(i), i > 0 ? "g" + std::to_string(i - 1) : ""));
  }
  EXPECT_THAT(write(document).text, HasSubstr("id=\"g19999\""));
}

// Every path with a transform or without, in the order of the file, as page coordinates.
void gather_paths(pugi::xml_node node, std::vector<Path>& paths) {
  for (const pugi::xml_node child : node.children()) {
    if (std::string_view(child.name()) == "path" && std::string_view(node.name()) != "clipPath") {
      const ParsedPath parsed = parse_path_grammar(child.attribute("d").value());
      EXPECT_FALSE(parsed.error_at);
      paths.push_back(parsed.path);
      const auto transform = parse_transform_attribute(child.attribute("transform").value());
      paths.back().transform(transform.value());
    }
    gather_paths(child, paths);
  }
}

// Whatever is in a document, the file is well-formed, its ids are unique, its references lead
// somewhere and its paths are all there.
TEST(SvgWriter, WritesAnyDocument) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Document document = any_document(seed);
    const Written written = write(document);
    pugi::xml_document tree;
    ASSERT_TRUE(tree.load_string(written.text.c_str())) << "seed " << seed;
    std::set<std::string> ids;
    for (const auto& node : tree.select_nodes("//*[@id]")) {
      EXPECT_TRUE(ids.insert(node.node().attribute("id").value()).second) << "seed " << seed;
    }
    std::vector<Path> paths;
    gather_paths(tree, paths);
    std::size_t next = 0;
    for (const Record& record : document.records) {
      const auto* path = std::get_if<PathRecord>(&record);
      if (!path) continue;
      ASSERT_LT(next, paths.size()) << "seed " << seed;
      EXPECT_EQ(paths[next].commands().size(), path->path.commands().size());
      if (!path->style.stroke_transform) {
        EXPECT_EQ(paths[next], path->path) << "seed " << seed;
      }
      ++next;
    }
  }
}

}  // namespace
}  // namespace libstyle::svg
