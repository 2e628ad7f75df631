// SPDX-License-Identifier: Apache-2.0
// The keys of every kind of record, once, for the reader and the writer alike.
//
// kFields<T> lists the keys of T in the order in which they are written. A field is a key, the way
// to its member, and a form: how the value looks as JSON, what range it has and what is meant when
// it is missing. The reader overloads read_value and the writer append_value for each form.
// Internal to libstyle/curves.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

#include "libstyle/curves/document.h"

namespace libstyle::fields {

// ---- Forms: how a value looks, and when it need not be written ----

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct VersionForm {};  // the format's version, in the header
struct TypeForm {};     // the name of the record's type

struct TextForm {};
struct TextListForm {};
struct FlagForm {};

struct NumberForm {
  double initial = 0;
  double low = -kNoLimit;
  double high = kNoLimit;
};

struct OptionalNumberForm {
  double low = -kNoLimit;
  double high = kNoLimit;
};

struct NumberListForm {
  double low = -kNoLimit;
};

// An enumeration or bool by name; the first is the initial one.
template <std::size_t N>
struct WordForm {
  std::array<std::string_view, N> words;
};

struct PathForm {};
struct PointForm {};      // [x, y]
struct TransformForm {};  // [a, b, c, d, e, f]
struct ColorForm {};
struct PaintForm {};
struct AlongForm {};

// One alternative of a variant as an object with the fields of T.
template <typename T>
struct AlternativeForm {};

// A vector as an array of objects with the fields of its elements.
struct ObjectListForm {};

inline bool is_initial(VersionForm, const Header&) { return false; }
inline bool is_initial(FlagForm, bool value) { return !value; }
inline bool is_initial(NumberForm form, double value) { return value == form.initial; }
inline bool is_initial(PathForm, const Path& value) { return value.empty(); }
inline bool is_initial(PointForm, const Point& value) { return value == Point{}; }
inline bool is_initial(PointForm, const std::optional<Point>& value) { return !value; }
inline bool is_initial(OptionalNumberForm, const std::optional<double>& value) { return !value; }
inline bool is_initial(PaintForm, const std::optional<Paint>& value) { return !value; }
inline bool is_initial(ColorForm, Color value) { return value == Color{}; }
inline bool is_initial(TransformForm, const Transform& value) { return value == Transform{}; }
inline bool is_initial(TransformForm, const std::optional<Transform>& value) { return !value; }

template <typename Record>
bool is_initial(TypeForm, const Record&) {
  return false;
}

template <std::size_t N, typename Value>
bool is_initial(const WordForm<N>&, Value value) {
  return value == Value{};
}

template <typename T, typename Variant>
bool is_initial(AlternativeForm<T>, const Variant& value) {
  return !std::holds_alternative<T>(value);
}

// Texts, lists and values along the curve.
template <typename Form, typename Container>
bool is_initial(const Form&, const Container& value) {
  return value.empty();
}

// ---- Fields ----

enum class Presence : std::uint8_t {
  kOptional,       // left out at its initial value
  kAlwaysWritten,  // may be missing when read
  kRequired
};

template <typename Access, typename Form>
struct Field {
  std::string_view key;
  Access access;  // from the object to the member; a pointer to member or a function
  Form form;
  Presence presence = Presence::kOptional;
};

template <typename Access, typename Form>
Field(std::string_view, Access, Form) -> Field<Access, Form>;
template <typename Access, typename Form>
Field(std::string_view, Access, Form, Presence) -> Field<Access, Form>;

// The way from a path record to a member of its style.
template <typename Value>
struct StyleMember {
  Value Style::*member;

