// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/painter.h"

#include <string>

#include "converters/svg/stroke.h"

namespace libstyle::svg {

// The fill is always said: a path that says nothing about its paint is a bare curve.
Style Painter::painted_style(pugi::xml_node element, const ComputedStyle& computed,
                             const PaintContext& context, const PaintedShape& shape) {
  const auto [fill, stroke] = paints_of(computed, context);
  Style style;
  style.fill_opacity = fill.opacity;
  style.fill = resolve_paint(element, fill.paint, computed, shape, style.fill_opacity);
  if (!style.fill) style.fill = NoPaint{};
  style.fill_rule = computed.fill_rule;
  style.stroke_opacity = stroke.opacity;
  style.stroke = resolve_paint(element, stroke.paint, computed, shape, style.stroke_opacity);
  style.stroke_first =
      style.stroke && computed.paint_order.comes_before(PaintPart::kStroke, PaintPart::kFill);
  if (style.stroke && !set_stroke_geometry(style, computed, shape.context, shape.page_from_user)) {
    reporter_.warn(element, "has a stroke that is too large; it is left out");
    style.stroke.reset();
  }
  style.crisp_edges = computed.crisp_edges;
  style.opacity = computed.opacity;
  style.hidden = computed.display == Display::kNone || computed.visibility == Visibility::kHidden ||
                 shape.page_from_user.determinant() == 0;
  return style;
}

// The alpha of a colour goes into the opacity of the paint.
std::optional<Paint> Painter::resolve_paint(pugi::xml_node element, const SpecifiedPaint& specified,
                                            const ComputedStyle& computed,
                                            const PaintedShape& shape, double& opacity) {
  const pugi::xml_node server = index_.find_reference(specified.reference);
  if (is_gradient(server)) {
    const std::optional<Paint> paint = gradients_.paint(server, shape, opacity);
    if (paint && std::holds_alternative<NoPaint>(*paint)) return std::nullopt;
    if (paint) return paint;
  } else if (std::string_view(server.name()) == "pattern") {
    reporter_.warn(element, "paint by pattern is not carried");
  }
  const std::optional<CssColor> color = specified.solid.resolve(computed.color);
  if (!color) return std::nullopt;
  opacity *= color->alpha;
  return color->color;
}

}  // namespace libstyle::svg
