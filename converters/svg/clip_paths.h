// SPDX-License-Identifier: Apache-2.0
// The property clip-path: what an element is clipped to, as clip records (SVG 1.1, section 14.3).
#pragma once

#include <functional>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "converters/svg/document_builder.h"
#include "converters/svg/walker.h"
#include "libstyle/geometry/box.h"

namespace libstyle::svg {

class ClipPaths {
 public:
  ClipPaths(Drawing& drawing, DocumentBuilder& builder) : drawing_(drawing), builder_(builder) {}

  // The id of the record for the clip-path of an element, added to the document if need be; ""
  // where nothing is clipped. `bounds` gives the box of the element in its user space.
  std::string find_or_add(pugi::xml_node element, const Scope& scope,
                          const std::function<Box()>& bounds);

 private:
  // Where a clipPath was last used: many elements in a row tend to share one.
  struct Use {
    Transform page_from_user;
    Vector viewport;
    std::string id;
  };

  pugi::xml_node find_clip(pugi::xml_node element, std::string_view value);
  std::string add(pugi::xml_node clip, const Scope& scope, const std::function<Box()>& bounds);

  Drawing& drawing_;
  DocumentBuilder& builder_;
  std::map<const void*, Use> last_uses_;
  std::vector<pugi::xml_node> open_;  // the clipPaths that are being added
};

}  // namespace libstyle::svg
