#include "experiments/common/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "thigma/math/elementary.h"

namespace thigma::experiments {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Sums about the means.
struct Moments {
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
};

Moments moments(std::span<const double> x, std::span<const double> y) {
  Moments m{mean(x), mean(y)};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - m.mean_x, dy = y[i] - m.mean_y;
    m.xx += dx * dx;
    m.yy += dy * dy;
    m.xy += dx * dy;
  }
  return m;
}

std::vector<double> ranks(std::span<const double> x) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  std::vector<double> rank(x.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && x[order[end]] == x[order[i]]) ++end;
    for (std::size_t j = i; j < end; ++j) rank[order[j]] = 0.5 * static_cast<double>(i + end - 1);
    i = end;
  }
  return rank;
}

/// The weight of what is smaller and half of that of what is equal.
std::vector<double> weighted_ranks(std::span<const double> x, std::span<const double> weight) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  std::vector<double> rank(x.size());
  double below = 0.0;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    double equal = 0.0;
    while (end < order.size() && x[order[end]] == x[order[i]]) equal += weight[order[end++]];
    for (std::size_t j = i; j < end; ++j) rank[order[j]] = below + 0.5 * equal;
    below += equal;
    i = end;
  }
  return rank;
}

/// Two-sided 95 % quantile of Student's t.
double student_t(std::size_t freedom) {
  static constexpr double kTable[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                      2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145,
                                      2.131,  2.120, 2.110, 2.101, 2.093, 2.086};
  if (freedom == 0) return std::numeric_limits<double>::infinity();
  if (freedom <= std::size(kTable)) return kTable[freedom - 1];
  return 1.95996 + 2.3722 / static_cast<double>(freedom) +
         2.82 / static_cast<double>(freedom * freedom);
}

/// One direction of a section of second order.
struct Section {
  double b0 = 0.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};

Section butterworth(double step, double cutoff) {
  const SinCos half = sin_cos(kPi * cutoff * step);
  const double k = half.sin / half.cos, k2 = k * k;
  const double norm = 1.0 / (1.0 + std::sqrt(2.0) * k + k2);
  return {k2 * norm, 2.0 * k2 * norm, k2 * norm, 2.0 * (k2 - 1.0) * norm,
          (1.0 - std::sqrt(2.0) * k + k2) * norm};
}

// Started in the steady state of the first sample.
void run_section(const Section& s, std::vector<double>& x) {
  if (x.empty()) return;
  double x1 = x[0], x2 = x[0], y1 = x[0], y2 = x[0];
  for (double& value : x) {
    const double y = s.b0 * value + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
    x2 = x1;
    x1 = value;
    y2 = y1;
    y1 = y;
    value = y;
  }
}

/// A line of a spectrum: power is weight (re^2 + im^2), in units of the signal's square.
struct Line {
  double re = 0.0, im = 0.0, weight = 0.0;
};

/// Those within [low, high] Hz, mean removed, under a Hann window.
std::vector<Line> lines_of(std::span<const double> x, double step, double low, double high) {
  const std::size_t n = x.size();
  const double average = mean(x), length = static_cast<double>(n);
  std::vector<double> windowed(n);
  double window_power = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double w = 0.5 - 0.5 * cosine(2.0 * kPi * (static_cast<double>(i) + 0.5) / length);
    windowed[i] = w * (x[i] - average);
    window_power += w * w / length;
  }
  std::vector<Line> lines;
  for (std::size_t k = 1; k <= n / 2; ++k) {
    const double frequency = static_cast<double>(k) / (length * step);
    if (frequency < low || frequency > high) continue;
    Line line{0.0, 0.0, (2 * k == n ? 1.0 : 2.0) / (length * length * window_power)};
    for (std::size_t i = 0; i < n; ++i) {
      const SinCos turn = sin_cos(2.0 * kPi * static_cast<double>((k * i) % n) / length);
      line.re += windowed[i] * turn.cos;
      line.im += windowed[i] * turn.sin;
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

double mean(std::span<const double> x) {
  if (x.empty()) return kNaN;
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double root_mean_square(std::span<const double> x) {
  if (x.empty()) return kNaN;
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double standard_deviation(std::span<const double> x) {
  if (x.size() < 2) return kNaN;
  const double m = mean(x);
  double sum = 0.0;
  for (const double v : x) sum += (v - m) * (v - m);
  return std::sqrt(sum / static_cast<double>(x.size() - 1));
}

double coefficient_of_variation(std::span<const double> x) {
  return standard_deviation(x) / mean(x);
}

double correlation(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size() || x.size() < 2) return kNaN;
  const Moments m = moments(x, y);
  if (!(m.xx > 0.0) || !(m.yy > 0.0)) return kNaN;
  return m.xy / std::sqrt(m.xx) / std::sqrt(m.yy);
}

double rank_correlation(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) return kNaN;
  return correlation(ranks(x), ranks(y));
}

double rank_correlation(std::span<const double> x, std::span<const double> y,
                        std::span<const double> weight) {
  if (x.size() != y.size() || x.size() != weight.size()) return kNaN;
  const std::vector<double> a = weighted_ranks(x, weight), b = weighted_ranks(y, weight);
  double total = 0.0, mean_a = 0.0, mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    total += weight[i];
    mean_a += weight[i] * a[i];
    mean_b += weight[i] * b[i];
  }
  mean_a /= total;
  mean_b /= total;
  double aa = 0.0, bb = 0.0, ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += weight[i] * (a[i] - mean_a) * (a[i] - mean_a);
    bb += weight[i] * (b[i] - mean_b) * (b[i] - mean_b);
    ab += weight[i] * (a[i] - mean_a) * (b[i] - mean_b);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : kNaN;
}

double relative_error(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) return kNaN;
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    error += (x[i] - y[i]) * (x[i] - y[i]);
    size += y[i] * y[i];
  }
  return size > 0.0 ? std::sqrt(error / size) : kNaN;
}

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  LineFit fit{kNaN, kNaN, kNaN, kNaN, kNaN};
  if (x.size() != y.size() || x.size() < 2) return fit;
  const Moments m = moments(x, y);
  if (!(m.xx > 0.0)) return fit;
  fit.slope = m.xy / m.xx;
  fit.intercept = m.mean_y - fit.slope * m.mean_x;
  const double residual = std::max(0.0, m.yy - fit.slope * m.xy);
  fit.r_squared = m.yy > 0.0 ? 1.0 - residual / m.yy : kNaN;
  const std::size_t freedom = x.size() - 2;
  double half = std::numeric_limits<double>::infinity();
  if (freedom > 0)
    half = student_t(freedom) * std::sqrt(residual / static_cast<double>(freedom) / m.xx);
  fit.slope_low = fit.slope - half;
  fit.slope_high = fit.slope + half;
  return fit;
}

