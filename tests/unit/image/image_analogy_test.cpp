// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/image_analogy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "libstyle/base/error.h"
#include "libstyle/image/luminance.h"
#include "libstyle/image/resample.h"
#include "tests/support/literal_image_analogy.h"
#include "tests/support/pictures.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

ImageAnalogyInput input_of(Image unfiltered, Image filtered, Image target) {
  ImageAnalogyInput input;
  input.examples.push_back({std::move(unfiltered), std::move(filtered)});
  input.target = std::move(target);
  return input;
}

// A guide that is different everywhere, so that only one answer is right.
TEST(ImageAnalogy, OfTheExampleItselfIsTheExample) {
  for (const bool exact : {true, false}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Image a = test::noise(48, 37, 3, seed);
      const Image filtered = test::noise(48, 37, 3, seed + 100);
      ImageAnalogyParameters parameters;
      parameters.exact = exact;
      const ImageAnalogyResult result = make_image_analogy(input_of(a, filtered, a), parameters);
      EXPECT_EQ(result.filtered, filtered) << "seed " << seed << (exact ? " exact" : " tree");
      EXPECT_EQ(result.sources[48 * 5 + 7], (SourcePixel{0, 7, 5}));
    }
  }
}

std::vector<SourcePixel> literal(const ImageAnalogyInput& input, int levels, double kappa) {
  std::vector<test::LiteralLevel> pyramid{
      {input.examples[0].unfiltered, input.examples[0].filtered, input.target}};
  while (static_cast<int>(pyramid.size()) < levels) {
    const test::LiteralLevel& finer = pyramid.front();
    pyramid.insert(pyramid.begin(),
                   {image::halved(finer.unfiltered, 1), image::halved(finer.filtered, 1),
                    image::halved(finer.target, 1)});
  }
  return test::literal_image_analogy(pyramid, kappa);
}

TEST(ImageAnalogy, ExactIsThePseudoCodeOfThePaper) {
  for (const int levels : {1, 2, 3}) {
    for (const double kappa : {0.0, 0.1, 1.0}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const ImageAnalogyInput input =
            input_of(test::noise(13, 11, 3, seed), test::noise(13, 11, 1, seed + 10),
                     test::noise(12, 14, 3, seed + 20));
        ImageAnalogyParameters parameters;
        parameters.exact = true;
        parameters.levels = levels;
        parameters.coherence = kappa;
        EXPECT_EQ(make_image_analogy(input, parameters).sources, literal(input, levels, kappa))
            << levels << " levels, kappa " << kappa << ", seed " << seed;
      }
    }
  }
}

// The fault that the comparison above is for.
TEST(ImageAnalogy, AnotherKappaIsSeen) {
  const ImageAnalogyInput input =
      input_of(test::noise(13, 11, 3, 1), test::noise(13, 11, 1, 11), test::noise(12, 14, 3, 21));
  ImageAnalogyParameters parameters;
  parameters.exact = true;
  parameters.levels = 1;
  parameters.coherence = 0.1;
  EXPECT_NE(make_image_analogy(input, parameters).sources, literal(input, 1, 0.2));
}

double share_of_equal(const std::vector<SourcePixel>& a, const std::vector<SourcePixel>& b) {
  double count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] == b[i];
  return count / static_cast<double>(a.size());
}

TEST(ImageAnalogy, IsTheSameOnAnyNumberOfThreads) {
  const ImageAnalogyInput input =
      input_of(test::noise(60, 50, 3, 1), test::noise(60, 50, 3, 2), test::noise(70, 45, 3, 3));
  ImageAnalogyParameters parameters;
  parameters.threads = 1;
  const ImageAnalogyResult one = make_image_analogy(input, parameters);
  for (const int threads : {2, 7}) {
    parameters.threads = threads;
    EXPECT_EQ(make_image_analogy(input, parameters).filtered, one.filtered);
  }
}

TEST(ImageAnalogy, MoreLeavesComeNearerToTheExactSearch) {
  const ImageAnalogyInput input =
      input_of(test::noise(48, 48, 1, 1), test::noise(48, 48, 1, 2), test::noise(40, 40, 1, 3));
  ImageAnalogyParameters parameters;
  parameters.levels = 1;
  parameters.coherence = 0;
  parameters.exact = true;
  const auto exact = make_image_analogy(input, parameters).sources;
  parameters.exact = false;
  parameters.leaves = 1;
  const double few = share_of_equal(make_image_analogy(input, parameters).sources, exact);
  parameters.leaves = 144;
  const double all = share_of_equal(make_image_analogy(input, parameters).sources, exact);
  EXPECT_GT(all, few);
}

