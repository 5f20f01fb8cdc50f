#include "thigma/session/statistics.h"

#include <algorithm>
#include <cmath>

namespace thigma {
void accumulate(HapticStatistics& tally, const HapticSample& sample, std::int64_t step_cpu_ns,
                std::int64_t wake_late_ns) THIGMA_RT {
  ++tally.frames;
  add_frame(tally.hash, sample.body, sample.command);
  if (step_cpu_ns >= 0) record(tally.step_cpu, step_cpu_ns);
  if (wake_late_ns >= 0) record(tally.wake_late, wake_late_ns);
  for (std::size_t i = 0; i < kLateBounds.size(); ++i)
    tally.late[i] += wake_late_ns > kLateBounds[i] ? 1 : 0;
  if (sample.model_sequence > 0) record(tally.model_age, to_ns(sample.model_age));
  const double force2 = sample.command.force.squaredNorm();
  const double torque2 = sample.feedback.torque.squaredNorm();
  tally.force_max = std::max(tally.force_max, std::sqrt(force2));
  tally.torque_max = std::max(tally.torque_max, std::sqrt(torque2));
  tally.force_square_sum += force2;
  tally.torque_square_sum += torque2;
  tally.penetration_max = std::max(tally.penetration_max, sample.penetration);
  if (sample.is_grasped) tally.stretch_max = std::max(tally.stretch_max, sample.stretch);
  if (rode_out_gap(sample)) {
    ++tally.ridden_out.gaps;
    tally.ridden_out.longest_gap =
        std::max(tally.ridden_out.longest_gap, sample.time - tally.last_time);
  }
  tally.ridden_out.stale_models += rode_out_model(sample, tally.last_weight) ? 1 : 0;
  tally.last_time = sample.time;
  tally.last_weight = rode_out_gap(sample) ? 0.0 : sample.model_weight;
}

void accumulate(HapticStatistics& tally, const StageTimes& times) THIGMA_RT {
  record(tally.device_read, times.device_read);
  record(tally.compute, times.whole - times.device_read - times.device_write);
  record(tally.device_write, times.device_write);
  record(tally.whole, times.whole);
  tally.overruns += times.is_overrun ? 1 : 0;
}

void accumulate(ContactStatistics& tally, const ContactSample& sample) THIGMA_RT {
  ++tally.updates;
  tally.dropped += static_cast<std::uint64_t>(sample.dropped);
  tally.contacts += static_cast<std::uint64_t>(sample.contacts);
  tally.clusters += static_cast<std::uint64_t>(sample.clusters);
  tally.front += static_cast<std::uint64_t>(sample.front);
  tally.tests += static_cast<std::uint64_t>(sample.tests);
  tally.mandatory_tests += static_cast<std::uint64_t>(sample.mandatory_tests);
  tally.unrefined += static_cast<std::uint64_t>(sample.unrefined);
  tally.level_changes += static_cast<std::uint64_t>(sample.level_changes);
  tally.texture_depths += static_cast<std::uint64_t>(sample.texture_depths);
  tally.texture_folds += static_cast<std::uint64_t>(sample.texture_folds);
  tally.bound_max = std::max(tally.bound_max, sample.bound_max);
  for (std::size_t i = 0; i < tally.object_levels.size(); ++i) {
    tally.object_levels[i] += static_cast<std::uint64_t>(sample.object_levels[i]);
    tally.scene_levels[i] += static_cast<std::uint64_t>(sample.scene_levels[i]);
  }
  for (std::size_t i = 0; i < tally.decided_by.size(); ++i)
    tally.decided_by[i] += static_cast<std::uint64_t>(sample.decided_by[i]);
  tally.triangles_below += sample.triangles_below;
  record(tally.query_cpu, to_ns(sample.query_cpu));
  record(tally.model_cpu, to_ns(sample.step_cpu - sample.query_cpu));
  record(tally.step_cpu, to_ns(sample.step_cpu));
}

}  // namespace thigma
