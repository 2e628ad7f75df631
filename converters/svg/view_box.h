// SPDX-License-Identifier: Apache-2.0
// How the inside of a viewport is laid into it: viewBox and preserveAspectRatio (SVG 1.1, sections
// 7.7 and 7.8).
#pragma once

#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "libstyle/geometry/transform.h"

namespace libstyle::svg {

struct Rectangle {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

// Four numbers; more are not looked at. Nothing when there are fewer, one has a unit, or a size is
// negative. A size of 0 is valid and means that nothing is drawn.
std::optional<Rectangle> parse_view_box(std::string_view text);

enum class Align : std::uint8_t { kMin, kMid, kMax };

struct AspectRatio {
  bool preserved = true;  // false: "none", both axes are scaled on their own
  Align x = Align::kMid;
  Align y = Align::kMid;
  bool slice = false;  // cover the viewport rather than fit into it
  bool defer = false;  // take the ratio of the image referred to, if it has one

  friend bool operator==(const AspectRatio&, const AspectRatio&) = default;
};

// "[defer] none|xMinYMin|..|xMaxYMax [meet|slice]" in any case; what follows is not looked at.
// Nothing when it is anything else.
std::optional<AspectRatio> parse_aspect_ratio(std::string_view text);

// What an element that opens a viewport shows in it.
struct View {
  std::optional<Rectangle> view_box;
  AspectRatio ratio;
};

// Nothing when viewBox or preserveAspectRatio is there and wrong. Such an element is in error and
// not drawn, as librsvg has it.
std::optional<View> read_view(pugi::xml_node element);

// Brings `view_box` into `viewport`. Nothing when a size of the view box is 0 or the map has no
// inverse.
std::optional<Transform> viewport_from_view_box(const Rectangle& viewport,
                                                const Rectangle& view_box, AspectRatio ratio);

}  // namespace libstyle::svg
