// SPDX-License-Identifier: Apache-2.0
// The tests by which switch chooses (SVG 1.1, section 5.8.5).
#pragma once

#include <pugixml.hpp>

namespace libstyle::svg {

// Whether requiredExtensions, requiredFeatures and systemLanguage of an element, where it has them,
// are met by a program that speaks English, draws static pictures and knows no extensions.
bool conditions_hold(pugi::xml_node element);

}  // namespace libstyle::svg
