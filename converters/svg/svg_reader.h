// SPDX-License-Identifier: Apache-2.0
// Reads an SVG file as one document of curves: everything that is drawn as lines and areas, with
// its geometry and paint resolved, in the order it is painted.
//
// The stages, each in a file of its own name:
// 1. xml: bytes to a tree with canonical names; entities and encodings are dealt with here.
// 2. file_index: ids and style sheets, wherever they stand.
// 3. walker: goes through the tree as it is drawn (groups, use, symbol, nested svg, switch), and
// for
//    each element asks
//    - cascade: what its properties are (style_sheet, selector, property),
//    - element_path: what its path is (path_grammar, shapes, length),
//    - text_outlines: what the paths of a text are (text_content, librsvg).
// 4. document_canvas: what the walk comes to, brought to the page with its paint (painter, stroke,
//    gradients), its clips (clip_paths) and its markers.
// 5. document_builder: the records.
//
// Carried: svg, g, a, switch, use, symbol, the basic shapes, path and text; transforms, viewBox,
// every unit; style sheets; fill and stroke in full; gradients; markers; opacity; clip-path; ids,
// classes, layers, labels and data-* attributes; what curves2svg carries along. What is hidden
// stays, as hidden. Not carried, with one warning for each element: images, foreignObject,
// filters, masks, patterns, animation, scripts.
//
// Nothing outside the text is ever opened. Depth, repetition and size are limited (SvgLimits).
#pragma once

#include <cstddef>
#include <string>

#include "converters/svg/xml.h"
#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle::svg {

struct SvgLimits {
  XmlLimits xml;
  // Elements gone through by way of `use`, drawn or not: a small file can ask for any number.
  std::size_t used_elements = 500'000;
  // Elements looked at to match style sheets; a few seconds.
  std::size_t match_steps = 30'000'000;
  // Text beyond these is left out with a warning. Characters between two tags: the time for them
  // goes with the square.
  std::size_t text_length = 5'000;
  // Characters of all texts together, and 16 for each node: half a minute.
  std::size_t text_work = 500'000;
  // Points of all paths together, 16 bytes each.
  std::size_t points = std::size_t{32} << 20;
};

struct SvgReadOptions {
  SvgLimits limits;
  std::string style_sheet;  // CSS that comes after the file's own style sheets
};

// `name` is how messages call the text; naming the document is left to the caller.
// Throws Error with file and line when the text is no SVG or passes a limit.
Document read_svg(std::string text, const std::string& name, const SvgReadOptions& options,
                  const WarningHandler& warn);

}  // namespace libstyle::svg