  Value& operator()(PathRecord& record) const { return record.style.*member; }
  const Value& operator()(const PathRecord& record) const { return record.style.*member; }
};

template <typename Value>
constexpr StyleMember<Value> in_style(Value Style::*member) {
  return {member};
}

template <typename T>
inline constexpr std::tuple<> kFields{};

inline constexpr NumberForm kOpacity = {1, 0, 1};
inline constexpr WordForm<2> kFillRules = {{"nonzero", "evenodd"}};
inline constexpr WordForm<2> kVisibilities = {{"visible", "hidden"}};

inline constexpr WordForm<16> kBlendModes = {kBlendModeNames};

inline constexpr auto kCommonFields = std::tuple{
    Field{"type", std::identity{}, TypeForm{}, Presence::kAlwaysWritten},
    Field{"id", &RecordBase::id, TextForm{}}, Field{"in", &RecordBase::parent, TextForm{}},
    Field{"class", &RecordBase::classes, TextForm{}},
    Field{"label", &RecordBase::label, TextForm{}}};

template <>
inline constexpr auto kFields<Header> =
    std::tuple{Field{"curves", std::identity{}, VersionForm{}, Presence::kRequired},
               Field{"name", &Header::name, TextForm{}},
               Field{"width", &Header::width, OptionalNumberForm{0}},
               Field{"height", &Header::height, OptionalNumberForm{0}},
               Field{"page-width", &Header::page_width, TextForm{}},
               Field{"page-height", &Header::page_height, TextForm{}},
               Field{"history", &Header::history, TextListForm{}}};

template <>
inline constexpr auto kFields<PathRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{
        Field{"shape", &PathRecord::shape, TextForm{}},
        Field{"clip", &PathRecord::clip, TextForm{}},
        Field{"fill", in_style(&Style::fill), PaintForm{}},
        Field{"fill-opacity", in_style(&Style::fill_opacity), kOpacity},
        Field{"fill-rule", in_style(&Style::fill_rule), kFillRules},
        Field{"stroke", in_style(&Style::stroke), PaintForm{}},
        Field{"stroke-opacity", in_style(&Style::stroke_opacity), kOpacity},
        Field{"stroke-width", in_style(&Style::stroke_width), NumberForm{1, 0}},
        Field{"stroke-linecap", in_style(&Style::line_cap),
              WordForm<3>{{"butt", "round", "square"}}},
        Field{"stroke-linejoin", in_style(&Style::line_join),
              WordForm<3>{{"miter", "round", "bevel"}}},
        Field{"stroke-miterlimit", in_style(&Style::miter_limit), NumberForm{4, 1}},
        Field{"stroke-dasharray", in_style(&Style::dash_array), NumberListForm{0}},
        Field{"stroke-dashoffset", in_style(&Style::dash_offset), NumberForm{0}},
        Field{"stroke-transform", in_style(&Style::stroke_transform), TransformForm{}},
        Field{"paint-order", in_style(&Style::stroke_first), WordForm<2>{{"normal", "stroke"}}},
        Field{"shape-rendering", in_style(&Style::crisp_edges),
              WordForm<2>{{"auto", "crispEdges"}}},
        Field{"opacity", in_style(&Style::opacity), kOpacity},
        Field{"visibility", in_style(&Style::hidden), kVisibilities},
        Field{"d", &PathRecord::path, PathForm{}, Presence::kRequired},
        Field{"along", &PathRecord::along, AlongForm{}}});

template <>
inline constexpr auto kFields<GroupRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{Field{"layer", &GroupRecord::layer, FlagForm{}},
               Field{"opacity", &GroupRecord::opacity, kOpacity},
               Field{"mix-blend-mode", &GroupRecord::blend_mode, kBlendModes},
               Field{"isolation", &GroupRecord::isolated, WordForm<2>{{"auto", "isolate"}}},
               Field{"clip", &GroupRecord::clip, TextForm{}},
               Field{"visibility", &GroupRecord::hidden, kVisibilities}});

template <>
inline constexpr auto kFields<GradientStop> =
    std::tuple{Field{"offset", &GradientStop::offset, NumberForm{0, 0, 1}, Presence::kRequired},
               Field{"stop-color", &GradientStop::color, ColorForm{}, Presence::kRequired},
               Field{"stop-opacity", &GradientStop::opacity, kOpacity}};

// The way from an object to one coordinate of a point in it.
template <typename T>
struct Coordinate {
  Point T::*point;
  double Point::*coordinate;

  double& operator()(T& object) const { return object.*point.*coordinate; }
  const double& operator()(const T& object) const { return object.*point.*coordinate; }
};

template <typename T>
constexpr Coordinate<T> x_of(Point T::*point) {
  return {point, &Point::x};
}

template <typename T>
constexpr Coordinate<T> y_of(Point T::*point) {
  return {point, &Point::y};
}

template <>
inline constexpr auto kFields<LinearGeometry> =
    std::tuple{Field{"x1", x_of(&LinearGeometry::start), NumberForm{}, Presence::kRequired},
               Field{"y1", y_of(&LinearGeometry::start), NumberForm{}, Presence::kRequired},
               Field{"x2", x_of(&LinearGeometry::end), NumberForm{}, Presence::kRequired},
               Field{"y2", y_of(&LinearGeometry::end), NumberForm{}, Presence::kRequired}};

