// SPDX-License-Identifier: Apache-2.0
// Says what is not carried: one warning for each element and matter, however often `use` draws it.
#pragma once

#include <pugixml.hpp>
#include <set>
#include <string>
#include <utility>

#include "converters/svg/xml.h"
#include "libstyle/base/warning.h"

namespace libstyle::svg {

class Reporter {
 public:
  Reporter(const XmlFile& file, const WarningHandler& handler) : file_(file), handler_(handler) {}

  void warn(pugi::xml_node element, const std::string& message) {
    if (!said_.emplace(element.internal_object(), message).second) return;
    handler_({file_.place(element), element.attribute("id").value(), message});
  }

 private:
  const XmlFile& file_;
  const WarningHandler& handler_;
  std::set<std::pair<const void*, std::string>> said_;
};

}  // namespace libstyle::svg
