// SPDX-License-Identifier: Apache-2.0
// An example of a style for tests, curves to draw in it, and what tests ask of the result.
#pragma once

#include <cstdint>

#include "libstyle/analogy/example.h"
#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/rigid_alignment.h"

namespace libstyle {

// A wave whose size and pace wander, over a straight line.
Polyline wandering_wave(std::uint64_t seed, double length);

// The wave over a line of 600 px.
ExamplePair wavy_pair();

// A sine of 20 px a wave, 5 px high, over a line of that length.
ExamplePair wave_pair(double length, double phase = 0);

// An open curve that bends both ways, 600 px from end to end, and a smooth closed one.
Polyline s_curve();
Polyline egg();

Polyline transformed(Polyline curve, const RigidTransform& transform);
ExamplePair transformed(ExamplePair pair, const RigidTransform& transform);

// From the nearest place of the curve.
double distance_from(const Polyline& curve, Point p);

}  // namespace libstyle
