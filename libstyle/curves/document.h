// SPDX-License-Identifier: Apache-2.0
// One document of the curves format, version 1, in memory. man/curves.5 is the specification; every
// struct here is one kind of record, every member one key.
//
// A document is a header and its records in paint order. Records refer to each other by id: an id
// is there once, and the record it names comes before those that refer to it; a reference to
// nothing has no effect. Nothing is lost on the way through a program: keys a record does not know
// are kept as JSON text in `extras`, records of unknown type as UnknownRecord.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libstyle/curves/style.h"
#include "libstyle/geometry/path.h"

namespace libstyle {

// A key and its value as JSON text, kept for the next program.
struct Extra {
  std::string key;   // without quotes, unescaped
  std::string json;  // compact JSON text

  friend bool operator==(const Extra&, const Extra&) = default;
};

// What all records share.
struct RecordBase {
  std::string id;       // "id"; may be empty except where something refers to it. See given_id
  std::string parent;   // "in": id of the group or element this belongs to; empty: the document
  std::string classes;  // "class": names separated by spaces
  std::string label;    // "label": a name for people (inkscape:label)
  std::vector<Extra> extras;  // everything else, data-* attributes too
  std::size_t line = 0;       // where it was read, 0 when made here; for messages, never written

  // Records are equal when they are written the same; where they were read does not count.
  friend bool operator==(const RecordBase& a, const RecordBase& b) {
    return a.id == b.id && a.parent == b.parent && a.classes == b.classes && a.label == b.label &&
           a.extras == b.extras;
  }
};

// Ids made by a program consist of, or end in, "~" and more: a character that no XML id can hold.
// Writers of other formats cut it off with what follows.
inline std::string_view given_id(std::string_view id) { return id.substr(0, id.find('~')); }

// One number for each vertex of the path.
struct Channel {
  std::string name;  // "width" (px), "pressure" (0 .. 1), "t", or any other
  std::vector<double> values;

  friend bool operator==(const Channel&, const Channel&) = default;
};

// "along": arrays parallel to the vertices of "d".
struct AlongValues {
  std::vector<Channel> channels;  // every member that is an array of numbers
  std::vector<Color> colors;      // "color"; empty or one for each vertex
  std::vector<Extra> extras;      // members that are anything else

  friend bool operator==(const AlongValues&, const AlongValues&) = default;

  bool empty() const { return channels.empty() && colors.empty() && extras.empty(); }
  // The values of a channel, or null.
  const std::vector<double>* find(std::string_view name) const;
};

struct PathRecord : RecordBase {
  static constexpr std::string_view kType = "path";

  Path path;          // "d"
  std::string shape;  // "shape": what it was drawn as: rect, circle, ...; empty: path
  std::string clip;   // "clip": id of a clip record
  Style style;        // keys named as in SVG
  AlongValues along;

  friend bool operator==(const PathRecord&, const PathRecord&) = default;
};

// Draws its members, the records that name it in "in", as one picture. Members follow the group and
// stand together.
struct GroupRecord : RecordBase {
  static constexpr std::string_view kType = "group";

  bool layer = false;  // shown as a layer by drawing programs
  double opacity = 1;  // 0 .. 1
  BlendMode blend_mode = BlendMode::kNormal;
  bool isolated = false;  // members blend with each other alone; implied by opacity and blend mode
  std::string clip;       // id of a clip record
  bool hidden = false;

  friend bool operator==(const GroupRecord&, const GroupRecord&) = default;
};

struct GradientStop {
  double offset = 0;  // 0 .. 1, not decreasing
  Color color;
  double opacity = 1;
  std::vector<Extra> extras = {};

  friend bool operator==(const GradientStop&, const GradientStop&) = default;
};

enum class Spread : std::uint8_t { kPad, kReflect, kRepeat };

// Members of "linear".
struct LinearGeometry {
  Point start, end;  // "x1" "y1" "x2" "y2"
  std::vector<Extra> extras = {};

  friend bool operator==(const LinearGeometry&, const LinearGeometry&) = default;
};

// Members of "radial".
struct RadialGeometry {
  Point center, focus;      // "cx" "cy" "fx" "fy"
  double radius = 0;        // "r"
  double focus_radius = 0;  // "fr"
  std::vector<Extra> extras = {};

  friend bool operator==(const RadialGeometry&, const RadialGeometry&) = default;
};

// Geometry is in gradient space; page_from_gradient brings it to the page. (Bounding boxes and
// inheritance between gradients are resolved by whoever writes the record.)
struct GradientRecord : RecordBase {
  static constexpr std::string_view kType = "gradient";

