// SPDX-License-Identifier: Apache-2.0
// From SVG to curves, back to SVG and again to curves: the records are the same.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <type_traits>

#include "converters/svg/svg_writer.h"
#include "tests/support/seeds.h"
#include "tests/unit/curves/any_document.h"
#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

std::string written(const Document& document) {
  TextSink sink;
  write_svg(sink, document, [](const Warning&) {});
  return sink.text;
}

// Ids that a program made are given out anew by each: paths lose them, what is referred to gets a
// number by its order.
class MadeIds {
 public:
  void settle(Record& record) {
    std::visit(
        [this](auto& known) {
          using Kind = std::decay_t<decltype(known)>;
          if constexpr (std::is_same_v<Kind, PathRecord>) settle_path(known);
          if constexpr (!std::is_same_v<Kind, UnknownRecord>) settle_base(known);
          if constexpr (std::is_same_v<Kind, GroupRecord>) rename(known.clip);
          if constexpr (std::is_same_v<Kind, ClipRecord>) settle_clip(known);
        },
        record);
  }

 private:
  void settle_base(RecordBase& record) {
    rename(record.parent);
    rename(record.id);
  }

  void settle_path(PathRecord& path) {
    if (path.id.find('~') != std::string::npos) path.id.clear();
    rename(path.clip);
    for (std::optional<Paint>* paint : {&path.style.fill, &path.style.stroke}) {
      if (*paint && std::holds_alternative<PaintReference>(**paint)) {
        rename(std::get<PaintReference>(**paint).id);
      }
    }
  }

  void settle_clip(ClipRecord& clip) {
    rename(clip.clip);
    for (ClipPart& part : clip.parts) rename(part.clip);
  }

  void rename(std::string& id) {
    if (id.find_first_of("~-") == std::string::npos) return;
    id = names_.emplace(id, "#" + std::to_string(names_.size())).first->second;
  }

  std::map<std::string, std::string> names_;
};

Records settled(Records records) {
  MadeIds ids;
  for (Record& record : records) ids.settle(record);
  return records;
}

void expect_round_trip(const Reading& first) {
  const std::string text = written(first.document);
  const Reading second = read_file(text);
  EXPECT_THAT(second.warning_texts(), ::testing::IsEmpty());
  EXPECT_EQ(settled(second.document.records) == settled(first.document.records), true)
      << to_stream({first.document}) << text << to_stream({second.document});
  EXPECT_EQ(second.document.header.width, first.document.header.width);
  EXPECT_EQ(second.document.header.page_width, first.document.header.page_width);
}

TEST(RoundTrip, KeepsShapes) {
  expect_round_trip(
      read("<rect x='1.1' y='2.2' width='30.3' height='40' rx='3'/><circle cx='3' cy='4' r='5.7'/>"
           "<ellipse cx='.3' cy='-4' rx='5.7' ry='.1'/><line x2='7.3' y2='1e-3'/>"
           "<polyline points='1,2 3.3,4 5,6'/><polygon points='1,2 3.3,4 5,6'/>"
           "<path d='M0 0q1 2 3 4t5 6a7 8 9 0 1 20 1zl1 1'/>"));
}

TEST(RoundTrip, KeepsShapesUnderAnyScale) {
  expect_round_trip(read_file(
      "<svg xmlns='http://www.w3.org/2000/svg' width='210mm' height='297mm' viewBox='3 4 21 29'>"
      "<g transform='translate(.3 .7) scale(1.3)'><rect x='1.1' width='3.3' height='4.7' rx='.3'/>"
      "<circle cx='3' cy='4.9' r='5.7'/><rect transform='rotate(7)' width='2' height='3'/></g>"
      "</svg>"));
}

TEST(RoundTrip, KeepsStructureAndNotes) {
  expect_round_trip(
      read("<g xmlns:i='http://www.inkscape.org/namespaces/inkscape' id='l' i:groupmode='layer'"
           " i:label='A &amp; \"B\"' class='x y'><g opacity='.5'><path id='a' d='M0 0h9' "
           "data-n=\"'&quot;\"/>"
           "</g><g display='none'><path d='M0 0h8'/></g><path visibility='hidden' d='M0 0h7'/></g>"
           "<use xlink:href='#a' id='u' y='5'/><use xlink:href='#a' y='6'/><use xlink:href='#l' "
           "x='9'/>"));
}

