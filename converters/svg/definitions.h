// SPDX-License-Identifier: Apache-2.0
// Gradients and clips as elements that paths refer to.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "converters/svg/record_ids.h"
#include "converters/svg/xml_writer.h"
#include "libstyle/curves/document.h"

namespace libstyle::svg {

// For users on the page, or in the space of a pen that it can be brought to (pen_space.h).
void write_gradient(XmlWriter& xml, const GradientRecord& gradient, std::string_view id,
                    const std::optional<Transform>& page_from_pen);

void write_clip(XmlWriter& xml, const ClipRecord& clip, std::string_view id, const RecordIds& ids);

// clip-path="url(#...)", or nothing when there is no such clip.
void write_clip_reference(XmlWriter& xml, std::string_view clip, const RecordIds& ids);

// id, and that of the record where it is another one.
void write_id(XmlWriter& xml, const RecordBase& record, std::string_view id);

// class, inkscape:label and the data-* attributes.
void write_notes(XmlWriter& xml, const RecordBase& record);

}  // namespace libstyle::svg
