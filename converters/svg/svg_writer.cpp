// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/svg_writer.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "converters/svg/carried_keys.h"
#include "converters/svg/definitions.h"
#include "converters/svg/pen_space.h"
#include "converters/svg/record_ids.h"
#include "converters/svg/shape_element.h"
#include "converters/svg/style_attributes.h"
#include "converters/svg/xml_writer.h"
#include "libstyle/base/number.h"
#include "libstyle/curves/nesting.h"
#include "libstyle/curves/writer.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

class SvgWriter {
 public:
  SvgWriter(ByteSink& sink, const Document& document, const WarningHandler& warn)
      : document_(document),
        warn_(warn),
        ids_(document),
        containers_(document),
        nesting_(
            containers_, [this](std::size_t place) { open(place); },
            [this](std::size_t) { xml_.end(); }),
        xml_(sink) {}

  void write() {
    xml_.begin("svg");
    xml_.attribute("xmlns", "http://www.w3.org/2000/svg");
    xml_.attribute("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    xml_.attribute("xmlns:curves", kCurvesNamespace);
    write_page();
    write_metadata();
    write_definitions();
    for (std::size_t i = 0; i < document_.records.size(); ++i) write_record(i);
    nesting_.enter(Containers::kNone);
    xml_.end();
    xml_.finish();
  }

 private:
  // ---- The page ----

  // A page without a size has none in SVG either. Its drawing is then shown from the origin on,
  // unless some of it lies before that: such a viewBox says that it stands for no page.
  void write_page() {
    const Header& header = document_.header;
    if (header.width && header.height) {
      write_size("width", header.page_width, *header.width);
      write_size("height", header.page_height, *header.height);
      xml_.attribute("viewBox", view_box({{0, 0}, {*header.width, *header.height}}));
      return;
    }
    const Box box = control_box(document_);
    if (box.empty() || (box.low.x >= 0 && box.low.y >= 0)) return;
    xml_.attribute("viewBox", view_box(box));
    xml_.attribute(kCarriedBox, view_box(box));
  }

  void write_size(std::string_view name, const std::string& original, double px) {
    if (original.empty()) {
      xml_.attribute(name, px);
    } else {
      xml_.attribute(name, original);
    }
  }

  static std::string view_box(const Box& box) {
    const double numbers[] = {box.low.x, box.low.y, box.width(), box.height()};
    return to_number_list(numbers);
  }

  // ---- What stands before the drawing ----

  void write_metadata() {
    Header header = document_.header;
    header.width = header.height = std::nullopt;
    header.page_width = header.page_height = "";
    std::string records;
    for (const Record& record : document_.records) {
      if (draws_nothing(record)) append_record(records, record);
    }
    if (header == Header{} && records.empty()) return;
    std::string text;
    append_header(text, header);
    text += records;
    xml_.begin("metadata");
    xml_.begin(kCarriedRecords);
    xml_.text(text);
    xml_.end();
    xml_.end();
  }

  // Records that draw nothing. They name their curves as the document does, and elements carry
  // those names.
  static bool draws_nothing(const Record& record) {
    return std::holds_alternative<ConstraintRecord>(record) ||
           std::holds_alternative<AdjustmentRecord>(record) ||
           std::holds_alternative<LabelRecord>(record) ||
           std::holds_alternative<SeedRecord>(record) ||
           std::holds_alternative<UnknownRecord>(record);
  }

  void write_definitions() {
    const bool any = std::ranges::any_of(document_.records, [](const Record& record) {
      return std::holds_alternative<GradientRecord>(record) ||
             std::holds_alternative<ClipRecord>(record);
    });
    if (!any) return;
    xml_.begin("defs");
    for (std::size_t i = 0; i < document_.records.size(); ++i) {
      const Record& record = document_.records[i];
      if (const auto* gradient = std::get_if<GradientRecord>(&record)) {
        write_gradient(xml_, *gradient, ids_.at(i), std::nullopt);
      } else if (const auto* clip = std::get_if<ClipRecord>(&record)) {
        write_clip(xml_, *clip, ids_.at(i), ids_);
      }
    }
    xml_.end();
  }

  // ---- The drawing ----

  void write_record(std::size_t place) {
    const Record& record = document_.records[place];
    if (const auto* path = std::get_if<PathRecord>(&record)) {
      check_parent(*path, place);
      nesting_.enter(containers_.of(place));
      write_path(*path, ids_.at(place));
    } else if (const auto* group = std::get_if<GroupRecord>(&record)) {
      check_parent(*group, place);
      nesting_.enter(place);
    } else if (const auto* element = std::get_if<ElementRecord>(&record)) {
      check_parent(*element, place);
      nesting_.enter(place);
    }
  }

  void check_parent(const RecordBase& record, std::size_t place) {
    if (record.parent.empty() || containers_.of(place) != Containers::kNone) return;
    warn_once(record, "the group \"" + record.parent + "\" is not there; written outside of it",
              "parent");
  }

  void open(std::size_t place) {
    const bool again = !opened_.insert(place).second;
    const Record& record = document_.records[place];
    xml_.begin("g");
    if (const auto* group = std::get_if<GroupRecord>(&record)) {
      write_container(*group, place, again);
      if (group->layer) xml_.attribute("inkscape:groupmode", "layer");
      if (group->opacity != 1) xml_.attribute("opacity", group->opacity);
      write_blending(*group);
      refer_to_clip(group->clip, *group);
      if (group->hidden) xml_.attribute("display", "none");
    } else {
      write_container(std::get<ElementRecord>(record), place, again);
    }
  }

  // These two are no presentation attributes.
  void write_blending(const GroupRecord& group) {
    std::string style;
    if (group.blend_mode != BlendMode::kNormal) {
      style += "mix-blend-mode:";
      style += kBlendModeNames[static_cast<std::size_t>(group.blend_mode)];
    }
    if (group.isolated) style += style.empty() ? "isolation:isolate" : ";isolation:isolate";
    if (!style.empty()) xml_.attribute("style", style);
  }

  // An id can stand once, so only where the container is opened first.
  template <typename Container>
  void write_container(const Container& container, std::size_t place, bool again) {
    if (again) {
      warn_once(container, "its members do not stand together; written as several groups", "split");
    } else {
      write_id(xml_, container, ids_.at(place));
    }
    write_notes(xml_, container);
    const std::string carried = carried_keys(container);
    if (!carried.empty()) xml_.attribute(kCarriedKeys, carried);
  }

  void write_path(const PathRecord& path, const std::string& id) {
    if (varies_along_stroke(path)) {
      warn_once(path, "SVG has no strokes that vary along the curve; drawn with their mean",
                "along");
    }
    if (!path.style.stroke_transform) return write_plain_path(path, id);
    const std::optional<Path> pen_path = to_pen_space(path.path, *path.style.stroke_transform);
    if (pen_path) return write_transformed_path(path, *pen_path, id);
    warn_once(path, "the space of its pen is too extreme for SVG; drawn with a round pen", "pen");
    write_plain_path(path, id);
  }

  void write_plain_path(const PathRecord& path, const std::string& id) {
    std::optional<ShapeElement> shape = shape_element(path.shape, path.path);
    const bool is_path = !shape;
    if (is_path) shape = ShapeElement{"path", {}};
    begin_path(shape->name, path, id);
    refer_to_clip(path.clip, path);
    write_style(xml_, path, [&](const PaintReference& paint) { return gradient_id(paint, path); });
    write_carried(path, is_path);
    for (const auto& [name, value] : shape->attributes) xml_.attribute(name, value);
    if (is_path) xml_.attribute("d", to_path_data(path.path));
    xml_.end();
  }

  // A clip stands around the path: its coordinates are those of the page. Gradients are brought
  // into the space of the pen.
  void write_transformed_path(const PathRecord& path, const Path& pen_path, const std::string& id) {
    const Transform page_from_pen = *path.style.stroke_transform;
    const bool clipped = !path.clip.empty();
    if (clipped) {
      xml_.begin("g");
      xml_.attribute(kCarriedFor, "path");
      refer_to_clip(path.clip, path);
    }
    const GradientIds gradient_ids = write_transformed_gradients(path, page_from_pen);
    begin_path("path", path, id);
    xml_.attribute("transform", to_matrix(page_from_pen));
    write_style(xml_, path, gradient_ids);
    write_carried(path, true);
    xml_.attribute("d", to_path_data(pen_path));
    if (to_page(pen_path, page_from_pen, "") != path.path) {
      xml_.attribute(kCarriedPath, to_path_data(path.path));
    }
    xml_.end();
    if (clipped) xml_.end();
  }

  // Writes those that the path refers to, in its own space, and returns their ids.
  GradientIds write_transformed_gradients(const PathRecord& path, const Transform& page_from_pen) {
    std::vector<std::pair<std::string, std::string>> written;
    for (const std::optional<Paint>& paint : {path.style.fill, path.style.stroke}) {
      const auto* reference = paint ? std::get_if<PaintReference>(&*paint) : nullptr;
      const GradientRecord* gradient = reference ? find_gradient(*reference, path) : nullptr;
      if (!gradient || !to_pen_space(gradient->page_from_gradient, page_from_pen)) continue;
      written.emplace_back(reference->id,
                           ids_.make_another(document_.records[ids_.place(reference->id)]));
      xml_.begin("defs");
      write_gradient(xml_, *gradient, written.back().second, page_from_pen);
      xml_.end();
    }
    return [written](const PaintReference& reference) {
      const auto found =
          std::ranges::find(written, reference.id, &decltype(written)::value_type::first);
      return found == written.end() ? std::string() : found->second;
    };
  }

  void begin_path(std::string_view element, const PathRecord& path, const std::string& id) {
    xml_.begin(element);
    write_id(xml_, path, id);
    write_notes(xml_, path);
  }

  void write_carried(const PathRecord& path, bool keep_shape) {
    const std::string carried = carried_keys(path, keep_shape);
    if (!carried.empty()) xml_.attribute(kCarriedKeys, carried);
  }

  // ---- References and warnings ----

  const GradientRecord* find_gradient(const PaintReference& paint, const RecordBase& user) {
    const std::size_t place = ids_.place(paint.id);
    const auto* gradient = place == RecordIds::kNowhere
                               ? nullptr
                               : std::get_if<GradientRecord>(&document_.records[place]);
    if (!gradient) {
      warn_once(user, "the gradient \"" + paint.id + "\" is not there; left unpainted", "gradient");
    }
    return gradient;
  }

  std::string gradient_id(const PaintReference& paint, const RecordBase& user) {
    return find_gradient(paint, user) ? ids_.find(paint.id) : std::string();
  }

  void refer_to_clip(const std::string& clip, const RecordBase& user) {
    if (clip.empty()) return;
    write_clip_reference(xml_, clip, ids_);
    if (ids_.find(clip).empty()) {
      warn_once(user, "the clip \"" + clip + "\" is not there; left unclipped", "clip");
    }
  }

  void warn_once(const RecordBase& record, const std::string& message, const char* kind) {
    if (warned_.insert(kind).second) warn_({{"", record.line}, record.id, message});
  }

  const Document& document_;
  const WarningHandler& warn_;
  RecordIds ids_;
  const Containers containers_;
  Nesting nesting_;
  XmlWriter xml_;
  std::set<std::size_t> opened_;
  std::set<std::string> warned_;
};

}  // namespace

void write_svg(ByteSink& sink, const Document& document, const WarningHandler& warn) {
  SvgWriter(sink, document, warn).write();
}

}  // namespace libstyle::svg
