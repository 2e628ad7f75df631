// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/png.h"

#include <libdeflate.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

constexpr int kLevel = 6;  // of libdeflate: the size of zlib's best effort in a third of its time
constexpr std::size_t kMostInChunk = std::size_t{1} << 30;

struct Pixels {
  const std::uint32_t* row(std::size_t y) const {
    return reinterpret_cast<const std::uint32_t*>(data + y * stride);
  }

  const unsigned char* data;
  std::size_t width, height, stride;
};

Pixels pixels_of(cairo_surface_t* image) {
  cairo_surface_flush(image);
  return {cairo_image_surface_get_data(image),
          static_cast<std::size_t>(cairo_image_surface_get_width(image)),
          static_cast<std::size_t>(cairo_image_surface_get_height(image)),
          static_cast<std::size_t>(cairo_image_surface_get_stride(image))};
}

bool is_opaque(const Pixels& pixels) {
  for (std::size_t y = 0; y < pixels.height; ++y) {
    const std::uint32_t* row = pixels.row(y);
    std::uint32_t all = 0xff000000;
    for (std::size_t x = 0; x < pixels.width; ++x) all &= row[x];
    if (all != 0xff000000) return false;
  }
  return true;
}

// Cairo keeps colours multiplied by alpha; PNG does not.
template <bool kHasAlpha>
unsigned char* pack_pixel(std::uint32_t pixel, unsigned char* out) {
  const std::uint32_t alpha = pixel >> 24;
  std::uint32_t red = pixel >> 16 & 0xff, green = pixel >> 8 & 0xff, blue = pixel & 0xff;
  if (kHasAlpha && alpha != 0 && alpha != 255) {
    red = (red * 255 + alpha / 2) / alpha;
    green = (green * 255 + alpha / 2) / alpha;
    blue = (blue * 255 + alpha / 2) / alpha;
  }
  *out++ = static_cast<unsigned char>(red);
  *out++ = static_cast<unsigned char>(green);
  *out++ = static_cast<unsigned char>(blue);
  if (kHasAlpha) *out++ = static_cast<unsigned char>(alpha);
  return out;
}

template <bool kHasAlpha>
std::vector<unsigned char> pack_rows(const Pixels& pixels) {
  const std::size_t row_bytes = 1 + pixels.width * (kHasAlpha ? 4 : 3);
  std::vector<unsigned char> bytes(row_bytes * pixels.height);
  unsigned char* out = bytes.data();
  for (std::size_t y = 0; y < pixels.height; ++y) {
    *out++ = 0;  // no filter
    const std::uint32_t* row = pixels.row(y);
    for (std::size_t x = 0; x < pixels.width; ++x) out = pack_pixel<kHasAlpha>(row[x], out);
  }
  return bytes;
}

void append_big_endian(std::string& text, std::size_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xff);
}

void write_chunk(ByteSink& sink, const char* type, std::string_view content) {
  std::string head, tail;
  append_big_endian(head, content.size());
  head += type;
  std::uint32_t crc = libdeflate_crc32(0, type, 4);
  crc = libdeflate_crc32(crc, content.data(), content.size());
  append_big_endian(tail, crc);
  sink.write(head);
  sink.write(content);
  sink.write(tail);
}

std::string compressed(const std::vector<unsigned char>& bytes) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
  result.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                         result.data(), result.size()));
  return result;
}

}  // namespace

void write_png(ByteSink& sink, cairo_surface_t* image) {
  constexpr char kRgb = 2, kRgba = 6;
  const Pixels pixels = pixels_of(image);
  const bool opaque = is_opaque(pixels);
  const std::string data = compressed(opaque ? pack_rows<false>(pixels) : pack_rows<true>(pixels));

  std::string header;
  append_big_endian(header, pixels.width);
  append_big_endian(header, pixels.height);
  header += {8, opaque ? kRgb : kRgba, 0, 0, 0};
  sink.write("\x89PNG\r\n\x1a\n");
  write_chunk(sink, "IHDR", header);
  for (std::size_t at = 0; at < data.size(); at += kMostInChunk) {
    write_chunk(sink, "IDAT", std::string_view(data).substr(at, kMostInChunk));
  }
  write_chunk(sink, "IEND", "");
}

}  // namespace libstyle
