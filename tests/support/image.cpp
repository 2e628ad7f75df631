// SPDX-License-Identifier: Apache-2.0
#include "tests/support/image.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "converters/cairo/handles.h"
#include "converters/cairo/png.h"
#include "converters/common/files.h"

namespace libstyle {
namespace {

cairo_status_t read_bytes(void* rest, unsigned char* bytes, unsigned int count) {
  auto& text = *static_cast<std::string_view*>(rest);
  if (text.size() < count) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(bytes, text.data(), count);
  text.remove_prefix(count);
  return CAIRO_STATUS_SUCCESS;
}

// Whether or not the file has an alpha channel, as ARGB32.
CairoSurface decoded(std::string_view bytes) {
  CairoSurface file(cairo_image_surface_create_from_png_stream(read_bytes, &bytes));
  check_cairo(cairo_surface_status(file.get()), "reading a PNG");
  const int width = cairo_image_surface_get_width(file.get());
  const int height = cairo_image_surface_get_height(file.get());
  CairoSurface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  const CairoContext context(cairo_create(image.get()));
  cairo_set_operator(context.get(), CAIRO_OPERATOR_SOURCE);
  cairo_set_source_surface(context.get(), file.get(), 0, 0);
  cairo_paint(context.get());
  cairo_surface_flush(image.get());
  return image;
}

std::uint32_t* row_of(cairo_surface_t* image, std::size_t y) {
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image));
  return reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(image) + y * stride);
}

}  // namespace

Raster decode_png(std::string_view bytes) {
  const CairoSurface surface = decoded(bytes);
  Raster image(static_cast<std::size_t>(cairo_image_surface_get_width(surface.get())),
              static_cast<std::size_t>(cairo_image_surface_get_height(surface.get())));
  for (std::size_t y = 0; y < image.height; ++y) {
    const std::uint32_t* row = row_of(surface.get(), y);
    for (std::size_t x = 0; x < image.width; ++x) {
      const auto channel = [&](int shift) { return static_cast<std::uint8_t>(row[x] >> shift); };
      image.at(x, y) = {channel(16), channel(8), channel(0), channel(24)};
    }
  }
  return image;
}

void encode_png(ByteSink& sink, const Raster& image) {
  const CairoSurface surface(cairo_image_surface_create(
      CAIRO_FORMAT_ARGB32, static_cast<int>(image.width), static_cast<int>(image.height)));
  check_cairo(cairo_surface_status(surface.get()), "making a picture");
  cairo_surface_flush(surface.get());
  for (std::size_t y = 0; y < image.height; ++y) {
    std::uint32_t* row = row_of(surface.get(), y);
    for (std::size_t x = 0; x < image.width; ++x) {
      const Pixel p = image.at(x, y);
      row[x] =
          std::uint32_t{p[3]} << 24 | std::uint32_t{p[0]} << 16 | std::uint32_t{p[1]} << 8 | p[2];
    }
  }
  cairo_surface_mark_dirty(surface.get());
  write_png(sink, surface.get());
}

Raster load_image(const std::string& name) {
  const auto source = open_input(name);
  return decode_png(read_all(*source, std::size_t{1} << 30, name));
}

void save_image(const std::string& name, const Raster& image) {
  OutputFile file(name);
  encode_png(file, image);
  file.commit();
}

Pixel on_white(Pixel pixel) {
  const auto white = static_cast<std::uint8_t>(255 - pixel[3]);
  for (std::size_t i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(pixel[i] + white);
  pixel[3] = 255;
  return pixel;
}

}  // namespace libstyle
