// SPDX-License-Identifier: Apache-2.0
// Makes a curve at one level of the pyramid, vertex by vertex, each the best that the example has.
//
// Source: SYNTHESIZECURVE, SYNTHESIZEANALOGY and REFINEANALOGY, sections 3.1 to 3.3 of the paper.
// For the vertex at t every place s_j of the example is a candidate. Its neighborhood is laid over
// what is known around the vertex (one rotation for all curves, a translation for each), which
// gives a position p_j = sum w q / sum w m over the virtual constraints
//     w_new |p - (R a'_j + t')|^2             the copied position
//     w_OFF |m p - r|^2                       the offset from each source, r = mean b
//                                             + R (mean a' - mean a) - what b' weighs already
//     w_c |p - q_c|^2                         constraints
// and a cost: what is left of these, plus the shape distances, times 1 + kappa / D if the candidate
// does not continue a piece that is being copied. The cheapest wins; where randomness is wanted,
// one of those within (1 + epsilon) best + floor does. Candidates that cannot win are screened out
// (screen.h), which changes no result.
//
// m is the share of one sample in the weight of the neighborhood, as printed. The share that really
// moves with a vertex is larger, but then one vertex makes up for the offset of its whole
// neighborhood, and curves blow up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/greedy/level_example.h"
#include "libstyle/analogy/greedy/search_parameters.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

inline constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();

// B' at a level, with what was copied where.
struct DrawnLevel {
  SampledCurve curve;
  std::vector<std::size_t> sources;  // S(i), places of the example; kNoPlace: not yet known
  std::vector<Vector> rotations;     // R of each vertex
};

struct LevelTask {
  std::vector<SampledCurve> targets;         // B_l, B'_(l-1): one for each source of the example
  std::vector<CurveConstraint> constraints;  // with the weights of this level
  double offset_weight = 0;
  double epsilon = 0;
};

class LevelSearch {
 public:
  // `example` and `parameters` outlive the search.
  LevelSearch(const LevelExample& example, LevelTask task, const SearchParameters& parameters);

  // A curve along the first target, from its beginning.
  DrawnLevel grow_along_target(const RandomStream& random);

  // A curve without a target. Without constraints it begins anywhere and ends when it is `length`
  // long. With constraints it grows from the first both ways, and t = 0 .. 1 stands for `length`.
  DrawnLevel grow_freely(double length, const RandomStream& random);

  // Chooses every vertex again, the others as they are, in order or in reverse.
  void refine(DrawnLevel& drawn, bool backward, const RandomStream& random);

  // What a vertex costs with its position and source as they are, without the coherence factor.
  double cost_of(const DrawnLevel& drawn, std::size_t vertex);

 private:
  // A vertex that is there already, next to the one that is chosen.
  struct Neighbor {
    Point position;
    std::size_t source = kNoPlace;
    bool before = true;  // along the curve
  };

  struct Query {
    double t = 0;
    bool ends_allowed = true;  // whether copies may begin where the example ends soon
    bool backward = false;
    std::size_t source = kNoPlace;  // where the vertex came from so far
    std::vector<Neighbor> neighbors;
  };

  struct Candidate {
    std::size_t place = kNoPlace;
    double cost = std::numeric_limits<double>::infinity();
    Point position;
    Vector rotation = {1, 0};
  };

  struct VirtualConstraint {
    double weight = 0;
    double share = 1;
    Point target;
  };

  struct GrowthStep {
    double t = 0;
    double gap = 0;  // expected length from the vertex before
    bool ends_allowed = false;
  };

  void grow(DrawnLevel& drawn, const GrowthStep& step, bool backward, const RandomStream& random);
  DrawnLevel begin_freely(double length, const RandomStream& random) const;
  void grow_to_length(DrawnLevel& drawn, double length, const RandomStream& random);
  void grow_to_end(DrawnLevel& drawn, double length, bool backward, const RandomStream& random);

  void sample_targets(double t);
  void set_neighbors(Query& query, const DrawnLevel& drawn, std::size_t vertex,
                     bool backward) const;
  Candidate choose(const Query& query, const RandomStream& random, std::uint64_t place);
  void score_guesses(const Query& query);
  void score_likely(const Query& query);
  void score(const Query& query, std::size_t j);
  bool can_be_compared(std::size_t j) const;
  double limit() const { return best_ * (1 + task_.epsilon) + example_.floor(); }

  Candidate evaluate(const Query& query, std::size_t j, double limit,
                     const Point* fixed = nullptr) const;
  void collect_constraints(double t);
  bool could_be_coherent(const Query& query, std::size_t j, double reach) const;
  bool is_coherent(const Query& query, std::size_t j, Point p) const;
  double reach_of_copies(const Query& query) const;

  const LevelExample& example_;
  const SearchParameters& parameters_;
  LevelTask task_;
  double penalty_;

  // What is known around the vertex at hand.
  Neighborhood drawn_;
  std::vector<Neighborhood> targets_;
  std::vector<NeighborhoodView> screened_;
  std::vector<VirtualConstraint> real_constraints_;
  const Point* hard_position_ = nullptr;

  // The choice at hand.
  ScreenedPlaces screened_places_;
  std::vector<Candidate> scored_;
  std::vector<std::uint8_t> is_scored_;
  double best_ = 0;
};

}  // namespace libstyle