TEST(RoundTrip, KeepsPaint) {
  expect_round_trip(read(
      "<path d='M0 0h9v9' fill='none' stroke='#123456' stroke-width='.3' stroke-dasharray='1 2 3'"
      " stroke-dashoffset='-1' stroke-linecap='round' stroke-linejoin='bevel' opacity='.7'"
      " stroke-opacity='.1' stroke-miterlimit='9' shape-rendering='crispEdges' "
      "paint-order='stroke'/>"
      "<path d='M0 0h9v9' fill='rgba(1,2,3,.5)' fill-opacity='.5' fill-rule='evenodd'/>"));
}

TEST(RoundTrip, KeepsGradientsAndClips) {
  expect_round_trip(read(
      "<linearGradient id='g' x2='.7' spreadMethod='reflect'><stop stop-color='red'/>"
      "<stop offset='.3' stop-opacity='.3'/></linearGradient><radialGradient id='r' href='#g'"
      " fx='.4' gradientTransform='rotate(3)'/><clipPath id='c'><circle r='30'/></clipPath>"
      "<clipPath id='d' clip-path='url(#c)'><path clip-rule='evenodd' d='M0 0h5v5z'/></clipPath>"
      "<rect width='9' height='7' fill='url(#g)' stroke='url(#r)' clip-path='url(#d)'/>"
      "<g transform='scale(2)' clip-path='url(#d)'><rect width='3' height='7' fill='url(#g)'/></g>"
      "<svg x='1' y='2' width='30' height='20'><circle r='50'/></svg>"));
}

// A path with a skewed pen, a gradient that is shared with one on the page, and a clip.
std::string drawing_with_any_pen(RandomValues& random) {
  const auto numbers = [&](int count, double size) {
    std::string text;
    for (int i = 0; i < count; ++i) text += ' ' + std::to_string(random.uniform(-size, size));
    return text;
  };
  const double size = std::pow(10, random.uniform(-3, 5));
  const std::string paint = random.chance(0.5) ? "url(#g)" : "red";
  return "<svg xmlns='http://www.w3.org/2000/svg' width='1000' height='1000'>"
         "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='7' gradientTransform='matrix(" +
         numbers(6, 3) + ")'><stop/></linearGradient><clipPath id='c'><path d='M0 0H9V9z'/>" +
         "</clipPath><g transform='matrix(" + numbers(6, 3) + ")'><path id='p' transform='matrix(" +
         numbers(4, 1) + numbers(2, size) + ")' d='M" + numbers(8, size) + "C" + numbers(6, size) +
         "z' fill='url(#g)' stroke='" + paint + "'" +
         (random.chance(0.5) ? " clip-path='url(#c)'" : "") + "/><path d='M0 0H3V4z' fill='" +
         paint + "'/></g></svg>";
}

TEST(RoundTrip, KeepsEveryBitUnderAnyPen) {
  for_each_seed(300, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Reading first = read_file(drawing_with_any_pen(random));
    EXPECT_EQ(to_stream({read_file(written(first.document)).document}),
              to_stream({first.document}));
  });
}

// It stands in SVG for the page and for each pen.
TEST(RoundTrip, KeepsOneGradientOfManyPens) {
  const Reading first = read(
      "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='7'><stop/></linearGradient>"
      "<g transform='matrix(.7 .2 .3 2.7 5 6)' fill='url(#g)'><path d='M1 2L3 4.7V9z' "
      "stroke='red'/>"
      "<path d='M0 0H3V4z'/><path d='M5 5H3V4z' stroke='red'/></g>");
  ASSERT_EQ(first.gradients().size(), 1U);
  EXPECT_EQ(to_stream({read_file(written(first.document)).document}), to_stream({first.document}));
}

// The numbers on the page that stand beside a path count no longer when somebody moves a vertex.
TEST(RoundTrip, TakesAnEditInTheSpaceOfThePen) {
  const Reading first =
      read("<path transform='matrix(.7 .2 .3 2.7 5 6)' d='M1 2L3 4.7' stroke='red'/>");
  std::string text = written(first.document);
  const std::size_t d = text.find(" d=\"M");
  ASSERT_NE(d, text.npos);
  ASSERT_NE(text.find(" curves:d=\"M"), text.npos);
  text.replace(d, text.find('L', d) - d, " d=\"M100,0");
  const Point moved = read_file(text).path().path.points()[0];
  EXPECT_LT(distance(moved, {70, 20}), 1e-12);
}

