// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/line_features.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

constexpr const char* kColor = "color";

struct ColorPart {
  FeatureKind kind;
  std::uint8_t Color::*member;
};
constexpr ColorPart kColorParts[] = {{FeatureKind::kRed, &Color::red},
                                     {FeatureKind::kGreen, &Color::green},
                                     {FeatureKind::kBlue, &Color::blue},
                                     {FeatureKind::kAlpha, &Color::alpha}};

std::uint8_t Color::*member_of(FeatureKind kind) {
  for (const ColorPart& part : kColorParts) {
    if (part.kind == kind) return part.member;
  }
  return nullptr;
}

void set_channel(AlongValues& along, const std::string& name, const std::vector<double>& values) {
  const auto same = std::ranges::find(along.channels, name, &Channel::name);
  if (same != along.channels.end()) {
    same->values = values;
  } else {
    along.channels.push_back({name, values});
  }
}

}  // namespace

std::vector<LineFeature> line_features(const AlongValues& along) {
  std::vector<LineFeature> result;
  for (const Channel& channel : along.channels) {
    if (channel.name == "t") continue;
    const bool is_width = channel.name == "width";
    result.push_back({channel.name, is_width ? FeatureKind::kLength : FeatureKind::kNumber});
  }
  if (along.colors.empty()) return result;
  for (const ColorPart& part : kColorParts) result.push_back({kColor, part.kind});
  return result;
}

std::vector<LineFeature> common_features(std::span<const std::vector<LineFeature>> each) {
  if (each.empty()) return {};
  std::vector<LineFeature> common = each.front();
  for (const std::vector<LineFeature>& features : each) {
    std::erase_if(common, [&](const LineFeature& feature) {
      return std::ranges::find(features, feature) == features.end();
    });
  }
  return common;
}

std::vector<double> feature_values(const AlongValues& along, const LineFeature& feature) {
  std::uint8_t Color::*const part = member_of(feature.kind);
  if (!part) {
    const std::vector<double>* values = along.find(feature.name);
    return values ? *values : std::vector<double>();
  }
  std::vector<double> result;
  for (const Color& color : along.colors) result.push_back(color.*part);
  return result;
}

void round_to_writable(std::vector<double>& values, const LineFeature& feature) {
  if (!member_of(feature.kind)) return;
  for (double& value : values) value = std::round(value);
}

void set_features(AlongValues& along, std::span<const LineFeature> features,
                  std::span<const std::vector<double>> values) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    std::uint8_t Color::*const part = member_of(features[i].kind);
    if (!part) {
      set_channel(along, features[i].name, values[i]);
      continue;
    }
    along.colors.resize(values[i].size());
    for (std::size_t k = 0; k < values[i].size(); ++k) {
      along.colors[k].*part = static_cast<std::uint8_t>(std::lround(values[i][k]));
    }
  }
}

}  // namespace libstyle
