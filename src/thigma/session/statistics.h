#pragma once
// Running statistics of a session, kept by the threads themselves so that a full telemetry ring
// loses none.

#include <array>
#include <cstdint>
#include <limits>

#include "thigma/core/rt.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/session/session.h"

namespace thigma {

/// Seconds as whole nanoseconds, towards zero.
[[nodiscard]] inline std::int64_t to_ns(double seconds) THIGMA_RT {
  return static_cast<std::int64_t>(seconds * 1e9);
}

/// Where a haptic frame's time went, by the clock [ns].
struct StageTimes {
  std::int64_t device_read = 0, device_write = 0, whole = 0;
  bool is_overrun = false;  // ended after the next deadline
};

/// Of the haptic frames in which the object was in the hand. Thread: one writer.
struct HeldCounts {
  std::uint64_t frames = 0, held_back = 0, squeezed = 0;
  std::uint64_t touching = 0, active = 0;  // frames in which rows pressed, and how many in all
  std::int32_t active_max = 0;
  double residual_max = 0.0, wanted_speed_max = 0.0;             // [m/s]
  double row_gap_min = std::numeric_limits<double>::infinity();  // [m]
};

/// How friction held, over frames. Thread: one writer.
struct SlipTotals {
  std::uint64_t sticking = 0, sliding = 0;  // contacts that pressed, over frames
  double work = 0.0;                        // [J]
};

/// Of the contact frames. Thread: one writer.
struct RowCounts {
  std::array<std::uint32_t, kMaxRows + 1> models{};  // by rows in the model
  std::int32_t halvings_max = 0;
  std::int64_t found_max = 0, left_out_max = 0;
  std::uint64_t halved_models = 0, left_out_models = 0;         // with less travel, with none
  double travel_min = std::numeric_limits<double>::infinity();  // of models with rows [m]
  double look_ahead_max = 0.0;                                  // [m]
  std::int64_t coarse_max = 0;
};

/// Of the haptic frames. Thread: one writer; read after it has stopped.
struct HapticStatistics : HapticTotals {
  StateHash hash;
  DurationHistogram step_cpu, wake_late, model_age, solve;
  DurationHistogram device_read, compute, device_write, whole;  // of a frame, by the clock
  // frames that ended after the next deadline
  std::uint64_t overruns = 0;
  std::array<std::uint64_t, kLateBounds.size()> late{};  // wake-ups later than each bound
  double force_square_sum = 0.0;                         // sent [N^2]
  double torque_square_sum = 0.0;                        // felt, sent or not [N^2 m^2]
  double penetration_max = 0.0;                          // see HapticSample [m]
  HeldCounts held;                                       // of the constrained response
  SlipTotals slip;
  double last_time = 0.0, last_weight = 1.0;  // of the frame before
};

/// Of the contact frames. Thread: as above.
struct ContactStatistics : ContactTotals {
  std::uint64_t updates = 0, dropped = 0;
  std::uint64_t contacts = 0, clusters = 0, front = 0;          // sums over updates
  DurationHistogram query_cpu, model_cpu, step_cpu;             // model: clusters, linearization
  std::uint64_t tests = 0, mandatory_tests = 0;                 // sums over updates
  double depth_max = -std::numeric_limits<double>::infinity();  // of the contacts [m]
  double triangles_below = 0.0;                                 // sum over contacts
  RowCounts rows;                                               // of the constrained response
};

/// Whether a frame was late, and whether its model had become too old, without a fault of it.
/// last_weight: of the model in the frame before; after a gap the model is old as well, which is
/// not counted again.
/// Thread    [haptic].
inline bool rode_out_gap(const HapticSample& sample) THIGMA_RT {
  return sample.external_fault == Fault::watchdog && sample.fault == Fault::none;
}
inline bool rode_out_model(const HapticSample& sample, double last_weight) THIGMA_RT {
  return sample.is_armed && !(sample.model_weight > 0.0) && last_weight > 0.0 &&
         !rode_out_gap(sample);
}

/// Adds a frame. Durations [ns]; negative ones (not measured) are left out. Thread [haptic].
void accumulate(HapticStatistics& statistics, const HapticSample& sample, std::int64_t step_cpu_ns,
                std::int64_t wake_late_ns) THIGMA_RT;
void accumulate(HapticStatistics& statistics, const StageTimes& times) THIGMA_RT;
void accumulate(ContactStatistics& statistics, const ContactSample& sample) THIGMA_RT;
void accumulate(HeldCounts& counts, const HapticSample& sample) THIGMA_RT;
void accumulate(SlipTotals& totals, const SlipCount& slip) THIGMA_RT;
void accumulate(RowCounts& counts, const ContactSample& sample) THIGMA_RT;

/// What the summary tells of these; a session's but for how it ended, missed ticks, rings, events
/// and notes. Thread [offline].
SessionSummary summarize(const SessionConfig& config, const HapticStatistics& haptic,
                         const ContactStatistics& contact, const HapticState& state);
PassivitySummary summarize(const PassivityParams& params, const PassivityControl& control) noexcept;
ConstraintSummary summarize(const HeldCounts& held, const RowCounts& rows) noexcept;
FrictionSummary summarize(const SlipTotals& slip) noexcept;

}  // namespace thigma
