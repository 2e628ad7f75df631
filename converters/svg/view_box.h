// SPDX-License-Identifier: Apache-2.0
// How the inside of a viewport is laid into it: viewBox and preserveAspectRatio (SVG 1.1, sections
// 7.7 and 7.8).
#pragma once

#include <cstdint>
#include <optional>
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

// Four numbers. Nothing when there are fewer or more, or a size is negative. A size of 0 is valid
// and means that nothing is drawn.
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

// "[defer] none|xMinYMin|..|xMaxYMax [meet|slice]". Nothing when it is anything else.
std::optional<AspectRatio> parse_aspect_ratio(std::string_view text);

// Brings `view_box` into `viewport`. Nothing when a size of the view box is 0 or the map has no
// inverse.
std::optional<Transform> viewport_from_view_box(const Rectangle& viewport,
                                                const Rectangle& view_box, AspectRatio ratio);

}  // namespace libstyle::svg
