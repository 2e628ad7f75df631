// SPDX-License-Identifier: Apache-2.0
// The paint of a path as presentation attributes.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "converters/svg/xml_writer.h"
#include "libstyle/curves/document.h"

namespace libstyle::svg {

// The XML id of a gradient that a path refers to; empty when it is not there.
using GradientIds = std::function<std::string(const PaintReference& reference)>;

// Whether the path has a width or a colour that varies along the stroke, which SVG cannot draw.
bool varies_along_stroke(const PathRecord& path);

// Writes what differs from SVG's initial values. A bare curve gets its black line; a stroke that
// varies along the curve gets its mean width and colour.
void write_style(XmlWriter& xml, const PathRecord& path, const GradientIds& gradient_ids);

// "1 2 3", ","-separated for lists that a person counts in pairs.
std::string to_number_list(std::span<const double> numbers, char separator = ' ');

std::string to_matrix(const Transform& transform);

}  // namespace libstyle::svg
