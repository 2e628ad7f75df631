// SPDX-License-Identifier: Apache-2.0
// What SVG has no place for, as text that stands in the SVG and is read back from it.
//
// An element carries the keys of its record that SVG does not know in the attribute "curves:keys":
// a record line with everything taken out that the element says itself. Records that draw nothing
// (constraints, labels, seeds, what is unknown) stand in <metadata> as record lines. Drawing
// programs keep both; people can read and change both.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libstyle/curves/document.h"

namespace libstyle::svg {

// The namespace of what we add to SVG, and the names in it.
inline constexpr std::string_view kCurvesNamespace = "urn:libstyle:curves";
inline constexpr const char* kCarriedKeys = "curves:keys";
inline constexpr const char* kCarriedId = "curves:id";
inline constexpr const char* kCarriedGeometry = "curves:geometry";  // of a gradient
// On a clipPath whose parts are to be united, and clips on it and on them to be heeded: what SVG
// says and librsvg does not do, so that drawings are not read so otherwise.
inline constexpr const char* kCarriedParts = "curves:parts";
inline constexpr std::string_view kUnited = "united";
inline constexpr const char* kCarriedRecords = "curves:records";
// The viewBox of a page without a size: as long as it stands there, the page has none.
inline constexpr const char* kCarriedBox = "curves:box";
// Path data and a transform on the page (pen_space.h).
inline constexpr const char* kCarriedPath = "curves:d";
inline constexpr const char* kCarriedTransform = "curves:transform";
// "path": a group that is there only to clip the path within.
inline constexpr const char* kCarriedFor = "curves:for";

// The id of a record that has another one in XML, or none; empty when there is nothing to carry.
// What a program called "~1" and nothing refers to needs no name.
std::string_view carried_id(std::string_view record_id, std::string_view xml_id);

// Whether a carried id still belongs to the XML id beside it. When somebody gave the element a new
// one, that counts.
bool fits_carried_id(std::string_view carried, std::string_view xml_id);

// Whether a key becomes an attribute of its own: "data-" and a name, with a text as value.
bool is_data_attribute(const Extra& extra);

// The attribute's value; empty when there is nothing to carry. `keep_shape` is for paths that are
// not written as the shape they were.
std::string carried_keys(const PathRecord& path, bool keep_shape);
std::string carried_keys(const GroupRecord& group);
std::string carried_keys(const ElementRecord& element);
std::string carried_keys(const GradientRecord& gradient);
std::string carried_keys(const ClipRecord& clip);

// Puts the keys that an attribute carries into a record: shape, values along the curve and unknown
// keys. Returns false, leaving the path alone, when the text is no record line or does not fit to
// the path, whose vertices may have been edited since.
bool restore_carried_keys(std::string_view carried, PathRecord& path);

// As above for a group; it becomes the element that it was, if it was one.
std::optional<Record> restore_carried_keys(std::string_view carried, const GroupRecord& group);

// As above for gradients and clips: their unknown keys.
bool restore_carried_keys(std::string_view carried, GradientRecord& gradient);
bool restore_carried_keys(std::string_view carried, ClipRecord& clip);

// The unknown keys of an object within a record, as the text of an attribute of the element that is
// written for it; empty when there are none.
std::string carried_extras(const std::vector<Extra>& extras);

// Puts them back. Returns false, leaving the object alone, when the text is not that.
bool restore_carried_extras(std::string_view carried, GradientStop& stop);
bool restore_carried_extras(std::string_view carried, LinearGeometry& linear);
bool restore_carried_extras(std::string_view carried, RadialGeometry& radial);
bool restore_carried_extras(std::string_view carried, ClipPart& part);

// Reads the lines of <metadata>: a header and records. Nothing when they are not that.
std::optional<Document> restore_carried_records(std::string_view carried);

}  // namespace libstyle::svg
