// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/object_reader.h"

namespace libstyle::fields {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The ranges of the values along a curve that have a meaning here.
struct KnownChannel {
  std::string_view name;
  double low, high;
};
constexpr KnownChannel kKnownChannels[] = {
    {"width", 0, kInfinity}, {"pressure", 0, 1}, {"t", -kInfinity, kInfinity}};

constexpr const char* kNotAChannel = ": must be an array with one value for each vertex";

Color read_color(json::Value& value) {
  const std::optional<Color> color = parse_color(json::read_text(value));
  if (!color) json::fail_wanted(value, "a color like \"#00aaff\"");
  return *color;
}

Color read_opaque_color(json::Value& value) {
  const Color color = read_color(value);
  if (color.alpha != 255) json::fail_wanted(value, "a color without alpha; use an opacity");
  return color;
}

// The numbers of an array of numbers; none for anything else.
std::vector<double> to_numbers(simdjson::dom::element element) {
  std::vector<double> numbers;
  simdjson::dom::array array;
  if (element.get_array().get(array) != simdjson::SUCCESS) return {};
  for (const simdjson::dom::element item : array) {
    double number = 0;
    if (item.get_double().get(number) != simdjson::SUCCESS) return {};
    numbers.push_back(number);
  }
  return numbers;
}

void check_range(const Channel& channel, const KnownChannel& known) {
  for (const double value : channel.values) {
    if (value >= known.low && value <= known.high) continue;
    throw Error("\"" + channel.name +
                "\": " + (value < 0 ? "a value is negative" : "a value is greater than 1"));
  }
}

void check_length(std::string_view name, std::size_t values, std::size_t vertices) {
  if (values == vertices) return;
  throw Error(R"("along": ")" + std::string(name) + "\" has " + std::to_string(values) +
              " values for " + std::to_string(vertices) + " vertices of \"d\"");
}

}  // namespace

void complete(PathRecord& record, const SeenKeys<PathRecord>&) {
  if (record.along.empty()) return;
  const std::size_t vertices = record.path.vertex_count();
  for (const Channel& channel : record.along.channels) {
    check_length(channel.name, channel.values.size(), vertices);
  }
  if (!record.along.colors.empty()) check_length("color", record.along.colors.size(), vertices);
}

void complete(GradientRecord& record, const SeenKeys<GradientRecord>& seen) {
  if (seen.has("linear") == seen.has("radial")) {
    throw Error(R"(a gradient has either "linear" or "radial")");
  }
  if (!std::ranges::is_sorted(record.stops, {}, &GradientStop::offset)) {
    throw Error("\"stops\": the offsets must not decrease");
  }
}

void complete(RadialGeometry& geometry, const SeenKeys<RadialGeometry>& seen) {
  if (!seen.has("fx")) geometry.focus.x = geometry.center.x;
  if (!seen.has("fy")) geometry.focus.y = geometry.center.y;
}

void fail_both_kinds() {
  throw Error(R"(a line has either "curves", as a header, or "type", as a record; not both)");
}

void ObjectReader::read_value(VersionForm, Value& value, Header&) {
  const double version = json::read_number(value, -kInfinity, kInfinity);
  if (version != 1) {
    json::fail_wanted(value, "1, the version this program reads (a newer libstyle may read it)");
  }
}

void ObjectReader::read_value(TextListForm, Value& value, std::vector<std::string>& texts) {
  json::read_list(value, [&](Value& item) { texts.emplace_back(json::read_text(item)); });
}

void ObjectReader::read_value(PointForm, Value& value, Point& point) {
  std::array<double, 2> numbers;
  json::read_exactly(value, numbers);
  point = {numbers[0], numbers[1]};
}

void ObjectReader::read_value(TransformForm, Value& value, Transform& transform) {
  std::array<double, 6> n;
  json::read_exactly(value, n);
  transform = {n[0], n[1], n[2], n[3], n[4], n[5]};
}

void ObjectReader::read_value(ColorForm, Value& value, Color& color) {
  color = read_opaque_color(value);
}

void ObjectReader::read_value(PaintForm, Value& value, std::optional<Paint>& paint) {
  constexpr std::string_view kBegin = "url(#", kEnd = ")";
  const std::string_view text = json::read_text(value);
  if (text == "none") {
    paint = NoPaint{};
  } else if (text.starts_with(kBegin) && text.ends_with(kEnd) &&
             text.size() > kBegin.size() + kEnd.size()) {
    const std::size_t length = text.size() - kBegin.size() - kEnd.size();
    paint = PaintReference{std::string(text.substr(kBegin.size(), length))};
  } else if (text.starts_with('#')) {
    paint = read_opaque_color(value);
  } else {
    json::fail_wanted(value, R"lit("none", a color like "#00aaff" or "url(#id)")lit");
  }
}

void ObjectReader::read_value(AlongForm, Value& value, AlongValues& along) {
  json::ondemand::object members;
  if (value.get_object().get(members) != simdjson::SUCCESS) json::fail_wanted(value, "an object");
  for (auto field : members) {
    std::string_view name;
    json::check(field.unescaped_key().get(name));
    json::Value member;
    json::check(field.value().get(member));
    if (along.find(name) || (name == "color" && !along.colors.empty())) {
      throw Error(quoted(name) + " is there twice");
    }
    if (name == "color") {
      json::read_list(member, [&](Value& item) { along.colors.push_back(read_color(item)); });
      if (along.colors.empty()) throw Error(quoted(name) + kNotAChannel);
    } else {
      read_channel(name, member, along);
    }
  }
}

// An array of numbers is a channel, whatever its name; anything else is kept as it is.
void ObjectReader::read_channel(std::string_view name, Value& value, AlongValues& along) {
  const json::RawChecker::Checked checked = raw_checker_.check_value(value);
  std::vector<double> numbers = to_numbers(checked.element);
  const auto known = std::ranges::find(kKnownChannels, name, &KnownChannel::name);
  const bool is_known = known != std::end(kKnownChannels);
  if (!numbers.empty()) {
    along.channels.push_back({std::string(name), std::move(numbers)});
    if (is_known) check_range(along.channels.back(), *known);
  } else if (is_known) {
    throw Error(quoted(name) + kNotAChannel);
  } else {
    along.extras.push_back({std::string(name), json::to_compact(checked.text)});
  }
}

std::string ObjectReader::list_words(std::span<const std::string_view> words) {
  std::string list;
  for (const std::string_view& word : words) {
    if (!list.empty()) list += &word == &words.back() ? " or " : ", ";
    list += quoted(word);
  }
  return list;
}

}  // namespace libstyle::fields
