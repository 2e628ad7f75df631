// SPDX-License-Identifier: Apache-2.0
#include "converters/image/image_file.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::array kFormats{ImageFormat::kPng, ImageFormat::kJpeg, ImageFormat::kTiff,
                              ImageFormat::kPnm, ImageFormat::kExr};
constexpr std::array kDepths{SampleDepth::k8, SampleDepth::k16, SampleDepth::kFloat};

// Bytes from numbers, as files are written down.
std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result += static_cast<char>(value);
  return result;
}

// A file with given content for as long as it lives.
class FileWith {
 public:
  explicit FileWith(const std::string& content)
      : name_(std::filesystem::temp_directory_path() /
              ("image_file_test." + std::to_string(getpid()))) {
    std::ofstream(name_, std::ios::binary) << content;
  }
  ~FileWith() { std::filesystem::remove(name_); }
  FileWith(const FileWith&) = delete;
  FileWith& operator=(const FileWith&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

ImageFile read_bytes(const std::string& content) { return read_image(FileWith(content).name()); }

// What read_image() says of bad content, with the name of the file in front taken off.
std::string complaint(const std::string& content) {
  const FileWith file(content);
  ::testing::internal::CaptureStderr();
  std::string message;
  try {
    read_image(file.name());
  } catch (const Error& error) {
    EXPECT_EQ(error.place().file, file.name());
    message = error.message();
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message;
}

Image make_image(int width, int height, int channels, std::vector<float> samples) {
  Image image(width, height, channels);
  image.samples = std::move(samples);
  return image;
}

// Every sample another one, each exactly one of the depth. Wider than high, to tell these apart.
Image sample_image(int channels, SampleDepth depth) {
  Image image(31, 17, channels);
  std::uint32_t state = 1;
  for (float& sample : image.samples) {
    state = state * 1664525 + 1013904223;
    if (depth == SampleDepth::k8) sample = static_cast<float>(state >> 24) / 255;
    if (depth == SampleDepth::k16) sample = static_cast<float>(state >> 16) / 65535;
    if (depth == SampleDepth::kFloat) sample = static_cast<float>(state >> 8) / 8e6f - 1;
  }
  return image;
}

Image without_alpha(const Image& image) {
  Image result(image.width, image.height, image.color_channels());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::ranges::copy(image.pixel(x, y).first(static_cast<std::size_t>(result.channels)),
                        result.pixel(x, y).begin());
    }
  }
  return result;
}

// Grey and alpha as red, green, blue and alpha.
Image in_color(const Image& image) {
  Image result(image.width, image.height, 4);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto from = image.pixel(x, y);
      std::ranges::copy(std::array{from[0], from[0], from[0], from[1]}, result.pixel(x, y).begin());
    }
  }
  return result;
}

// What is left of an image in a file of a format.
Image kept(const Image& image, ImageFormat format) {
  if (!image.has_alpha()) return image;
  if (format == ImageFormat::kPnm || format == ImageFormat::kJpeg) return without_alpha(image);
  return image.channels == 2 ? in_color(image) : image;
}

std::string big_endian(std::uint32_t value) {
  return bytes({static_cast<int>(value >> 24), static_cast<int>(value >> 16 & 0xff),
                static_cast<int>(value >> 8 & 0xff), static_cast<int>(value & 0xff)});
}

std::string png_chunk(const std::string& content_with_name) {
  std::uint32_t checksum = ~0u;
  for (const char c : content_with_name) {
    checksum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) {
      checksum = checksum >> 1 ^ ((checksum & 1) != 0 ? 0xEDB88320u : 0u);
    }
  }
  return big_endian(static_cast<std::uint32_t>(content_with_name.size() - 4)) + content_with_name +
         big_endian(~checksum);
}

// A PNG whose rows, each with its filter in front, are not compressed.
std::string png(std::uint32_t width, std::uint32_t height, int bits, int color_type,
                const std::string& rows, const std::string& chunks_before = "") {
  std::uint32_t a = 1, b = 0;
  for (const char c : rows) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const int size = static_cast<int>(rows.size());
  const std::string data =
      bytes({0x78, 1, 1, size & 0xff, size >> 8, ~size & 0xff, ~size >> 8 & 0xff}) + rows +
      big_endian(b << 16 | a);
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR" + big_endian(width) + big_endian(height) +
                   bytes({bits, color_type, 0, 0, 0})) +
         chunks_before + png_chunk("IDAT" + data) + png_chunk("IEND");
}

struct TiffField {
  int tag;
  int value;
};

