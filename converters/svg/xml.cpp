// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/xml.h"

#include <algorithm>
#include <utility>

#include "converters/svg/carried_keys.h"
#include "converters/svg/encoding.h"
#include "converters/svg/gzip.h"

namespace libstyle::svg {
namespace {

constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";

// The prefix that we use for a namespace; "foreign" for one that means nothing to us.
std::string_view canonical_prefix(std::string_view uri) {
  constexpr std::pair<std::string_view, std::string_view> kKnown[] = {
      {kSvgNamespace, ""},
      {"", ""},
      {"http://www.w3.org/1999/xlink", "xlink"},
      {"http://www.w3.org/XML/1998/namespace", "xml"},
      {"http://www.inkscape.org/namespaces/inkscape", "inkscape"},
      {"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd", "sodipodi"},
      {"http://inkscape.sourceforge.net/DTD/sodipodi-0.dtd", "sodipodi"},
      {kCurvesNamespace, "curves"},
  };
  const auto* const known =
      std::ranges::find(kKnown, uri, &std::pair<std::string_view, std::string_view>::first);
  return known == std::end(kKnown) ? "foreign" : known->second;
}

// Gives the elements and attributes of a tree their canonical names, without recursion.
class NameResolver {
 public:
  NameResolver(std::size_t depth_limit, const XmlFile& file)
      : depth_limit_(depth_limit), file_(file) {}

  void resolve(pugi::xml_node root) {
    pugi::xml_node node = root;
    while (node) {
      enter(node);
      pugi::xml_node next = next_element(node.first_child());
      while (!next && node) {
        leave();
        next = node == root ? pugi::xml_node() : next_element(node.next_sibling());
        if (!next) node = node == root ? pugi::xml_node() : node.parent();
      }
      node = next;
    }
  }

 private:
  struct Declaration {
    std::string_view prefix;
    std::string_view uri;
  };

  static pugi::xml_node next_element(pugi::xml_node node) {
    while (node && node.type() != pugi::node_element) node = node.next_sibling();
    return node;
  }

  void enter(pugi::xml_node node) {
    scope_sizes_.push_back(scope_.size());
    if (scope_sizes_.size() > depth_limit_) {
      throw Error(file_.place(node),
                  "elements nest deeper than " + std::to_string(depth_limit_) + " levels");
    }
    for (const pugi::xml_attribute attribute : node.attributes()) declare(attribute);
    rename_element(node);
    for (pugi::xml_attribute attribute : node.attributes()) rename_attribute(attribute);
  }

  void leave() {
    scope_.resize(scope_sizes_.back());
    scope_sizes_.pop_back();
  }

  void declare(pugi::xml_attribute attribute) {
    const std::string_view name = attribute.name();
    if (!name.starts_with("xmlns")) return;
    if (name.size() == 5) {
      scope_.push_back({"", attribute.value()});
    } else if (name[5] == ':') {
      scope_.push_back({name.substr(6), attribute.value()});
    }
  }

  const Declaration* find(std::string_view prefix) const {
    for (auto it = scope_.rbegin(); it != scope_.rend(); ++it) {
      if (it->prefix == prefix) return &*it;
    }
    return nullptr;
  }

  void rename_element(pugi::xml_node node) const {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    const std::string_view prefix = colon == std::string_view::npos ? "" : name.substr(0, colon);
    const Declaration* const declared = find(prefix);
    // What is not declared is taken as it looks.
    const std::string_view target =
        declared != nullptr ? canonical_prefix(declared->uri) : (prefix == "svg" ? "" : prefix);
    if (target == prefix) return;
    const std::string_view local = colon == std::string_view::npos ? name : name.substr(colon + 1);
    node.set_name(joined(target, local).c_str());
  }

  void rename_attribute(pugi::xml_attribute attribute) const {
    const std::string_view name = attribute.name();
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || name.starts_with("xmlns:")) return;
    const Declaration* const declared = find(name.substr(0, colon));
    if (declared == nullptr) return;
    const std::string_view target = canonical_prefix(declared->uri);
    if (target == "foreign" || target == name.substr(0, colon)) return;
    attribute.set_name(joined(target, name.substr(colon + 1)).c_str());
  }

  static std::string joined(std::string_view prefix, std::string_view local) {
    std::string name(prefix);
    if (!prefix.empty()) name += ':';
    return name.append(local);
  }

  std::size_t depth_limit_;
  const XmlFile& file_;
  std::vector<Declaration> scope_;
  std::vector<std::size_t> scope_sizes_;
};

std::vector<std::size_t> find_line_ends(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t at = text.find('\n'); at != std::string_view::npos;
       at = text.find('\n', at + 1)) {
    ends.push_back(at);
  }
  return ends;
}

std::string explain(const pugi::xml_parse_result& result) {
  switch (result.status) {
    case pugi::status_no_document_element:
      return "is no XML: it has no element";
    case pugi::status_end_element_mismatch:
      return "an element is not closed, or closed by the name of another; is the file cut off?";
    case pugi::status_out_of_memory:
      return "needs more memory than there is";
    default:
      return std::string("is no well-formed XML: ") + result.description();
  }
}

}  // namespace

XmlFile::XmlFile(std::string text, std::string file, const XmlLimits& limits,
                 const WarningHandler& warn)
    : file_(std::move(file)) {
  if (text.size() > limits.bytes) {
    throw Error({file_, 0}, "is larger than " + std::to_string(limits.bytes >> 20) + " MB");
  }
  if (is_gzip(text)) text = gunzip(text, limits.bytes, file_);
  text = to_utf8(std::move(text), file_, warn);
  text_ = expand_entities(std::move(text), file_, limits.entities, warn);
  line_ends_ = find_line_ends(text_);
  // White space between two elements is a word space in text.
  constexpr unsigned kOptions = pugi::parse_default | pugi::parse_pi | pugi::parse_ws_pcdata;
  const pugi::xml_parse_result result =
      tree_.load_buffer_inplace(text_.data(), text_.size(), kOptions, pugi::encoding_utf8);
  if (!result) throw Error(place_of_offset(result.offset), explain(result));
  NameResolver(limits.depth, *this).resolve(root());
  if (std::string_view(root().name()) != "svg") {
    throw Error(place(root()), std::string("is no SVG: its outermost element is ") + root().name());
  }
}

Place XmlFile::place(pugi::xml_node node) const { return place_of_offset(node.offset_debug()); }

Place XmlFile::place_of_offset(std::ptrdiff_t offset) const {
  if (offset < 0) return {file_, 0};
  const auto end = std::ranges::lower_bound(line_ends_, static_cast<std::size_t>(offset));
  return {file_, 1 + static_cast<std::size_t>(end - line_ends_.begin())};
}

bool is_foreign(std::string_view name) { return name.find(':') != std::string_view::npos; }

}  // namespace libstyle::svg
