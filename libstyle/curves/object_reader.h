// SPDX-License-Identifier: Apache-2.0
// Reads a JSON object into a record by the fields of its kind. Internal to libstyle/curves; only
// the reader includes this.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/curves/fields.h"
#include "libstyle/curves/json_value.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::fields {

// Which keys of an object have been there.
template <typename T>
class SeenKeys {
 public:
  static_assert(kFieldCount<T> <= 64);

  // Returns false when the key was there before.
  bool add(std::size_t index) {
    const bool first = !has(index);
    bits_ |= std::uint64_t{1} << index;
    return first;
  }
  bool has(std::size_t index) const { return bits_ >> index & 1; }
  bool has(std::string_view key) const {
    return has(static_cast<std::size_t>(std::ranges::find(kKeys<T>, key) - kKeys<T>.begin()));
  }

 private:
  std::uint64_t bits_ = 0;
};

// What a field by field reading cannot see: defaults that follow from other keys, and faults
// between keys.
template <typename T>
void complete(T&, const SeenKeys<T>&) {}
void complete(PathRecord& record, const SeenKeys<PathRecord>& seen);
void complete(GradientRecord& record, const SeenKeys<GradientRecord>& seen);
void complete(RadialGeometry& geometry, const SeenKeys<RadialGeometry>& seen);

[[noreturn]] void fail_both_kinds();

class ObjectReader {
 public:
  // Fills `object` from `json`. Throws Error (no place) that names the key.
  template <typename T>
  void read_object(json::ondemand::object& json, T& object) {
    SeenKeys<T> seen;
    std::size_t expected = 0;
    for (auto field : json) {
      std::string_view key;
      json::check(field.unescaped_key().get(key));
      json::Value value;
      json::check(field.value().get(value));
      const std::size_t index = find_key<T>(key, expected);
      if (index == kFieldCount<T>) {
        refuse_reserved<T>(key);
        keep_extra(key, value, object.extras);
      } else {
        if (!seen.add(index)) throw Error(quoted(key) + " is there twice");
        read_field(index, value, object);
        expected = index + 1;
      }
    }
    require_all(seen);
    complete(object, seen);
  }

  json::RawChecker& raw_checker() { return raw_checker_; }

 private:
  using Value = json::Value;

  static std::string quoted(std::string_view key) { return '"' + std::string(key) + '"'; }

  // Keys mostly come in the order of the table, so the search begins after the last one found.
  template <typename T>
  static std::size_t find_key(std::string_view key, std::size_t expected) {
    for (std::size_t i = expected; i < kFieldCount<T>; ++i) {
      if (kKeys<T>[i] == key) return i;
    }
    for (std::size_t i = 0; i < expected; ++i) {
      if (kKeys<T>[i] == key) return i;
    }
    return kFieldCount<T>;
  }

  // "curves" and "type" tell headers and records apart, so neither may stand in the other.
  template <typename T>
  static void refuse_reserved(std::string_view key) {
    constexpr bool kIsHeader = std::is_same_v<T, Header>;
    constexpr bool kIsRecord = std::is_base_of_v<RecordBase, T>;
    if ((kIsHeader && key == "type") || (kIsRecord && key == "curves")) fail_both_kinds();
  }

  template <typename T>
  static void require_all(const SeenKeys<T>& seen) {
    std::size_t index = 0;
    const auto require = [&](const auto& field) {
      if (field.presence == Presence::kRequired && !seen.has(index)) {
        throw Error(quoted(field.key) + " is missing");
      }
      ++index;
    };
    std::apply([&](const auto&... field) { (require(field), ...); }, kFields<T>);
  }

  template <typename T>
  void read_field(std::size_t index, Value& value, T& object) {
    using ReadField = void (*)(ObjectReader&, Value&, T&);
    static constexpr auto kReaders = []<std::size_t... I>(std::index_sequence<I...>) {
      return std::array<ReadField, sizeof...(I)>{[](ObjectReader& reader, Value& v, T& target) {
        constexpr const auto& kField = std::get<I>(kFields<T>);
        reader.read_value(kField.form, v, std::invoke(kField.access, target));
      }...};
    }
    (std::make_index_sequence<kFieldCount<T>>());
    try {
      kReaders[index](*this, value, object);
    } catch (const Error& error) {
      throw Error(quoted(kKeys<T>[index]) + ": " + error.what());
    }
  }

  void keep_extra(std::string_view key, Value& value, std::vector<Extra>& extras) {
    extras.push_back({std::string(key), json::to_compact(raw_checker_.check_value(value).text)});
  }

  // ---- Values, one function a form ----

  void read_value(VersionForm, Value& value, Header& header);
  void read_value(TextForm, Value& value, std::string& text) { text = json::read_text(value); }
  void read_value(TextListForm, Value& value, std::vector<std::string>& texts);
  void read_value(FlagForm, Value& value, bool& flag) { flag = json::read_flag(value); }
  void read_value(NumberForm form, Value& value, double& number) {
    number = json::read_number(value, form.low, form.high);
  }
  void read_value(OptionalNumberForm form, Value& value, std::optional<double>& number) {
    number = json::read_number(value, form.low, form.high);
  }
  void read_value(NumberListForm form, Value& value, std::vector<double>& numbers) {
    numbers = json::read_numbers(value, form.low);
  }
  void read_value(PathForm, Value& value, Path& path) {
    path = parse_path_data(json::read_text(value));
  }
  void read_value(PointForm, Value& value, Point& point);
  void read_value(PointForm form, Value& value, std::optional<Point>& point) {
    read_value(form, value, point.emplace());
  }
  void read_value(TransformForm, Value& value, Transform& transform);
  void read_value(TransformForm form, Value& value, std::optional<Transform>& transform) {
    read_value(form, value, transform.emplace());
  }
  void read_value(ColorForm, Value& value, Color& color);
  void read_value(PaintForm, Value& value, std::optional<Paint>& paint);
  void read_value(AlongForm, Value& value, AlongValues& along);

  // The type was read to know what kind of record this is.
  template <typename Record>
  void read_value(TypeForm, Value&, Record&) {}

  template <std::size_t N, typename Word>
  void read_value(const WordForm<N>& form, Value& value, Word& word) {
    const auto found = std::ranges::find(form.words, json::read_text(value));
    if (found == form.words.end()) json::fail_wanted(value, list_words(form.words));
    word = static_cast<Word>(found - form.words.begin());
  }

  template <typename T, typename Variant>
  void read_value(AlternativeForm<T>, Value& value, Variant& variant) {
    read_nested(value, variant.template emplace<T>());
  }

  template <typename T>
  void read_value(ObjectListForm, Value& value, std::vector<T>& objects) {
    json::read_list(value, [&](Value& item) { read_nested(item, objects.emplace_back()); });
  }

  template <typename T>
  void read_nested(Value& value, T& object) {
    json::ondemand::object json;
    if (value.get_object().get(json) != simdjson::SUCCESS) json::fail_wanted(value, "an object");
    read_object(json, object);
  }

  void read_channel(std::string_view name, Value& value, AlongValues& along);

  static std::string list_words(std::span<const std::string_view> words);

  json::RawChecker raw_checker_;
};

}  // namespace libstyle::fields