// A TIFF of one row, low bytes first, whose fields are all short integers. libtiff takes one number
// of bits for all samples.
std::string tiff(int width, int bits, int samples, int photometric, const std::string& row,
                 const std::vector<TiffField>& more) {
  const int data_at = 8, directory_at = data_at + static_cast<int>(row.size());
  std::vector<TiffField> fields{
      {256, width},   {257, 1},           {258, bits},
      {259, 1},       {262, photometric}, {273, data_at},
      {277, samples}, {278, 1},           {279, static_cast<int>(row.size())},
      {284, 1}};
  fields.insert(fields.end(), more.begin(), more.end());
  std::string result = bytes({'I', 'I', 42, 0, directory_at, 0, 0, 0}) + row +
                       bytes({static_cast<int>(fields.size()), 0});
  for (const auto& [tag, value] : fields) {
    result += bytes({tag & 0xff, tag >> 8, 3, 0, 1, 0, 0, 0, value & 0xff, value >> 8, 0, 0});
  }
  return result + bytes({0, 0, 0, 0});
}

// The same JPEG with a note of the camera on how it was held.
std::string with_orientation(const std::string& jpeg, int orientation) {
  const std::string note = bytes({0xFF, 0xE1, 0, 34}) + "Exif" + bytes({0, 0}) + "MM" +
                           bytes({0, 42, 0, 0, 0, 8,           0, 1, 0x01, 0x12, 0, 3,
                                  0, 0,  0, 1, 0, orientation, 0, 0, 0,    0,    0, 0});
  return jpeg.substr(0, 2) + note + jpeg.substr(2);
}

// Dark, with one corner of 8 x 8 pixels that is bright.
Image bright_corner(int width, int height, int channels, bool is_right, bool is_low) {
  Image image(width, height, channels);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto pixel = image.pixel(is_right ? width - 1 - x : x, is_low ? height - 1 - y : y);
      std::ranges::fill(pixel, 1.f);
    }
  }
  return image;
}

void expect_near(const Image& actual, const Image& expected, float tolerance) {
  ASSERT_EQ(actual.width, expected.width);
  ASSERT_EQ(actual.height, expected.height);
  ASSERT_EQ(actual.channels, expected.channels);
  for (std::size_t i = 0; i < expected.samples.size(); ++i) {
    ASSERT_NEAR(actual.samples[i], expected.samples[i], tolerance) << "sample " << i;
  }
}

TEST(ImageFile, ReadsBackWhatItWrote) {
  for (const ImageFormat format : kFormats) {
    if (format == ImageFormat::kJpeg) continue;
    for (const SampleDepth depth : kDepths) {
      if (fitting_depth(format, depth) != depth) continue;
      for (int channels = 1; channels <= 4; ++channels) {
        SCOPED_TRACE(::testing::Message() << "format " << int(format) << ", depth " << int(depth)
                                          << ", " << channels << " channels");
        const Image image = sample_image(channels, depth);
        const ImageFile file = read_bytes(encode_image(image, format, depth));
        EXPECT_EQ(file.depth, depth);
        const bool is_multiplied = format == ImageFormat::kExr && image.has_alpha();
        expect_near(file.image, kept(image, format), is_multiplied ? 1e-6f : 0.f);
      }
    }
  }
}

TEST(ImageFile, JpegKeepsSmoothPictures) {
  for (int channels = 1; channels <= 4; ++channels) {
    Image image(40, 24, channels);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const auto pixel = image.pixel(x, y);
        for (int c = 0; c < channels; ++c) pixel[c] = c == 1 ? 0.5f : 0.2f + 0.01f * float(x + c);
      }
    }
    const ImageFile file = read_bytes(encode_image(image, ImageFormat::kJpeg, SampleDepth::kFloat));
    EXPECT_EQ(file.depth, SampleDepth::k8);
    expect_near(file.image, kept(image, ImageFormat::kJpeg), 0.03f);
  }
}

TEST(ImageFile, IntegersAreCutOffAndRounded) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Image image = make_image(
      7, 1, 1, {-kInfinity, -0.1f, 0.49f / 255, 0.51f / 255, 254.49f / 255, 1.1f, kInfinity});
  const Image expected = make_image(7, 1, 1, {0, 0, 0, 1.f / 255, 254.f / 255, 1, 1});
  for (const ImageFormat format : {ImageFormat::kPng, ImageFormat::kTiff, ImageFormat::kPnm}) {
    EXPECT_EQ(read_bytes(encode_image(image, format, SampleDepth::k8)).image, expected);
  }
}