TEST(ImageAnalogy, EveryPixelInColorIsOneOfTheExample) {
  const ImageAnalogyInput input =
      input_of(test::noise(20, 20, 1, 1), test::noise(20, 20, 4, 2), test::noise(24, 17, 1, 3));
  const ImageAnalogyResult result = make_image_analogy(input, {});
  ASSERT_EQ(result.filtered.channels, 4);
  for (int y = 0; y < 17; ++y) {
    for (int x = 0; x < 24; ++x) {
      const SourcePixel& source = result.sources[std::size_t(y) * 24 + x];
      EXPECT_TRUE(std::ranges::equal(result.filtered.pixel(x, y),
                                     input.examples[0].filtered.pixel(source.x, source.y)));
    }
  }
}

TEST(ImageAnalogy, HigherKappaCopiesLongerPieces) {
  const ImageAnalogyInput input =
      input_of(test::noise(40, 40, 1, 1), test::noise(40, 40, 1, 2), test::noise(40, 40, 1, 3));
  double before = -1;
  for (const double kappa : {0.0, 0.5, 2.0, 10.0}) {
    ImageAnalogyParameters parameters;
    parameters.coherence = kappa;
    const double share = make_image_analogy(input, parameters).levels.back().coherent_share;
    EXPECT_GT(share, before);
    before = share;
  }
}

TEST(ImageAnalogy, ByLuminanceKeepsTheColorsOfTheTarget) {
  const ImageAnalogyInput input =
      input_of(test::noise(30, 30, 3, 1), test::noise(30, 30, 3, 2), test::noise(25, 31, 4, 3));
  ImageAnalogyParameters parameters;
  parameters.features = MatchFeatures::kLuminance;
  const Image result = make_image_analogy(input, parameters).filtered;
  ASSERT_EQ(result.channels, 4);
  for (int y = 0; y < 31; ++y) {
    for (int x = 0; x < 25; ++x) {
      const auto before = input.target.pixel(x, y);
      const auto after = result.pixel(x, y);
      EXPECT_NEAR(after[0] - after[1], before[0] - before[1], 1e-5);
      EXPECT_NEAR(after[1] - after[2], before[1] - before[2], 1e-5);
      EXPECT_EQ(after[3], before[3]);
    }
  }
}

TEST(ImageAnalogy, RemappingMakesUpForAnotherBrightness) {
  const Image a = test::noise(40, 33, 1, 1);
  const Image filtered = test::noise(40, 33, 1, 2);
  Image darker = a;
  for (float& sample : darker.samples) sample = 0.1F + 0.4F * sample;
  ImageAnalogyParameters parameters;
  parameters.features = MatchFeatures::kLuminance;
  const ImageAnalogyResult result = make_image_analogy(input_of(a, filtered, darker), parameters);
  EXPECT_EQ(result.sources[40 * 20 + 11], (SourcePixel{0, 11, 20}));
  for (std::size_t i = 0; i < filtered.samples.size(); ++i) {
    EXPECT_NEAR(result.filtered.samples[i], 0.1F + 0.4F * filtered.samples[i], 1e-5);
  }
}

TEST(ImageAnalogy, TakesFromTheExampleThatFits) {
  ImageAnalogyInput input;
  const Image a1 = test::noise(24, 20, 1, 1);
  const Image a2 = test::noise(31, 26, 1, 2);
  const Image f1 = test::noise(24, 20, 1, 3);
  const Image f2 = test::noise(31, 26, 1, 4);
  input.examples = {{a1, f1}, {a2, f2}};
  input.target = a2;
  const auto share_of = [&](int example) {
    const auto sources = make_image_analogy(input, {}).sources;
    const auto count = std::ranges::count(sources, example, &SourcePixel::example);
    return static_cast<double>(count) / static_cast<double>(sources.size());
  };
  EXPECT_EQ(share_of(1), 1);
  ImageAnalogyParameters exact;
  exact.exact = true;
  EXPECT_EQ(make_image_analogy(input, exact).filtered, f2);
  input.target = a1;
  EXPECT_EQ(share_of(0), 1);
  EXPECT_EQ(make_image_analogy(input, exact).filtered, f1);
}

TEST(ImageAnalogy, AFurtherGuideDecidesWhereTheFirstSaysNothing) {
  const Image filtered = test::noise(32, 32, 1, 1);
  ImageAnalogyInput input =
      input_of(test::flat(32, 32, 1, 0.5F), filtered, test::flat(32, 32, 1, 0.5F));
  const Image depth = test::noise(32, 32, 3, 2);
  input.guides.push_back({{depth}, depth, 1});
  EXPECT_EQ(make_image_analogy(input, {}).filtered, filtered);
  input.examples[0].unfiltered = {};
  input.target = {};
  EXPECT_EQ(make_image_analogy(input, {}).filtered, filtered) << "a guide alone";
}

