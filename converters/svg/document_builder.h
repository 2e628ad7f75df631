// SPDX-License-Identifier: Apache-2.0
// Puts the records of a document together: ids that are unique, names and notes of the elements.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "converters/svg/reporter.h"
#include "converters/svg/xml.h"
#include "libstyle/curves/document.h"

namespace libstyle::svg {

// Gives out ids of which no two are the same. What is wanted again, because `use` draws it twice or
// the file has it twice, ends in "~2", "~3" and so on; what has no id becomes "~1", "~2".
class OutputIds {
 public:
  std::string make(std::string_view wanted);
  // Takes an id as it is; says no when it is taken.
  bool keep(const std::string& id) { return taken_.insert(id).second; }

 private:
  std::map<std::string, int, std::less<>> counts_;
  std::unordered_set<std::string> taken_;  // looked up, never walked through
};

// How a group as a whole is drawn.
struct GroupLook {
  double opacity = 1;
  BlendMode blend_mode = BlendMode::kNormal;
  bool isolated = false;
  std::string clip;
  bool hidden = false;
};

class DocumentBuilder {
 public:
  DocumentBuilder(const XmlFile& file, Reporter& reporter, Document& document)
      : file_(file), reporter_(reporter), document_(document) {}

  // Adds what the file carries of an earlier document that SVG has no place for (carried_keys.h):
  // history, and records that draw nothing.
  void add_carried_records(pugi::xml_node root);

  // Adds a group for an element, or none when it would carry nothing. Returns the id that its
  // members are in. `element` may be null.
  std::string add_group(pugi::xml_node element, const GroupLook& look, const std::string& parent);

  // Adds a path for an element, with the element's id and notes.
  void add_path(pugi::xml_node element, PathRecord path, const std::string& parent);

  // Adds a gradient for an element, unless the one of its id is the same, and returns its id.
  std::string add_gradient(pugi::xml_node element, GradientRecord gradient);

  // Adds a clip and returns its id. `element` may be null.
  std::string add_clip(pugi::xml_node element, std::vector<ClipPart> parts,
                       const std::string& outer_clip);

 private:
  std::string make_id(pugi::xml_node element);
  bool has_gradient(const GradientRecord& gradient) const;
  void describe(RecordBase& record, pugi::xml_node element) const;
  void warn_unless(bool restored, pugi::xml_node element);

  const XmlFile& file_;
  Reporter& reporter_;
  Document& document_;
  OutputIds ids_;
  std::map<std::string, std::size_t> gradients_;  // places of their records, by id
};

}  // namespace libstyle::svg
