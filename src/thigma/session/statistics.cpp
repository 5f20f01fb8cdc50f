#include "thigma/session/statistics.h"

#include <algorithm>
#include <cmath>

namespace thigma {

void accumulate(HeldCounts& counts, const HapticSample& sample) THIGMA_RT {
  if (!sample.is_grasped) return;
  ++counts.frames;
  counts.held_back += sample.is_held_back ? 1 : 0;
  counts.squeezed += sample.is_squeezed ? 1 : 0;
  counts.touching += sample.touching > 0 ? 1 : 0;
  counts.active += static_cast<std::uint64_t>(std::max(sample.touching, 0));
  counts.active_max = std::max(counts.active_max, sample.touching);
  counts.residual_max = std::max(counts.residual_max, sample.solve_residual);
  counts.wanted_speed_max = std::max(counts.wanted_speed_max, sample.wanted_speed);
  counts.row_gap_min = std::min(counts.row_gap_min, -sample.penetration);
}

void accumulate(SlipTotals& totals, const SlipCount& slip) THIGMA_RT {
  totals.sticking += static_cast<std::uint64_t>(slip.sticking);
  totals.sliding += static_cast<std::uint64_t>(slip.sliding);
  totals.work += slip.work;
}

FrictionSummary summarize(const SlipTotals& slip) noexcept {
  FrictionSummary s;
  const std::uint64_t all = slip.sticking + slip.sliding;
  s.is_on = all > 0;
  if (all > 0) s.sticking_share = static_cast<double>(slip.sticking) / static_cast<double>(all);
  s.slip_work = slip.work;
  return s;
}

void accumulate(RowCounts& counts, const ContactSample& sample) THIGMA_RT {
  const std::size_t rows = sample.model.constraints.rows.size();
  ++counts.models[rows];
  counts.found_max = std::max(counts.found_max, sample.rows);
  counts.halvings_max = std::max(counts.halvings_max, sample.travel_halvings);
  counts.left_out_max = std::max(counts.left_out_max, sample.left_out);
  counts.halved_models += sample.travel_halvings > 0 ? 1 : 0;
  counts.left_out_models += sample.left_out > 0 ? 1 : 0;
  counts.look_ahead_max = std::max(counts.look_ahead_max, sample.look_ahead);
  counts.coarse_max = std::max(counts.coarse_max, sample.coarse);
  if (rows > 0) counts.travel_min = std::min(counts.travel_min, sample.travel);
}

ConstraintSummary summarize(const HeldCounts& held, const RowCounts& rows) noexcept {
  ConstraintSummary s;
  s.is_on = true;
  const double frames = static_cast<double>(std::max<std::uint64_t>(held.frames, 1));
  s.held_back_share = static_cast<double>(held.held_back) / frames;
  s.squeezed_share = static_cast<double>(held.squeezed) / frames;
  s.held_back_frames = held.held_back;
  s.active_mean = static_cast<double>(held.active) /
                  static_cast<double>(std::max<std::uint64_t>(held.touching, 1));
  s.active_max = held.active_max;
  s.residual_max = held.residual_max;
  s.wanted_speed_max = held.wanted_speed_max;
  s.row_gap_min = held.row_gap_min;
  s.found_max = rows.found_max;
  s.halvings_max = rows.halvings_max;
  s.halved_models = rows.halved_models;
  s.left_out_max = rows.left_out_max;
  s.left_out_models = rows.left_out_models;
  s.travel_min = rows.travel_min;
  s.look_ahead_max = rows.look_ahead_max;
  s.coarse_max = rows.coarse_max;
  std::uint64_t all = 0, so_far = 0, sum = 0;
  for (std::size_t n = 1; n < rows.models.size(); ++n) {
    all += rows.models[n];
    sum += n * rows.models[n];
  }
  s.rows_mean = static_cast<double>(sum) / static_cast<double>(std::max<std::uint64_t>(all, 1));
  for (std::size_t n = 1; n < rows.models.size(); ++n) {
    if (rows.models[n] == 0) continue;
    s.rows_max = static_cast<std::int64_t>(n);
    if (2 * so_far < all) s.rows_p50 = s.rows_max;
    so_far += rows.models[n];
  }
  return s;
}

void accumulate(HapticStatistics& statistics, const HapticSample& sample, std::int64_t step_cpu_ns,
                std::int64_t wake_late_ns) THIGMA_RT {
  ++statistics.frames;
  add_frame(statistics.hash, sample.body, sample.command);
  if (step_cpu_ns >= 0) record(statistics.step_cpu, step_cpu_ns);
  if (wake_late_ns >= 0) record(statistics.wake_late, wake_late_ns);
  for (std::size_t i = 0; i < kLateBounds.size(); ++i)
    statistics.late[i] += wake_late_ns > kLateBounds[i] ? 1 : 0;
  if (sample.model_sequence > 0) record(statistics.model_age, to_ns(sample.model_age));
  const double force2 = sample.command.force.squaredNorm();
  const double torque2 = sample.feedback.torque.squaredNorm();
  statistics.force_max = std::max(statistics.force_max, std::sqrt(force2));
  statistics.torque_max = std::max(statistics.torque_max, std::sqrt(torque2));
  statistics.force_square_sum += force2;
  statistics.torque_square_sum += torque2;
  statistics.penetration_max = std::max(statistics.penetration_max, sample.penetration);
  if (sample.is_grasped) statistics.stretch_max = std::max(statistics.stretch_max, sample.stretch);
  if (rode_out_gap(sample)) {
    ++statistics.ridden_out.gaps;
    statistics.ridden_out.longest_gap =
        std::max(statistics.ridden_out.longest_gap, sample.time - statistics.last_time);
  }
  statistics.ridden_out.stale_models += rode_out_model(sample, statistics.last_weight) ? 1 : 0;
  accumulate(statistics.held, sample);
  accumulate(statistics.slip, sample.slip);
  if (sample.solve_ns > 0) record(statistics.solve, sample.solve_ns);
  statistics.last_time = sample.time;
  statistics.last_weight = rode_out_gap(sample) ? 0.0 : sample.model_weight;
}

void accumulate(HapticStatistics& statistics, const StageTimes& times) THIGMA_RT {
  record(statistics.device_read, times.device_read);
  record(statistics.compute, times.whole - times.device_read - times.device_write);
  record(statistics.device_write, times.device_write);
  record(statistics.whole, times.whole);
  statistics.overruns += times.is_overrun ? 1 : 0;
}

void accumulate(ContactStatistics& statistics, const ContactSample& sample) THIGMA_RT {
  ++statistics.updates;
  statistics.dropped += static_cast<std::uint64_t>(sample.dropped);
  statistics.contacts += static_cast<std::uint64_t>(sample.contacts);
  statistics.clusters += static_cast<std::uint64_t>(sample.clusters);
  statistics.front += static_cast<std::uint64_t>(sample.front);
  statistics.tests += static_cast<std::uint64_t>(sample.tests);
  statistics.mandatory_tests += static_cast<std::uint64_t>(sample.mandatory_tests);
  statistics.unrefined += static_cast<std::uint64_t>(sample.unrefined);
  statistics.level_changes += static_cast<std::uint64_t>(sample.level_changes);
  statistics.texture_depths += static_cast<std::uint64_t>(sample.texture_depths);
  statistics.texture_folds += static_cast<std::uint64_t>(sample.texture_folds);
  statistics.texture_coarse += static_cast<std::uint64_t>(sample.texture_coarse);
  statistics.texture_bent += static_cast<std::uint64_t>(sample.texture_bent);
  statistics.texture_left_out += static_cast<std::uint64_t>(sample.texture_left_out);
  statistics.depth_max = std::max(statistics.depth_max, sample.depth_max);
  statistics.bound_max = std::max(statistics.bound_max, sample.bound_max);
  for (std::size_t i = 0; i < statistics.object_levels.size(); ++i) {
    statistics.object_levels[i] += static_cast<std::uint64_t>(sample.object_levels[i]);
    statistics.scene_levels[i] += static_cast<std::uint64_t>(sample.scene_levels[i]);
  }
  for (std::size_t i = 0; i < statistics.decided_by.size(); ++i)
    statistics.decided_by[i] += static_cast<std::uint64_t>(sample.decided_by[i]);
  statistics.triangles_below += sample.triangles_below;
  accumulate(statistics.rows, sample);
  record(statistics.query_cpu, to_ns(sample.query_cpu));
  record(statistics.model_cpu, to_ns(sample.step_cpu - sample.query_cpu));
  record(statistics.step_cpu, to_ns(sample.step_cpu));
}

}  // namespace thigma
