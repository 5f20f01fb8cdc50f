#include "viewer/server/timing_window.h"

#include <algorithm>
#include <limits>

namespace thigma::live {
namespace {

constexpr std::size_t kStepCpu = 10, kWakeLate = 11;  // in ChannelRow::values
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// NaN of nothing.
double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return kUnknown;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

void add(std::span<const ChannelRow> rows, std::span<const double> queries, TimingWindow& window) {
  for (const ChannelRow& row : rows) {
    window.step_cpu.push_back(static_cast<double>(row.values[kStepCpu]));
    window.wake_late.push_back(static_cast<double>(row.values[kWakeLate]));
  }
  window.query_cpu.insert(window.query_cpu.end(), queries.begin(), queries.end());
}

Timing close(double now, bool has_frame, std::uint64_t frame, std::uint64_t update,
             TimingWindow& window) {
  Timing t{};
  t.step_p50 = quantile(window.step_cpu, 0.5);
  t.step_p99 = quantile(window.step_cpu, 0.99);
  t.late_p50 = quantile(window.wake_late, 0.5);
  t.late_p99 = quantile(window.wake_late, 0.99);
  t.query_p50 = quantile(window.query_cpu, 0.5);
  t.query_p99 = quantile(window.query_cpu, 0.99);
  t.haptic_hz = t.contact_hz = kUnknown;
  const double elapsed = now - window.since;
  // A session that began anew counts from 0 again.
  if (window.has_first && has_frame && elapsed > 0.0 && frame >= window.first_frame) {
    t.haptic_hz = static_cast<double>(frame - window.first_frame) / elapsed;
    t.contact_hz = static_cast<double>(update - window.first_update) / elapsed;
  }
  window.since = now;
  window.first_frame = frame;
  window.first_update = update;
  window.has_first = has_frame;
  window.step_cpu.clear();
  window.wake_late.clear();
  window.query_cpu.clear();
  return t;
}

}  // namespace thigma::live
