#include "thigma/session/statistics.h"

#include <algorithm>
#include <cmath>

namespace thigma {
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
  statistics.bound_max = std::max(statistics.bound_max, sample.bound_max);
  for (std::size_t i = 0; i < statistics.object_levels.size(); ++i) {
    statistics.object_levels[i] += static_cast<std::uint64_t>(sample.object_levels[i]);
    statistics.scene_levels[i] += static_cast<std::uint64_t>(sample.scene_levels[i]);
  }
  for (std::size_t i = 0; i < statistics.decided_by.size(); ++i)
    statistics.decided_by[i] += static_cast<std::uint64_t>(sample.decided_by[i]);
  statistics.triangles_below += sample.triangles_below;
  record(statistics.query_cpu, to_ns(sample.query_cpu));
  record(statistics.model_cpu, to_ns(sample.step_cpu - sample.query_cpu));
  record(statistics.step_cpu, to_ns(sample.step_cpu));
}

}  // namespace thigma