TEST(ImageFile, IsTheSameBytesEachTime) {
  for (const ImageFormat format : kFormats) {
    for (const SampleDepth depth : kDepths) {
      const Image image = sample_image(3, depth);
      EXPECT_EQ(encode_image(image, format, depth), encode_image(image, format, depth));
    }
  }
}

TEST(ImageFile, WhatNoFormatHoldsIsNotWritten) {
  for (const ImageFormat format : kFormats) {
    EXPECT_THROW(encode_image(Image(), format, SampleDepth::k8), Error);
    EXPECT_THROW(encode_image(Image(2, 2, 5), format, SampleDepth::k8), Error);
  }
  // The numbers in a JPEG end at 65535.
  EXPECT_THROW(encode_image(Image(70000, 1, 1), ImageFormat::kJpeg, SampleDepth::k8), Error);
}

TEST(ImageFile, FormatsAreToldByTheEndOfTheName) {
  EXPECT_EQ(image_format("a.b/c.PNG"), ImageFormat::kPng);
  EXPECT_EQ(image_format("a.jpg"), ImageFormat::kJpeg);
  EXPECT_EQ(image_format("a.jpeg"), ImageFormat::kJpeg);
  EXPECT_EQ(image_format("a.tif"), ImageFormat::kTiff);
  EXPECT_EQ(image_format("a.tiff"), ImageFormat::kTiff);
  EXPECT_EQ(image_format("a.pnm"), ImageFormat::kPnm);
  EXPECT_EQ(image_format("a.ppm"), ImageFormat::kPnm);
  EXPECT_EQ(image_format("a.pgm"), ImageFormat::kPnm);
  EXPECT_EQ(image_format("a.exr"), ImageFormat::kExr);
  EXPECT_EQ(image_format("a.png.txt"), std::nullopt);
  EXPECT_EQ(image_format("png"), std::nullopt);
  EXPECT_EQ(image_format(""), std::nullopt);
}

TEST(ImageFile, DepthsFitTheFormat) {
  using enum SampleDepth;
  const auto fitting = [](ImageFormat format) {
    return std::array{fitting_depth(format, k8), fitting_depth(format, k16),
                      fitting_depth(format, kFloat)};
  };
  EXPECT_EQ(fitting(ImageFormat::kPng), (std::array{k8, k16, k16}));
  EXPECT_EQ(fitting(ImageFormat::kJpeg), (std::array{k8, k8, k8}));
  EXPECT_EQ(fitting(ImageFormat::kTiff), (std::array{k8, k16, kFloat}));
  EXPECT_EQ(fitting(ImageFormat::kPnm), (std::array{k8, k16, k16}));
  EXPECT_EQ(fitting(ImageFormat::kExr), (std::array{kFloat, kFloat, kFloat}));
}

TEST(ImageFile, ReadsPngOfAPalette) {
  const std::string palette = png_chunk("PLTE" + bytes({255, 0, 0, 0, 51, 255}));
  const std::string row = bytes({0, 0x40});  // 2 bits a pixel: 1, 0
  EXPECT_EQ(read_bytes(png(2, 1, 2, 3, row, palette)).image,
            make_image(2, 1, 3, {0, 0.2f, 1, 1, 0, 0}));
  const std::string alpha = png_chunk("tRNS" + bytes({51}));
  EXPECT_EQ(read_bytes(png(2, 1, 2, 3, row, palette + alpha)).image,
            make_image(2, 1, 4, {0, 0.2f, 1, 1, 1, 0, 0, 0.2f}));
}

TEST(ImageFile, ReadsPngOfFewBits) {
  EXPECT_EQ(read_bytes(png(3, 1, 1, 0, bytes({0, 0xA0}))).image, make_image(3, 1, 1, {1, 0, 1}));
  EXPECT_EQ(read_bytes(png(2, 1, 4, 0, bytes({0, 0x3F}))).image, make_image(2, 1, 1, {0.2f, 1}));
}

TEST(ImageFile, ReadsPngOfGreyAndAlpha) {
  EXPECT_EQ(read_bytes(png(2, 1, 8, 4, bytes({0, 51, 255, 255, 0}))).image,
            make_image(2, 1, 4, {0.2f, 0.2f, 0.2f, 1, 1, 1, 1, 0}));
  const ImageFile fine = read_bytes(png(1, 1, 16, 4, bytes({0, 0x33, 0x33, 0x66, 0x66})));
  EXPECT_EQ(fine.depth, SampleDepth::k16);
  EXPECT_EQ(fine.image, make_image(1, 1, 4, {0.2f, 0.2f, 0.2f, 0.4f}));
}

