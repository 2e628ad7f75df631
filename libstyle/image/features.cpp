// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/features.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/image/luminance.h"
#include "libstyle/image/oriented_filters.h"
#include "libstyle/image/resample.h"

namespace libstyle::image {
namespace {

constexpr int kDirections = 4;     // of oriented filters
constexpr int kSmallestSide = 16;  // of the coarsest level, where levels are not given
constexpr std::size_t kMostPixels = std::size_t{1} << 28;

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

void check_picture(const Image& image, const std::string& name) {
  if (image.empty()) throw Error(name + " is empty");
  if (std::size_t(image.width) * image.height > kMostPixels) {
    throw Error(name + " is larger than 2^28 pixels");
  }
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    if (std::isfinite(image.samples[i])) continue;
    const std::size_t pixel = i / image.channels;
    throw Error(name + " has a sample that is no number, in column " +
                std::to_string(pixel % image.width + 1) + " of row " +
                std::to_string(pixel / image.width + 1));
  }
}

void check_same_size(const Image& a, const std::string& name_of_a, const Image& b,
                     const std::string& name_of_b) {
  if (a.width == b.width && a.height == b.height) return;
  throw Error(name_of_a + " is " + size_text(a) + " and " + name_of_b + " is " + size_text(b) +
              "; they must be of one size");
}

// How error messages call the pictures of an example.
std::string of_example(const char* what, std::size_t index, std::size_t count) {
  std::string name = std::string("the ") + what + " picture";
  if (count > 1) name += " of example " + std::to_string(index + 1);
  return name;
}

void check_guide(const ImageAnalogyInput& input, std::size_t number) {
  const ImageGuide& guide = input.guides[number];
  const std::string name = "guide " + std::to_string(number + 1);
  if (!(guide.weight >= 0 && guide.weight <= 1000)) {
    throw Error("the weight of " + name + " must be 0 to 1000");
  }
  if (guide.examples.size() != input.examples.size()) {
    throw Error(name + " needs one picture an example");
  }
  check_picture(guide.target, name + " of the target");
  if (!input.target.empty()) {
    check_same_size(guide.target, name + " of the target", input.target, "the target");
  } else {
    check_same_size(guide.target, name + " of the target", input.guides.front().target,
                    "guide 1 of the target");
  }
  for (std::size_t i = 0; i < guide.examples.size(); ++i) {
    check_picture(guide.examples[i], name + " of the example");
    check_same_size(guide.examples[i], name + " of the example", input.examples[i].filtered,
                    of_example("filtered", i, input.examples.size()));
  }
}

bool any_color(const std::vector<const Image*>& images) {
  return std::ranges::any_of(images,
                             [](const Image* image) { return image->color_channels() > 1; });
}

// The colours of a picture, without alpha; grey three times over where colours are wanted.
Image colors(const Image& image, int channels) {
  Image result(image.width, image.height, channels);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto from = image.pixel(x, y);
      const auto to = result.pixel(x, y);
      for (int c = 0; c < channels; ++c) to[c] = from[image.color_channels() == 1 ? 0 : c];
    }
  }
  return result;
}

Image beside(const Image& a, const Image& b) {
  if (a.channels == 0) return b;
  Image result(a.width, a.height, a.channels + b.channels);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const auto to = result.pixel(x, y);
      std::ranges::copy(a.pixel(x, y), to.begin());
      std::ranges::copy(b.pixel(x, y), to.begin() + a.channels);
    }
  }
  return result;
}

Image mapped(Image image, const LinearMap& map) {
  for (float& sample : image.samples) sample = map(sample);
  return image;
}

