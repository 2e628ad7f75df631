// SPDX-License-Identifier: Apache-2.0
#include "converters/image/image_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "converters/common/files.h"
#include "converters/image/picture_facts.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

constexpr std::size_t kMostBytes = std::size_t{2047} << 20;  // OpenCV counts them in an int
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

// libpng and libjpeg, as OpenCV calls them, print warnings to stderr and offer no way to be told
// otherwise; what is wrong with a file is said by us, in one line. One thread at a time: two that
// overlap would put each other's silence back as the stream.
class QuietStderr {
 public:
  QuietStderr() : lock_(mutex()), kept_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nothing >= 0) dup2(nothing, STDERR_FILENO);
    if (nothing >= 0) close(nothing);
  }
  ~QuietStderr() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }

  std::lock_guard<std::mutex> lock_;
  int kept_;
};

// Before the first picture. OpenCV asks for the variable when it first meets an EXR.
void set_up_opencv() {
  static const bool once = [] {
    setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 1);
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    return true;
  }();
  static_cast<void>(once);
}

cv::Mat decode(const std::string& bytes, int flags) {
  const cv::Mat data(1, static_cast<int>(bytes.size()), CV_8U,
                     const_cast<char*>(bytes.data()));  // only read
  const QuietStderr quiet;
  try {
    return cv::imdecode(data, flags);
  } catch (const std::exception&) {  // of OpenCV, or of OpenEXR below it
    return {};
  }
}

// The largest sample of an integer type; 0 for what is no fraction of one.
double most_of(SampleDepth depth) {
  switch (depth) {
    case SampleDepth::k8:
      return 255;
    case SampleDepth::k16:
      return 65535;
    case SampleDepth::kFloat:
      break;
  }
  return 0;
}

SampleDepth sample_depth(int depth) {
  switch (depth) {
    case CV_8U:
      return SampleDepth::k8;
    case CV_16U:
      return SampleDepth::k16;
    default:
      return SampleDepth::kFloat;
  }
}

// Colours that are multiplied by alpha, made straight. Where nothing is seen there is nothing to
// divide by, and they stay.
void divide_by_alpha(Image& image) {
  for (std::size_t at = 0; at < image.samples.size(); at += 4) {
    const float alpha = image.samples[at + 3];
    if (alpha == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) image.samples[at + c] /= alpha;
  }
}

// OpenCV has blue first.
void swap_red_and_blue(cv::Mat& pixels) {
  if (pixels.channels() == 3) cv::cvtColor(pixels, pixels, cv::COLOR_BGR2RGB);
  if (pixels.channels() == 4) cv::cvtColor(pixels, pixels, cv::COLOR_BGRA2RGBA);
}

void check_finite(const Image& image, const Place& place) {
  const auto is_finite = [](float sample) { return std::isfinite(sample); };
  const auto odd = std::ranges::find_if_not(image.samples, is_finite);
  if (odd == image.samples.end()) return;
  const auto pixel = (odd - image.samples.begin()) / image.channels;
  throw Error(place, "has a sample that is no finite number, in column " +
                         std::to_string(pixel % image.width) + " of row " +
                         std::to_string(pixel / image.width) + " (counted from 0)");
}

Image to_image(cv::Mat pixels, const PictureFacts& facts, const Place& place) {
  if (facts.is_negative && pixels.depth() == CV_16U) cv::bitwise_not(pixels, pixels);
  const double most = facts.most != 0 ? facts.most : most_of(sample_depth(pixels.depth()));
  Image image(pixels.cols, pixels.rows, pixels.channels());
  cv::Mat floats(pixels.rows, pixels.cols, CV_32FC(pixels.channels()), image.samples.data());
  pixels.convertTo(floats, CV_32F);
  if (!facts.is_red_first) swap_red_and_blue(floats);
  if (most != 0) {
    const auto divisor = static_cast<float>(most);
    for (float& sample : image.samples) sample /= divisor;
  }
  if (facts.is_multiplied && image.channels == 4) divide_by_alpha(image);
  check_finite(image, place);
  return image;
}

// OpenCV has no format of grey and alpha, so that becomes red, green, blue and alpha.
cv::Mat to_pixels(const Image& image, ImageFormat format, SampleDepth depth) {
  const bool keeps_alpha = format != ImageFormat::kJpeg && format != ImageFormat::kPnm;
  const bool has_alpha = image.has_alpha() && keeps_alpha;
  const bool is_multiplied = has_alpha && format == ImageFormat::kExr;
  const int channels = has_alpha ? 4 : image.color_channels();
  const int colors = std::min(channels, 3);
  cv::Mat pixels(image.height, image.width, CV_32FC(channels));
  const std::ptrdiff_t step = image.color_channels() == 1 ? 0 : 1;  // grey is red, green and blue
  const float* from = image.samples.data();
  for (int y = 0; y < image.height; ++y) {
    auto* to = pixels.ptr<float>(y);
    for (int x = 0; x < image.width; ++x, from += image.channels, to += channels) {
      const float alpha = from[image.channels - 1];
      for (int c = 0; c < colors; ++c) to[c] = from[c * step] * (is_multiplied ? alpha : 1);
      if (has_alpha) to[3] = alpha;
    }
  }
  if (depth != SampleDepth::kFloat) {
    cv::min(pixels, 1, pixels);  // below 0 convertTo cuts off, but the largest numbers wrap round
    pixels.convertTo(pixels, depth == SampleDepth::k8 ? CV_8U : CV_16U, most_of(depth));
  }
  swap_red_and_blue(pixels);
  return pixels;
}

