// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/ink.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "converters/cairo/canvas.h"

namespace libstyle {
namespace {

bool is_painted(const std::optional<Paint>& paint) {
  return paint && !std::holds_alternative<NoPaint>(*paint);
}

// The largest factor by which a transform lengthens (its Frobenius norm bounds it).
double most_stretch(const Transform& t) {
  return std::sqrt(t.a * t.a + t.b * t.b + t.c * t.c + t.d * t.d);
}

double widest(const PathRecord& record) {
  const std::vector<double>* widths = record.along.find("width");
  if (!widths || widths->empty()) return record.style.stroke_width;
  return std::max(0.0, *std::max_element(widths->begin(), widths->end()));
}

}  // namespace

bool has_stroke(const PathRecord& record) {
  const Style& style = record.style;
  const bool wanted = style.is_bare() || is_painted(style.stroke) ||
                      (!style.stroke && !record.along.colors.empty());
  return wanted && widest(record) > 0;
}

double stroke_reach(const PathRecord& record) {
  const Style& style = record.style;
  const double corners = style.line_join == LineJoin::kMiter ? style.miter_limit : 1;
  const double ends = style.line_cap == LineCap::kSquare ? std::numbers::sqrt2 : 1;
  const double stretch = style.stroke_transform ? most_stretch(*style.stroke_transform) : 1;
  return widest(record) / 2 * std::max(corners, ends) * stretch;
}

Box ink_box(const PathRecord& record) {
  Box box;
  if (record.style.hidden || record.path.empty()) return box;
  const bool stroked = has_stroke(record);
  if (!stroked && !is_painted(record.style.fill)) return box;
  box = record.path.control_box();
  if (stroked) {
    const double reach = stroke_reach(record);
    box.low -= {reach, reach};
    box.high += {reach, reach};
  }
  return box;
}

namespace {

// What may be drawn in a group: paths, groups and elements. Null for other records.
const RecordBase* as_member(const Record& record) {
  if (const auto* path = std::get_if<PathRecord>(&record)) return path;
  if (const auto* group = std::get_if<GroupRecord>(&record)) return group;
  return std::get_if<ElementRecord>(&record);
}

// The boxes of the records, and of what stands in no group. From the last record to the first, so
// that every group is complete before it is added to the group it is in.
std::pair<std::vector<Box>, Box> gather_boxes(const Document& document) {
  const ReferenceIndex index(document);
  std::vector<Box> boxes(document.records.size());
  Box whole;
  for (std::size_t i = document.records.size(); i-- > 0;) {
    const RecordBase* member = as_member(document.records[i]);
    if (!member) continue;
    const auto* path = std::get_if<PathRecord>(&document.records[i]);
    const auto* group = std::get_if<GroupRecord>(&document.records[i]);
    if (path) boxes[i] = ink_box(*path);
    if (group && group->hidden) boxes[i] = {};
    const std::size_t container = index.container(member->parent, i);
    (container == ReferenceIndex::kNone ? whole : boxes[container]).include(boxes[i]);
  }
  return {std::move(boxes), whole};
}

}  // namespace

std::vector<Box> ink_boxes(const Document& document) { return gather_boxes(document).first; }

Box drawn_box(const Document& document) { return gather_boxes(document).second; }

}  // namespace libstyle
