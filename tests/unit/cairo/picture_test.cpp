// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/picture.h"

#include <gmock/gmock.h>

#include "libstyle/base/error.h"
#include "tests/support/seeds.h"
#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Document some_drawing() {
  PathRecord colored = stroked("M10 10 C40 90 60 -20 90 90", 5);
  colored.along.colors = {{255, 0, 0}, {0, 0, 255, 99}};
  return make_page({group("g", 0.4), in("g", filled("M10 10 L60 10 L60 90 Z", kRed)),
                    in("g", stroked("M0 0 L99 99", 7)), colored});
}

std::string picture_of(const std::vector<Document>& documents, const PictureSettings& settings) {
  TextSink sink;
  Picture picture(sink, settings, {});
  for (const Document& document : documents) picture.add(document);
  picture.finish();
  return sink.text;
}

Raster sized(const Document& document, const PictureSize& size) {
  PictureSettings settings;
  settings.size = size;
  return decode_png(picture_of({document}, settings));
}

TEST(Picture, TheSameDocumentGivesTheSameBytes) {
  for (const PictureFormat format : {PictureFormat::kPng, PictureFormat::kPdf}) {
    PictureSettings settings;
    settings.format = format;
    EXPECT_EQ(picture_of({some_drawing()}, settings), picture_of({some_drawing()}, settings));
  }
}

TEST(Picture, PdfHoldsADocumentAPageAndNoDate) {
  PictureSettings settings;
  settings.format = PictureFormat::kPdf;
  const std::string pdf = picture_of({some_drawing(), some_drawing(), some_drawing()}, settings);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/Count 3"));
  EXPECT_THAT(pdf, Not(HasSubstr("Date")));
  EXPECT_THAT(pdf, HasSubstr("%%EOF"));
}

TEST(Picture, PngAndSvgHoldOne) {
  for (const PictureFormat format : {PictureFormat::kPng, PictureFormat::kSvg}) {
    PictureSettings settings;
    settings.format = format;
    EXPECT_THROW(picture_of({some_drawing(), some_drawing()}, settings), Error);
  }
}

TEST(Picture, APageThatFailsLeavesNoTrace) {
  Document bad = some_drawing();
  for (int i = 0; i < 2000; ++i) {  // more groups in each other than can be drawn
    GroupRecord layer = group("n" + std::to_string(i), 0.5);
    if (i > 0) layer.parent = "n" + std::to_string(i - 1);
    bad.records.emplace_back(layer);
  }
  bad.records.emplace_back(in("n1999", filled("M0 0 L9 9 L0 9 Z")));
  PictureSettings settings;
  settings.format = PictureFormat::kPdf;
  TextSink sink;
  Picture picture(sink, settings, {});
  EXPECT_THROW(picture.add(bad), Error);
  picture.add(some_drawing());
  EXPECT_THROW(picture.add(bad), Error);
  picture.add(some_drawing());
  EXPECT_THROW(picture.add(bad), Error);
  picture.finish();
  EXPECT_EQ(sink.text, picture_of({some_drawing(), some_drawing()}, settings));
}

TEST(Picture, TheFormatIsThatOfTheEnding) {
  EXPECT_EQ(picture_format("out/a.b.png"), PictureFormat::kPng);
  EXPECT_EQ(picture_format("A.SVG"), PictureFormat::kSvg);
  EXPECT_EQ(picture_format("{name}.pdf"), PictureFormat::kPdf);
  EXPECT_EQ(picture_format("pdf"), std::nullopt);
}

TEST(Picture, PngKeepsEveryPixel) {
  for_each_seed(20, [](std::uint64_t seed) {
    RandomValues random(seed);
    Raster image(1 + random.below(50), 1 + random.below(50));
    const bool opaque = random.chance(0.5);
    for (Pixel& pixel : image.pixels) {
      const std::size_t alpha = opaque ? 255 : random.below(256);
      for (std::size_t i = 0; i < 3; ++i)
        pixel[i] = static_cast<std::uint8_t>(random.below(alpha + 1));
      pixel[3] = static_cast<std::uint8_t>(alpha);
    }
    TextSink sink;
    encode_png(sink, image);
    EXPECT_EQ(count_different(decode_png(sink.text), image, 1), 0u);
  });
}

TEST(Picture, TheSizeIsThatOfThePageOrAsAskedFor) {
  Document document = some_drawing();
  document.header.height = 50.2;
  const auto size = [&](const PictureSize& asked) {
    const Raster image = sized(document, asked);
    return std::pair(image.width, image.height);
  };
  EXPECT_EQ(size({}), std::pair(std::size_t{100}, std::size_t{51}));
  EXPECT_EQ(size({{}, {}, 2}), std::pair(std::size_t{200}, std::size_t{101}));
  EXPECT_EQ(size({300, {}, 1}), std::pair(std::size_t{300}, std::size_t{151}));
  EXPECT_EQ(size({{}, 25.1, 1}), std::pair(std::size_t{50}, std::size_t{26}));
  EXPECT_EQ(size({300, 50.2, 1}), std::pair(std::size_t{100}, std::size_t{51}));
}

TEST(Picture, WithoutAPageItIsAsLargeAsWhatIsDrawn) {
  Document document = make_page({filled("M-20 30 L40 30 L40 70 L-20 70 Z"), group("hidden")});
  std::get<GroupRecord>(document.records[1]).hidden = true;
  document.records.emplace_back(in("hidden", filled("M0 0 L900 0 L900 900 Z")));
  document.header.width.reset();
  document.header.height.reset();
  const Raster image = draw(document);
  EXPECT_EQ(image.width, 60u);
  EXPECT_EQ(image.height, 40u);
  EXPECT_DOUBLE_EQ(covered_area(image), 2400);
}

TEST(Picture, NothingOnNoPageIsOneEmptyPixelAndAWarning) {
  int warnings = 0;
  EXPECT_EQ(draw(Document{}, [&](const Warning&) { ++warnings; }), Raster(1, 1));
  EXPECT_EQ(warnings, 1);
}

TEST(Picture, PagesBeyondAllSizesAreAnError) {
  for (const double side : {40000.0, 1e9, 1e308}) {
    Document document = some_drawing();
    document.header.width = side;
    for (const PictureFormat format : {PictureFormat::kPng, PictureFormat::kPdf}) {
      PictureSettings settings;
      settings.format = format;
      if (side < 1e6 && format == PictureFormat::kPdf) continue;
      EXPECT_THROW(picture_of({document}, settings), Error) << side;
    }
  }
}

TEST(Picture, TheBackgroundIsUnderEverything) {
  PictureSettings settings;
  settings.background = Color{10, 20, 30};
  const Raster image =
      decode_png(picture_of({make_page({filled("M0 0 L50 0 L50 100 L0 100 Z", kRed)})}, settings));
  EXPECT_EQ(image.at(25, 50), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(image.at(75, 50), (Pixel{10, 20, 30, 255}));
}

class BrokenSink final : public ByteSink {
 public:
  void write(std::string_view) override { throw Error("no room"); }
};

TEST(Picture, WhatASinkThrowsComesThroughCairo) {
  for (const PictureFormat format :
       {PictureFormat::kPng, PictureFormat::kSvg, PictureFormat::kPdf}) {
    PictureSettings settings;
    settings.format = format;
    BrokenSink sink;
    const auto run = [&] {
      Picture picture(sink, settings, {});
      picture.add(some_drawing());
      picture.finish();
    };
    EXPECT_THROW(run(), Error);
  }
}

}  // namespace
}  // namespace libstyle
