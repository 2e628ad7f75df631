// SPDX-License-Identifier: Apache-2.0
// What the options of image-analogy say.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/common/command.h"
#include "converters/image/image_file.h"
#include "libstyle/image/image_analogy.h"

namespace libstyle {

struct ImageAnalogySettings {
  std::vector<std::string> unfiltered;
  std::vector<std::string> filtered;
  std::string target;
  std::vector<std::string> guides;
  std::string size;
  std::string application;
  std::string match = "color";
  std::string source_map;
  std::string apply_map;
  std::string output = "-";
  std::string format;
  std::string depth;
  bool keeps_luminance = false;  // --no-remap
  ImageAnalogyParameters parameters;
  std::vector<std::string> given;

  bool is_given(std::string_view option) const;
};

// The options about how B' is matched.
std::vector<Option> match_options(ImageAnalogySettings& settings);

// The parameters: those of the application, and over them what was given. Throws UsageError.
ImageAnalogyParameters image_analogy_parameters(const ImageAnalogySettings& settings);

ImageFormat output_format(const ImageAnalogySettings& settings);

// The depth that was asked for, or that of the pictures which the result is made from.
SampleDepth output_depth(const ImageAnalogySettings& settings, SampleDepth of_pictures);

// "640x480". Throws UsageError.
std::pair<int, int> parse_size(const std::string& text);

// "A.png,A2.png:B.png*0.5": a guide's pictures of the examples and of the target, and its weight.
struct GuideFiles {
  std::vector<std::string> examples;
  std::string target;
  double weight = 1;
};
GuideFiles parse_guide(const std::string& text);

}  // namespace libstyle
