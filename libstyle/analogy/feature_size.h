// SPDX-License-Identifier: Apache-2.0
// How large the features of an example are, found from the example.
#pragma once

#include <optional>
#include <span>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// The smallest Gaussian that takes 90 % of the extra length out of the filtered curves: extra to
// their plain length, which is that of the unfiltered curves, if there are any and they are at
// least 5 % shorter, or what a blur by an eighth of the length leaves. About half the diameter of
// loops and just under half the wavelength of a wiggle. The result lies between the length over 600
// and over 12, all curves taken together; it is the latter for lines without any extra length. The
// curves have a length.
double find_feature_size(std::span<const Polyline> filtered,
                         std::optional<double> unfiltered_length);

}  // namespace libstyle
