// SPDX-License-Identifier: Apache-2.0
// Curves for tests: from text, of known shape, and random ones of several kinds.
#pragma once

#include <cstddef>
#include <string_view>

#include "libstyle/geometry/polyline.h"
#include "tests/support/seeds.h"

namespace libstyle {

// "0 0, 1 2, 3 4": points; a final "z" closes the polyline.
Polyline polyline(std::string_view text);

// Points on an arc of a circle, `from` to `to` in radians, ends included.
Polyline arc(Point center, double radius, double from, double to, std::size_t count);

// The whole circle, closed.
Polyline circle(Point center, double radius, std::size_t count);

// A smooth hand's stroke: direction and curvature wander; `count` points, unevenly spaced about 1.
Polyline random_stroke(RandomValues& random, std::size_t count);

// Points strewn in a square of the given side, joined in order: as wild as can be.
Polyline random_scribble(RandomValues& random, std::size_t count, double side);

// A closed simple outline round the origin, radius about 10.
Polyline random_blob(RandomValues& random, std::size_t count);

// The same with integer coordinates 0 .. side - 1, so that exact contacts are common.
Polyline random_lattice_walk(RandomValues& random, std::size_t count, std::size_t side);

// Every point moved by a normal deviate in x and y.
Polyline with_noise(Polyline curve, RandomValues& random, double deviation);

}  // namespace libstyle
