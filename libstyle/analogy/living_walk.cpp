// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/living_walk.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

constexpr std::uint64_t kDecisions = std::uint64_t{1} << 24;  // places of what is not a step

class WalkChanger {
 public:
  WalkChanger(const ChainModel& model, const ChainTask& task, std::span<const ChainState> walk,
              const WalkChange& change, const RandomStream& random, std::uint64_t first_place)
      : model_(model),
        task_(task),
        change_(change),
        random_(random),
        first_place_(first_place),
        walk_(walk.begin(), walk.end()),
        uses_(model.state_count(), 0) {
    for (const ChainState state : walk_) ++uses_[state];
  }

  std::vector<ChainState> change() {
    std::uint64_t decision = first_place_ + kDecisions;
    // A closed walk is never drawn anew all round: something has to hold the ends of a piece.
    const std::size_t n = walk_.size();
    const std::size_t piece = change_.closed ? std::min(change_.piece, n / 2) : change_.piece;
    if (piece == 0) return walk_;
    const std::size_t phase = random_.below(decision++, piece);
    if (!change_.closed && phase > 0) consider(0, std::min(phase, n), decision++);
    const std::size_t end = change_.closed ? n + phase : n;
    for (std::size_t begin = phase; begin < end; begin += piece) {
      consider(begin, std::min(begin + piece, end), decision++);
    }
    return walk_;
  }

 private:
  ChainState& at(std::size_t step) { return walk_[step % walk_.size()]; }

  void consider(std::size_t begin, std::size_t end, std::uint64_t decision) {
    if (random_.uniform(decision) < change_.share) redraw(begin, end);
  }

  // Steps begin .. end - 1 anew; on a closed walk they may go on past the last.
  void redraw(std::size_t begin, std::size_t end) {
    const std::size_t n = walk_.size();
    const bool from_start = !change_.closed && begin == 0;
    const std::size_t first = from_start ? 0 : begin + n - 1;  // modulo n; the state before
    const std::size_t steps = end - begin + (from_start ? 0 : 1);
    std::vector<ChainState> old;
    for (std::size_t i = 0; i < steps; ++i) {
      old.push_back(at(first + i));
      --uses_[old.back()];
    }

    ChainTask task;
    task.steps = steps;
    if (task_.costs) {
      task.costs = [&](std::size_t step, std::span<double> costs) {
        return task_.costs((first + step) % n, costs);
      };
    }
    if (!from_start) task.origin = old.front();
    if (change_.closed || end < n) task.next = at(end);
    ChainVariety variety = change_.variety;
    variety.uses = uses_;
    if (!from_start) variety.run_before = run_before(first);
    const std::vector<ChainState> fresh =
        sample_chain(model_, task, random_, first_place_ + first % n, variety);
    put(first, fresh);
    if (task.next && runs_too_far(end)) {
      const std::size_t reached = run_through(end);
      put(first, old);
      if (run_through(end) >= reached) put(first, fresh);
    }
    for (std::size_t i = 0; i < steps; ++i) ++uses_[at(first + i)];
  }

  void put(std::size_t first, std::span<const ChainState> states) {
    for (std::size_t i = 0; i < states.size(); ++i) at(first + i) = states[i];
  }

  bool goes_on_at(std::size_t step) {
    const ChainState before = at(step + walk_.size() - 1);
    return model_.rows[before].coherent > 0 && at(step) == before + 1;
  }

  // How many steps lie in the run of a step before it, and after it.
  std::size_t run_before(std::size_t step) {
    std::size_t count = 0;
    const std::size_t most = change_.closed ? walk_.size() - 1 : step % walk_.size();
    while (count < most && goes_on_at(step + walk_.size() - count)) ++count;
    return count;
  }
  std::size_t run_after(std::size_t step) {
    std::size_t count = 0;
    const std::size_t most =
        change_.closed ? walk_.size() - 1 : walk_.size() - 1 - step % walk_.size();
    while (count < most && goes_on_at(step + count + 1)) ++count;
    return count;
  }

  // The steps of the run that leads on to a step; 0 if none does.
  std::size_t run_through(std::size_t step) {
    return goes_on_at(step) ? run_before(step) + 1 + run_after(step) : 0;
  }
  bool runs_too_far(std::size_t end) {
    const std::size_t longest = change_.variety.longest_run;
    return longest > 0 && run_through(end) > longest;
  }

  const ChainModel& model_;
  const ChainTask& task_;
  const WalkChange& change_;
  const RandomStream& random_;
  std::uint64_t first_place_;
  std::vector<ChainState> walk_;
  std::vector<int> uses_;
};

}  // namespace

std::vector<ChainState> changed_walk(const ChainModel& model, const ChainTask& task,
                                     std::span<const ChainState> walk, const WalkChange& change,
                                     const RandomStream& random, std::uint64_t first_place) {
  return WalkChanger(model, task, walk, change, random, first_place).change();
}

}  // namespace libstyle
