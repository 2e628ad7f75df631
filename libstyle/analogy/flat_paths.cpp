// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/flat_paths.h"

#include <algorithm>
#include <map>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/junctions.h"

namespace libstyle {
namespace {

constexpr double kFlatness = 0.02;  // of a feature size: of what is drawn along
constexpr double kMeeting = 1e-3;   // of the drawing's diagonal: ends that near a line meet it

}  // namespace

FlatPath flatten_path(const Path& path, const CurveAnalogy& style) {
  const Box box = path.control_box();
  if (!(std::max(box.width(), box.height()) <= style.longest_curve())) return {{}, {}, true};
  FlatPath flat{flatten(path, kFlatness * style.example().feature_size()), {}, false};
  flat.held.resize(flat.subpaths.size());
  return flat;
}

void find_meetings(std::span<FlatPath> paths) {
  std::vector<Polyline> curves;
  std::vector<std::vector<double>*> held;
  Box box;
  for (FlatPath& path : paths) {
    for (std::size_t i = 0; i < path.subpaths.size(); ++i) {
      curves.push_back(path.subpaths[i].polyline);
      held.push_back(&path.held[i]);
      for (const Point p : curves.back().points) box.include(p);
    }
  }
  if (box.empty()) return;
  const double tolerance = kMeeting * distance(box.low, box.high);
  std::map<std::size_t, ArcLength> tables;
  for (const Junction& junction : find_junctions(curves, tolerance).junctions) {
    for (const JunctionMember& member : junction.members) {
      if (member.role != JunctionRole::kInterior) continue;
      const std::size_t curve = member.at.curve;
      const ArcLength& along = tables.try_emplace(curve, curves[curve]).first->second;
      held[curve]->push_back(along.length_to(member.at.place));
    }
  }
  for (std::vector<double>* lengths : held) std::ranges::sort(*lengths);
}

}  // namespace libstyle
