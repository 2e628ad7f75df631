// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/match_level.h"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>

#include "libstyle/base/random.h"
#include "libstyle/base/wavefront.h"
#include "libstyle/image/lanes.h"

namespace libstyle::image {
namespace {

constexpr std::size_t kComparedPlaces = 8;  // of those near in the projection, held against exactly

struct Offset {
  int dx;
  int dy;
};

struct Match {
  PixelIndex place = -1;
  float distance = std::numeric_limits<float>::max();
};

// The pixels of a window that may have been made, the nearest first.
std::vector<Offset> neighbors(int radius, bool is_first) {
  std::vector<Offset> result;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const bool before = dy < 0 || (dy == 0 && dx < 0);
      if (before || (!is_first && (dx != 0 || dy != 0))) result.push_back({dx, dy});
    }
  }
  std::ranges::stable_sort(result, {}, [](Offset o) { return o.dx * o.dx + o.dy * o.dy; });
  return result;
}

// A pixel of the target on its way through BESTMATCH.
class PixelMatcher {
 public:
  PixelMatcher(Level& level, const MatchPass& pass, const MatchSettings& settings,
               SourceIndices& sources)
      : level_(level),
        pass_(pass),
        settings_(settings),
        sources_(sources),
        neighbors_(neighbors(pass.neighborhood.fine.radius, pass.is_first)),
        example_rows_(example_rows(level, pass.coarser)),
        target_rows_{level.target.row_floats(),
                     pass.coarser.level ? pass.coarser.level->target.row_floats() : 0},
        random_(settings.seed, settings.pass) {}

  // Returns whether the coherent match was taken.
  bool match(int x, int y) {
    const Query query = query_at(x, y);
    const Match coherent = best_coherent(query);
    const double limit = coherent.place < 0 ? std::numeric_limits<float>::max()
                                            : coherent.distance / (1 + settings_.coherence);
    const Match other = knows_nothing(query) ? drawn_at_random(query)
                                             : best_approximate(query, static_cast<float>(limit));
    const bool takes_coherent =
        coherent.place >= 0 && (other.place < 0 || !(other.distance < limit));
    const PixelIndex place = takes_coherent ? coherent.place : other.place;
    sources_[std::size_t(y) * level_.target.width() + x] = place;
    level_.copy(place, level_.target.index(x, y));
    return takes_coherent;
  }

 private:
  struct Query {
    int x;
    int y;
    Windows windows;
    bool is_whole;  // nothing of its windows lies outside of the target
    const Neighborhood* counts;
    Neighborhood clipped;
  };

  Query query_at(int x, int y) const {
    const Neighborhood& all = pass_.neighborhood;
    const FeaturePlane& target = level_.target;
    Query query{x, y, {target.window(target.index(x, y), all.fine.radius)}, true, &all, {}};
    query.is_whole = !reaches_over(target, all.fine, x, y);
    const Level* coarser = pass_.coarser.level;
    if (coarser) {
      const FeaturePlane& coarse = coarser->target;
      query.windows.coarse = coarse.window(coarse.index(x / 2, y / 2), all.coarse.radius);
      query.is_whole = query.is_whole && !reaches_over(coarse, all.coarse, x / 2, y / 2);
    }
    if (!query.is_whole) {
      query.clipped.fine = clipped_to(target, all.fine, x, y);
      if (coarser) query.clipped.coarse = clipped_to(coarser->target, all.coarse, x / 2, y / 2);
    }
    return query;
  }

  static const Neighborhood& counts(const Query& query) {
    return query.is_whole ? *query.counts : query.clipped;
  }

  float distance(const Query& query, PixelIndex place, float limit) const {
    return neighborhood_distance(counts(query), query.windows, target_rows_,
                                 example_windows(level_, pass_.neighborhood, pass_.coarser, place),
                                 example_rows_, limit);
  }

  void compare(const Query& query, PixelIndex place, Match& best) const {
    const float d = distance(query, place, best.distance);
    if (d < best.distance) best = {place, d};
  }

