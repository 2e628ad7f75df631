// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/writer.h"

#include <cassert>

#include "libstyle/base/number.h"
#include "libstyle/curves/fields.h"
#include "libstyle/curves/json_text.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle {
namespace {

using namespace fields;

template <typename T>
void append_object(std::string& text, const T& object);

// Puts a comma before everything but the first.
class Commas {
 public:
  explicit Commas(std::string& text) : text_(text) {}

  void next() {
    if (!first_) text_ += ',';
    first_ = false;
  }

 private:
  std::string& text_;
  bool first_ = true;
};

template <typename List, typename AppendItem>
void append_list(std::string& text, const List& list, AppendItem append_item) {
  text += '[';
  Commas commas(text);
  for (const auto& item : list) {
    commas.next();
    append_item(item);
  }
  text += ']';
}

void append_numbers(std::string& text, std::span<const double> numbers) {
  append_list(text, numbers, [&](double number) { append_number(text, number); });
}

void append_color(std::string& text, Color color) {
  text += '"';
  text += to_text(color);
  text += '"';
}

// ---- Values, one function a form ----

void append_value(VersionForm, std::string& text, const Header&) { text += '1'; }

template <typename Record>
void append_value(TypeForm, std::string& text, const Record&) {
  append_json_string(text, Record::kType);
}

void append_value(TextForm, std::string& text, const std::string& value) {
  append_json_string(text, value);
}

void append_value(TextListForm, std::string& text, const std::vector<std::string>& values) {
  append_list(text, values, [&](const std::string& value) { append_json_string(text, value); });
}

void append_value(FlagForm, std::string& text, bool value) { text += value ? "true" : "false"; }

void append_value(NumberForm, std::string& text, double value) { append_number(text, value); }

void append_value(OptionalNumberForm, std::string& text, const std::optional<double>& value) {
  append_number(text, *value);
}

void append_value(NumberListForm, std::string& text, const std::vector<double>& values) {
  append_numbers(text, values);
}

template <std::size_t N, typename Value>
void append_value(const WordForm<N>& form, std::string& text, Value value) {
  append_json_string(text, form.words[static_cast<std::size_t>(value)]);
}

void append_value(PathForm, std::string& text, const Path& path) {
  text += '"';
  append_path_data(text, path);
  text += '"';
}

void append_value(PointForm, std::string& text, const Point& point) {
  const double numbers[] = {point.x, point.y};
  append_numbers(text, numbers);
}

void append_value(PointForm form, std::string& text, const std::optional<Point>& point) {
  append_value(form, text, *point);
}

void append_value(TransformForm, std::string& text, const Transform& t) {
  const double numbers[] = {t.a, t.b, t.c, t.d, t.e, t.f};
  append_numbers(text, numbers);
}

void append_value(TransformForm form, std::string& text, const std::optional<Transform>& t) {
  append_value(form, text, *t);
}

void append_value(ColorForm, std::string& text, Color color) { append_color(text, color); }

void append_value(PaintForm, std::string& text, const std::optional<Paint>& paint) {
  if (const auto* color = std::get_if<Color>(&*paint)) {
    assert(color->alpha == 255);
    append_color(text, *color);
  } else if (const auto* reference = std::get_if<PaintReference>(&*paint)) {
    append_json_string(text, "url(#" + reference->id + ")");
  } else {
    text += "\"none\"";
  }
}

template <typename T, typename Variant>
void append_value(AlternativeForm<T>, std::string& text, const Variant& value) {
  append_object(text, std::get<T>(value));
}

template <typename T>
void append_value(ObjectListForm, std::string& text, const std::vector<T>& objects) {
  append_list(text, objects, [&](const T& object) { append_object(text, object); });
}

// ---- Objects ----

void append_key(std::string& text, Commas& commas, std::string_view key) {
  commas.next();
  append_json_string(text, key);
  text += ':';
}

void append_extras(std::string& text, Commas& commas, const std::vector<Extra>& extras) {
  for (const Extra& extra : extras) {
    append_key(text, commas, extra.key);
    text += extra.json;
  }
}

void append_value(AlongForm, std::string& text, const AlongValues& along) {
  text += '{';
  Commas commas(text);
  for (const Channel& channel : along.channels) {
    if (channel.values.empty()) continue;  // of a path without vertices
    append_key(text, commas, channel.name);
    append_numbers(text, channel.values);
  }
  if (!along.colors.empty()) {
    append_key(text, commas, "color");
    append_list(text, along.colors, [&](Color color) { append_color(text, color); });
  }
  append_extras(text, commas, along.extras);
  text += '}';
}

template <typename T, typename Access, typename Form>
void append_field(std::string& text, Commas& commas, const T& object,
                  const Field<Access, Form>& field) {
  const auto& value = std::invoke(field.access, object);
  if (field.presence == Presence::kOptional && is_initial(field.form, value)) return;
  append_key(text, commas, field.key);
  append_value(field.form, text, value);
}

template <typename T>
void append_object(std::string& text, const T& object) {
  text += '{';
  Commas commas(text);
  std::apply([&](const auto&... field) { (append_field(text, commas, object, field), ...); },
             kFields<T>);
  append_extras(text, commas, object.extras);
  text += '}';
}

constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

}  // namespace

void append_header(std::string& text, const Header& header) {
  append_object(text, header);
  text += '\n';
}

void append_record(std::string& text, const Record& record) {
  std::visit(
      [&](const auto& known) {
        if constexpr (kIsKnown<std::decay_t<decltype(known)>>) {
          append_object(text, known);
        } else {
          text += known.json;
        }
      },
      record);
  text += '\n';
}

void write_document(ByteSink& sink, const Document& document) {
  std::string text;
  append_header(text, document.header);
  for (const Record& record : document.records) {
    append_record(text, record);
    if (text.size() < kPieceBytes) continue;
    sink.write(text);
    text.clear();
  }
  sink.write(text);
}

}  // namespace libstyle
