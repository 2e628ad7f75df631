// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/image_analogy.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"
#include "libstyle/image/features.h"
#include "libstyle/image/match_level.h"
#include "libstyle/image/random_cells.h"
#include "libstyle/image/window.h"
#include "libstyle/image/window_index.h"

namespace libstyle {
namespace {

using image::Level;
using image::Neighborhood;

// Fewer places than these are quicker held against each other than ordered.
constexpr std::size_t kFewPlaces = 512;

void check_range(double value, double least, double most, const char* name) {
  if (value >= least && value <= most) return;
  std::string range = std::string(name) + " must be ";
  append_number(range, least);
  range += " to ";
  append_number(range, most);
  throw Error(range);
}

void check_side(int side, int least, const char* name) {
  check_range(side, least, 15, name);
  if (side % 2 == 0) throw Error(std::string(name) + " must be odd");
}

// How far a run is, from the pixels that are done.
class PixelProgress {
 public:
  PixelProgress(std::size_t total, const ProgressHandler& handler)
      : total_(static_cast<double>(std::max<std::size_t>(total, 1))), handler_(handler) {}

  void add(std::size_t pixels) {
    done_ += pixels;
    if (handler_) handler_(std::min(1.0, static_cast<double>(done_) / total_));
  }

 private:
  double total_;
  std::size_t done_ = 0;
  const ProgressHandler& handler_;
};

// A level with what has been made of it.
struct MadeLevel {
  explicit MadeLevel(Level made) : level(std::move(made)) {}

  Level level;
  image::SourceIndices sources;
};

class Synthesis {
 public:
  Synthesis(const ImageAnalogyParameters& parameters, const std::vector<double>& guide_shares,
            std::vector<image::LevelImages> pyramid, const ProgressHandler& progress)
      : parameters_(parameters),
        guide_shares_(guide_shares),
        pyramid_(std::move(pyramid)),
        progress_(pixel_count(), progress) {}

  // Makes all levels, the coarsest first; returns the finest.
  std::unique_ptr<MadeLevel> run(std::vector<LevelReport>& reports) {
    std::unique_ptr<MadeLevel> coarser;
    while (!pyramid_.empty()) {
      const auto start = std::chrono::steady_clock::now();
      auto made = std::make_unique<MadeLevel>(Level(pyramid_.back(), border()));
      const int levels_left = static_cast<int>(pyramid_.size()) - 1;
      pyramid_.pop_back();
      const image::MatchCounts counts = make(*made, coarser.get(), levels_left);
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      reports.push_back({made->level.target.width(), made->level.target.height(),
                         static_cast<double>(counts.coherent) / static_cast<double>(counts.pixels),
                         time.count()});
      coarser = std::move(made);
    }
    return coarser;
  }

 private:
  // Passes with whole neighbourhoods over the random cells of a texture.
  static constexpr int kJoiningPasses = 4;

  int border() const { return std::max(parameters_.window, parameters_.coarse_window) / 2; }

  std::size_t pixel_count() const {
    std::size_t result = 0;
    for (const image::LevelImages& images : pyramid_) {
      result += std::size_t(images.target_guide.width) * images.target_guide.height;
    }
    return result;
  }

  image::MatchCounts make(MadeLevel& made, const MadeLevel* coarser, int levels_left) {
    Level& level = made.level;
    image::CoarserLevel above;
    if (coarser) {
      above = {&coarser->level, &coarser->sources, image::coarse_places(level, coarser->level)};
      image::start_from_coarse(level, coarser->level);
    }
    const image::MatchSettings settings{
        .coherence = parameters_.coherence * std::pow(2.0, -levels_left),
        .exact = parameters_.exact,
        .seed = parameters_.seed,
        .pass = static_cast<std::uint64_t>(levels_left),
        .threads = parameters_.threads};
    if (!coarser && level.guide_channels == 0) return join_cells(made, above, settings);

    const Neighborhood neighborhood = this->neighborhood(level, image::FilteredPart::kBefore);
    const std::optional<image::WindowIndex> index = this->index(level, neighborhood, above);
    return image::match_level(level,
                              {.neighborhood = neighborhood,
                               .coarser = above,
                               .index = index ? &*index : nullptr,
                               .progress = [&](std::size_t pixels) { progress_.add(pixels); }},
                              settings, made.sources);
  }

