// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/stroke_records.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <variant>

namespace libstyle {
namespace {

bool is_painted(const std::optional<Paint>& paint) {
  return paint && !std::holds_alternative<NoPaint>(*paint);
}

void name_lines(const Document& document, std::span<StyledPath> paths) {
  std::unordered_set<std::string_view> taken;
  for (const Record& record : document.records) {
    if (const RecordBase* base = base_of(record)) taken.insert(base->id);
  }
  for (StyledPath& path : paths) {
    if (!path.line || path.line->id.empty()) continue;
    const std::string area = path.line->id + '~';
    int number = 2;
    while (taken.contains(area + std::to_string(number))) ++number;
    path.line->id = area + std::to_string(number);
  }
}

}  // namespace

void part_area_from_line(StyledPath& path) {
  if (!path.analogy || !path.analogy->example().has_strokes()) return;
  PathRecord& area = *path.record;
  if (!is_painted(area.style.fill)) return;
  if (!is_painted(area.style.stroke) && area.along.colors.empty()) {
    path.analogy = nullptr;
    return;
  }
  path.line = area;
  path.line->style.fill = NoPaint{};
  area.style.stroke = NoPaint{};
  area.along = {};
}

void insert_lines(Document& document, std::span<StyledPath> paths) {
  const auto has_line = [](const StyledPath& path) { return path.line.has_value(); };
  if (std::ranges::none_of(paths, has_line)) return;
  name_lines(document, paths);
  Records records;
  auto path = paths.begin();
  for (Record& record : document.records) {
    std::optional<PathRecord> line;
    if (std::holds_alternative<PathRecord>(record)) line = std::move((path++)->line);
    const bool below = line && line->style.stroke_first;
    if (below) records.emplace_back(std::move(*line));
    records.push_back(std::move(record));
    if (line && !below) records.emplace_back(std::move(*line));
  }
  document.records = std::move(records);
}

}  // namespace libstyle
