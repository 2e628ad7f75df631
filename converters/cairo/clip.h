// SPDX-License-Identifier: Apache-2.0
// Clips of the curves format on a Cairo context.
//
// Cairo can only intersect clips. A clip of one part is one of Cairo's; a union of parts is drawn
// as a mask over what was drawn inside the scope.
#pragma once

#include <string>
#include <vector>

#include "converters/cairo/canvas.h"

namespace libstyle {

// Restricts drawing to the clip called `id` (all clips it is within included) until end().
class ClipScope {
 public:
  // An id that names no clip restricts nothing, and is warned about on behalf of `user`.
  ClipScope(Canvas& canvas, const std::string& id, const RecordBase& user);

  // Draws what the scope held through its masks. A scope left by an exception is not ended: the
  // picture is given up then.
  void end();

 private:
  ClipScope(Canvas& canvas, const ClipRecord* clip);

  void begin(const ClipRecord* clip);
  void draw_through(const ClipRecord& clip);

  Canvas& canvas_;
  bool saved_ = false;
  std::vector<const ClipRecord*> masks_;  // outermost first; each has begun a Cairo group
};

}  // namespace libstyle
