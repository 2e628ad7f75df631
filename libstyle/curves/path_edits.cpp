// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/path_edits.h"

#include <string>
#include <unordered_set>

#include "libstyle/base/error.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {
namespace {

// --- Splitting ----------------------------------------------------------------------------------

std::vector<Path> split(const Path& path) {
  std::vector<Path> pieces;
  const Point* next = path.points().data();
  for (const PathCommand command : path.commands()) {
    if (command == PathCommand::kMove) pieces.emplace_back();
    pieces.back().append(command, {next, point_count(command)});
    next += point_count(command);
  }
  return pieces;
}

template <typename Value>
std::vector<Value> part_of(const std::vector<Value>& values, std::size_t first, std::size_t count) {
  if (values.empty()) return {};
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

AlongValues part_of(const AlongValues& along, std::size_t first, std::size_t count) {
  AlongValues part;
  for (const Channel& channel : along.channels) {
    part.channels.push_back({channel.name, part_of(channel.values, first, count)});
  }
  part.colors = part_of(along.colors, first, count);
  part.extras = along.extras;
  return part;
}

class IdNumbers {
 public:
  explicit IdNumbers(const Document& document) {
    for (const Record& record : document.records) {
      const RecordBase* base = base_of(record);
      if (base && !base->id.empty()) taken_.insert(base->id);
    }
  }

  // `id` with the next number that is free, from `number` up.
  std::string make(const std::string& id, std::size_t& number) {
    if (id.empty()) return {};
    while (true) {
      std::string made = id + '~' + std::to_string(number++);
      if (taken_.insert(made).second) return made;
    }
  }

 private:
  std::unordered_set<std::string> taken_;
};

void append_pieces(Records& records, PathRecord whole, IdNumbers& ids) {
  std::vector<Path> pieces = split(whole.path);
  if (pieces.size() < 2) {
    records.emplace_back(std::move(whole));
    return;
  }
  std::size_t vertex = 0, number = 2;
  for (Path& path : pieces) {
    const std::size_t vertices = path.vertex_count();
    PathRecord piece = whole;
    if (vertex > 0) piece.id = ids.make(whole.id, number);
    piece.path = std::move(path);
    piece.along = part_of(whole.along, vertex, vertices);
    records.emplace_back(std::move(piece));
    vertex += vertices;
  }
}

// --- Flattening ---------------------------------------------------------------------------------

struct FlatPath {
  Path path;
  std::vector<PathPlace> places;  // one for each vertex
};

FlatPath to_flat(const Path& path, double tolerance) {
  FlatPath flat;
  for (const FlattenedSubpath& subpath : flatten(path, tolerance)) {
    flat.path.append(to_path(subpath.polyline));
    flat.places.insert(flat.places.end(), subpath.places.begin(), subpath.places.end());
  }
  return flat;
}

void flatten_record(PathRecord& record, double tolerance) {
  FlatPath flat = to_flat(record.path, tolerance);
  for (Channel& channel : record.along.channels) {
    channel.values = values_along(flat.places, channel.values);
  }
  if (!record.along.colors.empty()) {
    record.along.colors = map_channels(record.along.colors, [&](std::span<const double> values) {
      return values_along(flat.places, values);
    });
  }
  record.path = std::move(flat.path);
}

}  // namespace

void split_subpaths(Document& document) {
  IdNumbers ids(document);
  Records records;
  for (Record& record : document.records) {
    if (auto* path = std::get_if<PathRecord>(&record)) {
      append_pieces(records, std::move(*path), ids);
    } else {
      records.push_back(std::move(record));
    }
  }
  document.records = std::move(records);
}

void flatten_paths(Document& document, double tolerance, const std::string& file) {
  for (Record& record : document.records) {
    const RecordBase* base = base_of(record);
    at_place({file, base ? base->line : 0}, [&] {
      if (auto* path = std::get_if<PathRecord>(&record)) flatten_record(*path, tolerance);
      if (auto* clip = std::get_if<ClipRecord>(&record)) {
        for (ClipPart& part : clip->parts) part.path = to_flat(part.path, tolerance).path;
      }
    });
  }
}

}  // namespace libstyle
