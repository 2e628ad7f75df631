// SPDX-License-Identifier: Apache-2.0
// Several styles for one drawing, each for a part of it: grass for the meadow, waves for the sea.
//
// Where the parts of two styles overlap, the one that names what is innermost has the path, and of
// two that name the same the one that was added last.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/drawing.h"
#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"
#include "libstyle/curves/selection.h"

namespace libstyle {

// A style as it is asked for.
struct StyleExample {
  std::string name = "the style";  // in messages
  std::vector<ExamplePair> pairs;
  CurveAnalogyParameters parameters;
  bool fits = false;  // parameters.scale is found for each drawing instead: fitting_scale
};

class StyleSet {
 public:
  // `rest` is for what no other style is for; without it that stays as it is.
  explicit StyleSet(std::optional<StyleExample> rest);

  void add(RecordSelector part, StyleExample example);

  // The plan for a drawing, valid until the next. Warns of styles that no line of it is drawn in.
  // Throws Error when an example cannot serve.
  StylePlan plan(const Document& document, const WarningHandler& warn);

 private:
  struct Style {
    StyleExample example;
    std::optional<CurveAnalogy> analogy;
  };

  static const CurveAnalogy* ready(Style& style, std::span<const Path* const> paths);

  std::vector<RecordSelector> parts_;
  std::vector<Style> styles_;  // of the parts
  std::optional<Style> rest_;
};

}  // namespace libstyle
