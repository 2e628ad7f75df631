// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/gzip.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "libstyle/base/error.h"

namespace libstyle::svg {
namespace {

using Decompressor =
    std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>;

// The size that stands at the end of a member, modulo 2^32; right for a file of one member, and no
// more than a guess otherwise. No more than deflate can pack into the bytes there are.
std::size_t guessed_size(std::string_view packed) {
  constexpr std::size_t kSizeField = 4, kMostRatio = 1032;
  if (packed.size() < kSizeField) return 0;
  std::size_t size = 0;
  for (std::size_t i = 0; i < kSizeField; ++i) {
    size |= std::size_t{static_cast<std::uint8_t>(packed[packed.size() - kSizeField + i])} << 8 * i;
  }
  return std::min(size, packed.size() * kMostRatio);
}

// Appends the member at the front of `packed` and takes it off.
void unpack_member(libdeflate_decompressor* decompressor, std::string_view& packed,
                   std::string& text, std::size_t limit, const std::string& file) {
  constexpr std::size_t kLeastRoom = 4096;
  const std::size_t before = text.size();
  const std::size_t most = limit - before;
  std::size_t room = std::min(std::max(guessed_size(packed), kLeastRoom), most);
  for (;;) {
    text.resize(before + room);
    std::size_t taken = 0, given = 0;
    const libdeflate_result result = libdeflate_gzip_decompress_ex(
        decompressor, packed.data(), packed.size(), text.data() + before, room, &taken, &given);
    if (result == LIBDEFLATE_SUCCESS) {
      text.resize(before + given);
      packed.remove_prefix(taken);
      return;
    }
    if (result != LIBDEFLATE_INSUFFICIENT_SPACE) {
      throw Error({file, 0}, "is packed by gzip, and damaged or cut off");
    }
    if (room == most) {
      throw Error({file, 0}, "is larger than " + std::to_string(limit >> 20) + " MB when unpacked");
    }
    room = std::min(2 * room, most);
  }
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

std::string gunzip(std::string_view packed, std::size_t limit, const std::string& file) {
  const Decompressor decompressor(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  std::string text;
  do unpack_member(decompressor.get(), packed, text, limit, file);
  while (is_gzip(packed));
  return text;
}

}  // namespace libstyle::svg
