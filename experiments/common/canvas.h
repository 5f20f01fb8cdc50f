#pragma once
// What drawing needs of Cairo: a page of pixels, text that is measured, lines that are crisp.

#include <memory>
#include <string>

#include "experiments/common/plot.h"
#include <cairo/cairo.h>

namespace thigma::plot {

struct Color {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;
};

enum class Align : unsigned char { start, middle, end };

/// A page, drawn in points, of which a PNG has two pixels each way.
/// Invariant: surface and context live as long as the page. Thread: of the caller.
class Canvas {
 public:
  /// Throws IoError when there is no memory for it.
  Canvas(int width, int height, PageFormat format);

  void set_color(const Color& color);
  void set_width(double width, bool is_dashed = false);
  void move_to(double x, double y);
  void line_to(double x, double y);
  void stroke();
  void line(double x0, double y0, double x1, double y1);
  void fill_rectangle(double x, double y, double width, double height);
  void dot(double x, double y, double radius);
  /// Everything until the next unclip stays inside.
  void clip(double x, double y, double width, double height);
  void unclip();

  void set_font(double size, bool is_bold = false);
  double text_width(const std::string& text) const;
  /// Baseline at y; align says which part of the text is at x.
  void text(double x, double y, const std::string& text, Align align = Align::start);
  /// Reading upwards, centred at (x, y).
  void text_upwards(double x, double y, const std::string& text);

  /// The file; nothing can be drawn afterwards. Throws IoError.
  std::string take_bytes();

 private:
  PageFormat format_;
  // of a page of lines, written as they are drawn; where it lies is known to the surface
  std::unique_ptr<std::string> lines_;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
  std::unique_ptr<cairo_t, void (*)(cairo_t*)> context_;
};

}  // namespace thigma::plot
