#include "experiments/common/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/axis_ticks.h"
#include "experiments/common/canvas.h"

namespace thigma::plot {
namespace {

// Okabe and Ito's palette, told apart by people with any colour vision; its yellow made darker.
constexpr Color kPalette[] = {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45},
                              {0.80, 0.47, 0.65}, {0.90, 0.62, 0.00}, {0.34, 0.71, 0.91},
                              {0.20, 0.20, 0.20}, {0.55, 0.43, 0.19}};
constexpr Color kInk{0.13, 0.13, 0.13}, kSoftInk{0.40, 0.40, 0.40}, kGrid{0.88, 0.88, 0.88},
    kFaintGrid{0.95, 0.95, 0.95}, kGuide{0.35, 0.35, 0.35};
constexpr double kLeft = 74.0, kRight = 18.0, kBelow = 44.0, kTitle = 20.0, kLegendRow = 16.0;
constexpr double kText = 10.5, kSmall = 9.5;

/// Where a panel's curves go, and how.
struct Area {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  Scale across, up;

  double px(double value) const { return x + width * position(across, value); }
  double py(double value) const { return y + height * (1.0 - position(up, value)); }
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double v, bool is_log) {
    if (!std::isfinite(v) || (is_log && !(v > 0.0))) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

Scale scale_of(const Axis& axis, Range range, int wanted, bool is_across) {
  if (!axis.categories.empty()) {
    Scale scale{-0.5, static_cast<double>(axis.categories.size()) - 0.5, false, {}};
    for (std::size_t i = 0; i < axis.categories.size(); ++i) {
      scale.ticks.push_back({static_cast<double>(i), axis.categories[i]});
    }
    return scale;
  }
  if (!(range.high >= range.low)) range = axis.is_log ? Range{1.0, 10.0} : Range{0.0, 1.0};
  // A curve along the frame is hard to see.
  if (axis.is_log) {
    const double pad = std::pow(std::max(range.high / range.low, 1.2), 0.05);
    range.low /= pad;
    range.high *= pad;
  } else if (!is_across) {
    const double pad = 0.04 * (range.high - range.low);
    if (range.low != 0.0) range.low -= pad;
    range.high += pad;
  }
  return make_scale(axis.low.value_or(range.low), axis.high.value_or(range.high), axis.is_log,
                    wanted, !axis.low && !is_across, !axis.high && !is_across);
}

void set_scales(const Panel& panel, Area& area) {
  Range across, up;
  for (const Series& s : panel.series) {
    for (const double v : s.x) across.add(v, panel.x.is_log);
    for (const std::vector<double>* values : {&s.y, &s.y_low, &s.y_high}) {
      for (const double v : *values) up.add(v, panel.y.is_log);
    }
    if (s.mark == Mark::steps && !panel.y.is_log) up.add(0.0, false);
  }
  for (const Guide& g : panel.guides)
    (g.is_vertical ? across : up).add(g.value, (g.is_vertical ? panel.x : panel.y).is_log);
  area.across = scale_of(panel.x, across, std::max(3, static_cast<int>(area.width / 75.0)), true);
  area.up = scale_of(panel.y, up, std::max(2, static_cast<int>(area.height / 36.0)), false);
}

/// Entries of the legend that share a row, as (series, x of its start).
struct LegendEntry {
  std::size_t series = 0;
  double x = 0.0;
  int row = 0;
};

std::vector<LegendEntry> lay_out_legend(Canvas& canvas, const Panel& panel, double width) {
  std::vector<LegendEntry> entries;
  canvas.set_font(kSmall);
  double x = 0.0;
  int row = 0;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    if (panel.series[i].label.empty()) continue;
    const double need = 26.0 + canvas.text_width(panel.series[i].label) + 16.0;
    if (x > 0.0 && x + need > width) {
      x = 0.0;
      ++row;
    }
    entries.push_back({i, x, row});
    x += need;
  }
  return entries;
}

Color color_of(const Panel& panel, std::size_t index) {
  const int chosen = panel.series[index].color;
  return kPalette[static_cast<std::size_t>(chosen >= 0 ? chosen : static_cast<int>(index)) %
                  std::size(kPalette)];
}

bool has_dots(const Series& s) { return s.mark == Mark::points || s.mark == Mark::line_and_points; }

void draw_frame(Canvas& canvas, const Panel& panel, const Area& area) {
  for (const Tick& t : area.across.ticks) {
    const double x = area.px(t.value);
    canvas.set_color(t.label.empty() ? kFaintGrid : kGrid);
    canvas.set_width(0.8);
    if (panel.x.categories.empty()) canvas.line(x, area.y, x, area.y + area.height);
  }
  for (const Tick& t : area.up.ticks) {
    const double y = area.py(t.value);
    canvas.set_color(t.label.empty() ? kFaintGrid : kGrid);
    canvas.set_width(0.8);
    canvas.line(area.x, y, area.x + area.width, y);
  }
  canvas.set_color(kInk);
  canvas.set_width(1.0);
  canvas.line(area.x, area.y, area.x, area.y + area.height);
  canvas.line(area.x, area.y + area.height, area.x + area.width, area.y + area.height);
  canvas.set_font(kSmall);
  for (const Tick& t : area.across.ticks) {
    canvas.line(area.px(t.value), area.y + area.height, area.px(t.value),
                area.y + area.height + (t.label.empty() ? 2.0 : 4.0));
    canvas.text(area.px(t.value), area.y + area.height + 15.0, t.label, Align::middle);
  }
  for (const Tick& t : area.up.ticks) {
    canvas.line(area.x - (t.label.empty() ? 2.0 : 4.0), area.py(t.value), area.x, area.py(t.value));
    canvas.text(area.x - 7.0, area.py(t.value) + 3.4, t.label, Align::end);
  }
  canvas.set_font(kText);
  canvas.text(area.x + 0.5 * area.width, area.y + area.height + 31.0, panel.x.label, Align::middle);
  canvas.text_upwards(area.x - 56.0, area.y + 0.5 * area.height, panel.y.label);
}

void draw_guides(Canvas& canvas, const Panel& panel, const Area& area) {
  canvas.set_font(kSmall);
  for (const Guide& g : panel.guides) {
    canvas.set_color(kGuide);
    canvas.set_width(1.1, true);
    if (g.is_vertical) {
      const double x = area.px(g.value);
      if (!(x >= area.x && x <= area.x + area.width)) continue;
      canvas.line(x, area.y, x, area.y + area.height);
      const bool is_right = x + 8.0 + canvas.text_width(g.label) > area.x + area.width;
      canvas.text(is_right ? x - 4.0 : x + 4.0, area.y + 10.0, g.label,
                  is_right ? Align::end : Align::start);
    } else {
      const double y = area.py(g.value);
      if (!(y >= area.y && y <= area.y + area.height)) continue;
      canvas.line(area.x, y, area.x + area.width, y);
      canvas.text(area.x + area.width - 4.0, y < area.y + 14.0 ? y + 11.0 : y - 4.0, g.label,
                  Align::end);
    }
  }
}

void draw_curve(Canvas& canvas, const Series& s, const Area& area) {
  canvas.set_width(s.width, s.is_dashed);
  bool is_down = false;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    const double x = area.px(s.x[i]), y = area.py(s.y[i]);
    if (!std::isfinite(x) || !std::isfinite(y)) {
      is_down = false;
      continue;
    }
    if (is_down)
      canvas.line_to(x, y);
    else
      canvas.move_to(x, y);
    if (s.mark == Mark::steps && i + 1 < s.x.size()) canvas.line_to(area.px(s.x[i + 1]), y);
    is_down = true;
  }
  canvas.stroke();
}

