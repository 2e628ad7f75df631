// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/pen_space.h"

#include <algorithm>
#include <utility>

#include "converters/svg/path_grammar.h"
#include "converters/svg/transform_list.h"

namespace libstyle::svg {

std::optional<Path> to_pen_space(const Path& page_path, const Transform& page_from_pen) {
  const std::optional<Transform> pen_from_page = inverse(page_from_pen);
  if (!pen_from_page) return std::nullopt;
  Path result = page_path;
  result.transform(*pen_from_page);
  const auto finite = [](Point point) { return is_finite(point); };
  if (!std::ranges::all_of(result.points(), finite)) return std::nullopt;
  return result;
}

std::optional<Transform> to_pen_space(const Transform& page_from_gradient,
                                      const Transform& page_from_pen) {
  const std::optional<Transform> pen_from_page = inverse(page_from_pen);
  if (!pen_from_page) return std::nullopt;
  const Transform result = *pen_from_page * page_from_gradient;
  return result.is_finite() ? std::optional(result) : std::nullopt;
}

Path to_page(Path pen_path, const Transform& page_from_pen, std::string_view carried) {
  if (!carried.empty()) {
    ParsedPath parsed = parse_path_grammar(carried, pen_path.points().size());
    if (!parsed.error_at && to_pen_space(parsed.path, page_from_pen) == pen_path) {
      return std::move(parsed.path);
    }
  }
  pen_path.transform(page_from_pen);
  return pen_path;
}

Transform to_page(const Transform& pen_from_gradient, const Transform& page_from_pen,
                  std::string_view carried) {
  if (!carried.empty()) {
    const std::optional<Transform> parsed = parse_transform_attribute(carried);
    if (parsed && to_pen_space(*parsed, page_from_pen) == pen_from_gradient) return *parsed;
  }
  return page_from_pen * pen_from_gradient;
}

}  // namespace libstyle::svg
