#include "viewer/server/timing_window.h"

#include <algorithm>
#include <limits>

#include "thigma/math/quantile.h"

namespace thigma::live {
namespace {

constexpr std::size_t kStepCpu = 10, kWakeLate = 11, kState = 14;  // in ChannelRow::values
constexpr double kNoRate = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void add(std::span<const ChannelRow> rows, std::span<const double> queries, TimingWindow& window) {
  for (const ChannelRow& row : rows) {
    window.step_cpu.push_back(static_cast<double>(row.values[kStepCpu]));
    window.wake_late.push_back(static_cast<double>(row.values[kWakeLate]));
    const auto state = static_cast<unsigned>(row.values[kState]);
    window.held_back += (state & kHeldBack) != 0 ? 1 : 0;
    window.squeezed += (state & kSqueezed) != 0 ? 1 : 0;
  }
  window.query_cpu.insert(window.query_cpu.end(), queries.begin(), queries.end());
}

Timing close(double now, bool has_rate, std::uint64_t frame, std::uint64_t update,
             TimingWindow& window) {
  Timing t{};
  t.step_p50 = sample_quantile(window.step_cpu, 0.5);
  t.step_p99 = sample_quantile(window.step_cpu, 0.99);
  t.late_p50 = sample_quantile(window.wake_late, 0.5);
  t.late_p99 = sample_quantile(window.wake_late, 0.99);
  t.query_p50 = sample_quantile(window.query_cpu, 0.5);
  t.query_p99 = sample_quantile(window.query_cpu, 0.99);
  const double frames = static_cast<double>(std::max<std::size_t>(window.step_cpu.size(), 1));
  t.held_back = static_cast<double>(window.held_back) / frames;
  t.squeezed = static_cast<double>(window.squeezed) / frames;
  t.haptic_hz = t.contact_hz = kNoRate;
  const double elapsed = now - window.since;
  // A session that began anew counts from 0 again.
  if (window.has_first && has_rate && elapsed > 0.0 && frame >= window.first_frame) {
    t.haptic_hz = static_cast<double>(frame - window.first_frame) / elapsed;
    t.contact_hz = static_cast<double>(update - window.first_update) / elapsed;
  }
  window.since = now;
  window.first_frame = frame;
  window.first_update = update;
  window.has_first = has_rate;
  window.held_back = window.squeezed = 0;
  window.step_cpu.clear();
  window.wake_late.clear();
  window.query_cpu.clear();
  return t;
}

}  // namespace thigma::live
