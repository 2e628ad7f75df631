// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/detail_transfer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace libstyle {
namespace {

// A place of an example curve, as lengths along it at both levels.
struct Trace {
  std::size_t curve = 0;
  double coarse = 0;
};

// Both levels of the example, place for place.
class Levels {
 public:
  Levels(const LevelExample& coarse, const LevelExample& fine) : coarse_(coarse), fine_(fine) {}

  // The length along the fine curve where the coarse one has this length.
  double fine_length(Trace at) const {
    return fine_.curve(at.curve).length_to(
        place_at_parameter(fine_.sampled_curve(at.curve), parameter(at)));
  }

  // A'_l(s) - A'_(l-1)(s)
  Vector detail(Trace at) const {
    return point_at_parameter(fine_.sampled_curve(at.curve), parameter(at)) -
           coarse_.curve(at.curve).point_at(at.coarse);
  }

  std::size_t fine_place(Trace at) const { return fine_.place_near(at.curve, fine_length(at)); }

  Trace trace(std::size_t coarse_place) const {
    return {coarse_.curve_of(coarse_place), coarse_.length_of(coarse_place)};
  }

  // The length of the fine curve over that of the coarse one, from a place on.
  double fine_span(Trace from, double coarse_length) const {
    const Trace to{from.curve, from.coarse + coarse_length};
    const double span = fine_length(to) - fine_length(from);
    const ArcLength& along = fine_.curve(from.curve);
    return along.polyline().closed && span < 0 ? span + along.total() : span;
  }

 private:
  double parameter(Trace at) const {
    const SampledCurve& curve = coarse_.sampled_curve(at.curve);
    const PolylinePlace place = coarse_.curve(at.curve).place_at(at.coarse);
    const std::size_t end = segment_end_index(curve.polyline, place.segment);
    const double t_end = curve.t[end] + (end == 0 ? 1 : 0);
    return std::lerp(curve.t[place.segment], t_end, place.fraction);
  }

  const LevelExample& coarse_;
  const LevelExample& fine_;
};

// One segment of the coarse drawn curve with the pieces that are copied along it: the same one, if
// they continue each other.
struct Piece {
  Point start, end;
  double t_start = 0, t_end = 0;
  Vector rotation_start, rotation_end;
  Trace from_start;   // runs on from the first vertex
  Trace to_end;       // where the piece of the last vertex is, at the first
  double copied = 0;  // length on the coarse example
  double length = 0;  // of the fine curve to be

  Trace start_trace(double u) const { return {from_start.curve, from_start.coarse + u * copied}; }
  Trace end_trace(double u) const { return {to_end.curve, to_end.coarse + u * copied}; }
};

Piece make_piece(const Levels& levels, const LevelExample& coarse, const DrawnLevel& drawn,
                 std::size_t segment) {
  const Polyline& line = drawn.curve.polyline;
  const std::size_t next = segment_end_index(line, segment);
  Piece piece;
  piece.start = line.points[segment];
  piece.end = line.points[next];
  piece.t_start = drawn.curve.t[segment];
  piece.t_end = drawn.curve.t[next] + (next == 0 ? 1 : 0);
  piece.rotation_start = drawn.rotations[segment];
  piece.rotation_end = drawn.rotations[next];
  piece.from_start = levels.trace(drawn.sources[segment]);
  const double chord = distance(piece.start, piece.end);
  const auto copied = coarse.copied_length(drawn.sources[segment], drawn.sources[next], chord);
  piece.copied = copied.value_or(chord);
  if (copied) {
    piece.to_end = piece.from_start;
  } else {
    piece.to_end = levels.trace(drawn.sources[next]);
    piece.to_end.coarse -= piece.copied;
  }
  // Detail adds length; where an example ends there is none to add.
  piece.length = std::max({chord, levels.fine_span(piece.from_start, piece.copied),
                           levels.fine_span(piece.to_end, piece.copied)});
  return piece;
}

// Lengths of the vertices to be, evenly between those at the ends and at the parameters kept.
struct Stop {
  double length = 0;
  double t = 0;
};

std::vector<Stop> find_stops(const std::vector<Piece>& pieces, std::span<const double> kept,
                             double total) {
  std::vector<Stop> stops = {{0, pieces.front().t_start}};
  std::vector<double> sorted(kept.begin(), kept.end());
  std::ranges::sort(sorted);
  double before = 0;
  std::size_t next = 0;
  for (const Piece& piece : pieces) {
    for (; next < sorted.size() && sorted[next] <= piece.t_end; ++next) {
      const double span = piece.t_end - piece.t_start;
      const double u = span > 0 ? (sorted[next] - piece.t_start) / span : 0;
      if (sorted[next] > stops.back().t) {
        stops.push_back({before + std::max(0.0, u) * piece.length, sorted[next]});
      }
    }
    before += piece.length;
  }
  if (pieces.back().t_end > stops.back().t) stops.push_back({total, pieces.back().t_end});
  return stops;
}

void append(DrawnLevel& fine, const Levels& levels, const Piece& piece, double u, double t) {
  const Trace first = piece.start_trace(u), second = piece.end_trace(u);
  const Vector from_start = turn(piece.rotation_start, levels.detail(first));
  const Vector from_end = turn(piece.rotation_end, levels.detail(second));
  fine.curve.polyline.points.push_back(lerp(piece.start, piece.end, u) +
                                       lerp(from_start, from_end, u));
  fine.curve.t.push_back(t);
  fine.sources.push_back(levels.fine_place(u < 0.5 ? first : second));
  fine.rotations.push_back(u < 0.5 ? piece.rotation_start : piece.rotation_end);
}

}  // namespace

DrawnLevel transfer_detail(const LevelExample& coarse, const LevelExample& fine,
                           const DrawnLevel& drawn, std::span<const double> kept) {
  const Levels levels(coarse, fine);
  std::vector<Piece> pieces;
  std::vector<double> begins = {0};
  for (std::size_t i = 0; i < segment_count(drawn.curve.polyline); ++i) {
    pieces.push_back(make_piece(levels, coarse, drawn, i));
    begins.push_back(begins.back() + pieces.back().length);
  }
  const std::vector<Stop> stops = find_stops(pieces, kept, begins.back());

  DrawnLevel result;
  result.curve.polyline.closed = drawn.curve.polyline.closed;
  std::size_t i = 0;
  const auto add = [&](double length, const double* t) {
    while (i + 1 < pieces.size() && begins[i + 1] < length) ++i;
    const double size = pieces[i].length;
    const double u = size > 0 ? std::clamp((length - begins[i]) / size, 0.0, 1.0) : 0;
    append(result, levels, pieces[i], u, t ? *t : std::lerp(pieces[i].t_start, pieces[i].t_end, u));
  };
  for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
    const double span = stops[k + 1].length - stops[k].length;
    const double parts = std::max(1.0, std::round(span / fine.spacing()));
    add(stops[k].length, &stops[k].t);
    for (double part = 1; part < parts; ++part) {
      add(stops[k].length + span * part / parts, nullptr);
    }
  }
  if (!drawn.curve.polyline.closed) add(stops.back().length, &stops.back().t);
  return result;
}

}  // namespace libstyle
