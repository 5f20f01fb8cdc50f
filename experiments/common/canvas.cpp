#include "experiments/common/canvas.h"

#include <utility>

#include <cairo/cairo-pdf.h>
#include <cairo/cairo-svg.h>

#include "thigma/core/error.h"

namespace thigma::plot {
namespace {

constexpr double kPixels = 2.0;  // a point

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(int width, int height, PageFormat format, std::string& bytes) {
  switch (format) {
    case PageFormat::svg:
      return cairo_svg_surface_create_for_stream(append, &bytes, width, height);
    case PageFormat::pdf: {
      cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
      // The same figure has the same bytes, whenever it is drawn.
      cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                     "2000-01-01T00:00:00Z");
      return surface;
    }
    case PageFormat::png:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kPixels * width),
                                    static_cast<int>(kPixels * height));
}

}  // namespace

Canvas::Canvas(int width, int height, PageFormat format)
    : format_(format),
      lines_(std::make_unique<std::string>()),
      surface_(make_surface(width, height, format, *lines_), cairo_surface_destroy),
      context_(cairo_create(surface_.get()), cairo_destroy) {
  if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS) {
    throw IoError(std::string("plot: no page to draw on: ") +
                  cairo_status_to_string(cairo_status(context_.get())));
  }
  if (format == PageFormat::png) cairo_scale(context_.get(), kPixels, kPixels);
  // The same letters whatever the settings of a desktop.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context_.get(), options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_source_rgb(context_.get(), 1.0, 1.0, 1.0);
  cairo_paint(context_.get());
}

void Canvas::set_color(const Color& c) {
  cairo_set_source_rgba(context_.get(), c.red, c.green, c.blue, c.alpha);
}

void Canvas::set_width(double width, bool is_dashed) {
  cairo_set_line_width(context_.get(), width);
  const double dashes[] = {5.0, 3.0};
  cairo_set_dash(context_.get(), dashes, is_dashed ? 2 : 0, 0.0);
}

void Canvas::move_to(double x, double y) { cairo_move_to(context_.get(), x, y); }
void Canvas::line_to(double x, double y) { cairo_line_to(context_.get(), x, y); }
void Canvas::stroke() { cairo_stroke(context_.get()); }

void Canvas::line(double x0, double y0, double x1, double y1) {
  move_to(x0, y0);
  line_to(x1, y1);
  stroke();
}

void Canvas::fill_rectangle(double x, double y, double width, double height) {
  cairo_rectangle(context_.get(), x, y, width, height);
  cairo_fill(context_.get());
}

void Canvas::dot(double x, double y, double radius) {
  cairo_new_sub_path(context_.get());
  cairo_arc(context_.get(), x, y, radius, 0.0, 6.283185307179586);
  cairo_fill(context_.get());
}

void Canvas::clip(double x, double y, double width, double height) {
  cairo_save(context_.get());
  cairo_rectangle(context_.get(), x, y, width, height);
  cairo_clip(context_.get());
}

void Canvas::unclip() { cairo_restore(context_.get()); }

void Canvas::set_font(double size, bool is_bold) {
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), size);
}

double Canvas::text_width(const std::string& text) const {
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(double x, double y, const std::string& text, Align align) {
  const double share = align == Align::start ? 0.0 : align == Align::middle ? 0.5 : 1.0;
  cairo_move_to(context_.get(), x - share * text_width(text), y);
  cairo_show_text(context_.get(), text.c_str());
  cairo_new_path(context_.get());
}

void Canvas::text_upwards(double x, double y, const std::string& text) {
  cairo_save(context_.get());
  cairo_translate(context_.get(), x, y + 0.5 * text_width(text));
  cairo_rotate(context_.get(), -1.5707963267948966);
  cairo_move_to(context_.get(), 0.0, 0.0);
  cairo_show_text(context_.get(), text.c_str());
  cairo_new_path(context_.get());
  cairo_restore(context_.get());
}

std::string Canvas::take_bytes() {
  std::string bytes;
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  if (format_ == PageFormat::png) {
    status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
  } else {
    cairo_show_page(context_.get());
    cairo_surface_finish(surface_.get());
    status = cairo_surface_status(surface_.get());
    bytes = std::move(*lines_);
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    throw IoError(std::string("plot: cannot be drawn: ") + cairo_status_to_string(status));
  }
  return bytes;
}

}  // namespace thigma::plot
