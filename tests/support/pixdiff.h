// SPDX-License-Identifier: Apache-2.0
// Whether two pictures are the same to within a stated bound.
#pragma once

#include <string>

#include "tests/support/image.h"

namespace libstyle {

struct DiffBounds {
  int per_channel = 0;   // 0 .. 255; a pixel that differs by more is bad
  double bad_share = 0;  // of all pixels; more bad ones than this fail
  int hard_stop = 255;   // no pixel may differ by more
  // A pixel may lie anywhere between the least and the most of its 3x3 neighbours in the other
  // picture, and the other way round: edges may move by a pixel, areas may not change.
  bool envelope = false;
  std::size_t size_slack = 0;  // px; larger pictures by so much are cut at the right and bottom
};

struct DiffResult {
  bool same_size = false;
  std::size_t bad = 0;  // pixels
  double bad_share = 0;
  int largest = 0;  // difference of any channel
  bool passed = false;

  // One line for a report: "12 of 40000 pixels (0.030 %) differ, by at most 31".
  std::string summary;
};

DiffResult compare(const Raster& expected, const Raster& actual, const DiffBounds& bounds);

// Expected, difference and actual side by side on white. Bad pixels are red over a pale copy.
Raster three_panels(const Raster& expected, const Raster& actual, const DiffBounds& bounds);

}  // namespace libstyle