// All eight ways to hold a camera: where the corner goes that is bright at the top left, and
// whether sides change places.
TEST(ImageFile, JpegIsTurnedAsTheCameraSays) {
  struct Turn {
    int orientation;
    bool is_right, is_low, is_on_its_side;
  };
  for (const int channels : {1, 3}) {
    const std::string jpeg = encode_image(bright_corner(32, 16, channels, false, false),
                                          ImageFormat::kJpeg, SampleDepth::k8);
    for (const auto& turn :
         {Turn{1, false, false, false}, Turn{2, true, false, false}, Turn{3, true, true, false},
          Turn{4, false, true, false}, Turn{5, false, false, true}, Turn{6, true, false, true},
          Turn{7, true, true, true}, Turn{8, false, true, true}}) {
      SCOPED_TRACE(turn.orientation);
      const auto [width, height] = turn.is_on_its_side ? std::pair(16, 32) : std::pair(32, 16);
      expect_near(read_bytes(with_orientation(jpeg, turn.orientation)).image,
                  bright_corner(width, height, channels, turn.is_right, turn.is_low), 0.02f);
    }
  }
}

TEST(ImageFile, ReadsPnmOfAnyMaximum) {
  const Image grey = make_image(2, 1, 1, {0.2f, 1});
  EXPECT_EQ(read_bytes("P5 2 1 15\n" + bytes({3, 15})).image, grey);
  EXPECT_EQ(read_bytes("P5\n# 9 9 9\n2 1\n1000\n" + bytes({0, 200, 3, 232})).image, grey);
  EXPECT_EQ(read_bytes("P2 2 1 15\n3 15\n").image, grey);
  EXPECT_EQ(read_bytes("P2 2 1 1000\n200 1000\n").image, grey);
  const Image colored = make_image(1, 1, 3, {1, 0.2f, 0});
  EXPECT_EQ(read_bytes("P6 1 1 15\n" + bytes({15, 3, 0})).image, colored);
  EXPECT_EQ(read_bytes("P3 1 1 255\n255 51 0\n").image, colored);
  EXPECT_EQ(read_bytes("P1 2 1\n1 0\n").image, make_image(2, 1, 1, {0, 1}));
  EXPECT_EQ(read_bytes("P4 2 1\n" + bytes({0x80})).image, make_image(2, 1, 1, {0, 1}));
}

TEST(ImageFile, ReadsPam) {
  const auto head = [](int depth, const std::string& type) {
    return "P7\nWIDTH 1\nHEIGHT 1\nDEPTH " + std::to_string(depth) + "\nMAXVAL 255\nTUPLTYPE " +
           type + "\nENDHDR\n";
  };
  EXPECT_EQ(read_bytes(head(3, "RGB") + bytes({255, 51, 0})).image,
            make_image(1, 1, 3, {1, 0.2f, 0}));
  EXPECT_EQ(read_bytes(head(4, "RGB_ALPHA") + bytes({255, 51, 0, 102})).image,
            make_image(1, 1, 4, {1, 0.2f, 0, 0.4f}));
  EXPECT_EQ(read_bytes(head(2, "GRAYSCALE_ALPHA") + bytes({255, 51})).image,
            make_image(1, 1, 2, {1, 0.2f}));
  EXPECT_THAT(complaint(head(1, "BLACKANDWHITE") + bytes({1})), HasSubstr("would be misread"));
}

TEST(ImageFile, AlphaOfTiffIsStraightWhateverTheFileSays) {
  constexpr int kExtraSamples = 338, kUnspecified = 0, kMultiplied = 1, kStraight = 2, kRgb = 2;
  const std::string row = bytes({51, 102, 0, 102});
  const Image straight = make_image(1, 1, 4, {0.2f, 0.4f, 0, 0.4f});
  for (const int kind : {kUnspecified, kStraight}) {
    EXPECT_EQ(read_bytes(tiff(1, 8, 4, kRgb, row, {{kExtraSamples, kind}})).image, straight);
  }
  expect_near(read_bytes(tiff(1, 8, 4, kRgb, row, {{kExtraSamples, kMultiplied}})).image,
              make_image(1, 1, 4, {0.5f, 1, 0, 0.4f}), 1e-6f);
}