const char* extension(ImageFormat format, int channels) {
  switch (format) {
    case ImageFormat::kPng:
      return ".png";
    case ImageFormat::kJpeg:
      return ".jpg";
    case ImageFormat::kTiff:
      return ".tif";
    case ImageFormat::kPnm:
      return channels == 1 ? ".pgm" : ".ppm";
    case ImageFormat::kExr:
      break;
  }
  return ".exr";
}

// Quick ones: for 600 x 600 pixels PNG takes 20 ms at level 1, 100 ms at level 6 for a quarter
// less; EXR takes 30 ms with runs, 150 ms zipped for a twentieth less. Unless told to use LZW,
// OpenCV writes colours of float TIFF as logarithms of 16 bits.
std::vector<int> settings() {
  constexpr int kPngLevel = 1, kJpegQuality = 95, kLzwInTiff = 5;
  return {cv::IMWRITE_PNG_COMPRESSION,  kPngLevel,     //
          cv::IMWRITE_JPEG_QUALITY,     kJpegQuality,  //
          cv::IMWRITE_TIFF_COMPRESSION, kLzwInTiff,    //
          cv::IMWRITE_EXR_COMPRESSION,  cv::IMWRITE_EXR_COMPRESSION_RLE};
}

}  // namespace

ImageFile read_image(const std::string& name) {
  set_up_opencv();
  const Place place{display_name(name)};
  std::string bytes = read_all(*open_input(name), kMostBytes, place.file);
  if (bytes.empty()) throw Error(place, "is empty; a picture is expected");
  const PictureFacts facts = examine_picture(bytes);
  if (facts.kind.empty()) {
    throw Error(place, "is no picture that can be read (PNG, JPEG, TIFF, PNM or EXR)");
  }
  const auto check_size = [&](std::uint64_t pixels) {
    if (pixels > kMostPixels) throw Error(place, "has more than 2^28 pixels; make it smaller");
  };
  check_size(facts.pixels);
  if (!facts.is_whole) throw Error(place, "is cut off; the end of the picture is missing");
  if (facts.kind == "TIFF") keep_alpha_straight(bytes);
  // IMREAD_UNCHANGED alone keeps alpha, and it alone does not turn photographs. JPEG has no alpha.
  const int flags =
      facts.kind == "JPEG" ? cv::IMREAD_ANYDEPTH | cv::IMREAD_ANYCOLOR : cv::IMREAD_UNCHANGED;
  const cv::Mat pixels = facts.is_beyond ? cv::Mat() : decode(bytes, flags);
  // Signed integers have no number that stands for 1.
  const int depth = pixels.depth();
  if (facts.is_beyond || depth == CV_8S || depth == CV_16S || depth == CV_32S) {
    throw Error(place, "is a rare kind of " + std::string(facts.kind) +
                           " that would be misread; save it as PNG");
  }
  if (pixels.empty()) {
    throw Error(place, "cannot be read: it is damaged, cut off, or a rare kind of " +
                           std::string(facts.kind));
  }
  check_size(pixels.total());
  if (pixels.channels() > 4) {
    throw Error(place,
                "has " + std::to_string(pixels.channels()) + " channels; at most 4 can be read");
  }
  return {to_image(pixels, facts, place), sample_depth(depth)};
}

std::optional<ImageFormat> image_format(std::string_view file_name) {
  static constexpr std::array<std::pair<std::string_view, ImageFormat>, 9> kEndings{{
      {".png", ImageFormat::kPng},
      {".jpg", ImageFormat::kJpeg},
      {".jpeg", ImageFormat::kJpeg},
      {".tif", ImageFormat::kTiff},
      {".tiff", ImageFormat::kTiff},
      {".pnm", ImageFormat::kPnm},
      {".ppm", ImageFormat::kPnm},
      {".pgm", ImageFormat::kPnm},
      {".exr", ImageFormat::kExr},
  }};
  std::string lower(file_name);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const auto& [ending, format] : kEndings) {
    if (lower.ends_with(ending)) return format;
  }
  return std::nullopt;
}

SampleDepth fitting_depth(ImageFormat format, SampleDepth wanted) {
  switch (format) {
    case ImageFormat::kJpeg:
      return SampleDepth::k8;
    case ImageFormat::kExr:
      return SampleDepth::kFloat;
    case ImageFormat::kTiff:
      return wanted;
    case ImageFormat::kPng:
    case ImageFormat::kPnm:
      break;
  }
  return std::min(wanted, SampleDepth::k16);
}

std::string encode_image(const Image& image, ImageFormat format, SampleDepth depth) {
  set_up_opencv();
  if (image.empty()) throw Error("a picture without pixels cannot be written");
  if (image.channels > 4) {
    throw Error("a picture of " + std::to_string(image.channels) +
                " channels cannot be written; at most 4 can");
  }
  const cv::Mat pixels = to_pixels(image, format, fitting_depth(format, depth));
  std::vector<unsigned char> bytes;
  bool is_done = false;
  {
    const QuietStderr quiet;
    try {
      is_done = cv::imencode(extension(format, pixels.channels()), pixels, bytes, settings());
    } catch (const std::exception&) {  // of OpenCV, or of OpenEXR below it
      is_done = false;
    }
  }
  if (!is_done) throw Error("the picture cannot be packed; it may be too large for the format");
  return {bytes.begin(), bytes.end()};
}

}  // namespace libstyle
