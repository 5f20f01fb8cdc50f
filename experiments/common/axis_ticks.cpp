#include "experiments/common/axis_ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace thigma::plot {
namespace {

// "0.02", "1500", "2·10⁶": the shortest that a person reads at once.
std::string number_label(double value, double step) {
  char text[48];
  const double size = std::fabs(value);
  if (size < 1e-12 * step || value == 0.0) return "0";
  if (size >= 1e5 || size < 1e-4) {
    static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
    const double mantissa = value / std::pow(10.0, exponent);
    std::string label;
    if (std::fabs(mantissa - 1.0) > 1e-6) {
      std::snprintf(text, sizeof text, "%.3g·", mantissa);
      label = text;
    }
    label += "10";
    if (exponent < 0) label += "⁻";
    const std::string digits = std::to_string(std::abs(exponent));
    for (const char c : digits) label += kDigits[c - '0'];
    return label;
  }
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 8);
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

double nice_step(double span, int wanted) {
  const double raw = span / std::max(wanted, 1);
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (factor * decade >= raw * (1.0 - 1e-9)) return factor * decade;
  }
  return 10.0 * decade;
}

Scale linear_scale(double low, double high, int wanted, bool fit_low, bool fit_high) {
  if (!(high > low)) {
    const double pad = low != 0.0 ? 0.5 * std::fabs(low) : 1.0;
    low -= pad;
    high += pad;
  }
  const double step = nice_step(high - low, wanted);
  Scale scale{low, high, false, {}};
  if (fit_low) scale.low = step * std::floor(low / step + 1e-9);
  if (fit_high) scale.high = step * std::ceil(high / step - 1e-9);
  for (double i = std::ceil(scale.low / step - 1e-9); i * step <= scale.high + 1e-9 * step; ++i) {
    scale.ticks.push_back({i * step, number_label(i * step, step)});
  }
  return scale;
}

Scale log_scale(double low, double high, int wanted, bool fit_low, bool fit_high) {
  if (!(low > 0.0)) low = high > 0.0 ? 1e-3 * high : 1.0;
  if (!(high > low)) high = 10.0 * low;
  Scale scale{low, high, true, {}};
  const bool is_short = high / low < 30.0;
  auto decade = [](double exponent) { return std::pow(10.0, exponent); };
  // Ends at 1, 2 or 5 of a decade.
  auto fitted = [&](double value, bool is_low) {
    const double base = decade(std::floor(std::log10(value) + 1e-9));
    double best = is_low ? base : 10.0 * base;
    for (const double m : {1.0, 2.0, 5.0}) {
      if (is_low && m * base <= value * (1.0 + 1e-9)) best = m * base;
      if (!is_low && m * base >= value * (1.0 - 1e-9)) best = std::min(best, m * base);
    }
    return best;
  };
  const double first = std::floor(std::log10(low) + 1e-9),
               last = std::ceil(std::log10(high) - 1e-9);
  if (fit_low && !is_short) scale.low = fitted(low, true);
  if (fit_high && !is_short) scale.high = fitted(high, false);
  const int every = std::max(1, static_cast<int>(std::ceil((last - first) / std::max(wanted, 1))));
  for (double e = first - 1.0; e <= last; ++e) {
    for (int m = 1; m <= 9; ++m) {
      const double value = m * decade(e);
      if (value < scale.low * (1.0 - 1e-9) || value > scale.high * (1.0 + 1e-9)) continue;
      const bool is_major = m == 1 && std::fmod(e - first, every) == 0.0;
      const bool is_named = is_major || (is_short && (m == 2 || m == 5 || m == 1));
      if (every > 3 && m != 1) continue;
      scale.ticks.push_back({value, is_named ? number_label(value, decade(e)) : ""});
    }
  }
  return scale;
}

}  // namespace

Scale make_scale(double low, double high, bool is_log, int wanted, bool fit_low, bool fit_high) {
  return is_log ? log_scale(low, high, wanted, fit_low, fit_high)
                : linear_scale(low, high, wanted, fit_low, fit_high);
}

double position(const Scale& scale, double value) {
  if (!scale.is_log) return (value - scale.low) / (scale.high - scale.low);
  if (!(value > 0.0)) return std::nan("");
  return std::log(value / scale.low) / std::log(scale.high / scale.low);
}

}  // namespace thigma::plot