TEST(ImageFile, ReadsTiffWhereWhiteIsZero) {
  EXPECT_EQ(read_bytes(tiff(2, 8, 1, 0, bytes({0, 204}), {})).image,
            make_image(2, 1, 1, {1, 0.2f}));
  EXPECT_EQ(read_bytes(tiff(2, 16, 1, 0, bytes({0, 0, 0xCC, 0xCC}), {})).image,
            make_image(2, 1, 1, {1, 0.2f}));
}

TEST(ImageFile, TiffThatWouldBeMisreadIsAnError) {
  constexpr int kSampleFormat = 339, kSigned = 2;
  EXPECT_THAT(complaint(tiff(1, 8, 2, 1, bytes({51, 102}), {})), HasSubstr("would be misread"));
  EXPECT_THAT(complaint(tiff(1, 16, 1, 1, bytes({51, 102}), {{kSampleFormat, kSigned}})),
              HasSubstr("would be misread"));
}

// With no alpha, nothing is left of a colour that was multiplied by it.
TEST(ImageFile, ColorsOfExrAreMultipliedByAlpha) {
  const Image image = make_image(2, 1, 4, {0.5f, 1, 0.25f, 0.5f, 0.5f, 1, 0.25f, 0});
  EXPECT_EQ(read_bytes(encode_image(image, ImageFormat::kExr, SampleDepth::kFloat)).image,
            make_image(2, 1, 4, {0.5f, 1, 0.25f, 0.5f, 0, 0, 0, 0}));
}

TEST(ImageFile, WhatIsMissingIsSaid) {
  try {
    read_image("/no/such/picture.png");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), StartsWith("/no/such/picture.png: cannot be opened"));
  }
  try {
    read_image("/tmp");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), StartsWith("/tmp: is a folder"));
  }
}

TEST(ImageFile, WhatIsNoPictureIsAnError) {
  EXPECT_THAT(complaint(""), StartsWith("is empty"));
  for (const char* text : {"once upon a time\n", "P", "P9 1 1\n", "<svg/>", "PK"}) {
    EXPECT_EQ(complaint(text), "is no picture that can be read (PNG, JPEG, TIFF, PNM or EXR)");
  }
}

TEST(ImageFile, WhatIsCutOffIsAnError) {
  for (const ImageFormat format : kFormats) {
    for (const SampleDepth depth : kDepths) {
      const std::string whole = encode_image(sample_image(3, depth), format, depth);
      for (std::size_t size = whole.size() - 1; size > 0; size = size * 3 / 4) {
        EXPECT_NE(complaint(whole.substr(0, size)), "")
            << "format " << int(format) << ", " << size << " of " << whole.size() << " bytes";
      }
    }
  }
}

// The end of the thumbnail is not the end of the picture.
TEST(ImageFile, JpegWithAThumbnailThatIsCutOffIsAnError) {
  const std::string jpeg =
      encode_image(sample_image(3, SampleDepth::k8), ImageFormat::kJpeg, SampleDepth::k8);
  const std::string small = encode_image(Image(1, 1, 1), ImageFormat::kJpeg, SampleDepth::k8);
  const auto length = static_cast<int>(small.size()) + 2;
  const std::string both =
      jpeg.substr(0, 2) + bytes({0xFF, 0xE5, length >> 8, length & 0xff}) + small + jpeg.substr(2);
  EXPECT_EQ(complaint(both), "");
  EXPECT_THAT(complaint(both.substr(0, both.size() - 2)), StartsWith("is cut off"));
}

TEST(ImageFile, DamageIsAnErrorOfOneLineAndNoNoise) {
  for (const ImageFormat format : kFormats) {
    const std::string whole =
        encode_image(sample_image(3, SampleDepth::k8), format, SampleDepth::k8);
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 97) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(~damaged[at]);
      complaint(damaged);  // some damage only changes the picture
    }
  }
}

TEST(ImageFile, TooManyPixelsAreNeverUnpacked) {
  EXPECT_THAT(complaint(png(40000, 40000, 8, 0, "")), StartsWith("has more than 2^28 pixels"));
  EXPECT_THAT(complaint("P5 40000 40000 255\n"), StartsWith("has more than 2^28 pixels"));
}

TEST(ImageFile, SamplesThatAreNoNumbersAreAnError) {
  for (const float odd :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    for (const ImageFormat format : {ImageFormat::kExr, ImageFormat::kTiff}) {
      Image image(5, 4, 3);
      image.pixel(3, 2)[1] = odd;
      EXPECT_THAT(complaint(encode_image(image, format, SampleDepth::kFloat)),
                  HasSubstr("in column 3 of row 2"));
    }
  }
}

}  // namespace
}  // namespace libstyle