  // The coarsest level of a texture, where all there is to hold places against is the texture.
  image::MatchCounts join_cells(MadeLevel& made, const image::CoarserLevel& above,
                                const image::MatchSettings& settings) {
    Level& level = made.level;
    int smallest_side = std::min(level.frames[0].width, level.frames[0].height);
    image::fill_with_random_cells(level, std::clamp(smallest_side / 3, 1, 8), settings.seed,
                                  made.sources);
    const Neighborhood around = neighborhood(level, image::FilteredPart::kAround);
    const std::optional<image::WindowIndex> index = this->index(level, around, above);
    image::MatchCounts counts;
    for (int i = 0; i < kJoiningPasses; ++i) {
      counts = image::match_level(level,
                                  {.neighborhood = around,
                                   .is_first = false,
                                   .coarser = above,
                                   .index = index ? &*index : nullptr},
                                  settings, made.sources);
    }
    progress_.add(counts.pixels);
    return counts;
  }

  Neighborhood neighborhood(const Level& level, image::FilteredPart filtered) const {
    image::WindowSettings fine{.radius = parameters_.window / 2,
                               .guide_in_middle_only = parameters_.single_pixel_guide,
                               .guide_shares = guide_shares_,
                               .filtered_channels = level.filtered_channels,
                               .filtered = filtered};
    image::WindowSettings coarse = fine;
    coarse.radius = parameters_.coarse_window / 2;
    coarse.filtered = image::FilteredPart::kWhole;
    if (parameters_.single_pixel_guide) std::ranges::fill(coarse.guide_shares, 0.0);
    return {image::make_window(fine), image::make_window(coarse)};
  }

  std::optional<image::WindowIndex> index(const Level& level, const Neighborhood& neighborhood,
                                          const image::CoarserLevel& above) const {
    if (parameters_.exact || level.places.size() < kFewPlaces) return std::nullopt;
    return image::WindowIndex(neighborhood, image::example_rows(level, above), level.places,
                              [&](image::PixelIndex place) {
                                return image::example_windows(level, neighborhood, above, place);
                              },
                              {.most_components = parameters_.components,
                               .leaves = parameters_.leaves,
                               .threads = parameters_.threads});
  }

  const ImageAnalogyParameters& parameters_;
  const std::vector<double> guide_shares_;
  std::vector<image::LevelImages> pyramid_;  // the finest first
  PixelProgress progress_;
};

std::vector<SourcePixel> source_pixels(const MadeLevel& made) {
  std::vector<SourcePixel> result;
  result.reserve(made.sources.size());
  const Level& level = made.level;
  for (const image::PixelIndex source : made.sources) {
    const int example = level.example_of(source);
    result.push_back({example, level.examples.column(source),
                      level.examples.row(source) - level.frames[example].first_row});
  }
  return result;
}

}  // namespace

void validate(const ImageAnalogyParameters& parameters) {
  check_range(parameters.coherence, 0, 1000, "coherence");
  check_range(parameters.guide_weight, 0, 1000, "guide_weight");
  check_range(parameters.orientation_weight, 0, 1000, "orientation_weight");
  check_side(parameters.window, 3, "window");
  check_side(parameters.coarse_window, 1, "coarse_window");
  check_range(parameters.levels, 0, 16, "levels");
  check_range(parameters.components, 1, 15, "components");
  check_range(parameters.leaves, 1, 10000, "leaves");
}

ImageAnalogyResult make_image_analogy(const ImageAnalogyInput& input,
                                      const ImageAnalogyParameters& parameters,
                                      const ProgressHandler& progress) {
  validate(parameters);
  image::check_pictures(input);
  const image::Features features = image::make_features(input, parameters);
  ImageAnalogyResult result;
  Synthesis synthesis(parameters, features.guide_shares,
                      image::feature_pyramid(features, parameters), progress);
  const std::unique_ptr<MadeLevel> finest = synthesis.run(result.levels);
  result.sources = source_pixels(*finest);
  result.filtered = image::filtered_picture(input, parameters, features, result.sources);
  return result;
}

Image copy_from_sources(const std::vector<Image>& examples, const std::vector<SourcePixel>& sources,
                        int width, int height) {
  if (examples.empty() || sources.size() != std::size_t(width) * height) {
    throw Error("the map of sources is not of this size");
  }
  Image result(width, height, examples.front().channels);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const SourcePixel& source = sources[std::size_t(y) * width + x];
      if (source.example < 0 || std::size_t(source.example) >= examples.size()) {
        throw Error("the map of sources names an example that is not there");
      }
      const Image& example = examples[source.example];
      if (source.x < 0 || source.x >= example.width || source.y < 0 || source.y >= example.height ||
          example.channels != result.channels) {
        throw Error("the map of sources does not fit the examples");
      }
      std::ranges::copy(example.pixel(source.x, source.y), result.pixel(x, y).begin());
    }
  }
  return result;
}

}  // namespace libstyle