void use_luminance(const ImageAnalogyInput& input, const ImageAnalogyParameters& parameters,
                   Features& features) {
  for (const ImagePair& example : input.examples) {
    features.filtered.push_back(luminance(example.filtered));
    if (!input.target.empty()) features.guides.push_back(luminance(example.unfiltered));
  }
  if (input.target.empty()) return;
  features.target_guide = luminance(input.target);
  features.base_channels = 1;
  if (!parameters.remap_luminance) return;
  std::vector<const Image*> unfiltered;
  for (const Image& guide : features.guides) unfiltered.push_back(&guide);
  const LinearMap map = remapping(distribution(unfiltered), distribution({&features.target_guide}));
  for (Image& guide : features.guides) guide = mapped(std::move(guide), map);
  for (Image& filtered : features.filtered) filtered = mapped(std::move(filtered), map);
}

void use_colors(const ImageAnalogyInput& input, Features& features) {
  std::vector<const Image*> filtered;
  std::vector<const Image*> unfiltered{&input.target};
  for (const ImagePair& example : input.examples) {
    filtered.push_back(&example.filtered);
    unfiltered.push_back(&example.unfiltered);
  }
  const int filtered_channels = any_color(filtered) ? 3 : 1;
  if (!input.target.empty()) {
    features.base_channels = any_color(unfiltered) ? 3 : 1;
    features.target_guide = colors(input.target, features.base_channels);
  }
  for (const ImagePair& example : input.examples) {
    features.filtered.push_back(colors(example.filtered, filtered_channels));
    if (input.target.empty()) continue;
    features.guides.push_back(colors(example.unfiltered, features.base_channels));
  }
}

// With the responses of oriented filters, which lie behind the colours.
Image with_orientation(const Image& guide, int base_channels, int threads) {
  return beside(guide, oriented_responses(luminance(colors(guide, base_channels)), threads));
}

int level_count(const Features& features, int wanted) {
  int side = std::min(features.target_guide.width, features.target_guide.height);
  for (const Image& filtered : features.filtered) {
    side = std::min({side, filtered.width, filtered.height});
  }
  int count = 1;
  while ((wanted == 0 ? (side + 1) / 2 >= kSmallestSide : count < wanted) && side > 1) {
    side = (side + 1) / 2;
    ++count;
  }
  return count;
}

Image with_channels(const Image& image, int channels) {
  if (image.channels == channels) return image;
  Image result(image.width, image.height, channels);
  const int color_channels = result.color_channels();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto from = image.pixel(x, y);
      const auto to = result.pixel(x, y);
      for (int c = 0; c < color_channels; ++c) to[c] = from[image.color_channels() == 1 ? 0 : c];
      if (result.has_alpha()) to[color_channels] = image.has_alpha() ? from.back() : 1.F;
    }
  }
  return result;
}

Image with_alpha_of(const Image& image, const Image& other) {
  Image result = with_channels(image, image.color_channels() + 1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      result.pixel(x, y).back() = other.pixel(x, y).back();
    }
  }
  return result;
}

}  // namespace

void check_pictures(const ImageAnalogyInput& input) {
  if (input.examples.empty()) throw Error("there is no example");
  const bool has_target = !input.target.empty();
  const std::size_t count = input.examples.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ImagePair& example = input.examples[i];
    const std::string filtered = of_example("filtered", i, count);
    check_picture(example.filtered, filtered);
    if (example.unfiltered.empty()) {
      if (has_target) {
        throw Error(of_example("unfiltered", i, count) +
                    " is missing: without it nothing says how the target is filtered");
      }
      continue;
    }
    const std::string unfiltered = of_example("unfiltered", i, count);
    if (!has_target) throw Error("there is " + unfiltered + ", but no target to filter like it");
    check_picture(example.unfiltered, unfiltered);
    check_same_size(example.unfiltered, unfiltered, example.filtered, filtered);
  }
  if (has_target) check_picture(input.target, "the target");
  for (std::size_t i = 0; i < input.guides.size(); ++i) check_guide(input, i);
  if (!has_target && input.guides.empty() &&
      (input.width < 1 || input.height < 1 ||
       std::size_t(input.width) * input.height > kMostPixels)) {
    throw Error("without a target the size of the result must be given: 1x1 to 2^28 pixels");
  }
}

