// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/text_outlines.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "converters/svg/encoding.h"
#include "converters/svg/librsvg.h"
#include "converters/svg/svg_reader.h"
#include "converters/svg/xml_text.h"
#include "libstyle/base/number.h"

namespace libstyle::svg {
namespace {

// Most fonts have 1000 or 2048 units to the em, and FreeType keeps 1/64 px.
constexpr double kFontSize = 256;
// Beyond 2^21 px the fixed-point numbers of Pango end, beyond 2^23 those of Cairo.
constexpr double kLargestHalfPage = 1 << 21;
// How many lengths like that of the text itself are left free around it, because how wide a font
// is, is not known before.
constexpr double kMargin = 4;
// What coordinates are rounded to, in shares of the font size, for short numbers in the result.
constexpr double kPrecision = 1e-5;

// --- The space that text is drawn in ------------------------------------------------------------

// A square page with the beginning of the text in its middle.
struct TextSpace {
  Point origin;  // of the text, in its user space
  double scale = 1;
  double half_page = 0;
  double steps = 1;  // in a px of user space, a power of ten

  Point user_from_page(Point p) const {
    return {rounded((p.x - half_page) / scale + origin.x),
            rounded((p.y - half_page) / scale + origin.y)};
  }
  double rounded(double value) const { return std::round(value * steps) / steps; }
};

// In px, of a length that knows no percentages.
double to_px(Length length, const ComputedStyle& style) {
  return resolve(length, LengthAxis::kHorizontal, {0, 0, style.font_size});
}

// Baseline shifts that are lengths; words and percentages are for librsvg.
std::optional<Length> baseline_shift(const ComputedStyle& style) {
  const std::optional<Length> length = parse_length(style.baseline_shift);
  return length && length->unit != LengthUnit::kPercent ? length : std::nullopt;
}

// Where the text begins, as far as it says so.
Point origin_of(const TextContent& text) {
  const auto x = std::ranges::find_if(text.parts, [](const auto& part) { return !part.x.empty(); });
  const auto y = std::ranges::find_if(text.parts, [](const auto& part) { return !part.y.empty(); });
  const auto end = text.parts.end();
  return {x == end ? 0 : x->x.front(), y == end ? 0 : y->y.front()};
}

double largest_font_size(const TextContent& text) {
  double size = 0;
  for (const TextPart& part : text.parts) size = std::max(size, part.style.font_size);
  return size;
}

// How far from its beginning a text may get.
double reach_of(const TextContent& text, Point origin, double font_size) {
  double farthest = 0, shifts = 0, advance = font_size;
  for (const TextPart& part : text.parts) {
    for (const double x : part.x) farthest = std::max(farthest, std::abs(x - origin.x));
    for (const double y : part.y) farthest = std::max(farthest, std::abs(y - origin.y));
    for (const double dx : part.dx) shifts += std::abs(dx);
    for (const double dy : part.dy) shifts += std::abs(dy);
    shifts += std::abs(to_px(baseline_shift(part.style).value_or(Length{}), part.style));
    advance = std::max(advance, font_size + std::abs(to_px(part.style.letter_spacing, part.style)));
  }
  return farthest + shifts + static_cast<double>(text.characters) * advance;
}

// As large as the precision of fonts asks for, and the page allows.
TextSpace choose_space(const TextContent& text, double font_size) {
  TextSpace space;
  space.origin = origin_of(text);
  const double reach = kMargin * reach_of(text, space.origin, font_size);
  space.scale = std::min(kFontSize / font_size, kLargestHalfPage / reach);
  space.half_page = std::ceil(reach * space.scale);
  space.steps = std::pow(10, std::ceil(-std::log10(kPrecision * font_size)));
  if (!(std::isfinite(space.half_page) && std::isfinite(space.steps) && space.steps > 0)) {
    throw Error("it is too large or too small");
  }
  return space;
}

// --- The drawing that librsvg gets --------------------------------------------------------------

Color color_of(std::size_t part) {
  return {static_cast<std::uint8_t>(part >> 16), static_cast<std::uint8_t>(part >> 8),
          static_cast<std::uint8_t>(part)};
}

std::size_t part_of(Color color) {
  return std::size_t{color.red} << 16 | std::size_t{color.green} << 8 | color.blue;
}

// Whether white space at the ends of a text goes away.
struct Trimming {
  bool begin = false;
  bool end = false;
};

// White space as SVG 1.1, section 10.15, has it.
std::string settled_space(std::string_view text, bool preserve, Trimming trimming) {
  std::string settled;
  for (const char c : text) {
    const bool line_end = c == '\n' || c == '\r';
    const char settled_c = line_end || c == '\t' ? ' ' : c;
    const bool repeated = settled_c == ' ' && settled.ends_with(' ');
    if (preserve || !(line_end || repeated)) settled += settled_c;
  }
  if (preserve) return settled;
  if (trimming.begin && settled.starts_with(' ')) settled.erase(0, 1);
  if (trimming.end && settled.ends_with(' ')) settled.pop_back();
  return settled;
}

// The bytes of the first character of UTF-8.
std::size_t character_size(std::string_view text) {
  std::size_t size = 1;
  while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) ++size;
  return size;
}

class TextWriter {
 public:
  TextWriter(const TextContent& text, const TextSpace& space) : text_(text), space_(space) {}

