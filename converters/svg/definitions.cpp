// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/definitions.h"

#include <algorithm>
#include <set>

#include "converters/svg/carried_keys.h"
#include "converters/svg/pen_space.h"
#include "converters/svg/style_attributes.h"
#include "libstyle/curves/json_text.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

constexpr std::string_view kSpreads[] = {"pad", "reflect", "repeat"};

void write_geometry(XmlWriter& xml, const LinearGeometry& linear) {
  xml.attribute("x1", linear.start.x);
  xml.attribute("y1", linear.start.y);
  xml.attribute("x2", linear.end.x);
  xml.attribute("y2", linear.end.y);
}

void write_geometry(XmlWriter& xml, const RadialGeometry& radial) {
  xml.attribute("cx", radial.center.x);
  xml.attribute("cy", radial.center.y);
  xml.attribute("r", radial.radius);
  if (radial.focus != radial.center) {
    xml.attribute("fx", radial.focus.x);
    xml.attribute("fy", radial.focus.y);
  }
  if (radial.focus_radius != 0) xml.attribute("fr", radial.focus_radius);
}

void write_extras(XmlWriter& xml, const char* attribute, const std::vector<Extra>& extras) {
  const std::string carried = carried_extras(extras);
  if (!carried.empty()) xml.attribute(attribute, carried);
}

void write_stop(XmlWriter& xml, const GradientStop& stop) {
  xml.begin("stop");
  xml.attribute("offset", stop.offset);
  xml.attribute("stop-color", to_text({stop.color.red, stop.color.green, stop.color.blue}));
  const double opacity = stop.opacity * (stop.color.alpha / 255.0);
  if (opacity != 1) xml.attribute("stop-opacity", opacity);
  write_extras(xml, kCarriedKeys, stop.extras);
  xml.end();
}

void write_transform(XmlWriter& xml, const Transform& page_from_gradient,
                     const std::optional<Transform>& page_from_pen) {
  const Transform user_from_gradient =
      page_from_pen ? to_pen_space(page_from_gradient, *page_from_pen).value_or(Transform{})
                    : page_from_gradient;
  if (user_from_gradient != Transform{}) {
    xml.attribute("gradientTransform", to_matrix(user_from_gradient));
  }
  if (page_from_pen && to_page(user_from_gradient, *page_from_pen, "") != page_from_gradient) {
    xml.attribute(kCarriedTransform, to_matrix(page_from_gradient));
  }
}

// Whether the clip is more than the one shape that librsvg would make of it.
bool is_composed(const ClipRecord& clip) {
  return clip.parts.size() > 1 || !clip.clip.empty() ||
         std::ranges::any_of(clip.parts, [](const ClipPart& part) { return !part.clip.empty(); });
}

template <typename Record>
void write_carried(XmlWriter& xml, const Record& record) {
  const std::string carried = carried_keys(record);
  if (!carried.empty()) xml.attribute(kCarriedKeys, carried);
}

}  // namespace

void write_gradient(XmlWriter& xml, const GradientRecord& gradient, std::string_view id,
                    const std::optional<Transform>& page_from_pen) {
  const bool linear = std::holds_alternative<LinearGeometry>(gradient.geometry);
  xml.begin(linear ? "linearGradient" : "radialGradient");
  write_id(xml, gradient, id);
  write_notes(xml, gradient);
  xml.attribute("gradientUnits", "userSpaceOnUse");
  std::visit([&](const auto& geometry) { write_geometry(xml, geometry); }, gradient.geometry);
  write_transform(xml, gradient.page_from_gradient, page_from_pen);
  if (gradient.spread != Spread::kPad) {
    xml.attribute("spreadMethod", kSpreads[static_cast<std::size_t>(gradient.spread)]);
  }
  write_carried(xml, gradient);
  std::visit([&](const auto& known) { write_extras(xml, kCarriedGeometry, known.extras); },
             gradient.geometry);
  for (const GradientStop& stop : gradient.stops) write_stop(xml, stop);
  xml.end();
}

void write_clip(XmlWriter& xml, const ClipRecord& clip, std::string_view id, const RecordIds& ids) {
  xml.begin("clipPath");
  write_id(xml, clip, id);
  write_notes(xml, clip);
  write_clip_reference(xml, clip.clip, ids);
  if (is_composed(clip)) xml.attribute(kCarriedParts, kUnited);
  write_carried(xml, clip);
  for (const ClipPart& part : clip.parts) {
    xml.begin("path");
    if (part.rule == FillRule::kEvenOdd) xml.attribute("clip-rule", "evenodd");
    write_clip_reference(xml, part.clip, ids);
    write_extras(xml, kCarriedKeys, part.extras);
    xml.attribute("d", to_path_data(part.path));
    xml.end();
  }
  xml.end();
}

void write_clip_reference(XmlWriter& xml, std::string_view clip, const RecordIds& ids) {
  const std::string& id = ids.find(clip);
  if (!id.empty()) xml.attribute("clip-path", "url(#" + id + ")");
}

void write_id(XmlWriter& xml, const RecordBase& record, std::string_view id) {
  if (!id.empty()) xml.attribute("id", id);
  const std::string_view carried = carried_id(record.id, id);
  if (!carried.empty()) xml.attribute(kCarriedId, carried);
}

void write_notes(XmlWriter& xml, const RecordBase& record) {
  if (!record.classes.empty()) xml.attribute("class", record.classes);
  if (!record.label.empty()) xml.attribute("inkscape:label", record.label);
  std::set<std::string_view> written;
  for (const Extra& extra : record.extras) {
    if (!is_data_attribute(extra) || !written.insert(extra.key).second) continue;
    const std::optional<std::string> value = parse_json_string(extra.json);
    if (value) xml.attribute(extra.key, *value);
  }
}

}  // namespace libstyle::svg