  Match best_coherent(const Query& query) const {
    const int width = level_.target.width();
    const int height = level_.target.height();
    const int stride = level_.examples.stride();
    // Neighbours mostly agree, so few places are different from each other.
    std::array<PixelIndex, 32> seen;
    std::size_t count = 0;
    Match best;
    for (const Offset offset : neighbors_) {
      const int x = query.x + offset.dx;
      const int y = query.y + offset.dy;
      if (x < 0 || x >= width || y < 0 || y >= height) continue;
      const PixelIndex place =
          sources_[std::size_t(y) * width + x] - offset.dy * stride - offset.dx;
      if (!level_.is_place[place]) continue;
      if (std::find(seen.begin(), seen.begin() + count, place) != seen.begin() + count) continue;
      if (count < seen.size()) seen[count++] = place;
      compare(query, place, best);
    }
    return best;
  }

  // The best that is nearer than the limit, if there is one.
  Match best_approximate(const Query& query, float limit) const {
    Match best{-1, limit};
    if (!pass_.index) {
      for (const PixelIndex place : level_.places) compare(query, place, best);
      return best;
    }
    compare_coarse_source(query, best);
    // What lies outside of the target counts in the projection, but not in the distance: there the
    // one is no bound of the other.
    std::array<NearPlace, kComparedPlaces> found;
    const std::size_t count = pass_.index->nearest(
        query.windows, target_rows_,
        query.is_whole ? best.distance : std::numeric_limits<float>::max(), found);
    for (std::size_t i = 0; i < count; ++i) {
      if (query.is_whole && found[i].distance >= best.distance) break;
      compare(query, found[i].place, best);
    }
    return best;
  }

  // The four pixels that the coarser level's pixel stands for lie where its source's do.
  void compare_coarse_source(const Query& query, Match& best) const {
    const Level* coarser = pass_.coarser.level;
    if (!coarser) return;
    const PixelIndex source =
        (*pass_.coarser.sources)[std::size_t(query.y / 2) * coarser->target.width() + query.x / 2];
    const int example = coarser->example_of(source);
    const ExampleFrame& frame = level_.frames[example];
    const int x = 2 * coarser->examples.column(source) + query.x % 2;
    const int y =
        2 * (coarser->examples.row(source) - coarser->frames[example].first_row) + query.y % 2;
    if (x < frame.width && y < frame.height) compare(query, level_.place(example, x, y), best);
  }

  bool knows_nothing(const Query& query) const {
    const auto is_zero = [](float weight) { return weight == 0; };
    if (query.is_whole) return false;
    return std::ranges::all_of(query.clipped.fine.weights, is_zero) &&
           std::ranges::all_of(query.clipped.coarse.weights, is_zero);
  }

  Match drawn_at_random(const Query& query) const {
    const auto number = static_cast<std::uint64_t>(query.y) * level_.target.width() + query.x;
    return {level_.places[random_.below(number, level_.places.size())], 0};
  }

  Level& level_;
  const MatchPass& pass_;
  const MatchSettings& settings_;
  SourceIndices& sources_;
  const std::vector<Offset> neighbors_;
  const RowSteps example_rows_;
  const RowSteps target_rows_;
  const RandomStream random_;
};

}  // namespace

Windows example_windows(const Level& level, const Neighborhood& neighborhood,
                        const CoarserLevel& coarser, PixelIndex place) {
  Windows windows{level.examples.window(place, neighborhood.fine.radius)};
  if (coarser.level) {
    windows.coarse =
        coarser.level->examples.window(coarser.places[place], neighborhood.coarse.radius);
  }
  return windows;
}

RowSteps example_rows(const Level& level, const CoarserLevel& coarser) {
  return {level.examples.row_floats(), coarser.level ? coarser.level->examples.row_floats() : 0};
}

MatchCounts match_level(Level& level, const MatchPass& pass, const MatchSettings& settings,
                        SourceIndices& sources) {
  const int width = level.target.width();
  const int height = level.target.height();
  sources.resize(std::size_t(width) * height);
  PixelMatcher matcher(level, pass, settings, sources);
  std::mutex mutex;
  MatchCounts counts{sources.size(), 0};
  // A window reads a whole number of lanes, and so up to three pixels beyond its last. A later pass
  // reads pixels below it too: rows at this distance have not come there yet.
  const int reach = pass.neighborhood.fine.radius + kLanes - 1;
  wavefront(height, width, reach, settings.threads, [&](int y, int begin, int end) {
    std::size_t coherent = 0;
    for (int x = begin; x < end; ++x) coherent += matcher.match(x, y);
    const std::lock_guard lock(mutex);
    counts.coherent += coherent;
    if (pass.progress) pass.progress(static_cast<std::size_t>(end - begin));
  });
  return counts;
}

}  // namespace libstyle::image
