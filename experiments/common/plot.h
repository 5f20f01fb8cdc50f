#pragma once
// Plots as PNG: panels of lines, points and steps over linear or logarithmic axes.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace thigma::plot {

enum class Mark : unsigned char {
  line,
  points,
  line_and_points,
  steps,  // of a histogram: y[i] holds from x[i] to x[i + 1]
};

/// One curve. Points that are not finite, or not positive on a logarithmic axis, interrupt it.
struct Series {
  std::string label{};  // "": not in the legend
  std::vector<double> x{}, y{};
  Mark mark = Mark::line;
  std::vector<double> y_low{}, y_high{};  // as long as y: vertical bars; empty: none
  int color = -1;                         // of the palette, 0..7; -1: next in turn
  bool is_dashed = false;
  double width = 1.6;  // [px]
};

/// A value of the source or a bound: a dashed line across the panel.
struct Guide {
  std::string label{};
  double value = 0.0;
  bool is_vertical = false;
};

struct Axis {
  std::string label{};  // with its unit: "force [N]"
  bool is_log = false;
  std::optional<double> low{}, high{};    // otherwise from the data
  std::vector<std::string> categories{};  // names at 0, 1, ... instead of numbers
};

struct Panel {
  std::string title{};
  Axis x{}, y{};
  std::vector<Series> series{};
  std::vector<Guide> guides{};
};

/// Panels in rows, `columns` a row.
struct Figure {
  std::string title{};
  std::string note{};  // under the title, one line
  std::vector<Panel> panels{};
  int columns = 1;
  int width = 900, panel_height = 260;  // [px]; the file has twice as many
};

/// Counts of values in bins of equal width, or of equal ratio when is_log, as a steps series.
Series histogram(std::string label, std::span<const double> values, int bins, bool is_log = false);

enum class PageFormat : unsigned char { png, svg, pdf };

/// The format that a file's ending asks for, PNG without one; nothing for another ending. Thread
/// [offline].
std::optional<PageFormat> page_format(const std::string& path);

/// A figure as a file. Same figure and same fonts, same bytes, but for names inside an SVG.
/// Thread   [offline]; IoError when drawing fails.
std::string figure_bytes(const Figure& figure, PageFormat format = PageFormat::png);

}  // namespace thigma::plot
