// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace libstyle::svg {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

// What windows-1252 has in 0x80 .. 0x9F, where ISO-8859-1 has control characters nobody means.
constexpr std::array<char16_t, 32> kWindows1252 = {
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

std::string from_windows1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (const char byte : bytes) {
    const auto c = static_cast<std::uint8_t>(byte);
    append_utf8(text, c >= 0x80 && c < 0xA0 ? kWindows1252[c - 0x80] : c);
  }
  return text;
}

bool is_high_surrogate(char32_t c) { return c >= 0xD800 && c < 0xDC00; }
bool is_low_surrogate(char32_t c) { return c >= 0xDC00 && c < 0xE000; }

std::string from_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t i) -> char32_t {
    const auto first = static_cast<std::uint8_t>(bytes[i]);
    const auto second = static_cast<std::uint8_t>(bytes[i + 1]);
    return static_cast<char32_t>(big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (is_high_surrogate(c) && i + 3 < bytes.size() && is_low_surrogate(unit(i + 2))) {
      c = 0x10000 + ((c - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
      i += 2;
    } else if (is_high_surrogate(c) || is_low_surrogate(c)) {
      c = kReplacement;
    }
    append_utf8(text, c);
  }
  return text;
}

// The length of the well-formed character at the front of `bytes`, or 0 (RFC 3629).
std::size_t character_length(std::string_view bytes) {
  const auto at = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<std::uint8_t>(bytes[i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (at(i) & 0xC0U) == 0x80U; };
  const unsigned lead = at(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return follows(1) ? 2 : 0;
  if (lead >= 0xE0 && lead < 0xF0) {
    const bool overlong = lead == 0xE0 && at(1) < 0xA0;
    const bool surrogate = lead == 0xED && at(1) >= 0xA0;
    return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead < 0xF5) {
    const bool overlong = lead == 0xF0 && at(1) < 0x90;
    const bool too_large = lead == 0xF4 && at(1) >= 0x90;
    return follows(1) && follows(2) && follows(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

std::size_t valid_prefix(std::string_view bytes) {
  std::size_t i = 0;
  while (i < bytes.size()) {
    if (static_cast<std::uint8_t>(bytes[i]) < 0x80) {
      ++i;
      continue;
    }
    const std::size_t length = character_length(bytes.substr(i, 4));
    if (length == 0) break;
    i += length;
  }
  return i;
}

// The encoding of <?xml ... encoding="..."?> in lower case, or "".
std::string declared_encoding(std::string_view text) {
  if (!text.starts_with("<?xml")) return "";
  const std::string_view declaration = text.substr(0, text.find("?>"));
  const std::size_t key = declaration.find("encoding");
  if (key == std::string_view::npos) return "";
  const std::size_t open = declaration.find_first_of("\"'", key);
  if (open == std::string_view::npos) return "";
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return "";
  std::string name(declaration.substr(open + 1, close - open - 1));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

// Encodings that continue ASCII with one byte a character, as iconv(3) knows them. No others: some
// that it knows have state, and faults.
bool is_other_8bit(std::string_view encoding) {
  return encoding.starts_with("iso-8859-") || encoding.starts_with("windows-125") ||
         encoding == "koi8-r" || encoding == "koi8-u";
}

// Nothing when iconv does not know the encoding.
std::optional<std::string> from_8bit(std::string_view bytes, const std::string& encoding) {
  const iconv_t converter = iconv_open("UTF-8", encoding.c_str());
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::array<std::string, 0x80> characters;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    char byte = static_cast<char>(0x80 + i), utf8[8];
    char *in = &byte, *out = utf8;
    std::size_t in_left = 1, out_left = sizeof utf8;
    const bool known = iconv(converter, &in, &in_left, &out, &out_left) != std::size_t(-1);
    if (known) {
      characters[i].assign(utf8, out);
    } else {
      append_utf8(characters[i], kReplacement);
    }
  }
  iconv_close(converter);
  std::string text;
  text.reserve(bytes.size());
  for (const char byte : bytes) {
    const auto c = static_cast<std::uint8_t>(byte);
    if (c < 0x80) {
      text.push_back(byte);
    } else {
      text += characters[c - 0x80];
    }
  }
  return text;
}

bool is_western_8bit(std::string_view encoding) {
  constexpr std::string_view kNames[] = {"iso-8859-1", "iso_8859-1",   "latin1",
                                         "iso8859-1",  "windows-1252", "cp1252"};
  return std::ranges::find(kNames, encoding) != std::end(kNames);
}

}  // namespace

void append_utf8(std::string& text, char32_t c) {
  const auto byte = [&](char32_t value) { text.push_back(static_cast<char>(value)); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xC0 | c >> 6);
    byte(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    byte(0xE0 | c >> 12);
    byte(0x80 | (c >> 6 & 0x3F));
    byte(0x80 | (c & 0x3F));
  } else {
    byte(0xF0 | c >> 18);
    byte(0x80 | (c >> 12 & 0x3F));
    byte(0x80 | (c >> 6 & 0x3F));
    byte(0x80 | (c & 0x3F));
  }
}

std::string to_utf8(std::string bytes, const std::string& file, const WarningHandler& warn) {
  const std::string_view view = bytes;
  if (view.starts_with("\xFE\xFF")) {
    bytes = from_utf16(view.substr(2), true);
  } else if (view.starts_with("\xFF\xFE")) {
    bytes = from_utf16(view.substr(2), false);
  } else if (view.starts_with(std::string_view("\0<", 2))) {
    bytes = from_utf16(view, true);
  } else if (view.starts_with(std::string_view("<\0", 2))) {
    bytes = from_utf16(view, false);
  } else if (view.starts_with("\xEF\xBB\xBF")) {
    bytes.erase(0, 3);
  } else if (const std::string encoding = declared_encoding(view); is_western_8bit(encoding)) {
    bytes = from_windows1252(view);
  } else if (is_other_8bit(encoding)) {
    if (std::optional<std::string> text = from_8bit(view, encoding)) bytes = std::move(*text);
  }
  const bool has_nul = bytes.find('\0') != std::string::npos;
  if (has_nul) throw Error({file, 0}, "is no XML text: it has NUL bytes");
  const std::size_t good = valid_prefix(bytes);
  if (good == bytes.size()) return bytes;
  const auto fault = bytes.begin() + static_cast<std::ptrdiff_t>(good);
  const auto line = 1 + static_cast<std::size_t>(std::count(bytes.begin(), fault, '\n'));
  warn({{file, line}, "", "has bytes that are no UTF-8; they are replaced"});
  return repaired_utf8(bytes);
}

std::string repaired_utf8(std::string_view text) {
  std::string repaired;
  while (true) {
    const std::size_t good = valid_prefix(text);
    repaired.append(text.substr(0, good));
    if (good == text.size()) return repaired;
    append_utf8(repaired, kReplacement);
    text.remove_prefix(good + 1);
  }
}

}  // namespace libstyle::svg
