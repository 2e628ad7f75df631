// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/gradient_definition.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "converters/svg/carried_keys.h"
#include "converters/svg/cascade.h"
#include "converters/svg/scanner.h"
#include "converters/svg/transform_list.h"

namespace libstyle::svg {
namespace {

// Longer chains are taken for circles.
constexpr std::size_t kLongestChain = 100;

constexpr Length percent(double value) { return {value, LengthUnit::kPercent}; }

// The gradient and those that it refers to, in order; empty when that ends in something else.
std::vector<pugi::xml_node> chain_of(pugi::xml_node element, const FileIndex& index) {
  std::vector<pugi::xml_node> chain;
  while (is_gradient(element) && chain.size() < kLongestChain) {
    chain.push_back(element);
    if (link_of(element).empty()) return chain;
    element = index.find_target(element);
  }
  return {};
}

// Values along a chain: the first element that has a valid one decides.
class Chain {
 public:
  explicit Chain(std::vector<pugi::xml_node> elements) : elements_(std::move(elements)) {}

  // `parse` returns an optional; `kind` is the name of the elements that have the attribute, empty
  // for all.
  template <typename Parse>
  auto find(const char* name, Parse parse, std::string_view kind = {}) const
      -> decltype(parse(std::string_view())) {
    for (const pugi::xml_node element : elements_) {
      if (!kind.empty() && element.name() != kind) continue;
      const pugi::xml_attribute attribute = element.attribute(name);
      if (!attribute) continue;
      if (auto value = parse(trimmed(attribute.value()))) return value;
    }
    return std::nullopt;
  }

 private:
  std::vector<pugi::xml_node> elements_;
};

std::optional<bool> parse_units(std::string_view text) {
  if (text == "objectBoundingBox") return true;
  if (text == "userSpaceOnUse") return false;
  return std::nullopt;
}

std::optional<Spread> parse_spread(std::string_view text) {
  if (text == "pad") return Spread::kPad;
  if (text == "reflect") return Spread::kReflect;
  if (text == "repeat") return Spread::kRepeat;
  return std::nullopt;
}

void read_geometry(const Chain& chain, GradientDefinition& definition) {
  const auto length = [&](const char* name, std::string_view kind) {
    return chain.find(name, parse_length, kind);
  };
  constexpr std::string_view kLinear = "linearGradient", kRadial = "radialGradient";
  definition.x1 = length("x1", kLinear).value_or(percent(0));
  definition.y1 = length("y1", kLinear).value_or(percent(0));
  definition.x2 = length("x2", kLinear).value_or(percent(100));
  definition.y2 = length("y2", kLinear).value_or(percent(0));
  definition.center_x = length("cx", kRadial).value_or(percent(50));
  definition.center_y = length("cy", kRadial).value_or(percent(50));
  definition.focus_x = length("fx", kRadial).value_or(definition.center_x);
  definition.focus_y = length("fy", kRadial).value_or(definition.center_y);
  definition.radius = length("r", kRadial).value_or(percent(50));
  definition.focus_radius = length("fr", kRadial).value_or(percent(0));
}

// Offsets never fall: each is at least the one before. A stop with a wrong offset is none.
std::vector<GradientStop> read_stops(pugi::xml_node gradient, const FileIndex& index,
                                     Reporter& reporter) {
  std::vector<GradientStop> stops;
  for (const pugi::xml_node element : gradient.children("stop")) {
    const pugi::xml_attribute attribute = element.attribute("offset");
    const std::optional<double> offset = attribute ? parse_opacity(attribute.value()) : 0;
    if (!offset) {
      reporter.warn(element, "its offset is no number; it is left out");
      continue;
    }
    const ComputedStyle style = style_in_place(element, index.sheets());
    const CssColor color = style.stop_color.resolve(style.color).value_or(CssColor{{}, 0});
    const double least = stops.empty() ? 0 : stops.back().offset;
    stops.push_back({std::max(*offset, least), color.color, style.stop_opacity * color.alpha});
    const pugi::xml_attribute carried = element.attribute(kCarriedKeys);
    if (carried && !restore_carried_extras(carried.value(), stops.back())) {
      reporter.warn(element, std::string(kCarriedKeys) + " is wrong; left out");
    }
  }
  return stops;
}

}  // namespace

bool is_gradient(pugi::xml_node element) {
  const std::string_view name = element.name();
  return name == "linearGradient" || name == "radialGradient";
}

std::optional<GradientDefinition> read_gradient(pugi::xml_node element, const FileIndex& index,
                                                Reporter& reporter) {
  const std::vector<pugi::xml_node> elements = chain_of(element, index);
  if (elements.empty()) {
    reporter.warn(element, "its href leads to no gradient; it does not paint");
    return std::nullopt;
  }
  const Chain chain(elements);
  GradientDefinition definition;
  definition.radial = std::string_view(element.name()) == "radialGradient";
  definition.in_bounding_box = chain.find("gradientUnits", parse_units).value_or(true);
  definition.transform =
      chain.find("gradientTransform", parse_transform_attribute).value_or(Transform{});
  definition.carried_transform = element.attribute(kCarriedTransform).value();
  definition.spread = chain.find("spreadMethod", parse_spread).value_or(Spread::kPad);
  read_geometry(chain, definition);
  for (const pugi::xml_node gradient : elements) {
    definition.stops = read_stops(gradient, index, reporter);
    if (!definition.stops.empty()) break;
  }
  if (!inverse(definition.transform)) return std::nullopt;
  return definition;
}

}  // namespace libstyle::svg
