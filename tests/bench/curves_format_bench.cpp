// SPDX-License-Identifier: Apache-2.0
// How fast the curves format is read and written, in bytes of its text, on one core. The goal is
// 200 MB/s each way.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "libstyle/base/number.h"
#include "libstyle/base/random.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle {
namespace {

// How the numbers of a stream look.
enum class Digits : std::uint8_t {
  kTwoPlaces,  // as people and drawing programs write them: 123.45
  kAll         // as transforms and fits leave them: 123.45678901234567
};

double coordinate(const RandomStream& stream, std::uint64_t index, Digits digits) {
  const double value = 1000 * stream.uniform(index);
  return digits == Digits::kAll ? value : std::round(100 * value) / 100;
}

struct Shape {
  int paths;
  int segments;  // of each path
  Digits digits;
  bool along;
};

// From icons to one long line, always about ten megabytes.
constexpr Shape kIcons = {60000, 3, Digits::kTwoPlaces, false};
constexpr Shape kDrawing = {12000, 20, Digits::kTwoPlaces, false};
constexpr Shape kFitted = {4500, 20, Digits::kAll, false};
constexpr Shape kStrokes = {2500, 100, Digits::kTwoPlaces, true};
constexpr Shape kLongLine = {1, 230000, Digits::kTwoPlaces, false};

PathRecord make_path(const Shape& shape, const RandomStream& stream, std::uint64_t& next) {
  const auto point = [&] {
    const double x = coordinate(stream, next++, shape.digits);
    return Point{x, coordinate(stream, next++, shape.digits)};
  };
  PathRecord record;
  record.id = "path" + std::to_string(next);
  record.parent = "layer1";
  record.style.fill = Color{255, 200, 0};
  record.style.stroke = Color{};
  record.style.stroke_width = 1.5;
  record.path.move_to(point());
  for (int i = 0; i < shape.segments; ++i) {
    const Point first = point(), second = point();
    record.path.cubic_to(first, second, point());
  }
  if (shape.along) {
    std::vector<double> widths;
    for (int i = 0; i <= shape.segments; ++i) {
      widths.push_back(std::round(100 * stream.uniform(next++)) / 100);
    }
    record.along.channels.push_back({"width", widths});
  }
  return record;
}

Document make_document(const Shape& shape) {
  const RandomStream stream(1, 0);
  std::uint64_t next = 0;
  Document document;
  document.header.name = "bench";
  for (int i = 0; i < shape.paths; ++i) document.records.push_back(make_path(shape, stream, next));
  return document;
}

class NullSink final : public ByteSink {
 public:
  void write(std::string_view bytes) override { count += bytes.size(); }
  std::size_t count = 0;
};

void write_curves(benchmark::State& state, const Shape& shape) {
  const Document document = make_document(shape);
  NullSink sink;
  for (auto _ : state) write_document(sink, document);
  state.SetBytesProcessed(static_cast<std::int64_t>(sink.count));
}

void read_curves(benchmark::State& state, const Shape& shape) {
  TextSink sink;
  write_document(sink, make_document(shape));
  for (auto _ : state) {
    TextSource source(sink.text);
    Reader reader(source, "bench");
    Document document;
    while (reader.read(document)) benchmark::DoNotOptimize(document);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(sink.text.size()) * state.iterations());
}

// A stream of many small documents, each of them into the same storage.
void read_many_documents(benchmark::State& state) {
  TextSink sink;
  const Document document = make_document({100, 20, Digits::kTwoPlaces, false});
  for (int i = 0; i < 120; ++i) write_document(sink, document);
  for (auto _ : state) {
    TextSource source(sink.text);
    Reader reader(source, "bench");
    Document read;
    while (reader.read(read)) benchmark::DoNotOptimize(read);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(sink.text.size()) * state.iterations());
}

void append_numbers(benchmark::State& state, Digits digits) {
  const RandomStream stream(1, 0);
  std::vector<double> numbers;
  for (std::uint64_t i = 0; i < 10000; ++i) numbers.push_back(coordinate(stream, i, digits));
  std::string text;
  for (auto _ : state) {
    text.clear();
    for (const double number : numbers) append_number(text, number);
    benchmark::DoNotOptimize(text.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

void parse_path(benchmark::State& state, Digits digits) {
  Shape shape = kDrawing;
  shape.segments = 2000;
  shape.digits = digits;
  std::uint64_t next = 0;
  const std::string text = to_path_data(make_path(shape, RandomStream(1, 0), next).path);
  for (auto _ : state) benchmark::DoNotOptimize(parse_path_data(text));
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

BENCHMARK_CAPTURE(write_curves, icons, kIcons);
BENCHMARK_CAPTURE(write_curves, drawing, kDrawing);
BENCHMARK_CAPTURE(write_curves, fitted, kFitted);
BENCHMARK_CAPTURE(write_curves, strokes, kStrokes);
BENCHMARK_CAPTURE(write_curves, long_line, kLongLine);
BENCHMARK_CAPTURE(read_curves, icons, kIcons);
BENCHMARK_CAPTURE(read_curves, drawing, kDrawing);
BENCHMARK_CAPTURE(read_curves, fitted, kFitted);
BENCHMARK_CAPTURE(read_curves, strokes, kStrokes);
BENCHMARK_CAPTURE(read_curves, long_line, kLongLine);
BENCHMARK(read_many_documents);
BENCHMARK_CAPTURE(append_numbers, two_places, Digits::kTwoPlaces);
BENCHMARK_CAPTURE(append_numbers, all, Digits::kAll);
BENCHMARK_CAPTURE(parse_path, two_places, Digits::kTwoPlaces);
BENCHMARK_CAPTURE(parse_path, all, Digits::kAll);

}  // namespace
}  // namespace libstyle