TEST(ImageAnalogy, OrientationTellsApartWhatLooksAlikeNearby) {
  const Image a = test::noise(40, 40, 1, 1);
  ImageAnalogyParameters parameters;
  parameters.orientation_weight = 1;
  EXPECT_EQ(make_image_analogy(input_of(a, test::noise(40, 40, 1, 2), a), parameters).filtered,
            test::noise(40, 40, 1, 2));
}

TEST(ImageAnalogy, TakesTheSmallestPictures) {
  for (const auto& [a, b] : {std::pair{1, 1}, {1, 9}, {9, 1}, {4, 4}, {2, 3}}) {
    const ImageAnalogyResult result = make_image_analogy(
        input_of(test::noise(a, a, 3, 1), test::noise(a, a, 3, 2), test::noise(b, b, 3, 3)), {});
    EXPECT_EQ(result.filtered.width, b);
    EXPECT_EQ(result.sources.size(), std::size_t(b) * b);
  }
}

TEST(ImageAnalogy, TakesOneColor) {
  const Image flat = test::flat(30, 30, 3, 0.5F);
  for (const auto features : {MatchFeatures::kColor, MatchFeatures::kLuminance}) {
    ImageAnalogyParameters parameters;
    parameters.features = features;
    const Image result = make_image_analogy(input_of(flat, flat, flat), parameters).filtered;
    for (const float sample : result.samples) EXPECT_NEAR(sample, 0.5F, 1e-6);
  }
}

TEST(ImageAnalogy, SaysWhatIsWrong) {
  const Image good = test::noise(5, 4, 1, 1);
  const auto made = [](const ImageAnalogyInput& input) {
    return [input] { make_image_analogy(input, {}); };
  };
  EXPECT_THAT(made(input_of(test::noise(4, 4, 1, 1), good, good)),
              ThrowsMessage<Error>(HasSubstr("4x4 and the filtered picture is 5x4")));
  EXPECT_THAT(made(input_of({}, good, good)), ThrowsMessage<Error>(HasSubstr("is missing")));
  EXPECT_THAT(made(input_of(good, good, {})), ThrowsMessage<Error>(HasSubstr("no target")));
  EXPECT_THAT(made(ImageAnalogyInput{}), ThrowsMessage<Error>(HasSubstr("no example")));
  Image broken = good;
  broken.pixel(2, 3)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(made(input_of(good, good, broken)),
              ThrowsMessage<Error>(HasSubstr("column 3 of row 4")));
  ImageAnalogyInput guided = input_of(good, good, good);
  guided.guides.push_back({{good}, test::noise(9, 9, 1, 1), 1});
  EXPECT_THAT(made(guided), ThrowsMessage<Error>(HasSubstr("guide 1 of the target is 9x9")));
}

TEST(ImageAnalogyParameters, NameWhatIsOutOfRange) {
  const auto checked = [](const std::function<void(ImageAnalogyParameters&)>& change) {
    return [change] {
      ImageAnalogyParameters parameters;
      change(parameters);
      validate(parameters);
    };
  };
  EXPECT_THAT(checked([](auto& p) { p.coherence = -1; }),
              ThrowsMessage<Error>(HasSubstr("coherence must be 0 to 1000")));
  EXPECT_THAT(checked([](auto& p) { p.coherence = std::nan(""); }),
              ThrowsMessage<Error>(HasSubstr("coherence")));
  EXPECT_THAT(checked([](auto& p) { p.window = 4; }),
              ThrowsMessage<Error>(HasSubstr("window must be odd")));
  EXPECT_THAT(checked([](auto& p) { p.components = 17; }),
              ThrowsMessage<Error>(HasSubstr("components must be 1 to 15")));
}

TEST(CopyFromSources, PutsOtherPicturesTogetherAlike) {
  const ImageAnalogyInput input =
      input_of(test::noise(20, 20, 1, 1), test::noise(20, 20, 3, 2), test::noise(10, 15, 1, 3));
  const ImageAnalogyResult result = make_image_analogy(input, {});
  EXPECT_EQ(copy_from_sources({input.examples[0].filtered}, result.sources, 10, 15),
            result.filtered);
  EXPECT_THAT([&] { copy_from_sources({test::noise(3, 3, 1, 1)}, result.sources, 10, 15); },
              ThrowsMessage<Error>(HasSubstr("does not fit the examples")));
}

}  // namespace
}  // namespace libstyle
