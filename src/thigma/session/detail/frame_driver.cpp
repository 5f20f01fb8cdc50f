#include "thigma/session/detail/frame_driver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thigma::detail {
namespace {

bool ends_session(const SessionConfig& config, Fault fault) THIGMA_RT {
  return fault != Fault::none && !is_resumable(config.haptic, fault);
}

}  // namespace

std::uint64_t frame_limit(const SessionConfig& config) noexcept {
  if (config.duration <= 0.0) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(std::llround(config.duration * config.rate));
}

Frame begin_frame(const SessionConfig& config, const FrameTick& tick,
                  FrameRecord& record) THIGMA_RT {
  const std::uint64_t gap = tick.index - record.previous;
  record.longest_gap = std::max(record.longest_gap, gap);
  record.previous = tick.index;
  Frame frame;
  frame.index = tick.index;
  frame.now = static_cast<double>(tick.index) / config.rate;
  frame.elapsed = static_cast<double>(std::clamp<std::uint64_t>(gap, 1, kMostTicks)) / config.rate;
  frame.wake_late_ns = tick.wake_late_ns;
  return frame;
}

void end_frame(const SessionConfig& config, const Frame& frame, const HapticSample& sample,
               FrameRecord& record) THIGMA_RT {
  accumulate(record.statistics, sample, frame.cpu_ns, frame.wake_late_ns);
  record.fault = sample.fault;
  if (record.has_fault_frame || !ends_session(config, sample.fault)) return;
  record.has_fault_frame = true;
  record.fault_frame = frame.index;
}

bool is_fault_over(const SessionConfig& config, const FrameRecord& record) THIGMA_RT {
  if (!ends_session(config, record.fault)) return false;
  const auto wait = static_cast<std::uint64_t>(std::ceil(config.after_fault * config.rate));
  return record.previous - record.fault_frame >= wait;
}

SessionEnd end_of_frames(const SessionConfig& config, const FrameRecord& record,
                         SessionEnd reason) noexcept {
  return ends_session(config, record.fault) ? SessionEnd::fault : reason;
}

}  // namespace thigma::detail
