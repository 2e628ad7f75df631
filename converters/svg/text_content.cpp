// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/text_content.h"

#include <algorithm>
#include <string_view>

#include "converters/svg/cascade.h"
#include "converters/svg/element_path.h"
#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

// The parser in librsvg takes no more than 256.
constexpr std::size_t kDepthLimit = 200;

bool is_part(std::string_view name) { return name == "tspan" || name == "tref" || name == "a"; }

void append_characters(pugi::xml_node node, std::string& text) {
  if (is_characters(node)) text += node.value();
  for (const pugi::xml_node child : node.children()) append_characters(child, text);
}

class ContentReader {
 public:
  ContentReader(const Scope& scope, const FileIndex& index, std::size_t work_limit,
                Reporter& reporter)
      : scope_(scope), index_(index), work_limit_(work_limit), reporter_(reporter) {}

  TextContent read(pugi::xml_node text) {
    add(text, scope_.style);
    return std::move(content_);
  }

 private:
  void add(pugi::xml_node element, const ComputedStyle& style) {
    const std::size_t index = content_.parts.size();
    content_.parts.push_back(make_part(element, style));
    ++depth_;
    if (std::string_view(element.name()) == "tref") {
      content_.parts.back().borrowed = borrowed_characters(element);
      count(content_.parts.back().borrowed);
    } else {
      for (const pugi::xml_node child : element.children()) {
        content_.work += 16;
        if (content_.work > work_limit_) break;
        add_child(child, style);
      }
    }
    --depth_;
    content_.parts[index].end = content_.parts.size();
  }

  void add_child(pugi::xml_node child, const ComputedStyle& parent) {
    if (is_characters(child)) return count(child.value());
    if (child.type() != pugi::node_element) return;
    if (is_part(child.name())) {
      if (depth_ == kDepthLimit) return reporter_.warn(child, "is nested too deep; it is left out");
      const ComputedStyle style = cascade(child, parent, index_.sheets());
      if (style.display != Display::kNone) add(child, style);
    } else if (element_kind(child.name()) == ElementKind::kNotCarried) {
      reporter_.warn(child, std::string(child.name()) + " is not carried");
    }
  }

  std::string borrowed_characters(pugi::xml_node reference) {
    const pugi::xml_node target = index_.find_target(reference);
    if (!target) {
      reporter_.warn(reference, "refers to \"" + std::string(link_of(reference)) +
                                    "\", which is not in the file");
    }
    std::string text;
    append_characters(target, text);
    return text;
  }

  void count(std::string_view characters) {
    content_.characters += characters.size();
    content_.work += characters.size();
    content_.longest = std::max(content_.longest, characters.size());
  }

  TextPart make_part(pugi::xml_node element, const ComputedStyle& style) {
    const LengthContext context = length_context(style, scope_.viewport);
    TextPart part;
    part.element = element;
    part.style = style;
    part.x = lengths(element, "x", LengthAxis::kHorizontal, context);
    part.y = lengths(element, "y", LengthAxis::kVertical, context);
    part.dx = lengths(element, "dx", LengthAxis::kHorizontal, context);
    part.dy = lengths(element, "dy", LengthAxis::kVertical, context);
    for (const char* name : {"rotate", "textLength"}) {
      if (element.attribute(name)) reporter_.warn(element, std::string(name) + " is not carried");
    }
    return part;
  }

  // Ends at the first that is wrong, and when there is no work left for more.
  std::vector<double> lengths(pugi::xml_node element, const char* name, LengthAxis axis,
                              const LengthContext& context) {
    std::vector<double> lengths;
    std::string_view rest = trimmed(element.attribute(name).value());
    while (!rest.empty() && content_.work <= work_limit_) {
      const std::size_t end = std::min(rest.find_first_of(", \t\r\n"), rest.size());
      const std::optional<Length> length = parse_length(rest.substr(0, end));
      if (!length) {
        reporter_.warn(element, std::string(name) + " has an error; it is read up to there");
        break;
      }
      if (!lengths.empty()) content_.work += 16;
      lengths.push_back(resolve(*length, axis, context));
      rest = trimmed(rest.substr(end));
      if (rest.starts_with(',')) rest = trimmed(rest.substr(1));
    }
    return lengths;
  }

  const Scope& scope_;
  const FileIndex& index_;
  std::size_t work_limit_;
  Reporter& reporter_;
  TextContent content_;
  std::size_t depth_ = 0;
};

}  // namespace

bool is_characters(pugi::xml_node node) {
  return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

TextContent read_text_content(pugi::xml_node element, const Scope& scope, const FileIndex& index,
                              std::size_t work_limit, Reporter& reporter) {
  return ContentReader(scope, index, work_limit, reporter).read(element);
}

}  // namespace libstyle::svg
