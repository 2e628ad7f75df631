// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <utility>

#include "converters/svg/css_text.h"
#include "converters/svg/scanner.h"
#include "converters/svg/selector.h"

namespace libstyle::svg {
namespace {

// ":not(:not(...))" cannot be written so deep by anyone who means well.
constexpr int kNestingLimit = 8;

class SelectorParser {
 public:
  explicit SelectorParser(std::string_view text, int nesting = 0)
      : scanner_(text), nesting_(nesting) {}

  bool parse_list(std::vector<Selector>& selectors) {
    do {
      Selector& selector = selectors.emplace_back();
      scanner_.skip_spaces();
      if (!parse_selector(selector)) return false;
    } while (scanner_.take(','));
    return scanner_.at_end();
  }

  bool parse_compound_list(std::vector<CompoundSelector>& compounds, Specificity& specificity) {
    do {
      scanner_.skip_spaces();
      if (!parse_compound(compounds.emplace_back(), specificity)) return false;
      scanner_.skip_spaces();
    } while (scanner_.take(','));
    return scanner_.at_end();
  }

 private:
  bool parse_selector(Selector& selector) {
    while (true) {
      if (!parse_compound(selector.compounds.emplace_back(), selector.specificity)) return false;
      const std::optional<Combinator> combinator = take_combinator();
      if (!combinator) return true;
      selector.combinators.push_back(*combinator);
    }
  }

  // What joins this compound to the next; nothing at the end of the selector.
  std::optional<Combinator> take_combinator() {
    const bool spaced = is_space(scanner_.peek());
    scanner_.skip_spaces();
    std::optional<Combinator> combinator;
    if (scanner_.take('>')) {
      combinator = Combinator::kChild;
    } else if (scanner_.take('+')) {
      combinator = Combinator::kNextSibling;
    } else if (scanner_.take('~')) {
      combinator = Combinator::kLaterSibling;
    } else if (spaced && !scanner_.at_end() && scanner_.peek() != ',') {
      combinator = Combinator::kDescendant;
    }
    scanner_.skip_spaces();
    return combinator;
  }

  bool parse_compound(CompoundSelector& compound, Specificity& specificity) {
    const std::size_t begin = scanner_.position();
    take_any_namespace();
    if (!scanner_.take('*')) {
      compound.type = take_identifier(scanner_);
      if (!compound.type.empty()) ++specificity.types;
    }
    while (true) {
      if (scanner_.take('#')) {
        ++specificity.ids;
        if (!take_name(compound.ids)) return false;
      } else if (scanner_.take('.')) {
        ++specificity.classes;
        if (!take_name(compound.classes)) return false;
      } else if (scanner_.take('[')) {
        ++specificity.classes;
        if (!parse_attribute(compound.attributes.emplace_back())) return false;
      } else if (scanner_.take(':')) {
        PseudoClass pseudo;
        if (!parse_pseudo_class(pseudo, compound.pseudo_classes, specificity)) return false;
        compound.pseudo_classes.push_back(std::move(pseudo));
      } else {
        return scanner_.position() > begin;
      }
    }
  }

  // "*|": everything that is read here is in the namespace of SVG.
  void take_any_namespace() {
    const Scanner before = scanner_;
    if (!scanner_.take('*') || !scanner_.take('|')) scanner_ = before;
  }

  bool take_name(std::vector<std::string>& names) {
    names.push_back(take_identifier(scanner_));
    return !names.back().empty();
  }

  bool parse_attribute(AttributeTest& test) {
    scanner_.skip_spaces();
    test.name = take_identifier(scanner_);
    if (test.name.empty()) return false;
    scanner_.skip_spaces();
    if (scanner_.take(']')) return true;
    if (!take_attribute_operator(test.kind)) return false;
    scanner_.skip_spaces();
    test.value = take_string_or_identifier(scanner_);
    scanner_.skip_spaces();
    test.ignores_case = scanner_.take('i') || scanner_.take('I');
    scanner_.skip_spaces();
    return scanner_.take(']');
  }

