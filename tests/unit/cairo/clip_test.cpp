// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "libstyle/base/error.h"
#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

constexpr const char* kPage = "M0 0 L100 0 L100 100 L0 100 Z";
constexpr const char* kLeft = "M10 10 L60 10 L60 90 L10 90 Z";
constexpr const char* kLeftBackwards = "M10 10 L10 90 L60 90 L60 10 Z";
constexpr const char* kRight = "M40 10 L90 10 L90 90 L40 90 Z";

PathRecord clipped(PathRecord record, std::string id) {
  record.clip = std::move(id);
  return record;
}

TEST(DrawClip, LetsThroughWhatIsInside) {
  EXPECT_EQ(draw(make_page({clip("c", {part(kLeft)}), clipped(filled(kPage), "c")})),
            draw(make_page({filled(kLeft)})));
}

// Drawn as one path, parts of opposite direction would cancel where they overlap.
TEST(DrawClip, PartsAreAUnionWhateverTheirDirection) {
  const Raster expected = draw(make_page({filled(kLeft), filled(kRight)}));
  for (const char* left : {kLeft, kLeftBackwards}) {
    const ClipRecord both = clip("c", {part(left), part(kRight)});
    EXPECT_EQ(draw(make_page({both, clipped(filled(kPage), "c")})), expected);
    EXPECT_EQ(draw(make_page({both, group("g", 1, "c"), in("g", filled(kPage))})), expected);
  }
}

TEST(DrawClip, EachPartHasItsOwnRule) {
  const std::string twice = std::string(kLeft) + kLeft;
  const ClipRecord record = clip("c", {part(twice, FillRule::kEvenOdd), part(kRight)});
  EXPECT_EQ(draw(make_page({record, clipped(filled(kPage), "c")})),
            draw(make_page({filled(kRight)})));
}

TEST(DrawClip, WithinAnotherClipIsTheIntersection) {
  const Raster expected = draw(make_page({filled("M40 10 L60 10 L60 90 L40 90 Z")}));
  ClipRecord inner = clip("inner", {part(kRight)});
  inner.clip = "outer";
  EXPECT_EQ(draw(make_page({clip("outer", {part(kLeft)}), inner, clipped(filled(kPage), "inner")})),
            expected);
  ClipRecord parted = clip("inner", {part(kRight), part(kRight)});
  for (ClipPart& each : parted.parts) each.clip = "outer";
  EXPECT_EQ(
      draw(make_page({clip("outer", {part(kLeft)}), parted, clipped(filled(kPage), "inner")})),
      expected);
}

TEST(DrawClip, WithoutPartsLetsNothingThrough) {
  EXPECT_EQ(covered_area(draw(make_page({clip("c", {}), clipped(filled(kPage), "c")}))), 0);
}

TEST(DrawClip, AMissingClipIsWarnedAboutAndIgnored) {
  std::vector<Warning> warnings;
  const Raster image = draw(make_page({clipped(filled(kLeft), "c")}),
                           [&](const Warning& w) { warnings.push_back(w); });
  EXPECT_EQ(image, draw(make_page({filled(kLeft)})));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].message, ::testing::HasSubstr("\"c\""));
}

TEST(DrawClip, ReferencesForwardMakeNoCycle) {
  ClipRecord first = clip("a", {part(kLeft), part(kRight)});
  first.clip = "b";
  first.parts[0].clip = "a";
  ClipRecord second = clip("b", {part(kPage)});
  second.clip = "a";
  const Raster image = draw(make_page({first, second, clipped(filled(kPage), "b")}));
  EXPECT_EQ(image, draw(make_page({filled(kLeft), filled(kRight)})));
}

// Ten parts within ten parts within ...: 10^40 without a limit.
TEST(DrawClip, ClipsThatMultiplyAreAnError) {
  Records records;
  for (int level = 0; level < 40; ++level) {
    ClipRecord record =
        clip(std::to_string(level), std::vector<ClipPart>(10, part("M0 0 L9 0 L9 9 Z")));
    for (ClipPart& each : record.parts) each.clip = std::to_string(level - 1);
    records.emplace_back(std::move(record));
  }
  records.emplace_back(clipped(filled(kPage), "39"));
  EXPECT_THROW(draw(make_page(std::move(records))), Error);
}

}  // namespace
}  // namespace libstyle
