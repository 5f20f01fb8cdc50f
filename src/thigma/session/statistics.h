#pragma once
// Running statistics of a session, kept by the threads themselves so that a full telemetry ring
// loses none.

#include <array>
#include <cstdint>
#include <limits>

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
struct HapticStatistics {
  std::uint64_t frames = 0;
  StateHash hash;
  DurationHistogram step_cpu, wake_late, model_age, solve;
  DurationHistogram device_read, compute, device_write, whole;  // of a frame, by the clock
  // frames that ended after the next deadline
  std::uint64_t overruns = 0;
  std::array<std::uint64_t, kLateBounds.size()> late{};  // wake-ups later than each bound
  double force_max = 0.0, force_square_sum = 0.0;        // sent [N, N^2]
  double torque_max = 0.0, torque_square_sum = 0.0;      // felt, sent or not [N m, N^2 m^2]
  double penetration_max = 0.0;                          // see HapticSample [m]
  double stretch_max = 0.0;                              // while grasped [m]
  RiddenOut ridden_out;
  HeldCounts held;  // of the constrained response
  SlipTotals slip;
  double last_time = 0.0, last_weight = 1.0;  // of the frame before
};

/// Of the contact frames. Thread: as above.
struct ContactStatistics {
  std::uint64_t updates = 0, dropped = 0;
  std::uint64_t contacts = 0, clusters = 0, front = 0;  // sums over updates
  DurationHistogram query_cpu, model_cpu, step_cpu;     // model: clusters and their linearization
  std::uint64_t tests = 0, mandatory_tests = 0, unrefined = 0,
                level_changes = 0;                      // sums over updates
  std::uint64_t texture_depths = 0, texture_folds = 0;  // likewise
  std::uint64_t texture_coarse = 0, texture_bent = 0, texture_left_out = 0;
  double depth_max = -std::numeric_limits<double>::infinity();            // of the contacts [m]
  double bound_max = 0.0;                                                 // [m]
  std::array<std::uint64_t, kLevelBins> object_levels{}, scene_levels{};  // contacts, sums
  std::array<std::uint64_t, kLevelDeciders> decided_by{};                 // contacts, sums
  double triangles_below = 0.0;                                           // sum over contacts
  RowCounts rows;  // of the constrained response
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

/// What the constrained response did; nothing of the others.
struct ConstraintSummary {
  bool is_on = false;
  double held_back_share = 0.0;  // of the frames with the object in the hand: its travel had ended
  double squeezed_share = 0.0;   // of these: rows contradicted each other
  std::uint64_t held_back_frames = 0;
  double active_mean = 0.0;       // rows that pressed, where any did
  std::int64_t active_max = 0;    // rows that pressed at once
  double residual_max = 0.0;      // of a solve: speed at which a row is violated [m/s]
  double wanted_speed_max = 0.0;  // of the object's fastest point [m/s]
  // least gap of a row, infinite without one: below 0 a feature has been behind a plane that it is
  // kept in front of, which beside the surface is no depth [m]
  double row_gap_min = std::numeric_limits<double>::infinity();
  DurationSummary solve;  // of the row solves of a frame, where there were rows [s]
  // in a model that has any, and found for one
  double rows_mean = 0.0;
  std::int64_t rows_p50 = 0, rows_max = 0, found_max = 0;
  // see ContactSample
  std::int64_t halvings_max = 0, left_out_max = 0;
  std::uint64_t halved_models = 0, left_out_models = 0;
  // least of models with rows, infinite without; tolerance of queries [m]
  double travel_min = std::numeric_limits<double>::infinity(), look_ahead_max = 0.0;
  std::int64_t coarse_max = 0;  // see ContactSample
};

/// Thread [offline].
ConstraintSummary summarize(const HeldCounts& held, const RowCounts& rows) noexcept;

/// How friction held over a session, of any response.
struct FrictionSummary {
  bool is_on = false;           // a contact with friction has pressed
  double sticking_share = 0.0;  // of the contacts with friction that pressed, over frames
  double slip_work = 0.0;       // that sliding has taken [J]
};

/// Thread [offline].
FrictionSummary summarize(const SlipTotals& slip) noexcept;

/// Calls visit(key, number) for every field but is_on.
template <class Visit>
void visit_constraint_summary(const ConstraintSummary& s, Visit&& visit) {
  visit("held_back_share", s.held_back_share);
  visit("held_back_frames", s.held_back_frames);
  visit("squeezed_share", s.squeezed_share);
  visit("active_mean", s.active_mean);
  visit("active_max", s.active_max);
  visit("residual_max", s.residual_max);
  visit("wanted_speed_max", s.wanted_speed_max);
  visit("rows_mean", s.rows_mean);
  visit("rows_p50", s.rows_p50);
  visit("rows_max", s.rows_max);
  visit("found_max", s.found_max);
  visit("halvings_max", s.halvings_max);
  visit("halved_models", s.halved_models);
  visit("left_out_max", s.left_out_max);
  visit("left_out_models", s.left_out_models);
  visit("travel_min", s.travel_min);
  visit("near_radius", s.look_ahead_max);
  visit("coarse_max", s.coarse_max);
  visit("row_gap_min", s.row_gap_min);
}

}  // namespace thigma
