// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/level.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace libstyle::image {
namespace {

FeaturePlane example_plane(const LevelImages& images, int channels, int border) {
  int width = 0;
  int height = -2 * border;
  for (const Image& filtered : images.filtered) {
    width = std::max(width, filtered.width);
    height += filtered.height + 2 * border;
  }
  return {width, height, channels, border};
}

}  // namespace

Level::Level(const LevelImages& images, int border)
    : guide_channels(images.target_guide.channels),
      filtered_channels(images.filtered.front().channels),
      examples(example_plane(images, guide_channels + filtered_channels, border)),
      is_place(examples.pixel_count()),
      target(images.target_guide.width, images.target_guide.height,
             guide_channels + filtered_channels, border) {
  int first_row = 0;
  for (std::size_t i = 0; i < images.filtered.size(); ++i) {
    const Image& filtered = images.filtered[i];
    examples.put(images.guides[i], first_row, 0);
    examples.put(filtered, first_row, guide_channels);
    for (int y = 0; y < filtered.height; ++y) {
      for (int x = 0; x < filtered.width; ++x) {
        places.push_back(examples.index(x, first_row + y));
        is_place[places.back()] = 1;
      }
    }
    frames.push_back({first_row, filtered.width, filtered.height});
    first_row += filtered.height + 2 * border;
  }
  target.put(images.target_guide, 0, 0);
}

void Level::copy(PixelIndex source, PixelIndex to) {
  std::copy_n(examples.features(source) + guide_channels, filtered_channels,
              target.features(to) + guide_channels);
}

int Level::example_of(PixelIndex source) const {
  const int row = examples.row(source);
  const auto next = std::ranges::upper_bound(frames, row, {}, &ExampleFrame::first_row);
  return static_cast<int>(next - frames.begin()) - 1;
}

std::vector<PixelIndex> coarse_places(const Level& fine, const Level& coarse) {
  std::vector<PixelIndex> result(fine.examples.pixel_count());
  for (std::size_t i = 0; i < fine.frames.size(); ++i) {
    const int example = static_cast<int>(i);
    for (int y = 0; y < fine.frames[i].height; ++y) {
      for (int x = 0; x < fine.frames[i].width; ++x) {
        result[fine.place(example, x, y)] = coarse.place(example, x / 2, y / 2);
      }
    }
  }
  return result;
}

void start_from_coarse(Level& fine, const Level& coarse) {
  FeaturePlane& to = fine.target;
  const FeaturePlane& from = coarse.target;
  for (int y = -to.border(); y < to.height() + to.border(); ++y) {
    const int coarse_y = std::clamp(y, 0, to.height() - 1) / 2;
    for (int x = -to.border(); x < to.width() + to.border(); ++x) {
      const int coarse_x = std::clamp(x, 0, to.width() - 1) / 2;
      std::copy_n(from.features(from.index(coarse_x, coarse_y)) + fine.guide_channels,
                  fine.filtered_channels, to.features(to.index(x, y)) + fine.guide_channels);
    }
  }
}

}  // namespace libstyle::image
