// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/curves/any_document.h"

#include <bit>
#include <cmath>

#include "libstyle/base/random.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

class DocumentMaker {
 public:
  explicit DocumentMaker(std::uint64_t seed) : stream_(seed, 0) {}

  Document make() {
    Document document;
    document.header = header();
    for (std::uint64_t left = below(12); left > 0; --left) document.records.push_back(record());
    return document;
  }

 private:
  std::uint64_t below(std::uint64_t count) { return stream_.below(next_++, count); }
  bool sometimes() { return below(3) == 0; }
  double fraction() { return stream_.uniform(next_++); }

  // Short decimals mostly, but any double now and then.
  double number() {
    if (!sometimes()) return static_cast<double>(static_cast<int>(below(20001)) - 10000) / 100;
    for (;;) {
      const double value = std::bit_cast<double>(stream_.bits(next_++));
      if (std::isfinite(value)) return value;
    }
  }
  double positive() { return std::abs(number()); }
  Point point() {
    const double x = number();
    return {x, number()};
  }

  std::string text() {
    static const std::string kPieces[] = {
        "a",    "Z",     "0", " ",  "\"",   "\\", "/", "\n", "\t", std::string(1, '\0'),
        "\x01", "\x7f",  "é", "線", "🖋", "{",  "}", "[",  ",",  ":",
        "~",    "\u2028"};
    std::string result;
    for (std::uint64_t left = below(8); left > 0; --left) result += kPieces[below(22)];
    return result;
  }
  std::string json() {
    static const char* const kValues[] = {"null",
                                          "true",
                                          "-1.50e3",
                                          "12345678901234567",
                                          "\"\\u00e9\\n\"",
                                          "[]",
                                          "{}",
                                          "[1,[2,{\"a\":null}]]",
                                          "{\"b\":[\"x y\",2],\"b\":3}"};
    return kValues[below(9)];
  }
  std::vector<Extra> extras() {
    std::vector<Extra> result;
    // Spelt so that no text can be a key of a record.
    while (sometimes()) result.push_back({"data-" + text(), json()});
    return result;
  }
  Color color() {
    return {static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256)),
            static_cast<std::uint8_t>(below(256))};
  }
  std::optional<Paint> paint() {
    switch (below(4)) {
      case 0:
        return NoPaint{};
      case 1:
        return color();
      case 2:
        return PaintReference{"g" + text()};
      default:
        return std::nullopt;
    }
  }
  std::optional<double> maybe(double value) {
    return sometimes() ? std::optional(value) : std::nullopt;
  }
  Transform transform() { return {number(), number(), number(), number(), number(), number()}; }

  Path path() {
    Path result;
    bool open = false;
    for (std::uint64_t left = below(10); left > 0; --left) {
      const std::uint64_t command = open ? below(4) : 0;
      if (command == 0) result.move_to(point());
      if (command == 1) result.line_to(point());
      if (command == 2) {
        const Point first = point(), second = point();
        result.cubic_to(first, second, point());
      }
      if (command == 3) result.close();
      open = command != 3;
    }
    return result;
  }

  Style style() {
    Style result;
    result.fill = paint();
    if (sometimes()) result.fill_opacity = fraction();
    if (sometimes()) result.fill_rule = FillRule::kEvenOdd;
    result.stroke = paint();
    if (sometimes()) result.stroke_opacity = fraction();
    if (sometimes()) result.stroke_width = positive();
    result.line_cap = static_cast<LineCap>(below(3));
    result.line_join = static_cast<LineJoin>(below(3));
    if (sometimes()) result.miter_limit = 1 + fraction();
    while (sometimes()) result.dash_array.push_back(positive());
    if (sometimes()) result.dash_offset = number();
    if (sometimes()) result.stroke_transform = transform();
    result.stroke_first = sometimes();
    result.crisp_edges = sometimes();
    if (sometimes()) result.opacity = fraction();
    result.hidden = sometimes();
    return result;
  }

  AlongValues along(std::size_t vertices) {
    AlongValues result;
    if (vertices == 0 || !sometimes()) return result;
    for (const char* name : {"width", "pressure", "t", "tilt \"x\""}) {
      if (sometimes()) continue;
      Channel channel{name, {}};
      for (std::size_t i = 0; i < vertices; ++i) channel.values.push_back(fraction());
      result.channels.push_back(std::move(channel));
    }
    if (sometimes()) {
      for (std::size_t i = 0; i < vertices; ++i) {
        result.colors.push_back(color());
        result.colors.back().alpha = static_cast<std::uint8_t>(below(256));
      }
    }
    if (sometimes()) result.extras.push_back({"note", "{\"by\":[\"hand\"]}"});
    return result;
  }

  template <typename R>
  R base() {
    R record;
    if (!sometimes()) record.id = "p" + std::to_string(next_) + text();
    record.parent = text();
    record.classes = text();
    record.label = text();
    record.extras = extras();
    return record;
  }

  PathRecord path_record() {
    auto record = base<PathRecord>();
    record.path = path();
    record.shape = sometimes() ? "rect" : "";
    record.clip = text();
    record.style = style();
    record.along = along(record.path.vertex_count());
    return record;
  }

  GroupRecord group() {
    auto record = base<GroupRecord>();
    record.layer = sometimes();
    if (sometimes()) record.opacity = fraction();
    record.blend_mode = static_cast<BlendMode>(below(kBlendModeNames.size()));
    record.isolated = sometimes();
    record.clip = text();
    record.hidden = sometimes();
    return record;
  }

  GradientRecord gradient() {
    auto record = base<GradientRecord>();
    if (sometimes()) {
      record.geometry = LinearGeometry{point(), point(), extras()};
    } else {
      record.geometry = RadialGeometry{point(), point(), positive(), positive(), extras()};
    }
    if (sometimes()) record.page_from_gradient = transform();
    record.spread = static_cast<Spread>(below(3));
    double offset = 0;
    while (!sometimes()) {
      record.stops.push_back({offset, color(), fraction(), extras()});
      offset += (1 - offset) * fraction();
    }
    return record;
  }

  ClipRecord clip() {
    auto record = base<ClipRecord>();
    record.clip = text();
    while (!sometimes()) {
      record.parts.push_back(
          {path(), sometimes() ? FillRule::kEvenOdd : FillRule::kNonZero, text(), extras()});
    }
    return record;
  }

  ElementRecord element() {
    auto record = base<ElementRecord>();
    record.category = text();
    if (sometimes()) record.position = point();
    return record;
  }

  ConstraintRecord constraint() {
    auto record = base<ConstraintRecord>();
    record.curve = text();
    record.position = point();
    record.t = maybe(fraction());
    record.weight = maybe(positive());
    return record;
  }

  AdjustmentRecord adjustment() {
    auto record = base<AdjustmentRecord>();
    record.curve = text();
    record.position = point();
    if (sometimes()) record.moved_from = point();
    return record;
  }

  LabelRecord label() {
    auto record = base<LabelRecord>();
    record.of = text();
    record.style = text();
    record.log_likelihood = maybe(number());
    return record;
  }

  SeedRecord seed() {
    auto record = base<SeedRecord>();
    record.curve = text();
    record.position = point();
    record.color = color();
    record.direction = maybe(number());
    return record;
  }

  Record record() {
    switch (below(10)) {
      case 0:
        return group();
      case 1:
        return gradient();
      case 2:
        return clip();
      case 3:
        return element();
      case 4:
        return constraint();
      case 5:
        return adjustment();
      case 6:
        return label();
      case 7:
        return seed();
      case 8:
        return UnknownRecord{"{\"type\":\"star\", \"points\" : " + json() + "}"};
      default:
        return path_record();
    }
  }

  Header header() {
    Header result;
    result.name = text();
    result.width = maybe(positive());
    result.height = maybe(positive());
    result.page_width = sometimes() ? "210mm" : "";
    result.page_height = sometimes() ? "297mm" : "";
    while (sometimes()) result.history.push_back(text());
    result.extras = extras();
    return result;
  }

  RandomStream stream_;
  std::uint64_t next_ = 0;
};

}  // namespace

Document any_document(std::uint64_t seed) { return DocumentMaker(seed).make(); }

std::string to_stream(const std::vector<Document>& documents) {
  TextSink sink;
  for (const Document& document : documents) write_document(sink, document);
  return sink.text;
}

}  // namespace libstyle
