// SPDX-License-Identifier: Apache-2.0
#include "converters/image/picture_facts.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace libstyle {
namespace {

using std::string_view_literals::operator""sv;

// The integer of `count` bytes at a place, the high byte first; 0 where they are not all there.
std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  if (at > bytes.size() || bytes.size() - at < count) return 0;
  std::uint64_t value = 0;
  for (const char byte : bytes.substr(at, count)) {
    value = value << 8 | static_cast<unsigned char>(byte);
  }
  return value;
}

// Chunks of a length, a name, the content and a checksum, up to IEND.
PictureFacts png_facts(std::string_view bytes) {
  constexpr std::size_t kSignature = 8, kAround = 12;
  PictureFacts facts{.kind = "PNG", .is_whole = false};
  facts.pixels = big_endian(bytes, 16, 4) * big_endian(bytes, 20, 4);
  for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
    const std::size_t next = at + kAround + big_endian(bytes, at, 4);
    if (bytes.substr(at + 4, 4) == "IEND") facts.is_whole = next <= bytes.size();
    at = next;
  }
  return facts;
}

// Segments of a marker and a length, some with a scan after them, up to the marker of the end.
// They are walked because a thumbnail in a segment has an end of its own.
PictureFacts jpeg_facts(std::string_view bytes) {
  PictureFacts facts{.kind = "JPEG", .is_whole = false};
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const int marker = static_cast<unsigned char>(bytes[at + 1]);
    const bool is_in_scan = marker == 0 || (marker >= 0xD0 && marker <= 0xD7);
    if (bytes[at] != '\xFF' || marker == 0xFF) {
      ++at;
    } else if (is_in_scan) {  // an escaped 0xFF, or a mark to start anew at
      at += 2;
    } else if (marker == 0xD9) {
      facts.is_whole = true;
      return facts;
    } else {
      const bool is_table = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
      if (marker >= 0xC0 && marker <= 0xCF && !is_table && facts.pixels == 0) {
        facts.pixels = big_endian(bytes, at + 5, 2) * big_endian(bytes, at + 7, 2);
      }
      at += 2 + big_endian(bytes, at + 2, 2);
    }
  }
  return facts;
}

// The next word of a PNM header, past comments; empty at the end.
std::string_view take_word(std::string_view& rest) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size()));
    if (!rest.starts_with('#')) break;
    rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
  }
  const std::string_view word = rest.substr(0, rest.find_first_of(kSpace));
  rest.remove_prefix(word.size());
  return word;
}

std::uint64_t take_number(std::string_view& rest) {
  const std::string_view word = take_word(rest);
  std::uint32_t number = 0;
  std::from_chars(word.data(), word.data() + word.size(), number);
  return number;
}

// OpenCV scales samples to 255 by the maximum of the header only where both are text and small.
PictureFacts pnm_facts(std::string_view bytes) {
  PictureFacts facts{.kind = "PNM"};
  std::string_view rest = bytes;
  const std::string_view magic = take_word(rest);
  const std::uint64_t width = take_number(rest), height = take_number(rest);
  facts.pixels = width * height;
  if (magic == "P1" || magic == "P4") return facts;
  const std::uint64_t most = take_number(rest);
  const bool is_text = magic == "P2" || magic == "P3";
  if (!is_text || most > 255) facts.most = static_cast<double>(most);
  return facts;
}

// OpenCV leaves red first in a PAM, and misreads those of black and white.
PictureFacts pam_facts(std::string_view bytes) {
  PictureFacts facts{.kind = "PAM", .is_red_first = true};
  std::uint64_t width = 0, height = 0;
  std::string_view rest = bytes;
  for (auto word = take_word(rest); !word.empty() && word != "ENDHDR"; word = take_word(rest)) {
    if (word == "WIDTH") width = take_number(rest);
    if (word == "HEIGHT") height = take_number(rest);
    if (word == "MAXVAL") facts.most = static_cast<double>(take_number(rest));
    if (word == "TUPLTYPE") facts.is_beyond = take_word(rest).starts_with("BLACKANDWHITE");
  }
  facts.pixels = width * height;
  return facts;
}

PictureFacts webp_facts(std::string_view bytes) {
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) length |= big_endian(bytes, 4 + i, 1) << (8 * i);
  return {.kind = "WebP", .is_whole = 8 + length <= bytes.size()};
}

