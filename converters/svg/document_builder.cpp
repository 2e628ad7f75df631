// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/document_builder.h"

#include <algorithm>
#include <utility>

#include "converters/svg/encoding.h"
#include "converters/svg/scanner.h"
#include "libstyle/curves/json_text.h"

namespace libstyle::svg {
namespace {

// Whether the group says anything of its own.
bool carries_something(const GroupRecord& group, std::string_view wanted_id) {
  return !wanted_id.empty() || !group.classes.empty() || !group.label.empty() ||
         !group.extras.empty() || group.layer || group.opacity != 1 || !group.clip.empty() ||
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

}  // namespace

std::string OutputIds::make(std::string_view wanted) {
  std::string base(wanted);
  std::ranges::replace(base, '~', '_');
  const int number = ++counts_[base];
  if (number == 1 && !base.empty()) return base;
  return base + '~' + std::to_string(number);
}

std::string DocumentBuilder::add_group(pugi::xml_node element, const GroupLook& look,
                                       const std::string& parent) {
  GroupRecord group;
  describe(group, element);
  group.layer = std::string_view(element.attribute("inkscape:groupmode").value()) == "layer";
  group.opacity = look.opacity;
  group.clip = look.clip;
  group.hidden = look.hidden;
  const std::string wanted = text_of(element.attribute("id"));
  if (!carries_something(group, wanted)) return parent;
  group.parent = parent;
  group.id = ids_.make(wanted);
  std::string id = group.id;
  document_.records.emplace_back(std::move(group));
  return id;
}

void DocumentBuilder::add_path(pugi::xml_node element, PathRecord path, const std::string& parent) {
  describe(path, element);
  const std::string wanted = text_of(element.attribute("id"));
  if (!wanted.empty()) path.id = ids_.make(wanted);
  path.parent = parent;
  document_.records.emplace_back(std::move(path));
}

std::string DocumentBuilder::add_clip(pugi::xml_node element, std::vector<ClipPart> parts,
                                      const std::string& outer_clip) {
  ClipRecord clip;
  clip.id = ids_.make(text_of(element.attribute("id")));
  if (element) clip.line = file_.place(element).line;
  clip.parts = std::move(parts);
  clip.clip = outer_clip;
  std::string id = clip.id;
  document_.records.emplace_back(std::move(clip));
  return id;
}

void DocumentBuilder::describe(RecordBase& record, pugi::xml_node element) const {
  record.line = file_.place(element).line;
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
