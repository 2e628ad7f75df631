// SPDX-License-Identifier: Apache-2.0
#include "cli/image_analogy/settings.h"

#include <algorithm>
#include <charconv>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

// What the paper does for each of its applications (section 4), and the kappa of section 3.2.
ImageAnalogyParameters parameters_for(std::string_view application) {
  ImageAnalogyParameters p;
  if (application == "filter" || application == "super-resolution") {
    p.features = MatchFeatures::kLuminance;
    p.remap_luminance = false;
    p.coherence = application == "filter" ? 0.5 : 1;
  } else if (application == "transfer") {
    p.features = MatchFeatures::kLuminance;
    p.single_pixel_guide = true;
    p.guide_weight = 0.2;
    p.coherence = 1;
  } else if (application == "painting") {
    p.features = MatchFeatures::kLuminance;
    p.coherence = 5;
  } else if (application == "line-art") {
    p.features = MatchFeatures::kLuminance;
    p.orientation_weight = 1;
    p.coherence = 1;
  }
  return p;
}

UsageError bad_value(const char* option, const std::string& text, const char* form) {
  return UsageError(std::string(option) + ": \"" + text + "\" is not of the form " + form);
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

}  // namespace

bool ImageAnalogySettings::is_given(std::string_view option) const {
  return std::ranges::find(given, option) != given.end();
}

std::vector<Option> match_options(ImageAnalogySettings& settings) {
  ImageAnalogyParameters& p = settings.parameters;
  return {
      {"--seed", "N", "another number gives another texture", &p.seed},
      {"--for",
       "APPLICATION",
       "set the options below as this application is served best",
       &settings.application,
       HistoryUse::kRecorded,
       {"filter", "texture", "super-resolution", "transfer", "painting", "line-art", "numbers"}},
      {"--kappa", "K", "how much coherent pieces are preferred to the best match", &p.coherence},
      {"--match",
       "FEATURES",
       "what is compared: color, or luminance, which keeps the colors of the target",
       &settings.match,
       HistoryUse::kRecorded,
       {"color", "luminance"}},
      {"--no-remap", "", "do not give the example the brightness and contrast of the target",
       &settings.keeps_luminance},
      {"--guide-weight,-w", "W", "how much the unfiltered pictures count", &p.guide_weight},
      {"--single-pixel-guide", "", "of the unfiltered pictures compare pixels, not neighborhoods",
       &p.single_pixel_guide},
      {"--orientation-weight", "W", "how much the directions of edges count",
       &p.orientation_weight},
      {"--window", "N", "pixels on a side of a neighborhood, odd", &p.window},
      {"--coarse-window", "N", "the same at the next coarser level", &p.coarse_window},
      {"--levels", "N", "of the pyramid; 0: as many as the pictures allow", &p.levels},
      {"--exact", "", "search all of the example for each pixel; slow", &p.exact},
      {"--components", "N", "numbers that neighborhoods are searched by", &p.components},
      {"--leaves", "N", "how thorough the search is", &p.leaves}};
}

ImageAnalogyParameters image_analogy_parameters(const ImageAnalogySettings& settings) {
  ImageAnalogyParameters p = parameters_for(settings.application);
  const ImageAnalogyParameters& asked = settings.parameters;
  const auto set = [&](const char* option, auto member) {
    if (settings.is_given(option)) p.*member = asked.*member;
  };
  set("--kappa", &ImageAnalogyParameters::coherence);
  set("--guide-weight", &ImageAnalogyParameters::guide_weight);
  set("--single-pixel-guide", &ImageAnalogyParameters::single_pixel_guide);
  set("--orientation-weight", &ImageAnalogyParameters::orientation_weight);
  if (settings.is_given("--match")) {
    p.features = settings.match == "luminance" ? MatchFeatures::kLuminance : MatchFeatures::kColor;
  }
  if (settings.keeps_luminance) {
    if (p.features != MatchFeatures::kLuminance) {
      throw UsageError("--no-remap is for --match luminance; give that too");
    }
    p.remap_luminance = false;
  }
  p.seed = asked.seed;
  p.window = asked.window;
  p.coarse_window = asked.coarse_window;
  p.levels = asked.levels;
  p.exact = asked.exact;
  p.components = asked.components;
  p.leaves = asked.leaves;
  p.threads = asked.threads;
  try {
    validate(p);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  return p;
}

ImageFormat output_format(const ImageAnalogySettings& settings) {
  if (!settings.format.empty()) return *image_format("." + settings.format);
  if (settings.output == "-") return ImageFormat::kPng;
  if (const auto format = image_format(settings.output)) return *format;
  throw UsageError("--output: \"" + settings.output +
                   "\" does not end in .png, .jpg, .tif, .ppm or .exr; say which with --format");
}

SampleDepth output_depth(const ImageAnalogySettings& settings, SampleDepth of_pictures) {
  if (settings.depth == "8") return SampleDepth::k8;
  if (settings.depth == "16") return SampleDepth::k16;
  if (settings.depth == "float") return SampleDepth::kFloat;
  return of_pictures;
}

std::pair<int, int> parse_size(const std::string& text) {
  constexpr const char* kForm = "WIDTHxHEIGHT, such as 640x480";
  const std::vector<std::string> sides = split(text, 'x');
  if (sides.size() != 2) throw bad_value("--size", text, kForm);
  const auto number = [&](const std::string& side) {
    int value = 0;
    const char* end = side.data() + side.size();
    const auto [stop, error] = std::from_chars(side.data(), end, value);
    if (error != std::errc() || stop != end || value < 1) throw bad_value("--size", text, kForm);
    return value;
  };
  return {number(sides[0]), number(sides[1])};
}

GuideFiles parse_guide(const std::string& text) {
  constexpr const char* kForm = "EXAMPLE[,EXAMPLE...]:TARGET[*WEIGHT]";
  GuideFiles guide;
  std::string files = text;
  if (const std::size_t star = files.rfind('*'); star != std::string::npos) {
    std::string_view weight = std::string_view(text).substr(star + 1);
    if (!take_number(weight, guide.weight) || !weight.empty() || !(guide.weight >= 0)) {
      throw bad_value("--guide", text, kForm);
    }
    files.resize(star);
  }
  const std::vector<std::string> sides = split(files, ':');
  if (sides.size() != 2 || sides[0].empty() || sides[1].empty()) {
    throw bad_value("--guide", text, kForm);
  }
  guide.examples = split(sides[0], ',');
  guide.target = sides[1];
  return guide;
}

}  // namespace libstyle
