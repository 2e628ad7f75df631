// SPDX-License-Identifier: Apache-2.0
// Drawing by librsvg, for what needs fonts. The only file that knows librsvg.
//
// The library is opened when the first text is met, not linked: with all that it brings along
// (Pango, GLib, fontconfig) it would add 6 ms to every start of every program that reads SVG.
#pragma once

#include <string>
#include <string_view>

namespace libstyle::svg {

// Draws an SVG file on a page of `size` px by `size` px and returns that page as SVG: all that was
// drawn has become paths, in px. Opens no file that the text refers to. Throws Error when librsvg
// cannot be loaded or cannot draw the text.
std::string redraw_by_librsvg(std::string_view text, double size);

}  // namespace libstyle::svg
