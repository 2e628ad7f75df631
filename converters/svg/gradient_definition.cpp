// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/gradient_definition.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "converters/svg/carried_keys.h"
#include "converters/svg/cascade.h"
#include "converters/svg/keyword.h"
#include "converters/svg/scanner.h"
#include "converters/svg/transform_list.h"

namespace libstyle::svg {
namespace {

// Longer chains are taken for circles.
constexpr std::size_t kLongestChain = 100;

constexpr Length percent(double value) { return {value, LengthUnit::kPercent}; }

// What a gradient element says itself.
struct GradientAttributes {
  std::optional<bool> in_bounding_box;
  std::optional<Transform> transform;
  std::optional<Spread> spread;
  bool refers = false;
  std::optional<Length> x1, y1, x2, y2;
  std::optional<Length> center_x, center_y, focus_x, focus_y, radius, focus_radius;
};

template <typename Value>
bool assign(std::optional<Value>& target, std::optional<Value> value) {
  target = std::move(value);
  return target.has_value();
}

std::optional<bool> parse_units(std::string_view text) {
  return find_keyword<bool>(text, {{"objectBoundingBox", true}, {"userSpaceOnUse", false}});
}

std::optional<Spread> parse_spread(std::string_view text) {
  return find_keyword<Spread>(
      text, {{"pad", Spread::kPad}, {"reflect", Spread::kReflect}, {"repeat", Spread::kRepeat}});
}

bool read_common(std::string_view name, std::string_view value, GradientAttributes& gradient) {
  if (name == "gradientUnits") return assign(gradient.in_bounding_box, parse_units(value));
  if (name == "gradientTransform") {
    return assign(gradient.transform, parse_transform_attribute(value));
  }
  if (name == "spreadMethod") return assign(gradient.spread, parse_spread(value));
  if (name == "href" || name == "xlink:href") gradient.refers = !value.empty();
  return true;
}

bool read_linear(std::string_view name, std::string_view value, GradientAttributes& gradient) {
  if (name == "x1") return assign(gradient.x1, parse_leading_length(value));
  if (name == "y1") return assign(gradient.y1, parse_leading_length(value));
  if (name == "x2") return assign(gradient.x2, parse_leading_length(value));
  if (name == "y2") return assign(gradient.y2, parse_leading_length(value));
  return true;
}

bool read_radial(std::string_view name, std::string_view value, GradientAttributes& gradient) {
  if (name == "cx") return assign(gradient.center_x, parse_leading_length(value));
  if (name == "cy") return assign(gradient.center_y, parse_leading_length(value));
  if (name == "fx") return assign(gradient.focus_x, parse_leading_length(value));
  if (name == "fy") return assign(gradient.focus_y, parse_leading_length(value));
  if (name == "r") return assign(gradient.radius, parse_leading_length(value));
  if (name == "fr") return assign(gradient.focus_radius, parse_leading_length(value));
  return true;
}

// As librsvg has it, an attribute that is wrong ends their reading: first of those that all
// gradients have, then of the geometry.
GradientAttributes read_attributes(pugi::xml_node element) {
  GradientAttributes result;
  const bool radial = std::string_view(element.name()) == "radialGradient";
  for (const auto read : {read_common, radial ? read_radial : read_linear}) {
    for (const pugi::xml_attribute attribute : element.attributes()) {
      if (!read(attribute.name(), trimmed(attribute.value()), result)) return result;
    }
  }
  return result;
}

// The gradient and those that it refers to, in order; empty when that ends in something else.
std::vector<pugi::xml_node> chain_of(pugi::xml_node element, const FileIndex& index) {
  std::vector<pugi::xml_node> chain;
  while (is_gradient(element) && chain.size() < kLongestChain) {
    chain.push_back(element);
    if (!read_attributes(element).refers) return chain;
    element = index.find_target(element);
  }
  return {};
}

// Values along a chain: the first element that has one decides.
class Chain {
 public:
  explicit Chain(const std::vector<pugi::xml_node>& elements) {
    for (const pugi::xml_node element : elements) links_.push_back(read_attributes(element));
  }

  template <typename Value>
  std::optional<Value> find(std::optional<Value> GradientAttributes::*member) const {
    for (const GradientAttributes& link : links_) {
      if (link.*member) return link.*member;
    }
    return std::nullopt;
  }

 private:
  std::vector<GradientAttributes> links_;
};

void read_geometry(const Chain& chain, GradientDefinition& definition) {
  using Attributes = GradientAttributes;
  definition.x1 = chain.find(&Attributes::x1).value_or(percent(0));
  definition.y1 = chain.find(&Attributes::y1).value_or(percent(0));
  definition.x2 = chain.find(&Attributes::x2).value_or(percent(100));
  definition.y2 = chain.find(&Attributes::y2).value_or(percent(0));
  definition.center_x = chain.find(&Attributes::center_x).value_or(percent(50));
  definition.center_y = chain.find(&Attributes::center_y).value_or(percent(50));
  definition.focus_x = chain.find(&Attributes::focus_x).value_or(definition.center_x);
  definition.focus_y = chain.find(&Attributes::focus_y).value_or(definition.center_y);
  definition.radius = chain.find(&Attributes::radius).value_or(percent(50));
  definition.focus_radius = chain.find(&Attributes::focus_radius).value_or(percent(0));
}

// Offsets never fall: each is at least the one before. A stop with a wrong offset is none.
std::vector<GradientStop> read_stops(pugi::xml_node gradient, const FileIndex& index,
                                     Reporter& reporter) {
  std::vector<GradientStop> stops;
  for (const pugi::xml_node element : gradient.children("stop")) {
    const pugi::xml_attribute attribute = element.attribute("offset");
    const std::optional<double> offset = attribute ? parse_leading_opacity(attribute.value()) : 0;
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
  definition.in_bounding_box = chain.find(&GradientAttributes::in_bounding_box).value_or(true);
  definition.transform = chain.find(&GradientAttributes::transform).value_or(Transform{});
  definition.carried_transform = element.attribute(kCarriedTransform).value();
  definition.spread = chain.find(&GradientAttributes::spread).value_or(Spread::kPad);
  read_geometry(chain, definition);
  for (const pugi::xml_node gradient : elements) {
    definition.stops = read_stops(gradient, index, reporter);
    if (!definition.stops.empty()) break;
  }
  if (!inverse(definition.transform)) return std::nullopt;
  return definition;
}

}  // namespace libstyle::svg
