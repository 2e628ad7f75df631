// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/conditions.h"

#include <algorithm>
#include <string_view>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

// The feature strings of SVG 1.1 (appendix N) that librsvg claims.
bool is_feature(std::string_view name) {
  constexpr std::string_view kPrefix = "http://www.w3.org/TR/SVG11/feature#";
  constexpr std::string_view kFeatures[] = {"SVG",
                                            "SVG-static",
                                            "BasicFilter",
                                            "BasicGraphicsAttribute",
                                            "BasicPaintAttribute",
                                            "BasicStructure",
                                            "BasicText",
                                            "ConditionalProcessing",
                                            "ContainerAttribute",
                                            "Filter",
                                            "Gradient",
                                            "Image",
                                            "Marker",
                                            "Mask",
                                            "OpacityAttribute",
                                            "Pattern",
                                            "Shape",
                                            "Structure",
                                            "Style",
                                            "View"};
  if (name == "org.w3c.svg.static") return true;  // of SVG 1.0
  return name.starts_with(kPrefix) &&
         std::ranges::find(kFeatures, name.substr(kPrefix.size())) != std::end(kFeatures);
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
  if (!trimmed(element.attribute("requiredExtensions").value()).empty()) return false;
  const auto is_missing = [](std::string_view feature) { return !is_feature(feature); };
  const std::string_view features = element.attribute("requiredFeatures").value();
  if (count_parts(features, " \t\r\n", is_missing) > 0) return false;
  return !element.attribute("systemLanguage");
}

}  // namespace libstyle::svg