// The fields of the first picture in a TIFF, or a BigTIFF, whose numbers are wider.
class TiffFields {
 public:
  explicit TiffFields(std::string_view bytes)
      : bytes_(bytes), is_high_first_(bytes.starts_with("MM")), is_wide_(number(2, 2) == 43) {}

  // Where the first value of a field is, if it stands in the field itself; 0 where there is none.
  std::size_t find(std::uint64_t tag) const {
    const std::size_t entry_size = is_wide_ ? 20 : 12, count_size = is_wide_ ? 8 : 2;
    const std::size_t directory = is_wide_ ? number(8, 8) : number(4, 4);
    const std::uint64_t count = number(directory, count_size);
    std::size_t at = directory + count_size;
    for (std::uint64_t i = 0; i < count && at < bytes_.size(); ++i, at += entry_size) {
      if (number(at, 2) == tag) return at + (is_wide_ ? 12 : 8);
    }
    return 0;
  }

  // The value of a field of one integer.
  std::uint64_t value(std::uint64_t tag, std::uint64_t otherwise) const {
    constexpr std::uint64_t kShort = 3, kLong = 4;
    const std::size_t at = find(tag);
    if (at == 0) return otherwise;
    const std::uint64_t type = number(at - (is_wide_ ? 10 : 6), 2);
    return number(at, type == kShort ? 2 : type == kLong ? 4 : 8);
  }

 private:
  std::uint64_t number(std::size_t at, std::size_t count) const {
    std::uint64_t value = big_endian(bytes_, at, count);
    if (is_high_first_) return value;
    std::uint64_t turned = 0;
    for (std::size_t i = 0; i < count; ++i, value >>= 8) turned = turned << 8 | (value & 0xff);
    return turned;
  }

  std::string_view bytes_;
  bool is_high_first_;
  bool is_wide_;
};

constexpr std::uint64_t kTiffExtraSamples = 338;
constexpr std::uint64_t kTiffUnspecified = 0, kTiffMultiplied = 1, kTiffStraight = 2;

PictureFacts tiff_facts(std::string_view bytes) {
  constexpr std::uint64_t kWidth = 256, kHeight = 257, kPhotometric = 262, kSamplesPerPixel = 277;
  constexpr std::uint64_t kWhiteIsZero = 0, kBlackIsZero = 1, kRgb = 2;
  const TiffFields fields(bytes);
  const std::uint64_t meaning = fields.value(kPhotometric, kRgb);
  PictureFacts facts{.kind = "TIFF"};
  facts.pixels = fields.value(kWidth, 0) * fields.value(kHeight, 0);
  facts.is_multiplied = fields.value(kTiffExtraSamples, kTiffUnspecified) == kTiffMultiplied;
  facts.is_negative = meaning == kWhiteIsZero;
  facts.is_beyond = meaning <= kBlackIsZero && fields.value(kSamplesPerPixel, 1) > 1;
  return facts;
}

}  // namespace

void keep_alpha_straight(std::string& bytes) {
  const TiffFields fields(bytes);
  if (fields.value(kTiffExtraSamples, kTiffUnspecified) != kTiffStraight) return;
  bytes.replace(fields.find(kTiffExtraSamples), 2, 2, '\0');
}

PictureFacts examine_picture(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return png_facts(bytes);
  if (bytes.starts_with("\xFF\xD8\xFF")) return jpeg_facts(bytes);
  for (const char* magic : {"II*\0", "MM\0*", "II+\0", "MM\0+"}) {
    if (bytes.starts_with(std::string_view(magic, 4))) return tiff_facts(bytes);
  }
  if (bytes.starts_with("\x76\x2f\x31\x01")) return {.kind = "EXR", .is_multiplied = true};
  if (bytes.starts_with("BM")) return {.kind = "BMP"};
  if (bytes.starts_with("RIFF") && bytes.substr(8).starts_with("WEBP")) return webp_facts(bytes);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7' &&
      std::string_view(" \t\r\n#").find(bytes[2]) != std::string_view::npos) {
    return bytes[1] == '7' ? pam_facts(bytes) : pnm_facts(bytes);
  }
  return {};
}

}  // namespace libstyle
