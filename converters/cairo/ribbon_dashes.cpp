// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/ribbon.h"

namespace libstyle {
namespace {

double length_of(const Ribbon& ribbon) {
  double length = 0;
  for (std::size_t i = 1; i < ribbon.points.size(); ++i) {
    length += distance(ribbon.points[i - 1].place, ribbon.points[i].place);
  }
  return length;
}

// Where in its pattern a line of dashes is.
class DashPhase {
 public:
  explicit DashPhase(const DashPattern& pattern)
      : lengths_(pattern.lengths), left_(lengths_[0] - pattern.offset) {
    while (left_ <= 0) {
      index_ = (index_ + 1) % lengths_.size();
      left_ += lengths_[index_];
    }
  }

  bool drawing() const { return index_ % 2 == 0; }
  double left() const { return left_; }
  void use(double length) { left_ -= length; }
  void next() {
    index_ = (index_ + 1) % lengths_.size();
    left_ = lengths_[index_];
  }

 private:
  const std::vector<double>& lengths_;
  std::size_t index_ = 0;
  double left_;
};

void cut_one(const Ribbon& ribbon, DashPhase phase, std::vector<Ribbon>& dashes) {
  if (phase.drawing()) dashes.push_back({{ribbon.points[0]}, false, {}, {}});
  for (std::size_t i = 1; i < ribbon.points.size(); ++i) {
    const RibbonPoint& from = ribbon.points[i - 1];
    const RibbonPoint& to = ribbon.points[i];
    const double length = distance(from.place, to.place);
    double done = 0;
    while (phase.left() < length - done) {
      done += phase.left();
      const RibbonPoint cut = lerp(from, to, done / length);
      if (phase.drawing()) dashes.back().points.push_back(cut);
      phase.next();
      if (phase.drawing()) dashes.push_back({{cut}, false, {}, {}});
    }
    phase.use(length - done);
    if (phase.drawing()) dashes.back().points.push_back(to);
  }
}

}  // namespace

std::vector<Ribbon> cut_dashes(std::vector<Ribbon> ribbons, const DashPattern& pattern) {
  if (pattern.lengths.empty()) return ribbons;
  double length = 0;
  for (const Ribbon& ribbon : ribbons) length += length_of(ribbon);
  if (pattern.pieces(length) > kMostDashes) return ribbons;
  std::vector<Ribbon> dashes;
  for (Ribbon& ribbon : ribbons) {
    if (ribbon.closed) ribbon.points.push_back(RibbonPoint(ribbon.points.front()));
    cut_one(ribbon, DashPhase(pattern), dashes);
  }
  return dashes;
}

}  // namespace libstyle
