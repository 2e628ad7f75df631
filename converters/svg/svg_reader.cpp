// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/svg_reader.h"

#include <utility>

#include "converters/svg/file_index.h"
#include "converters/svg/reporter.h"
#include "converters/svg/walker.h"

namespace libstyle::svg {

Document read_svg(std::string text, const std::string& name, const SvgReadOptions& options,
                  const WarningHandler& warn) {
  const XmlFile file(std::move(text), name, options.limits.xml, warn);
  Reporter reporter(file, warn);
  const FileIndex index(file, options.style_sheet, reporter, warn);
  Document document;
  Walker(file, index, options.limits, reporter, document).walk();
  return document;
}

}  // namespace libstyle::svg