  std::string write() {
    out_ = R"(<svg xmlns="http://www.w3.org/2000/svg" overflow="visible")";
    attribute("width", 2 * space_.half_page);
    attribute("height", 2 * space_.half_page);
    out_ += "><g";
    attribute("transform",
              "translate(" + number(space_.half_page) + ' ' + number(space_.half_page) + ')');
    // Nothing is to depend on the language that the user has set.
    attribute("xml:lang", "en");
    out_ += '>';
    write_part(0, "text", ComputedStyle{});
    out_ += "</g></svg>";
    return std::move(out_);
  }

 private:
  void write_part(std::size_t index, std::string_view name, const ComputedStyle& parent) {
    const TextPart& part = text_.parts[index];
    begin(name, index);
    if (part.placed() == 1) write_place(part, 0);
    write_style(part.style, parent);
    out_ += '>';
    std::size_t count = 0;  // of characters of its own
    write_characters(index, part.borrowed, {true, true}, count);
    std::size_t next = index + 1;
    for (const pugi::xml_node child : part.element.children()) {
      if (next < part.end && text_.parts[next].element == child) {
        write_part(next, "tspan", part.style);
        next = text_.parts[next].end;
      } else if (is_characters(child) && part.borrowed.empty()) {
        write_characters(index, child.value(), {!child.previous_sibling(), !child.next_sibling()},
                         count);
      }
    }
    out_.append("</").append(name).append(">");
  }

  // Characters with places of their own become elements of their own; librsvg knows one place for
  // an element. `count` is that of the characters before.
  void write_characters(std::size_t index, std::string_view characters, Trimming trimming,
                        std::size_t& count) {
    const TextPart& part = text_.parts[index];
    if (part.placed() <= 1) return append_escaped(out_, repaired_utf8(characters), 0);
    const std::string text =
        settled_space(repaired_utf8(characters), part.style.white_space == "preserve", trimming);
    for (std::string_view rest = text; !rest.empty(); ++count) {
      const std::size_t size = count < part.placed() ? character_size(rest) : rest.size();
      begin("tspan", index);
      attribute("xml:space", "preserve");
      word("text-decoration", part.style.text_decoration, "", "");
      write_place(part, count);
      out_ += '>';
      append_escaped(out_, rest.substr(0, size), 0);
      out_ += "</tspan>";
      rest.remove_prefix(size);
    }
  }

  void begin(std::string_view name, std::size_t part) {
    out_.append("<").append(name);
    attribute("fill", to_text(color_of(part)));
  }

  void write_place(const TextPart& part, std::size_t character) {
    write_length("x", part.x, character, space_.origin.x);
    write_length("y", part.y, character, space_.origin.y);
    write_length("dx", part.dx, character, 0);
    write_length("dy", part.dy, character, 0);
  }

  void write_length(std::string_view name, const std::vector<double>& lengths,
                    std::size_t character, double origin) {
    if (character >= lengths.size()) return;
    attribute(name, (lengths[character] - origin) * space_.scale);
  }

