// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/style.h"

#include <gtest/gtest.h>

namespace libstyle {
namespace {

TEST(ColorText, ReadsBackTheSameColor) {
  for (int i = 0; i < 256; ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    const Color color = {byte, static_cast<std::uint8_t>(255 - i), 7, byte};
    EXPECT_EQ(parse_color(to_text(color)), color);
  }
}

TEST(ColorText, LeavesOutAnOpaqueAlpha) {
  EXPECT_EQ(to_text(Color{255, 0, 16}), "#ff0010");
  EXPECT_EQ(to_text(Color{255, 0, 16, 128}), "#ff001080");
}

TEST(ColorText, TakesBothCasesOfHexDigits) {
  EXPECT_EQ(parse_color("#AbCdEf"), parse_color("#abcdef"));
}

TEST(ColorText, RefusesEverythingElse) {
  for (const char* text : {"", "#", "red", "#fff", "#12345", "#1234567", "123456", "#12345g",
                           "#1234567890", "# 12345", "#-12345"}) {
    EXPECT_EQ(parse_color(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace libstyle