void draw_dots(Canvas& canvas, const Series& s, const Area& area) {
  const double radius = s.x.size() > 400 ? 1.2 : s.x.size() > 60 ? 1.8 : 2.8;
  for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
    const double x = area.px(s.x[i]), y = area.py(s.y[i]);
    if (std::isfinite(x) && std::isfinite(y)) canvas.dot(x, y, radius);
  }
}

void draw_bars(Canvas& canvas, const Series& s, const Area& area) {
  canvas.set_width(1.0);
  for (std::size_t i = 0; i < std::min({s.x.size(), s.y_low.size(), s.y_high.size()}); ++i) {
    const double x = area.px(s.x[i]), low = area.py(s.y_low[i]), high = area.py(s.y_high[i]);
    if (!std::isfinite(x) || !std::isfinite(low) || !std::isfinite(high)) continue;
    canvas.line(x, low, x, high);
    canvas.line(x - 3.0, low, x + 3.0, low);
    canvas.line(x - 3.0, high, x + 3.0, high);
  }
}

void draw_legend(Canvas& canvas, const Panel& panel, const std::vector<LegendEntry>& entries,
                 double left, double top) {
  canvas.set_font(kSmall);
  for (const LegendEntry& e : entries) {
    const Series& s = panel.series[e.series];
    const double x = left + e.x, y = top + kLegendRow * e.row + 9.0;
    canvas.set_color(color_of(panel, e.series));
    canvas.set_width(std::max(s.width, 1.6), s.is_dashed);
    if (s.mark != Mark::points) canvas.line(x, y - 3.0, x + 20.0, y - 3.0);
    if (has_dots(s)) canvas.dot(x + 10.0, y - 3.0, 2.8);
    canvas.set_color(kInk);
    canvas.text(x + 25.0, y, s.label);
  }
}

