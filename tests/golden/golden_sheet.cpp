// SPDX-License-Identifier: Apache-2.0
// golden_sheet OUTPUT.png: all golden pictures on one sheet, for the human eye.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "converters/cairo/handles.h"
#include "converters/cairo/png.h"
#include "converters/common/files.h"

namespace libstyle {
namespace {

constexpr int kColumns = 8;
constexpr int kPicture = 200;  // px
constexpr int kGap = 10;
constexpr int kCaption = 18;
constexpr int kCell = kPicture + kGap;
constexpr int kRow = kPicture + kCaption + kGap;

std::vector<std::filesystem::path> golden_pictures() {
  std::vector<std::filesystem::path> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(GOLDEN_FOLDER)) {
    if (entry.path().extension() == ".png") names.push_back(entry.path());
  }
  std::ranges::sort(names);
  return names;
}

void draw_cell(cairo_t* context, const std::filesystem::path& name, int x, int y) {
  const CairoSurface picture(cairo_image_surface_create_from_png(name.c_str()));
  cairo_set_source_surface(context, picture.get(), x, y + kCaption);
  cairo_paint(context);
  cairo_set_source_rgb(context, 0, 0, 0);
  cairo_move_to(context, x, y + kCaption - 5);
  const auto caption = std::filesystem::relative(name, GOLDEN_FOLDER).replace_extension();
  cairo_show_text(context, caption.c_str());
}

CairoSurface make_sheet(const std::vector<std::filesystem::path>& names) {
  const int rows = (static_cast<int>(names.size()) + kColumns - 1) / kColumns;
  CairoSurface sheet(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, kColumns * kCell + kGap,
                                                std::max(1, rows) * kRow + kGap));
  const CairoContext context(cairo_create(sheet.get()));
  cairo_set_source_rgb(context.get(), 0.93, 0.93, 0.93);
  cairo_paint(context.get());
  cairo_select_font_face(context.get(), "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context.get(), 12);
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    draw_cell(context.get(), names[static_cast<std::size_t>(i)], kGap + i % kColumns * kCell,
              kGap + i / kColumns * kRow);
  }
  check_cairo(cairo_status(context.get()), "drawing the sheet");
  return sheet;
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "golden_sheet: name the output\n";
    return 2;
  }
  try {
    const auto sheet = libstyle::make_sheet(libstyle::golden_pictures());
    libstyle::OutputFile output(argv[1]);
    libstyle::write_png(output, sheet.get());
    output.commit();
  } catch (const std::exception& error) {
    std::cerr << "golden_sheet: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
