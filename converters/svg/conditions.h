// SPDX-License-Identifier: Apache-2.0
// The tests by which switch chooses (SVG 1.1, section 5.8.5).
#pragma once

#include <pugixml.hpp>

namespace libstyle::svg {

// Whether requiredExtensions, requiredFeatures and systemLanguage of an element, where it has them,
// are met by a program that draws static pictures, knows no extensions and speaks no language: what
// rsvg-convert is in the C locale.
bool conditions_hold(pugi::xml_node element);

}  // namespace libstyle::svg
