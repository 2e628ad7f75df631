// SPDX-License-Identifier: Apache-2.0
// Where a document is being drawn: what the parts of the drawing code share.
//
// Cairo's own matrix is the identity throughout: points are brought to the device by us, in double
// and within Cairo's range (see safe_path.h). It is set only while a pen or a gradient needs it.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// Finds the records that others refer to. A reference reaches back only, so it never makes a cycle.
class ReferenceIndex {
 public:
  explicit ReferenceIndex(const Document& document);

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  // The group or element called `id`, standing before record `from`; kNone if there is none.
  std::size_t container(std::string_view id, std::size_t from) const;
  // The clip or gradient called `id`, or null. A clip refers only to clips that stand before it.
  const ClipRecord* clip(std::string_view id, const ClipRecord* from = nullptr) const;
  const GradientRecord* gradient(std::string_view id) const;

 private:
  std::size_t find(std::string_view id) const;

  const Document& document_;
  std::unordered_map<std::string_view, std::size_t>
      places_;  // of groups, elements, clips, gradients
  std::unordered_map<const ClipRecord*, std::size_t> clip_places_;
};

struct Canvas {
  cairo_t* context;
  Transform device_from_page;
  Box window;  // of the device; nothing outside it is seen
  const ReferenceIndex& index;
  const WarningHandler& warn;
  bool is_raster = true;              // whether what is drawn becomes pixels
  std::size_t clip_parts_drawn = 0;   // for one use of a clip, see clip.cpp
  double edge_pairs = 0;              // of all that was drawn, see crowding.h
  std::vector<double> layer_bytes{};  // of the layers that are open, see layer.cpp

  void warn_about(const RecordBase& record, const std::string& message) const {
    if (warn) warn({{"", record.line}, record.id, message});
  }
};

inline cairo_matrix_t to_cairo(const Transform& t) { return {t.a, t.b, t.c, t.d, t.e, t.f}; }

inline Box transformed(const Box& box, const Transform& target_from_source) {
  Box result;
  if (box.empty()) return result;
  for (const double x : {box.low.x, box.high.x}) {
    for (const double y : {box.low.y, box.high.y}) result.include(target_from_source({x, y}));
  }
  return result;
}

}  // namespace libstyle