LineFit fit_power(std::span<const double> x, std::span<const double> y) {
  std::vector<double> log_x, log_y;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!(x[i] > 0.0) || !(y[i] > 0.0)) continue;
    log_x.push_back(std::log(x[i]));
    log_y.push_back(std::log(y[i]));
  }
  return fit_line(log_x, log_y);
}

double proportional_r_squared(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size() || x.size() < 2) return kNaN;
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += x[i] * x[i];
    xy += x[i] * y[i];
  }
  const double variance = moments(x, y).yy;
  if (!(xx > 0.0) || !(variance > 0.0)) return kNaN;
  double residual = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double e = y[i] - xy / xx * x[i];
    residual += e * e;
  }
  return 1.0 - residual / variance;
}

std::vector<double> low_pass(std::span<const double> x, double step, double cutoff) {
  if (x.size() < 2) return {x.begin(), x.end()};
  // Long enough for what the start leaves behind to die out.
  const std::size_t pad =
      std::min(x.size() - 1, static_cast<std::size_t>(std::ceil(3.0 / (cutoff * step))));
  std::vector<double> y;
  y.reserve(x.size() + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) y.push_back(2.0 * x.front() - x[i]);
  y.insert(y.end(), x.begin(), x.end());
  for (std::size_t i = 1; i <= pad; ++i) y.push_back(2.0 * x.back() - x[x.size() - 1 - i]);
  const Section section = butterworth(step, cutoff);
  run_section(section, y);
  std::reverse(y.begin(), y.end());
  run_section(section, y);
  std::reverse(y.begin(), y.end());
  return {y.begin() + static_cast<std::ptrdiff_t>(pad), y.end() - static_cast<std::ptrdiff_t>(pad)};
}

std::vector<double> second_derivative(std::span<const double> x, double step) {
  std::vector<double> d;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    d.push_back((x[i - 1] - 2.0 * x[i] + x[i + 1]) / (step * step));
  }
  return d;
}

double band_level(std::span<const double> x, double step, double low, double high) {
  if (x.size() < 4) return kNaN;
  double power = 0.0;
  for (const Line& line : lines_of(x, step, low, high))
    power += line.weight * (line.re * line.re + line.im * line.im);
  return std::sqrt(power);
}

double band_share(std::span<const double> x, std::span<const double> reference, double step,
                  double low, double high) {
  if (x.size() < 4 || x.size() != reference.size()) return kNaN;
  const std::vector<Line> ours = lines_of(x, step, low, high);
  const std::vector<Line> theirs = lines_of(reference, step, low, high);
  double common = 0.0, power = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Line &a = ours[i], &b = theirs[i];
    common += b.weight * (a.re * b.re + a.im * b.im);
    power += b.weight * (b.re * b.re + b.im * b.im);
  }
  return power > 0.0 ? common / power : kNaN;
}

}  // namespace thigma::experiments