TEST(RoundTrip, TakesAnEditOfTheGroupAroundAPath) {
  const Reading first = read(
      "<clipPath id='c'><path d='M0 0H9V9z'/></clipPath><g transform='scale(1 2)'>"
      "<path d='M0 0H9' stroke='red' clip-path='url(#c)'/></g>");
  ASSERT_TRUE(first.groups().empty());
  std::string text = written(first.document);
  const std::size_t group = text.find("<g ");
  ASSERT_NE(group, text.npos);
  text.insert(group + 3, "opacity=\".5\" ");
  const Reading second = read_file(text);
  EXPECT_EQ(second.group().opacity, 0.5);
  EXPECT_NE(second.group().clip, "");
}

TEST(RoundTrip, KeepsAPageWithoutASize) {
  const Reading first = read_file(
      "<svg xmlns='http://www.w3.org/2000/svg'><path d='M-5.1 3L7 8.3' stroke='red'/></svg>");
  EXPECT_EQ(to_stream({read_file(written(first.document)).document}), to_stream({first.document}));
}

TEST(RoundTrip, KeepsWhatSvgHasNoPlaceFor) {
  Reading first = read("<g id='e'><path id='a' d='M0 0h9v9' stroke='red'/></g>");
  Document& document = first.document;
  ElementRecord element;
  element.id = "e";
  element.category = "leaf";
  element.position = Point{1, 2};
  document.records[0] = element;
  PathRecord& path = std::get<PathRecord>(document.records[1]);
  path.along.channels = {{"width", {1, 2, 6}}, {"t", {0, 0.5, 1}}};
  path.style.stroke_width = 3;  // the mean
  path.extras = {{"note", "[1,{\"a\":null}]"}};
  ConstraintRecord constraint;
  constraint.curve = "a";
  constraint.position = {3, 4};
  document.records.emplace_back(constraint);
  document.records.emplace_back(UnknownRecord{"{\"type\":\"spline\",\"k\":3}"});
  document.header.history = {"first", "second"};
  document.header.extras = {{"origin", "\"here\""}};
  expect_round_trip(first);
  EXPECT_EQ(read_file(written(document)).document.header.history, document.header.history);
  EXPECT_EQ(read_file(written(document)).document.header.extras, document.header.extras);
}

TEST(RoundTrip, KeepsMadeIds) {
  const Reading first = read(
      "<defs><linearGradient id='a'><stop/></linearGradient><g id='chair'>"
      "<clipPath><path d='M0 0H1'/></clipPath><rect id='seat' width='9' height='9' fill='url(#a)'/>"
      "</g></defs><use href='#chair'/><use href='#chair' x='5' opacity='.5'/>"
      "<g display='none'><path d='M0 0H1'/></g>");
  EXPECT_EQ(read_file(written(first.document)).document.records, first.document.records);
}

TEST(RoundTrip, KeepsAViewportWithinAClip) {
  const Reading first = read(
      "<clipPath id='c'><circle r='9'/></clipPath>"
      "<svg clip-path='url(#c)' width='5' height='5'><path d='M0 0H9V9'/></svg>");
  EXPECT_EQ(read_file(written(first.document)).document.records, first.document.records);
}

TEST(RoundTrip, KeepsUnknownKeysOfStopsGeometryAndParts) {
  Reading first = read(
      "<clipPath id='c'><path d='M0 0H1V1z'/></clipPath><linearGradient id='a'><stop/><stop/>"
      "</linearGradient><rect width='9' height='9' fill='url(#a)' clip-path='url(#c)'/>");
  for (Record& record : first.document.records) {
    if (auto* clip = std::get_if<ClipRecord>(&record)) clip->parts[0].extras = {{"part", "1"}};
    if (auto* gradient = std::get_if<GradientRecord>(&record)) {
      gradient->stops[1].extras = {{"stop", "{\"a\":[1]}"}};
      std::get<LinearGeometry>(gradient->geometry).extras = {{"bend", "\"up\""}};
    }
  }
  EXPECT_EQ(read_file(written(first.document)).document.records, first.document.records);
}

// Documents that no SVG has made come to rest after one trip.
TEST(RoundTrip, SettlesAnyDocument) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Document once = read_file(written(any_document(seed))).document;
    const Document twice = read_file(written(once)).document;
    ASSERT_EQ(twice.records.size(), once.records.size()) << "seed " << seed;
    for (std::size_t i = 0; i < once.records.size(); ++i) {
      EXPECT_EQ(twice.records[i].index(), once.records[i].index()) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace libstyle::svg
