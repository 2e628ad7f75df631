// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/clip.h"

#include "converters/cairo/layer.h"
#include "converters/cairo/trace.h"

namespace libstyle {
namespace {

// Clips of several parts within each other multiply; a quarter of a second's work.
constexpr std::size_t kMostParts = 100'000;

void clip_to_box(Canvas& canvas, const Box& page_box) {
  Path corners;
  if (!page_box.empty()) {
    corners.move_to(page_box.low);
    corners.line_to({page_box.high.x, page_box.low.y});
    corners.line_to(page_box.high);
    corners.line_to({page_box.low.x, page_box.high.y});
    corners.close();
  }
  cairo_new_path(canvas.context);
  trace_fill(canvas, corners);
  cairo_clip(canvas.context);
}

void trace_part(Canvas& canvas, const ClipPart& part) {
  if (++canvas.clip_parts_drawn > kMostParts) {
    throw Error("clips within clips come to over 100,000 parts; simplify them");
  }
  cairo_new_path(canvas.context);
  trace_fill(canvas, part.path);
  cairo_set_fill_rule(canvas.context, to_cairo(part.rule));
}

}  // namespace

ClipScope::ClipScope(Canvas& canvas, const std::string& id, const RecordBase& user)
    : canvas_(canvas) {
  if (id.empty()) return;
  canvas.clip_parts_drawn = 0;
  const ClipRecord* clip = canvas.index.clip(id);
  if (!clip) canvas.warn_about(user, "the clip \"" + id + "\" is not there; drawn without it");
  begin(clip);
}

ClipScope::ClipScope(Canvas& canvas, const ClipRecord* clip) : canvas_(canvas) { begin(clip); }

// Clips of one part lead on to the clips they are within, down to none or to a union.
void ClipScope::begin(const ClipRecord* clip) {
  if (!clip) return;
  saved_ = true;
  cairo_save(canvas_.context);
  std::vector<const ClipRecord*> pending = {clip};
  while (!pending.empty()) {
    const ClipRecord& next = *pending.back();
    pending.pop_back();
    if (const ClipRecord* outer = canvas_.index.clip(next.clip, &next)) pending.push_back(outer);
    if (next.parts.size() == 1) {
      trace_part(canvas_, next.parts[0]);
      cairo_clip(canvas_.context);
      const ClipRecord* inner = canvas_.index.clip(next.parts[0].clip, &next);
      if (inner) pending.push_back(inner);
      continue;
    }
    Box box;
    for (const ClipPart& part : next.parts) box.include(part.path.control_box());
    clip_to_box(canvas_, box);
    if (!next.parts.empty()) masks_.push_back(&next);
  }
  for (std::size_t i = 0; i < masks_.size(); ++i) begin_layer(canvas_);
}

void ClipScope::end() {
  for (; !masks_.empty(); masks_.pop_back()) draw_through(*masks_.back());
  if (saved_) cairo_restore(canvas_.context);
}

void ClipScope::draw_through(const ClipRecord& clip) {
  cairo_t* context = canvas_.context;
  const CairoPattern content = end_layer(canvas_);
  begin_layer(canvas_, CAIRO_CONTENT_ALPHA);
  for (const ClipPart& part : clip.parts) {
    ClipScope within(canvas_, canvas_.index.clip(part.clip, &clip));
    trace_part(canvas_, part);
    cairo_set_source_rgb(context, 0, 0, 0);
    cairo_fill(context);
    within.end();
  }
  const CairoPattern mask = end_layer(canvas_);
  cairo_set_source(context, content.get());
  cairo_mask(context, mask.get());
}

}  // namespace libstyle