  void write_style(const ComputedStyle& style, const ComputedStyle& parent) {
    word("font-family", style.font_family, parent.font_family, "sans-serif");
    word("font-style", style.font_style, parent.font_style, "normal");
    word("font-variant", style.font_variant, parent.font_variant, "normal");
    word("font-stretch", style.font_stretch, parent.font_stretch, "normal");
    word("text-anchor", style.text_anchor, parent.text_anchor, "start");
    word("direction", style.direction, parent.direction, "ltr");
    word("writing-mode", style.writing_mode, parent.writing_mode, "lr-tb");
    word("text-orientation", style.text_orientation, parent.text_orientation, "mixed");
    word("xml:lang", style.language, parent.language, "en");
    word("xml:space", style.white_space, parent.white_space, "default");
    word("text-decoration", style.text_decoration, "", "");
    word("unicode-bidi", style.unicode_bidi, "", "");
    attribute("font-weight", std::to_string(style.font_weight));
    attribute("font-size", style.font_size * space_.scale);
    attribute("letter-spacing", to_px(style.letter_spacing, style) * space_.scale);
    write_baseline_shift(style);
  }

  void write_baseline_shift(const ComputedStyle& style) {
    if (const std::optional<Length> length = baseline_shift(style)) {
      attribute("baseline-shift", to_px(*length, style) * space_.scale);
    } else {
      word("baseline-shift", style.baseline_shift, "", "");
    }
  }

  // A property whose value is a word, where it is not that of the parent.
  void word(std::string_view name, std::string_view value, std::string_view parent,
            std::string_view initial) {
    if (value != parent) attribute(name, value.empty() ? initial : value);
  }

  void attribute(std::string_view name, std::string_view value) {
    out_.append(" ").append(name).append("=\"");
    append_escaped(out_, repaired_utf8(value), '"');
    out_ += '"';
  }
  void attribute(std::string_view name, double value) { attribute(name, number(value)); }

  static std::string number(double value) {
    std::string text;
    append_number(text, value);
    return text;
  }

  const TextContent& text_;
  const TextSpace& space_;
  std::string out_;
};

// --- The paths that come back -------------------------------------------------------------------

// Leaves out subpaths that are a point: Pango ends every line with one.
Path to_user_space(const Path& path, const TextSpace& space) {
  Path result;
  std::optional<Point> start;  // of a subpath that nothing has been drawn of
  const Point* next = path.points().data();
  const auto take = [&] { return space.user_from_page(*next++); };
  for (const PathCommand command : path.commands()) {
    if (command == PathCommand::kMove) {
      start = take();
      continue;
    }
    if (command == PathCommand::kClose) {
      if (!start) result.close();
      continue;
    }
    if (start) result.move_to(*start);
    start.reset();
    if (command == PathCommand::kLine) {
      result.line_to(take());
    } else {
      const Point control1 = take(), control2 = take();
      result.cubic_to(control1, control2, take());
    }
  }
  return result;
}

}  // namespace

std::vector<TextRun> outline_text(const TextContent& text) {
  const double font_size = largest_font_size(text);
  if (font_size == 0 || text.characters == 0) return {};
  const TextSpace space = choose_space(text, font_size);
  std::string drawn = redraw_by_librsvg(TextWriter(text, space).write(), 2 * space.half_page);
  const Document outlines = read_svg(std::move(drawn), "outlines of text", {}, [](const auto&) {});
  std::vector<TextRun> runs;
  for (const Record& record : outlines.records) {
    const auto* const path = std::get_if<PathRecord>(&record);
    if (path == nullptr || !path->style.fill) continue;
    const auto* const color = std::get_if<Color>(&*path->style.fill);
    if (color == nullptr || part_of(*color) >= text.parts.size()) continue;
    const Path outline = to_user_space(path->path, space);
    if (outline.empty()) continue;
    if (runs.empty() || runs.back().part != part_of(*color)) runs.push_back({part_of(*color), {}});
    runs.back().path.append(outline);
  }
  return runs;
}

}  // namespace libstyle::svg
