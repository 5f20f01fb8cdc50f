#pragma once
// Running statistics of a session, kept by the threads themselves so that a full telemetry ring
// loses none.

#include <array>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/loop/samples.h"
#include "thigma/session/histogram.h"

namespace thigma {

/// Seconds as whole nanoseconds, towards zero.
[[nodiscard]] inline std::int64_t to_ns(double seconds) THIGMA_RT {
  return static_cast<std::int64_t>(seconds * 1e9);
}

/// Wake-ups later than these are counted [ns].
inline constexpr std::array<std::int64_t, 3> kLateBounds = {100'000, 200'000, 1'000'000};

/// Where a haptic frame's time went, by the clock [ns].
struct StageTimes {
  std::int64_t device_read = 0, device_write = 0, whole = 0;
  bool is_overrun = false;  // ended after the next deadline
};

/// What was late and ridden out (SafetyLimits::rides_out_gaps).
struct RiddenOut {
  std::uint64_t gaps = 0, stale_models = 0;
  double longest_gap = 0.0;  // from the frame before to the one that was late [s]
};

/// Of the haptic frames. Thread: one writer; read after it has stopped.
struct HapticStatistics {
  std::uint64_t frames = 0;
  StateHash hash;
  DurationHistogram step_cpu, wake_late, model_age;
  DurationHistogram device_read, compute, device_write, whole;  // of a frame, by the clock
  // frames that ended after the next deadline
  std::uint64_t overruns = 0;
  std::array<std::uint64_t, kLateBounds.size()> late{};  // wake-ups later than each bound
  double force_max = 0.0, force_square_sum = 0.0;        // sent [N, N^2]
  double torque_max = 0.0, torque_square_sum = 0.0;      // felt, sent or not [N m, N^2 m^2]
  double penetration_max = 0.0;                          // [m]
  double stretch_max = 0.0;                              // while grasped [m]
  RiddenOut ridden_out;
  double last_time = 0.0, last_weight = 1.0;  // of the frame before
};

/// Of the contact frames. Thread: as above.
struct ContactStatistics {
  std::uint64_t updates = 0, dropped = 0;
  std::uint64_t contacts = 0, clusters = 0, front = 0;  // sums over updates
  DurationHistogram query_cpu, model_cpu, step_cpu;     // model: clusters and their linearization
  std::uint64_t tests = 0, mandatory_tests = 0, unrefined = 0,
                level_changes = 0;                                        // sums over updates
  std::uint64_t texture_depths = 0, texture_folds = 0;                    // likewise
  double bound_max = 0.0;                                                 // [m]
  std::array<std::uint64_t, kLevelBins> object_levels{}, scene_levels{};  // contacts, sums
  std::array<std::uint64_t, kLevelDeciders> decided_by{};                 // contacts, sums
  double triangles_below = 0.0;                                           // sum over contacts
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

}  // namespace thigma