Features make_features(const ImageAnalogyInput& input, const ImageAnalogyParameters& parameters) {
  Features features;
  if (parameters.features == MatchFeatures::kLuminance) {
    use_luminance(input, parameters, features);
  } else {
    use_colors(input, features);
  }
  for (int c = 0; c < features.base_channels; ++c) {
    features.guide_shares.push_back(parameters.guide_weight / features.base_channels);
  }
  if (input.target.empty()) {
    const bool has_guide = !input.guides.empty();
    const int width = has_guide ? input.guides.front().target.width : input.width;
    const int height = has_guide ? input.guides.front().target.height : input.height;
    features.target_guide = Image(width, height, 0);
    for (const ImagePair& example : input.examples) {
      features.guides.emplace_back(example.filtered.width, example.filtered.height, 0);
    }
  }
  for (const ImageGuide& guide : input.guides) {
    std::vector<const Image*> all{&guide.target};
    for (const Image& example : guide.examples) all.push_back(&example);
    const int channels = any_color(all) ? 3 : 1;
    features.target_guide = beside(features.target_guide, colors(guide.target, channels));
    for (std::size_t i = 0; i < guide.examples.size(); ++i) {
      features.guides[i] = beside(features.guides[i], colors(guide.examples[i], channels));
    }
    features.guide_shares.insert(features.guide_shares.end(), channels, guide.weight / channels);
  }
  if (parameters.orientation_weight > 0 && features.base_channels > 0) {
    features.guide_shares.insert(features.guide_shares.end(), kDirections,
                                 parameters.orientation_weight / kDirections);
  }
  return features;
}

std::vector<LevelImages> feature_pyramid(const Features& features,
                                         const ImageAnalogyParameters& parameters) {
  std::vector<LevelImages> levels{{features.guides, features.filtered, features.target_guide}};
  const int count = level_count(features, parameters.levels);
  while (static_cast<int>(levels.size()) < count) {
    const LevelImages& finer = levels.back();
    LevelImages coarser;
    for (const Image& guide : finer.guides) {
      coarser.guides.push_back(halved(guide, parameters.threads));
    }
    for (const Image& filtered : finer.filtered) {
      coarser.filtered.push_back(halved(filtered, parameters.threads));
    }
    coarser.target_guide = halved(finer.target_guide, parameters.threads);
    levels.push_back(std::move(coarser));
  }
  if (parameters.orientation_weight > 0 && features.base_channels > 0) {
    const auto add_orientation = [&](Image& guide) {
      guide = with_orientation(guide, features.base_channels, parameters.threads);
    };
    for (LevelImages& level : levels) {
      for (Image& guide : level.guides) add_orientation(guide);
      add_orientation(level.target_guide);
    }
  }
  return levels;
}

Image filtered_picture(const ImageAnalogyInput& input, const ImageAnalogyParameters& parameters,
                       const Features& features, const std::vector<SourcePixel>& sources) {
  const int width = features.target_guide.width;
  const int height = features.target_guide.height;
  if (parameters.features == MatchFeatures::kLuminance && !input.target.empty()) {
    return with_luminance(input.target,
                          copy_from_sources(features.filtered, sources, width, height));
  }
  int channels = 1;
  for (const ImagePair& example : input.examples) {
    channels = std::max(channels, example.filtered.color_channels());
  }
  const bool has_alpha = std::ranges::any_of(
      input.examples, [](const ImagePair& example) { return example.filtered.has_alpha(); });
  std::vector<Image> filtered;
  for (const ImagePair& example : input.examples) {
    filtered.push_back(with_channels(example.filtered, channels + (has_alpha ? 1 : 0)));
  }
  const Image result = copy_from_sources(filtered, sources, width, height);
  const bool takes_alpha = !has_alpha && !input.target.empty() && input.target.has_alpha();
  return takes_alpha ? with_alpha_of(result, input.target) : result;
}

}  // namespace libstyle::image
