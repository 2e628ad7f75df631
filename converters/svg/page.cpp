// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/page.h"

#include <string_view>

#include "converters/svg/carried_keys.h"
#include "converters/svg/scanner.h"
#include "converters/svg/view_box.h"

namespace libstyle::svg {
namespace {

// What percentages refer to on a page of unknown size.
constexpr Vector kUnknownViewport = {100, 100};

std::optional<double> absolute_size(std::optional<Length> length, double font_size) {
  if (!length || length->unit == LengthUnit::kPercent) return std::nullopt;
  return resolve(*length, LengthAxis::kDiagonal, {0, 0, font_size});
}

bool is_paper_unit(LengthUnit unit) {
  return unit == LengthUnit::kMm || unit == LengthUnit::kCm || unit == LengthUnit::kIn ||
         unit == LengthUnit::kPt || unit == LengthUnit::kPc;
}

std::string paper_size(const char* text) {
  const std::optional<Length> length = parse_length(text);
  if (!length || !is_paper_unit(length->unit)) return "";
  return std::string(trimmed(text));
}

// One size and the proportions of the viewBox give the other; a page without a viewBox and without
// both sizes is as large as what is drawn.
void set_size(Page& page, const ComputedStyle& style, const std::optional<Rectangle>& view_box) {
  page.width = absolute_size(style.width, style.font_size);
  page.height = absolute_size(style.height, style.font_size);
  if (page.width && page.height) return;
  if (!view_box || view_box->width == 0 || view_box->height == 0) {
    page.width = page.height = std::nullopt;
  } else if (page.width) {
    page.height = *page.width * view_box->height / view_box->width;
  } else if (page.height) {
    page.width = *page.height * view_box->width / view_box->height;
  } else {
    page.width = view_box->width;
    page.height = view_box->height;
  }
}

// Whether the viewBox is only what curves2svg shows of a page without a size.
bool has_no_page(pugi::xml_node root, const ComputedStyle& style) {
  const pugi::xml_attribute shown = root.attribute(kCarriedBox);
  return shown && std::string_view(root.attribute("viewBox").value()) == shown.value() &&
         !style.width && !style.height;
}

}  // namespace

Page read_page(pugi::xml_node root, const ComputedStyle& style) {
  Page page;
  const std::optional<View> view = read_view(root);
  const bool boxed = view && !has_no_page(root, style);
  const std::optional<Rectangle> view_box = boxed ? view->view_box : std::nullopt;
  set_size(page, style, view_box);
  if (page.width) page.width_text = paper_size(root.attribute("width").value());
  if (page.height) page.height_text = paper_size(root.attribute("height").value());

  page.viewport = page.width ? Vector{*page.width, *page.height} : kUnknownViewport;
  if (!view) return page;
  page.page_from_user = Transform{};
  if (view_box && page.width) {
    const auto map =
        viewport_from_view_box({0, 0, *page.width, *page.height}, *view_box, view->ratio);
    if (!map) return page;  // a viewBox without size; librsvg goes on as if there were none
    page.page_from_user = map;
    page.viewport = {view_box->width, view_box->height};
  }
  return page;
}

}  // namespace libstyle::svg
