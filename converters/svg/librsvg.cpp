// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/librsvg.h"

#include <cairo-svg.h>
#include <dlfcn.h>
#include <fontconfig/fontconfig.h>
#include <librsvg/rsvg.h>

#include <memory>

#include "libstyle/base/error.h"

namespace libstyle::svg {
namespace {

constexpr char kLibrary[] = "librsvg-2.so.2";

// --- The library --------------------------------------------------------------------------------

// What is called of librsvg, and of Cairo, GLib and fontconfig, which it brings along.
struct Functions {
  decltype(&rsvg_handle_new_from_data) new_from_data;
  decltype(&rsvg_handle_render_document) render_document;
  decltype(&g_object_unref) unref;
  decltype(&g_error_free) free_error;
  decltype(&FcConfigGetFonts) fonts;
  decltype(&cairo_svg_surface_create_for_stream) create_surface;
  decltype(&cairo_svg_surface_set_document_unit) set_unit;
  decltype(&cairo_create) create_context;
  decltype(&cairo_destroy) destroy_context;
  decltype(&cairo_surface_finish) finish_surface;
  decltype(&cairo_surface_status) surface_status;
  decltype(&cairo_surface_destroy) destroy_surface;
};

template <typename Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw Error(std::string(kLibrary) + " has no " + name);
}

// The library stays open: GLib cannot be unloaded.
Functions load() {
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error(std::string("it needs ") + kLibrary + ", which is not there");
  Functions f;
  find(library, "rsvg_handle_new_from_data", f.new_from_data);
  find(library, "rsvg_handle_render_document", f.render_document);
  find(library, "g_object_unref", f.unref);
  find(library, "g_error_free", f.free_error);
  find(library, "FcConfigGetFonts", f.fonts);
  find(library, "cairo_svg_surface_create_for_stream", f.create_surface);
  find(library, "cairo_svg_surface_set_document_unit", f.set_unit);
  find(library, "cairo_create", f.create_context);
  find(library, "cairo_destroy", f.destroy_context);
  find(library, "cairo_surface_finish", f.finish_surface);
  find(library, "cairo_surface_status", f.surface_status);
  find(library, "cairo_surface_destroy", f.destroy_surface);
  return f;
}

// Pango would draw a speck for each character.
void require_fonts(const Functions& f) {
  const FcFontSet* const fonts = f.fonts(nullptr, FcSetSystem);
  if (fonts == nullptr || fonts->nfont == 0) throw Error("it needs fonts, and none are installed");
}

const Functions& library() {
  static const Functions functions = [] {
    const Functions loaded = load();
    require_fonts(loaded);
    return loaded;
  }();
  return functions;
}

// --- Drawing ------------------------------------------------------------------------------------

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

// Takes what is said about an error.
Error to_error(GError* error) {
  const std::string message = error != nullptr ? error->message : "librsvg cannot draw it";
  if (error != nullptr) library().free_error(error);
  return Error(message);
}

}  // namespace

std::string redraw_by_librsvg(std::string_view text, double size) {
  const Functions& f = library();
  GError* error = nullptr;
  const auto* const bytes = reinterpret_cast<const guint8*>(text.data());
  // Without a base file librsvg opens nothing.
  const std::unique_ptr<RsvgHandle, void (*)(void*)> handle(
      f.new_from_data(bytes, text.size(), &error), f.unref);
  if (!handle) throw to_error(error);

  std::string result;
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      f.create_surface(append, &result, size, size), f.destroy_surface);
  f.set_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  const std::unique_ptr<cairo_t, void (*)(cairo_t*)> context(f.create_context(surface.get()),
                                                             f.destroy_context);
  const RsvgRectangle page = {0, 0, size, size};
  if (!f.render_document(handle.get(), context.get(), &page, &error)) throw to_error(error);
  f.finish_surface(surface.get());
  if (f.surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    throw Error("Cairo cannot write what librsvg drew");
  }
  return result;
}

}  // namespace libstyle::svg