  std::variant<LinearGeometry, RadialGeometry> geometry;  // "linear" or "radial"
  Transform page_from_gradient;                           // "transform"
  Spread spread = Spread::kPad;
  std::vector<GradientStop> stops;

  friend bool operator==(const GradientRecord&, const GradientRecord&) = default;
};

// What one path lets through: its inside by `rule`, itself clipped by `clip`.
struct ClipPart {
  Path path;  // "d"
  FillRule rule = FillRule::kNonZero;
  std::string clip;  // id of another clip record; empty: none
  std::vector<Extra> extras = {};

  friend bool operator==(const ClipPart&, const ClipPart&) = default;
};

// Lets through the union of its parts, within another clip if `clip` names one.
struct ClipRecord : RecordBase {
  static constexpr std::string_view kType = "clip";

  std::vector<ClipPart> parts;
  std::string clip;

  friend bool operator==(const ClipRecord&, const ClipRecord&) = default;
};

// A group that stands for one thing in an arrangement.
struct ElementRecord : RecordBase {
  static constexpr std::string_view kType = "element";

  std::string category;           // empty: not decided
  std::optional<Point> position;  // "at": [x, y]

  friend bool operator==(const ElementRecord&, const ElementRecord&) = default;
};

// A place that a curve must pass ("hard") or is drawn towards.
struct ConstraintRecord : RecordBase {
  static constexpr std::string_view kType = "constraint";

  std::string curve;             // id of the path
  Point position;                // "at": [x, y]
  std::optional<double> t;       // where on the curve, as a fraction of its length, 0 .. 1
  std::optional<double> weight;  // >= 0, 1/px^2; unset: hard

  friend bool operator==(const ConstraintRecord&, const ConstraintRecord&) = default;
};

// A point of an earlier result that the next must pass through.
struct AdjustmentRecord : RecordBase {
  static constexpr std::string_view kType = "adjustment";

  std::string curve;
  Point position;
  std::optional<Point> moved_from;  // "from": [x, y], where the point was in the earlier result

  friend bool operator==(const AdjustmentRecord&, const AdjustmentRecord&) = default;
};

// What a thing is in its scene.
struct LabelRecord : RecordBase {
  static constexpr std::string_view kType = "label";

  std::string of;     // id of a path, group or element
  std::string style;  // the name of what it is
  std::optional<double> log_likelihood;

  friend bool operator==(const LabelRecord&, const LabelRecord&) = default;
};

// A place from which a closed curve is filled.
struct SeedRecord : RecordBase {
  static constexpr std::string_view kType = "seed";

  std::string curve;
  Point position;
  Color color;
  std::optional<double> direction;  // radians, clockwise from +x

  friend bool operator==(const SeedRecord&, const SeedRecord&) = default;
};

// A record of a type that this version does not know, kept whole.
struct UnknownRecord {
  std::string json;  // the line, without its end
  std::size_t line = 0;

  friend bool operator==(const UnknownRecord& a, const UnknownRecord& b) {
    return a.json == b.json;
  }
};

using Record =
    std::variant<PathRecord, GroupRecord, GradientRecord, ClipRecord, ElementRecord,
                 ConstraintRecord, AdjustmentRecord, LabelRecord, SeedRecord, UnknownRecord>;

// What records of known type share; null for one of unknown type.
const RecordBase* base_of(const Record& record);

// In paint order. Records stay where they are while others are added: they are large, so moving
// them to make room would cost a third of the time of reading small paths.
using Records = std::deque<Record>;

struct Header {
  std::string name;              // file stem of the first input; names outputs
  std::optional<double> width;   // px; unset: as large as what is drawn
  std::optional<double> height;  // px
  std::string page_width;        // the original unit, such as "210mm"; empty: px
  std::string page_height;
  std::vector<std::string> history;  // the commands that made this, oldest first
  std::vector<Extra> extras;
  std::size_t line = 0;

  friend bool operator==(const Header& a, const Header& b) {
    return a.name == b.name && a.width == b.width && a.height == b.height &&
           a.page_width == b.page_width && a.page_height == b.page_height &&
           a.history == b.history && a.extras == b.extras;
  }
};

struct Document {
  Header header;
  Records records;

  friend bool operator==(const Document&, const Document&) = default;
};

// The box of everything drawn, strokes not counted.
Box control_box(const Document& document);

}  // namespace libstyle
