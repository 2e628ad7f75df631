// SPDX-License-Identifier: Apache-2.0
// Documents as picture files: PNG and SVG hold one, PDF one a page.
//
// The bytes depend on the documents alone; there are no time stamps.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "converters/cairo/viewport.h"
#include "libstyle/base/bytes.h"
#include "libstyle/base/warning.h"

namespace libstyle {

enum class PictureFormat { kPng, kSvg, kPdf };

// The format that the ending of a file name stands for.
std::optional<PictureFormat> picture_format(std::string_view file_name);

struct PictureSettings {
  PictureFormat format = PictureFormat::kPng;
  PictureSize size;
  std::optional<Color> background;  // unset: none
};

class Picture {
 public:
  // The sink outlives the picture.
  Picture(ByteSink& sink, const PictureSettings& settings, WarningHandler warn);
  ~Picture();

  // Draws a document; `file` is where messages say it comes from. Throws Error when it cannot be
  // drawn, which then leaves no trace, or when the picture is full.
  void add(const Document& document, const std::string& file = "");

  // Writes what is left. A picture without it is not whole.
  void finish();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace libstyle
