#include "resolution_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

namespace thigma::app {
namespace {

/// Numbers between commas, all finite; empty when the text is anything else.
std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return {};
    numbers.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty()) return numbers;
    if (text.front() != ',') return {};
    text.remove_prefix(1);
  }
}

std::string parse_one_metric(std::string_view text, RefinementMetric& metric, bool& has_haptic) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::string_view rest =
      equals == std::string_view::npos ? std::string_view{} : text.substr(equals + 1);
  const std::vector<double> values = numbers_in(rest);
  if (name == "haptic" && equals == std::string_view::npos) {
    has_haptic = true;
    return {};
  }
  if (name == "velocity") {
    if (values.size() != 1 || !(values[0] > 0.0))
      return "--metric velocity=ALPHA takes seconds above 0";
    metric.velocity = values[0];
    return {};
  }
  if (name == "view") {
    bool is_positive = values.size() == 5;
    for (const double v : values) is_positive = is_positive && v > 0.0;
    if (!is_positive) {
      return "--metric view=N,l,n,f,i takes five numbers above 0: pixels, distance of the eye, "
             "near "
             "distance, size of the near plane, size of the image in pixels";
    }
    metric.view = {values[0], values[1], values[3], values[2], values[4]};
    return {};
  }
  return "--metric is haptic, velocity=ALPHA or view=N,l,n,f,i, or several joined by +";
}

std::string parse_support(const std::string& text, SupportReading& reading) {
  if (text == "one_ring")
    reading = SupportReading::one_ring;
  else if (text == "flood")
    reading = SupportReading::flood;
  else if (text == "patch")
    reading = SupportReading::patch;
  else
    return "--support is one_ring, flood or patch";
  return {};
}

}  // namespace

void add_resolution_options(CLI::App& verb, ResolutionOptions& o) {
  verb.add_flag("--exact", o.is_exact, "contacts at full resolution");
  verb.add_option("--threshold", o.threshold,
                  "levels of detail by contact: s0 as a fraction of the smaller radius (0.025)");
  verb.add_option("--deviation-cap", o.deviation_cap,
                  "most surface deviation of a contact, a fraction of the smaller radius, or off "
                  "(the default)");
  verb.add_option("--budget-us", o.budget_us,
                  "CPU time of a query [us]; what is left coarse for it shows in the bounds");
  verb.add_option("--budget-tests", o.budget_tests, "the same in pairs looked at: reproducible")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
  verb.add_option("--support", o.support,
                  "how the support area D of a contact is read: flood (the default) or one_ring, "
                  "around it, or patch, one for all contacts of a patch");
  verb.add_option(
      "--carry", o.carry,
      "carry contacts along until the bodies may have moved by this share of the "
      "tolerance; 0 measures all in each frame (the default; 0.1 with the constrained response)");
  verb.add_option("--metric", o.metric,
                  "haptic, velocity=ALPHA, view=N,l,n,f,i, or several joined by +");
}

std::string parse_metric(const std::string& text, RefinementMetric& metric) {
  const RefinementMetric before = metric;
  metric = RefinementMetric{};
  metric.has_eye = before.has_eye;
  metric.eye = before.eye;
  bool has_haptic = false;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('+', at), text.size());
    const std::string wrong =
        parse_one_metric(std::string_view(text).substr(at, end - at), metric, has_haptic);
    if (!wrong.empty()) return wrong;
    at = end + 1;
  }
  metric.haptic = has_haptic ? before.haptic : 0.0;
  return {};
}

bool asks_for_levels(const ResolutionOptions& o) {
  return o.threshold || !o.deviation_cap.empty() || o.budget_us || o.budget_tests ||
         !o.metric.empty() || !o.support.empty();
}

std::string apply(const ResolutionOptions& o, Resolution& resolution) {
  const bool has_levels = asks_for_levels(o);
  if (o.is_exact && has_levels) {
    return "--exact stands beside --threshold, --deviation-cap, --budget-us, --budget-tests, "
           "--support or --metric, expected one of the two";
  }
  if (o.carry) {
    if (!(*o.carry >= 0.0) || !std::isfinite(*o.carry))
      return "--carry must be a share of the tolerance, 0 or more";
    resolution.carry = *o.carry;
  }
  if (o.is_exact) resolution.is_exact = true;
  if (!has_levels) return {};
  resolution.is_exact = false;
  if (o.threshold) {
    if (!(*o.threshold >= 0.0) || !std::isfinite(*o.threshold))
      return "--threshold must be a fraction of the radius, 0 or more (0.025 is 2.5 %)";
    resolution.metric.haptic = *o.threshold;
  }
  if (!o.metric.empty()) {
    const std::string wrong = parse_metric(o.metric, resolution.metric);
    if (!wrong.empty()) return wrong;
  }
  if (!o.support.empty()) {
    const std::string wrong = parse_support(o.support, resolution.reading);
    if (!wrong.empty()) return wrong;
  }
  if (o.deviation_cap == "off") {
    resolution.deviation_cap = kNoCap;
  } else if (!o.deviation_cap.empty()) {
    const std::vector<double> cap = numbers_in(o.deviation_cap);
    if (cap.size() != 1 || !(cap[0] > 0.0))
      return "--deviation-cap must be a fraction of the radius above 0, or off";
    resolution.deviation_cap = cap[0];
  }
  if (o.budget_us) {
    if (!(*o.budget_us > 0.0 && *o.budget_us < 1e9))
      return "--budget-us must be above 0 and below 1e9 microseconds";
    resolution.budget_cpu = 1e-6 * *o.budget_us;
  }
  if (o.budget_tests) {
    if (*o.budget_tests < 1) return "--budget-tests must be 1 or more";
    resolution.budget_tests = *o.budget_tests;
  }
  return {};
}

}  // namespace thigma::app
