// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/gzip.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include "libstyle/base/error.h"

namespace libstyle::svg {
namespace {

constexpr std::size_t kEnough = std::size_t{16} << 20;

std::string pack(std::string_view text) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(6);
  std::string packed(libdeflate_gzip_compress_bound(compressor, text.size()), '\0');
  packed.resize(
      libdeflate_gzip_compress(compressor, text.data(), text.size(), packed.data(), packed.size()));
  libdeflate_free_compressor(compressor);
  return packed;
}

std::string unpack(const std::string& packed, std::size_t limit = kEnough) {
  return gunzip(packed, limit, "test.svgz");
}

TEST(Gzip, UnpacksWhatWasPacked) {
  for (const std::size_t size : {0U, 1U, 5000U, 10'000'000U}) {
    const std::string text(size, 'a');
    EXPECT_TRUE(is_gzip(pack(text)));
    EXPECT_EQ(unpack(pack(text)), text);
  }
}

// Only the size of the last member stands at the end.
TEST(Gzip, UnpacksMembersOneAfterTheOther) {
  const std::string large(1'000'000, 'a');
  EXPECT_EQ(unpack(pack(large) + pack("b") + pack(large)), large + "b" + large);
  EXPECT_EQ(unpack(pack(large) + pack("b")), large + "b");
}

TEST(Gzip, DoesNotLookBehindTheLastMember) {
  EXPECT_EQ(unpack(pack("<svg/>") + std::string(512, '\0')), "<svg/>");
}

TEST(Gzip, RefusesWhatIsCutOff) {
  const std::string packed = pack("<svg><rect width='1' height='1'/></svg>");
  for (std::size_t size = 2; size < packed.size(); ++size) {
    EXPECT_THROW(unpack(packed.substr(0, size)), Error) << size;
  }
}

TEST(Gzip, RefusesADamagedByte) {
  std::string packed = pack("<svg><rect width='1' height='1'/></svg>");
  packed[packed.size() - 8] ^= 1;  // of the checksum
  EXPECT_THROW(unpack(packed), Error);
}

TEST(Gzip, RefusesMoreThanTheLimit) {
  const std::string text(100'000, 'a');
  EXPECT_EQ(unpack(pack(text), text.size()), text);
  EXPECT_THROW(unpack(pack(text), text.size() - 1), Error);
  EXPECT_THROW(unpack(pack(text) + pack("b"), text.size()), Error);
}

}  // namespace
}  // namespace libstyle::svg
