// SPDX-License-Identifier: Apache-2.0
#include "converters/image/source_map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "converters/image/image_file.h"
#include "libstyle/base/error.h"
#include "tests/support/pictures.h"

namespace libstyle {
namespace {

std::string file(const std::string& bytes) {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("source_map_test." + std::to_string(getpid()) + ".png");
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

TEST(SourceMapFile, ComesBackAsItWasWritten) {
  SourceMap map{3, 2, {}};
  for (int i = 0; i < 6; ++i) map.pixels.push_back({i % 2, 13107 * i, 65535 - i});
  const SourceMap back = read_source_map(file(encode_source_map(map)));
  EXPECT_EQ(back.width, 3);
  EXPECT_EQ(back.height, 2);
  EXPECT_EQ(back.pixels, map.pixels);
}

TEST(SourceMapFile, HoldsNoPlaceBeyondSixteenBits) {
  EXPECT_THROW(encode_source_map({1, 1, {{0, 65536, 0}}}), Error);
}

TEST(SourceMapFile, IsNoOtherPicture) {
  const std::string name =
      file(encode_image(test::noise(4, 4, 3, 1), ImageFormat::kPng, SampleDepth::k8));
  EXPECT_THAT([&] { read_source_map(name); },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("is no map of sources")));
}

}  // namespace
}  // namespace libstyle
