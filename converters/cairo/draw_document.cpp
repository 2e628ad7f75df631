// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/draw_document.h"

#include <memory>
#include <vector>

#include "converters/cairo/clip.h"
#include "converters/cairo/draw_path.h"
#include "converters/cairo/ink.h"
#include "converters/cairo/layer.h"

namespace libstyle {
namespace {

class Painter {
 public:
  Painter(cairo_t* context, const Document& document, const Transform& device_from_page,
          const std::string& file, const WarningHandler& warn)
      : document_(document),
        file_(file),
        index_(document),
        ink_(ink_boxes(document)),
        canvas_{context, device_from_page, window_of(context), index_, warn, is_raster(context)} {}

  void draw() {
    for (std::size_t i = 0; i < document_.records.size(); ++i) {
      const auto* path = std::get_if<PathRecord>(&document_.records[i]);
      if (!path || ink_[i].empty()) continue;
      at_place({file_, path->line}, [&] {
        enter(container_of(*path, i));
        if (hidden_depth_ == 0) draw_path(canvas_, *path, ink_[i]);
      });
    }
    at_place({file_, document_.header.line}, [&] { enter(ReferenceIndex::kNone); });
  }

 private:
  // A group or element that is being drawn.
  struct Open {
    std::size_t place;
    bool hidden = false;
    bool has_layer = false;
    double opacity = 1;
    BlendMode blend_mode = BlendMode::kNormal;
    std::unique_ptr<ClipScope> clip = nullptr;
  };

  static Box window_of(cairo_t* context) {
    double left = 0, top = 0, right = 0, bottom = 0;
    cairo_clip_extents(context, &left, &top, &right, &bottom);
    return {{left, top}, {right, bottom}};
  }

  static bool is_raster(cairo_t* context) {
    return cairo_surface_get_type(cairo_get_target(context)) == CAIRO_SURFACE_TYPE_IMAGE;
  }

  std::size_t container_of(const RecordBase& record, std::size_t place) const {
    const std::size_t container = index_.container(record.parent, place);
    if (container == ReferenceIndex::kNone && !record.parent.empty()) {
      canvas_.warn_about(
          record, "the group \"" + record.parent + "\" is not there; drawn outside of any group");
    }
    return container;
  }

  // Closes and opens containers until `place` is the innermost. A container stands before its
  // members, so of two that differ the later one is not around the earlier.
  void enter(std::size_t place) {
    std::vector<std::size_t> to_open;
    while (place != innermost()) {
      if (!open_.empty() && (place == ReferenceIndex::kNone || place < innermost())) {
        close();
      } else {
        to_open.push_back(place);
        place = parent_of(place);
      }
    }
    for (; !to_open.empty(); to_open.pop_back()) open(to_open.back());
  }

  std::size_t innermost() const {
    return open_.empty() ? ReferenceIndex::kNone : open_.back().place;
  }

  std::size_t parent_of(std::size_t place) const {
    const Record& record = document_.records[place];
    if (const auto* group = std::get_if<GroupRecord>(&record)) return container_of(*group, place);
    return container_of(std::get<ElementRecord>(record), place);
  }

  void open(std::size_t place) {
    Open entry{.place = place};
    if (const auto* group = std::get_if<GroupRecord>(&document_.records[place])) {
      entry.hidden = group->hidden || group->opacity <= 0;
      if (!entry.hidden && hidden_depth_ == 0) begin(*group, ink_[place], entry);
    }
    if (entry.hidden) ++hidden_depth_;
    open_.push_back(std::move(entry));
  }

  void begin(const GroupRecord& group, const Box& ink, Open& entry) {
    if (!group.clip.empty()) entry.clip = std::make_unique<ClipScope>(canvas_, group.clip, group);
    entry.opacity = group.opacity;
    entry.blend_mode = group.blend_mode;
    entry.has_layer = group.opacity < 1 || group.isolated || group.blend_mode != BlendMode::kNormal;
    if (entry.has_layer) begin_layer_over(canvas_, ink);
  }

  void close() {
    const Open entry = std::move(open_.back());
    open_.pop_back();
    if (entry.has_layer) draw_layer(canvas_, entry.opacity, entry.blend_mode);
    if (entry.clip) entry.clip->end();
    if (entry.hidden) --hidden_depth_;
  }

  const Document& document_;
  const std::string& file_;
  const ReferenceIndex index_;
  const std::vector<Box> ink_;
  Canvas canvas_;
  std::vector<Open> open_;
  std::size_t hidden_depth_ = 0;  // of hidden groups that are open
};

}  // namespace

void draw_document(cairo_t* context, const Document& document, const Transform& device_from_page,
                   const std::string& file, const WarningHandler& warn) {
  Painter(context, document, device_from_page, file, warn).draw();
}

}  // namespace libstyle
