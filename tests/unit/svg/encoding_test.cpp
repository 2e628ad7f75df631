// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/encoding.h"

#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

struct Decoded {
  std::string text;
  int warnings = 0;
};

Decoded decode(std::string bytes) {
  Decoded decoded;
  decoded.text = to_utf8(std::move(bytes), "test.svg", [&](const Warning&) { ++decoded.warnings; });
  return decoded;
}

std::string utf16(std::u16string_view text, bool big_endian) {
  std::string bytes;
  for (const char16_t unit : text) {
    const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

TEST(Encoding, KeepsUtf8) {
  const std::string text = "<svg id='\u00e9 \u4e2d \U0001F600'/>";
  EXPECT_EQ(decode(text).text, text);
  EXPECT_EQ(decode(text).warnings, 0);
}

TEST(Encoding, TakesTheByteOrderMarkOff) { EXPECT_EQ(decode("\xEF\xBB\xBF<svg/>").text, "<svg/>"); }

TEST(Encoding, ReadsUtf16InBothOrders) {
  const std::u16string text = u"<svg id='\u00e9 \U0001F600'/>";
  for (const bool big_endian : {true, false}) {
    EXPECT_EQ(decode(utf16(text, big_endian)).text, "<svg id='\u00e9 \U0001F600'/>");
    EXPECT_EQ(decode(utf16(u"\uFEFF" + text, big_endian)).text, "<svg id='\u00e9 \U0001F600'/>");
  }
}

TEST(Encoding, ReadsDeclaredWesternBytes) {
  EXPECT_EQ(decode("<?xml version='1.0' encoding='ISO-8859-1'?><svg id='\xE9\x80'/>").text,
            "<?xml version='1.0' encoding='ISO-8859-1'?><svg id='\u00e9\u20ac'/>");
}

TEST(Encoding, ReadsDeclaredBytesOfOtherAlphabets) {
  const auto decoded_id = [](const std::string& encoding, const std::string& id) {
    const std::string head = "<?xml version='1.0' encoding='" + encoding + "'?>";
    return decode(head + id).text.substr(head.size());
  };
  EXPECT_EQ(decoded_id("windows-1251", "a\xDF"), "a\u042F");
  EXPECT_EQ(decoded_id("KOI8-R", "a\xF1"), "a\u042F");
  EXPECT_EQ(decoded_id("ISO-8859-15", "a\xA4"), "a\u20AC");
  EXPECT_EQ(decoded_id("ISO-8859-7", "a\xE1\xFF"), "a\u03B1\uFFFD");  // 0xFF is no character of it
}

TEST(Encoding, ReplacesWhatIsNoUtf8AndSaysSoOnce) {
  const Decoded decoded = decode("<svg id='a\xE9-b\xFF'/>");
  EXPECT_EQ(decoded.text, "<svg id='a\uFFFD-b\uFFFD'/>");
  EXPECT_EQ(decoded.warnings, 1);
}

TEST(Encoding, RefusesOverlongAndSurrogateForms) {
  for (const char* bytes : {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80"}) {
    EXPECT_EQ(decode(bytes).text.find(bytes), std::string::npos);
  }
}

TEST(Encoding, RefusesNulCharacters) {
  EXPECT_THROW(decode(std::string("<svg>\0</svg>", 12)), Error);
}

}  // namespace
}  // namespace libstyle::svg