double legend_height(Canvas& canvas, const Panel& panel, double panel_width) {
  const std::vector<LegendEntry> entries =
      lay_out_legend(canvas, panel, panel_width - kLeft - kRight);
  return entries.empty() ? 0.0 : kLegendRow * (entries.back().row + 1);
}

/// Draws a panel into the box (x, y, width, height), `legend` of it for the legend.
void draw_panel(Canvas& canvas, const Panel& panel, double x, double y, double width, double height,
                double legend) {
  Area area;
  area.x = x + kLeft;
  area.width = width - kLeft - kRight;
  const std::vector<LegendEntry> entries = lay_out_legend(canvas, panel, area.width);
  const double title = panel.title.empty() ? 4.0 : kTitle;
  area.y = y + title + legend + 4.0;
  area.height = std::max(40.0, y + height - kBelow - area.y);
  set_scales(panel, area);
  canvas.set_color(kInk);
  canvas.set_font(11.5, true);
  canvas.text(area.x, y + 13.0, panel.title);
  draw_legend(canvas, panel, entries, area.x, y + title);
  draw_frame(canvas, panel, area);
  canvas.clip(area.x - 1.0, area.y - 1.0, area.width + 2.0, area.height + 2.0);
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const Series& s = panel.series[i];
    canvas.set_color(color_of(panel, i));
    if (s.mark != Mark::points) draw_curve(canvas, s, area);
    if (has_dots(s)) draw_dots(canvas, s, area);
    draw_bars(canvas, s, area);
  }
  canvas.unclip();
  draw_guides(canvas, panel, area);
}

}  // namespace

Series histogram(std::string label, std::span<const double> values, int bins, bool is_log) {
  Series series{.label = std::move(label), .mark = Mark::steps};
  Range range;
  for (const double v : values) range.add(v, is_log);
  if (!(range.high >= range.low)) return series;
  if (range.high == range.low)
    range.high = is_log || range.low != 0.0 ? range.low + std::fabs(range.low) : 1.0;
  const Scale scale{range.low, range.high, is_log, {}};
  std::vector<double> counts(static_cast<std::size_t>(bins), 0.0);
  for (const double v : values) {
    if (!std::isfinite(v) || (is_log && !(v > 0.0))) continue;
    const double at = position(scale, v) * bins;
    counts[static_cast<std::size_t>(std::clamp(at, 0.0, bins - 1.0))] += 1.0;
  }
  for (int i = 0; i <= bins; ++i) {
    const double share = static_cast<double>(i) / bins;
    series.x.push_back(is_log ? range.low * std::pow(range.high / range.low, share)
                              : range.low + share * (range.high - range.low));
    series.y.push_back(counts[static_cast<std::size_t>(std::min(i, bins - 1))]);
  }
  return series;
}

std::optional<PageFormat> page_format(const std::string& path) {
  for (const auto& [ending, format] :
       {std::pair{".png", PageFormat::png}, {".svg", PageFormat::svg}, {".pdf", PageFormat::pdf}})
    if (path.ends_with(ending)) return format;
  const bool has_ending = path.find('.', path.rfind('/') + 1) != std::string::npos;
  return has_ending ? std::nullopt : std::optional(PageFormat::png);
}

std::string figure_bytes(const Figure& figure, PageFormat format) {
  const int columns = std::max(figure.columns, 1);
  const int rows = (static_cast<int>(figure.panels.size()) + columns - 1) / columns;
  const double top = (figure.title.empty() ? 8.0 : 30.0) + (figure.note.empty() ? 0.0 : 16.0);
  Canvas canvas(figure.width, static_cast<int>(top) + rows * figure.panel_height + 6, format);
  canvas.set_color(kInk);
  canvas.set_font(14.0, true);
  canvas.text(12.0, 22.0, figure.title);
  canvas.set_color(kSoftInk);
  canvas.set_font(kSmall);
  canvas.text(12.0, 38.0, figure.note);
  const double width = static_cast<double>(figure.width) / columns;
  std::vector<double> legends(static_cast<std::size_t>(rows), 0.0);  // panels of a row line up
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    double& tallest = legends[i / static_cast<std::size_t>(columns)];
    tallest = std::max(tallest, legend_height(canvas, figure.panels[i], width));
  }
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const int row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    draw_panel(canvas, figure.panels[i], width * column, top + row * figure.panel_height, width,
               figure.panel_height, legends[static_cast<std::size_t>(row)]);
  }
  return canvas.take_bytes();
}

}  // namespace thigma::plot
