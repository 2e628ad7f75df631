// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/document_builder.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "converters/svg/carried_keys.h"
#include "converters/svg/encoding.h"
#include "converters/svg/scanner.h"
#include "libstyle/curves/json_text.h"

namespace libstyle::svg {
namespace {

// Whether the group says anything of its own.
bool carries_something(const GroupRecord& group, std::string_view wanted_id) {
  return !wanted_id.empty() || !group.classes.empty() || !group.label.empty() ||
         !group.extras.empty() || group.layer || group.opacity != 1 ||
         group.blend_mode != BlendMode::kNormal || group.isolated || !group.clip.empty() ||
         group.hidden;
}

std::string json_string(std::string_view text) {
  std::string json;
  append_json_string(json, text);
  return json;
}

// References to characters ("&#xD800;") can name some that do not exist.
std::string text_of(pugi::xml_attribute attribute) {
  return repaired_utf8(trimmed(attribute.value()));
}

// The id that an earlier document had, if the element still carries it; else that of the element.
std::string wanted_id(pugi::xml_node element) {
  std::string given = text_of(element.attribute("id"));
  std::string carried = text_of(element.attribute(kCarriedId));
  return !carried.empty() && fits_carried_id(carried, given) ? carried : given;
}

}  // namespace

std::string OutputIds::make(std::string_view wanted) {
  std::string base(wanted);
  std::ranges::replace(base, '~', '_');
  for (;;) {
    const int number = ++counts_[base];
    std::string id = number == 1 && !base.empty() ? base : base + '~' + std::to_string(number);
    if (keep(id)) return id;
  }
}

std::string DocumentBuilder::make_id(pugi::xml_node element) {
  const std::string given = text_of(element.attribute("id"));
  std::string wanted = wanted_id(element);
  return wanted != given && ids_.keep(wanted) ? wanted : ids_.make(given);
}

void DocumentBuilder::add_carried_records(pugi::xml_node root) {
  for (const pugi::xml_node metadata : root.children("metadata")) {
    const pugi::xml_node element = metadata.child(kCarriedRecords);
    if (!element) continue;
    std::optional<Document> carried = restore_carried_records(element.text().get());
    if (!carried) {
      reporter_.warn(element, std::string(kCarriedRecords) + " is wrong; left out");
      continue;
    }
    document_.header.history = std::move(carried->header.history);
    document_.header.extras = std::move(carried->header.extras);
    std::ranges::move(carried->records, std::back_inserter(document_.records));
  }
}

std::string DocumentBuilder::add_group(pugi::xml_node element, const GroupLook& look,
                                       const std::string& parent) {
  GroupRecord group;
  describe(group, element);
  group.layer = std::string_view(element.attribute("inkscape:groupmode").value()) == "layer";
  group.opacity = look.opacity;
  group.blend_mode = look.blend_mode;
  group.isolated = look.isolated;
  group.clip = look.clip;
  group.hidden = look.hidden;
  const std::string wanted = text_of(element.attribute("id"));
  const std::string_view carried = element.attribute(kCarriedKeys).value();
  if (!carries_something(group, wanted) && carried.empty()) return parent;
  group.parent = parent;
  group.id = make_id(element);
  std::string id = group.id;
  std::optional<Record> restored;
  if (!carried.empty()) {
    restored = restore_carried_keys(carried, group);
    warn_unless(restored.has_value(), element);
  }
  document_.records.push_back(restored ? std::move(*restored) : std::move(group));
  return id;
}

void DocumentBuilder::add_path(pugi::xml_node element, PathRecord path, const std::string& parent) {
  describe(path, element);
  if (element.attribute("id") || element.attribute(kCarriedId)) path.id = make_id(element);
  path.parent = parent;
  const std::string_view carried = element.attribute(kCarriedKeys).value();
  if (!carried.empty()) warn_unless(restore_carried_keys(carried, path), element);
  document_.records.emplace_back(std::move(path));
}

std::string DocumentBuilder::add_gradient(pugi::xml_node element, GradientRecord gradient) {
  describe(gradient, element);
  const std::string_view carried = element.attribute(kCarriedKeys).value();
  if (!carried.empty()) warn_unless(restore_carried_keys(carried, gradient), element);
  if (const pugi::xml_attribute geometry = element.attribute(kCarriedGeometry)) {
    const auto restore = [&](auto& known) {
      return restore_carried_extras(geometry.value(), known);
    };
    warn_unless(std::visit(restore, gradient.geometry), element);
  }
  gradient.id = wanted_id(element);
  if (has_gradient(gradient)) return gradient.id;
  gradient.id = make_id(element);
  std::string id = gradient.id;
  gradients_.emplace(id, document_.records.size());
  document_.records.emplace_back(std::move(gradient));
  return id;
}

// What stands in SVG once for the page and once for each pen is one.
bool DocumentBuilder::has_gradient(const GradientRecord& gradient) const {
  const auto found = gradients_.find(gradient.id);
  return found != gradients_.end() &&
         std::get<GradientRecord>(document_.records[found->second]) == gradient;
}

std::string DocumentBuilder::add_clip(pugi::xml_node element, std::vector<ClipPart> parts,
                                      const std::string& outer_clip) {
  ClipRecord clip;
  clip.id = make_id(element);
  if (element) clip.line = file_.place(element).line;
  clip.parts = std::move(parts);
  clip.clip = outer_clip;
  std::string id = clip.id;
  document_.records.emplace_back(std::move(clip));
  return id;
}

void DocumentBuilder::warn_unless(bool restored, pugi::xml_node element) {
  if (restored) return;
  reporter_.warn(element,
                 std::string(kCarriedKeys) + " is wrong or does not fit the vertices; left out");
}

void DocumentBuilder::describe(RecordBase& record, pugi::xml_node element) const {
  if (element) record.line = file_.place(element).line;
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "class") {
      record.classes = text_of(attribute);
    } else if (name == "inkscape:label") {
      record.label = text_of(attribute);
    } else if (name.starts_with("data-")) {
      record.extras.push_back({repaired_utf8(name), json_string(text_of(attribute))});
    }
  }
}

}  // namespace libstyle::svg
