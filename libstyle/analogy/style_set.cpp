// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_set.h"

#include <utility>
#include <variant>

#include "libstyle/analogy/fitting_scale.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

// What is drawn in a style.
std::vector<const Path*> paths_in(const Document& document, const StylePlan& plan,
                                  std::size_t style) {
  std::vector<const Path*> result;
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    const auto* record = std::get_if<PathRecord>(&document.records[i]);
    if (record && plan.style_of_record[i] == style) result.push_back(&record->path);
  }
  return result;
}

}  // namespace

StyleSet::StyleSet(std::optional<StyleExample> rest) {
  if (rest) rest_.emplace(Style{std::move(*rest), std::nullopt});
}

void StyleSet::add(RecordSelector part, StyleExample example) {
  parts_.push_back(std::move(part));
  styles_.push_back({std::move(example), std::nullopt});
}

StylePlan StyleSet::plan(const Document& document, const WarningHandler& warn) {
  StylePlan plan;
  for (const std::size_t part : selected_by(document, parts_)) {
    const std::size_t otherwise = rest_ ? parts_.size() : StylePlan::kNone;
    plan.style_of_record.push_back(part == kNotSelected ? otherwise : part);
  }
  const auto prepare = [&](Style& style) {
    const std::vector<const Path*> paths = paths_in(document, plan, plan.styles.size());
    const CurveAnalogy* analogy = paths.empty() ? nullptr : ready(style, paths);
    plan.styles.push_back({analogy, style.example.name, style.example.fits});
    return analogy != nullptr;
  };
  for (Style& style : styles_) {
    if (prepare(style) || !warn) continue;
    Warning warning;
    warning.place.line = document.header.line;
    warning.message =
        style.example.name +
        " draws no line: nothing in this drawing is called so, or other styles have it all";
    warn(warning);
  }
  if (rest_) prepare(*rest_);
  return plan;
}

// The same for all drawings unless its scale depends on them.
const CurveAnalogy* StyleSet::ready(Style& style, std::span<const Path* const> paths) {
  StyleExample& example = style.example;
  return at_place({example.name}, [&] {
    if (example.fits) {
      example.parameters.scale = fitting_scale(paths, example.pairs, example.parameters);
    }
    if (example.fits || !style.analogy) style.analogy.emplace(example.pairs, example.parameters);
    return &*style.analogy;
  });
}

}  // namespace libstyle
