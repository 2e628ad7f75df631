// SPDX-License-Identifier: Apache-2.0
// A cursor over the text of an attribute: what the small grammars of SVG have in common. Every
// take_ function removes what it reads from the front, or leaves the text alone and says no.
#pragma once

#include <string_view>
#include <vector>

namespace libstyle::svg {

constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr char to_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

// `text` without white space at both ends.
std::string_view trimmed(std::string_view text);

// Whether two texts are equal but for the case of ASCII letters.
bool equal_ignoring_case(std::string_view a, std::string_view b);

class Scanner {
 public:
  explicit Scanner(std::string_view text)
      : begin_(text.data()), next_(begin_), end_(begin_ + text.size()) {}

  bool at_end() const { return next_ == end_; }
  // The next character, or 0 at the end.
  char peek() const { return at_end() ? '\0' : *next_; }
  // How many characters have been taken.
  std::size_t position() const { return static_cast<std::size_t>(next_ - begin_); }
  void advance() { ++next_; }

  void skip_spaces() {
    while (next_ != end_ && is_space(*next_)) ++next_;
  }
  // White space with at most one comma in it. Returns whether the comma was there.
  bool skip_separator();

  bool take(char c);
  // A number as SVG and CSS write it: "+1", ".5", "5.", "-3e2". It ends where the next one can
  // begin
  // ("1.5.5" is two), and an "e" without digits after it is left ("1em"). A number too large for a
  // double is not taken; one too small is 0.
  bool take_number(double& value);
  // As above, as CSS has it: a point needs a digit after it, or the number ends before it.
  bool take_css_number(double& value);
  // ASCII letters, digits, '-' and '_' that do not begin with a digit; may be empty.
  std::string_view take_word();

 private:
  const char* begin_;
  const char* next_;
  const char* end_;
};

// Numbers separated by white space and single commas. Reads until the text does not go on like
// that; `complete` tells whether that was the end.
struct NumberList {
  std::vector<double> numbers;
  bool complete = false;
};
NumberList parse_number_list(std::string_view text);

}  // namespace libstyle::svg
