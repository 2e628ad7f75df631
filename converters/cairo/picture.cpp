// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "converters/cairo/draw_document.h"
#include "converters/cairo/handles.h"
#include "converters/cairo/png.h"

namespace libstyle {
namespace {

constexpr double kPointsPerPx = 0.75;    // PDF counts in 1/72 inch, CSS in 1/96
constexpr double kMostSide = 32767;      // px; Cairo's limit for images
constexpr double kMostPixels = 1 << 28;  // a gigabyte of them
constexpr double kMostUnits = 1 << 20;   // leaves Cairo room in its 24.8 fixed point

// A picture's side in whole pixels: up, as rsvg-convert does, but not for the last digit's sake.
double whole_pixels(double side) { return std::max(1.0, std::ceil(side - 1e-6)); }

CairoSurface make_image(const Viewport& viewport) {
  const double width = whole_pixels(viewport.width), height = whole_pixels(viewport.height);
  if (width > kMostSide || height > kMostSide || width * height > kMostPixels) {
    throw Error(
        "the picture is too large for PNG (at most 32767 px a side and 268 million pixels); set "
        "--width, or draw it as PDF");
  }
  CairoSurface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(width),
                                                static_cast<int>(height)));
  check_cairo(cairo_surface_status(image.get()), "making the picture");
  return image;
}

}  // namespace

std::optional<PictureFormat> picture_format(std::string_view file_name) {
  const auto ends_in = [&](std::string_view ending) { return file_name.ends_with(ending); };
  if (ends_in(".png") || ends_in(".PNG")) return PictureFormat::kPng;
  if (ends_in(".svg") || ends_in(".SVG")) return PictureFormat::kSvg;
  if (ends_in(".pdf") || ends_in(".PDF")) return PictureFormat::kPdf;
  return std::nullopt;
}

class Picture::Implementation {
 public:
  Implementation(ByteSink& sink, const PictureSettings& settings, WarningHandler warn)
      : sink_(sink), settings_(settings), warn_(std::move(warn)) {}

  void add(const Document& document, const std::string& file) {
    place_ = {file, document.header.line};
    if (full_) {
      throw Error(place_, "a second document, but this picture holds one");
    }
    const Viewport viewport = viewport_of(document);
    if (settings_.format == PictureFormat::kPng) {
      const CairoSurface image = at_place(place_, [&] { return make_image(viewport); });
      draw(image.get(), document, viewport.picture_from_page);
      write_png(sink_, image.get());
    } else {
      add_page(document, viewport);
    }
    full_ = settings_.format != PictureFormat::kPdf;
  }

  void finish() {
    if (!vector_) return;
    cairo_surface_finish(vector_.get());
    check_vector();
  }

 private:
  void warn(Warning warning) const {
    if (!warn_) return;
    warning.place.file = place_.file;
    warn_(warning);
  }

  Viewport viewport_of(const Document& document) const {
    Viewport viewport = at_place(place_, [&] { return make_viewport(document, settings_.size); });
    if (viewport.width > 0) return viewport;
    warn({place_, "",
          "the page has no size and nothing is drawn on it; the picture is one empty pixel"});
    return {1, 1, Transform{}};
  }

  void add_page(const Document& document, const Viewport& viewport) {
    const bool is_pdf = settings_.format == PictureFormat::kPdf;
    const double unit = is_pdf ? kPointsPerPx : 1;
    const double width = unit * viewport.width, height = unit * viewport.height;
    if (width > kMostUnits || height > kMostUnits) {
      throw Error(place_, "the picture is too large (at most a million units a side); set --width");
    }
    if (!vector_) vector_ = make_vector(width, height);
    if (is_pdf) cairo_pdf_surface_set_size(vector_.get(), width, height);
    try {
      draw(vector_.get(), document, Transform::scaling(unit, unit) * viewport.picture_from_page);
    } catch (const Error&) {
      clear_page();
      throw;
    }
    if (is_pdf) cairo_surface_show_page(vector_.get());
    check_vector();
  }

  // Cairo would make a page of what there is of a document that failed.
  void clear_page() const {
    const CairoContext context(cairo_create(vector_.get()));
    cairo_set_operator(context.get(), CAIRO_OPERATOR_CLEAR);
    cairo_paint(context.get());
  }

  CairoSurface make_vector(double width, double height) {
    CairoSurface surface;
    if (settings_.format == PictureFormat::kPdf) {
      surface.reset(cairo_pdf_surface_create_for_stream(write, this, width, height));
      // An empty date takes the place of the present time, and is not written.
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    } else {
      surface.reset(cairo_svg_surface_create_for_stream(write, this, width, height));
      cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    }
    return surface;
  }

  void draw(cairo_surface_t* surface, const Document& document,
            const Transform& device_from_page) const {
    const CairoContext context(cairo_create(surface));
    if (settings_.background) {
      const Color color = *settings_.background;
      cairo_set_source_rgba(context.get(), color.red / 255.0, color.green / 255.0,
                            color.blue / 255.0, color.alpha / 255.0);
      cairo_paint(context.get());
    }
    draw_document(context.get(), document, device_from_page, place_.file,
                  [&](const Warning& w) { warn(w); });
    if (failure_) std::rethrow_exception(failure_);
    at_place(place_, [&] { check_cairo(cairo_status(context.get()), "drawing"); });
  }

  // Cairo is C: an exception waits here until the call has returned.
  static cairo_status_t write(void* self, const unsigned char* bytes, unsigned int count) {
    auto& picture = *static_cast<Implementation*>(self);
    try {
      picture.sink_.write({reinterpret_cast<const char*>(bytes), count});
      return CAIRO_STATUS_SUCCESS;
    } catch (...) {
      picture.failure_ = std::current_exception();
      return CAIRO_STATUS_WRITE_ERROR;
    }
  }

  void check_vector() const {
    if (failure_) std::rethrow_exception(failure_);
    check_cairo(cairo_surface_status(vector_.get()), "drawing");
  }

  ByteSink& sink_;
  const PictureSettings settings_;
  const WarningHandler warn_;
  Place place_;  // of the document being drawn
  bool full_ = false;
  std::exception_ptr failure_;  // of the sink
  CairoSurface vector_;         // of SVG and PDF; last, since closing it still writes
};

Picture::Picture(ByteSink& sink, const PictureSettings& settings, WarningHandler warn)
    : implementation_(std::make_unique<Implementation>(sink, settings, std::move(warn))) {}

Picture::~Picture() = default;

void Picture::add(const Document& document, const std::string& file) {
  implementation_->add(document, file);
}

void Picture::finish() { implementation_->finish(); }

}  // namespace libstyle