// The focus is at the center unless it says otherwise; see complete() in the reader.
template <>
inline constexpr auto kFields<RadialGeometry> =
    std::tuple{Field{"cx", x_of(&RadialGeometry::center), NumberForm{}, Presence::kRequired},
               Field{"cy", y_of(&RadialGeometry::center), NumberForm{}, Presence::kRequired},
               Field{"r", &RadialGeometry::radius, NumberForm{0, 0}, Presence::kRequired},
               Field{"fx", x_of(&RadialGeometry::focus), NumberForm{}, Presence::kAlwaysWritten},
               Field{"fy", y_of(&RadialGeometry::focus), NumberForm{}, Presence::kAlwaysWritten},
               Field{"fr", &RadialGeometry::focus_radius, NumberForm{0, 0}}};

template <>
inline constexpr auto kFields<GradientRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{Field{"linear", &GradientRecord::geometry, AlternativeForm<LinearGeometry>{}},
               Field{"radial", &GradientRecord::geometry, AlternativeForm<RadialGeometry>{}},
               Field{"transform", &GradientRecord::page_from_gradient, TransformForm{}},
               Field{"spread", &GradientRecord::spread, WordForm<3>{{"pad", "reflect", "repeat"}}},
               Field{"stops", &GradientRecord::stops, ObjectListForm{}, Presence::kRequired}});

template <>
inline constexpr auto kFields<ClipPart> = std::tuple{
    Field{"clip-rule", &ClipPart::rule, kFillRules}, Field{"clip", &ClipPart::clip, TextForm{}},
    Field{"d", &ClipPart::path, PathForm{}, Presence::kRequired}};

template <>
inline constexpr auto kFields<ClipRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{Field{"clip", &ClipRecord::clip, TextForm{}},
               Field{"parts", &ClipRecord::parts, ObjectListForm{}, Presence::kRequired}});

template <>
inline constexpr auto kFields<ElementRecord> = std::tuple_cat(
    kCommonFields, std::tuple{Field{"category", &ElementRecord::category, TextForm{}},
                              Field{"at", &ElementRecord::position, PointForm{}}});

template <>
inline constexpr auto kFields<ConstraintRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{Field{"curve", &ConstraintRecord::curve, TextForm{}, Presence::kRequired},
               Field{"at", &ConstraintRecord::position, PointForm{}, Presence::kRequired},
               Field{"t", &ConstraintRecord::t, OptionalNumberForm{0, 1}},
               Field{"weight", &ConstraintRecord::weight, OptionalNumberForm{0}}});

template <>
inline constexpr auto kFields<AdjustmentRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{Field{"curve", &AdjustmentRecord::curve, TextForm{}, Presence::kRequired},
               Field{"at", &AdjustmentRecord::position, PointForm{}, Presence::kRequired},
               Field{"from", &AdjustmentRecord::moved_from, PointForm{}}});

template <>
inline constexpr auto kFields<LabelRecord> = std::tuple_cat(
    kCommonFields,
    std::tuple{Field{"of", &LabelRecord::of, TextForm{}, Presence::kRequired},
               Field{"style", &LabelRecord::style, TextForm{}, Presence::kRequired},
               Field{"log-likelihood", &LabelRecord::log_likelihood, OptionalNumberForm{}}});

template <>
inline constexpr auto kFields<SeedRecord> = std::tuple_cat(
    kCommonFields, std::tuple{Field{"curve", &SeedRecord::curve, TextForm{}, Presence::kRequired},
                              Field{"at", &SeedRecord::position, PointForm{}, Presence::kRequired},
                              Field{"color", &SeedRecord::color, ColorForm{}, Presence::kRequired},
                              Field{"direction", &SeedRecord::direction, OptionalNumberForm{}}});

// ---- Tables made from the fields ----

template <typename T>
inline constexpr std::size_t kFieldCount = std::tuple_size_v<std::decay_t<decltype(kFields<T>)>>;

template <typename T>
inline constexpr auto kKeys = std::apply(
    [](const auto&... field) {
      return std::array<std::string_view, sizeof...(field)>{field.key...};
    },
    kFields<T>);

// Whether T is one of the kinds of records that have fields.
template <typename T>
inline constexpr bool kIsKnown = kFieldCount<T> > 0;

}  // namespace libstyle::fields
