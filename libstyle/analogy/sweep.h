// SPDX-License-Identifier: Apache-2.0
// The sweep of a curve: where it goes on the whole, without its detail, and in which direction.
//
// Pieces of a style are held relative to the sweep: an offset from a place, in a frame whose x axis
// points along the curve there. The frame comes from the curve blurred by about a feature size, so
// that detail does not shake it.
#pragma once

#include <vector>

#include "libstyle/analogy/parameters.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// Turns +x to the unit vector `direction`, and back.
inline Vector to_page(Vector in_frame, Vector direction) {
  return {direction.x * in_frame.x - direction.y * in_frame.y,
          direction.y * in_frame.x + direction.x * in_frame.y};
}
inline Vector to_frame(Vector on_page, Vector direction) {
  return to_page(on_page, {direction.x, -direction.y});
}

class Sweep {
 public:
  // `curve` has a length. Its places lie on the curve blurred by `smoothing` and its frames on the
  // curve blurred by `frame_blur`, both standard deviations in arc length, >= 0.
  Sweep(const Polyline& curve, double smoothing, double frame_blur, Invariance invariance);

  // Lengths are those of the curve as it was given. Beyond the ends of an open curve the nearer end
  // is meant; a closed curve goes round.
  double length() const { return along_.total(); }
  bool closed() const { return along_.polyline().closed; }
  Point point_at(double length) const;
  // The same place on the curve blurred by `blur` (standard deviation in arc length, >= 0) there.
  Point point_at(double length, double blur) const;
  // The direction of the frame: {1, 0} everywhere under Invariance::kTranslate.
  Vector frame_at(double length) const;
  // The direction of the blurred curve itself.
  Vector direction_at(double length) const;

 private:
  ArcLength along_;  // the curve, cut finely enough for the blur to show
  Polyline places_;  // its vertices after smoothing
  std::vector<Vector> directions_;
  Invariance invariance_;
};

}  // namespace libstyle
