// SPDX-License-Identifier: Apache-2.0
// What the bytes of a picture say before any decoder sees them.
//
// Decoders fill what is missing with grey and say nothing, make room for a picture before they see
// that it is too large, and pass over the rarer fields.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace libstyle {

struct PictureFacts {
  std::string_view kind;       // empty where it is none we know
  bool is_whole = true;        // false where the end is missing for sure
  std::uint64_t pixels = 0;    // 0 where it takes a decoder to tell
  double most = 0;             // the sample that stands for 1; 0 for the largest integer there is
  bool is_multiplied = false;  // alpha into the colours
  bool is_negative = false;    // 0 is white, and the decoder does not turn that round
  bool is_red_first = false;   // in what the decoder hands out
  bool is_beyond = false;      // the decoder would leave something out, or misread it
};

// Of PNG, JPEG, TIFF, PNM, PAM, EXR, BMP and WebP, by their headers and marks. Never throws.
PictureFacts examine_picture(std::string_view bytes);

// libtiff, as OpenCV calls it, multiplies colours by an alpha that says it is straight, and leaves
// them alone where the file does not say what the fourth sample is: takes that word out of the
// bytes of a TIFF.
void keep_alpha_straight(std::string& tiff);

}  // namespace libstyle