  bool take_attribute_operator(AttributeTest::Kind& kind) {
    constexpr std::pair<char, AttributeTest::Kind> kOperators[] = {
        {'~', AttributeTest::Kind::kWord},   {'|', AttributeTest::Kind::kDash},
        {'^', AttributeTest::Kind::kPrefix}, {'$', AttributeTest::Kind::kSuffix},
        {'*', AttributeTest::Kind::kPart},
    };
    kind = AttributeTest::Kind::kEqual;
    for (const auto& [sign, meaning] : kOperators) {
      if (scanner_.take(sign)) {
        kind = meaning;
        break;
      }
    }
    return scanner_.take('=');
  }

  bool parse_pseudo_class(PseudoClass& pseudo, std::vector<PseudoClass>& more,
                          Specificity& specificity) {
    const std::string name = take_identifier(scanner_);
    if (name == "not") return parse_not(pseudo, specificity);
    ++specificity.classes;
    using Kind = PseudoClass::Kind;
    if (name == "root") {
      pseudo.kind = Kind::kRoot;
    } else if (name == "empty") {
      pseudo.kind = Kind::kEmpty;
    } else if (name == "link" || name == "any-link") {
      pseudo.kind = Kind::kLink;
    } else if (name == "lang") {
      pseudo.kind = Kind::kLanguage;
      return parse_languages(pseudo.languages);
    } else if (name.ends_with("-child") || name.ends_with("-of-type")) {
      pseudo.kind = Kind::kPlace;
      return parse_place(name, pseudo, more);
    } else {
      return is_never(name);
    }
    return true;
  }

  // "first", "last", "only", "nth" or "nth-last", then "-child" or "-of-type".
  bool parse_place(std::string_view name, PseudoClass& pseudo, std::vector<PseudoClass>& more) {
    pseudo.of_type = name.ends_with("-of-type");
    name.remove_suffix(std::string_view(pseudo.of_type ? "-of-type" : "-child").size());
    pseudo.from_end = name == "last" || name == "nth-last";
    if (name == "only") {
      more.push_back(pseudo);
      more.back().from_end = true;
    }
    if (name == "nth" || name == "nth-last") return parse_nth(take_argument(scanner_), pseudo);
    return name == "first" || name == "last" || name == "only";
  }

  bool parse_languages(std::vector<std::string>& languages) {
    const std::string text = take_argument(scanner_);
    Scanner argument(text);
    do {
      argument.skip_spaces();
      languages.push_back(take_string_or_identifier(argument));
      argument.skip_spaces();
    } while (argument.take(','));
    return argument.at_end() && !languages.back().empty();
  }

  static bool is_never(std::string_view name) {
    constexpr std::string_view kNames[] = {"visited", "hover", "focus", "active", "target"};
    return std::ranges::find(kNames, name) != std::end(kNames);
  }

  // :not() counts as what is in it.
  bool parse_not(PseudoClass& pseudo, Specificity& specificity) {
    pseudo.kind = PseudoClass::Kind::kNot;
    const std::string argument = take_argument(scanner_);
    SelectorParser inner(argument, nesting_ + 1);
    return nesting_ < kNestingLimit && inner.parse_compound_list(pseudo.arguments, specificity);
  }

  // "odd", "even", "3", "2n+1", "-n + 3".
  static bool parse_nth(std::string_view text, PseudoClass& pseudo) {
    std::string compact;
    for (const char c : text) {
      if (!is_space(c)) compact += to_lower(c);
    }
    if (compact == "odd") compact = "2n+1";
    if (compact == "even") compact = "2n";
    const std::size_t n = compact.find('n');
    if (n == std::string::npos) return parse_integer(compact, pseudo.offset);
    const std::string step = compact.substr(0, n);
    const std::string offset = compact.substr(n + 1);
    if (step.empty() || step == "+" || step == "-") {
      pseudo.step = step == "-" ? -1 : 1;
    } else if (!parse_integer(step, pseudo.step)) {
      return false;
    }
    pseudo.offset = 0;
    return offset.empty() || parse_integer(offset, pseudo.offset);
  }

  static bool parse_integer(std::string_view text, int& value) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() && result.ptr == text.data() + text.size();
  }

  Scanner scanner_;
  int nesting_;
};

}  // namespace

std::optional<std::vector<Selector>> parse_selector_list(std::string_view text) {
  std::vector<Selector> selectors;
  if (!SelectorParser(text).parse_list(selectors)) return std::nullopt;
  return selectors;
}

}  // namespace libstyle::svg
