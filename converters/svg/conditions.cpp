// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/conditions.h"

#include <algorithm>
#include <string_view>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

// SVG 1.1, appendix N, without scripts, movement and fonts.
bool is_feature(std::string_view name) {
  constexpr std::string_view kPrefix = "http://www.w3.org/TR/SVG11/feature#";
  constexpr std::string_view kFeatures[] = {"SVG",
                                            "SVGDOM",
                                            "CoreAttribute",
                                            "SVG-static",
                                            "SVGDOM-static",
                                            "Structure",
                                            "Shape",
                                            "BasicStructure",
                                            "ContainerAttribute",
                                            "Style",
                                            "ViewportAttribute",
                                            "PaintAttribute",
                                            "BasicPaintAttribute",
                                            "OpacityAttribute",
                                            "GraphicsAttribute",
                                            "BasicGraphicsAttribute",
                                            "ConditionalProcessing",
                                            "XlinkAttribute",
                                            "XLinkAttribute",
                                            "BasicText",
                                            "Text",
                                            "Image",
                                            "Marker",
                                            "Gradient",
                                            "Pattern",
                                            "Clip",
                                            "BasicClip",
                                            "Mask",
                                            "Filter",
                                            "BasicFilter",
                                            "ExternalResourcesRequired"};
  return name.starts_with(kPrefix) &&
         std::ranges::find(kFeatures, name.substr(kPrefix.size())) != std::end(kFeatures);
}

// "en", and its regional forms.
bool is_english(std::string_view language) {
  return language.size() >= 2 && equal_ignoring_case(language.substr(0, 2), "en") &&
         (language.size() == 2 || language[2] == '-' || language[2] == '_');
}

// Calls `test` on the parts of `text`; an empty list holds none.
template <typename Test>
std::size_t count_parts(std::string_view text, std::string_view separators, Test test) {
  std::size_t count = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    const std::string_view part = trimmed(text.substr(0, end));
    if (!part.empty() && test(part)) ++count;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return count;
}

}  // namespace

bool conditions_hold(pugi::xml_node element) {
  if (element.attribute("requiredExtensions")) return false;
  if (const pugi::xml_attribute features = element.attribute("requiredFeatures")) {
    const std::string_view list = features.value();
    const auto any = [](std::string_view) { return true; };
    const std::size_t wanted = count_parts(list, " \t\r\n", any);
    if (wanted == 0 || count_parts(list, " \t\r\n", is_feature) < wanted) return false;
  }
  const pugi::xml_attribute languages = element.attribute("systemLanguage");
  return !languages || count_parts(languages.value(), ",", is_english) > 0;
}

}  // namespace libstyle::svg
