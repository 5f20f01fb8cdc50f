#include "thigma/session/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thigma {
namespace {

std::vector<StageHistogram> timed_stages(const HapticStatistics& haptic,
                                         const ContactStatistics& contact) {
  const std::pair<const char*, const DurationHistogram*> all[] = {
      {"haptic_wake_late", &haptic.wake_late},   {"haptic_device_read", &haptic.device_read},
      {"haptic_compute", &haptic.compute},       {"haptic_device_write", &haptic.device_write},
      {"haptic_whole", &haptic.whole},           {"haptic_step_cpu", &haptic.step_cpu},
      {"contact_query_cpu", &contact.query_cpu}, {"contact_model_cpu", &contact.model_cpu},
      {"contact_step_cpu", &contact.step_cpu},   {"contact_model_age", &haptic.model_age},
      {"haptic_row_solve", &haptic.solve}};
  std::vector<StageHistogram> timed;
  for (const auto& [name, histogram] : all) {
    if (histogram->total > 0) timed.push_back({name, *histogram});
  }
  return timed;
}

}  // namespace

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
  statistics.texture_sheets += static_cast<std::uint64_t>(sample.texture_sheets);
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

PassivitySummary summarize(const PassivityParams& params,
                           const PassivityControl& control) noexcept {
  PassivitySummary s;
  s.is_on = params.is_on;
  s.delay = params.delay;
  if (control.wanted_frames == 0) return s;
  const auto frames = static_cast<double>(control.wanted_frames);
  s.acted_share = static_cast<double>(control.acted_frames) / frames;
  s.sent_share = control.share_sum / frames;
  s.damping_max = control.damping_max;
  return s;
}

SessionSummary summarize(const SessionConfig& config, const HapticStatistics& haptic,
                         const ContactStatistics& contact, const HapticState& state) {
  SessionSummary s;
  static_cast<HapticTotals&>(s) = haptic;
  static_cast<ContactTotals&>(s) = contact;
  s.rate = config.rate;
  s.seconds = static_cast<double>(haptic.frames) / config.rate;
  s.step_cpu = summarize(haptic.step_cpu);
  s.wake_late = summarize(haptic.wake_late);
  s.model_age = summarize(haptic.model_age);
  s.contact_updates = contact.updates;
  s.stages = {summarize(haptic.device_read), summarize(haptic.compute),
              summarize(haptic.device_write), summarize(haptic.whole)};
  s.deadlines.overruns = haptic.overruns;
  s.deadlines.late = haptic.late;
  s.histograms = timed_stages(haptic, contact);
  s.query_cpu = summarize(contact.query_cpu);
  s.model_cpu = summarize(contact.model_cpu);
  s.contact_step_cpu = summarize(contact.step_cpu);
  const double updates = std::max(1.0, static_cast<double>(contact.updates));
  s.contacts_mean = static_cast<double>(contact.contacts) / updates;
  s.clusters_mean = static_cast<double>(contact.clusters) / updates;
  s.front_mean = static_cast<double>(contact.front) / updates;
  s.tests_mean = static_cast<double>(contact.tests) / updates;
  s.mandatory_tests_mean = static_cast<double>(contact.mandatory_tests) / updates;
  s.triangles_below_mean =
      contact.triangles_below / std::max(1.0, static_cast<double>(contact.contacts));
  const double frames = std::max(1.0, static_cast<double>(haptic.frames));
  s.force_rms = std::sqrt(haptic.force_square_sum / frames);
  s.torque_rms = std::sqrt(haptic.torque_square_sum / frames);
  // Of simulated bodies the frames' own, of which there may be no contact frame.
  s.penetration_max =
      std::max(0.0, contact.updates > 0 ? contact.depth_max : haptic.penetration_max);
  s.energy_min = state.energy.energy_min;
  if (config.haptic.response == ResponseKind::constrained) {
    s.constraint = summarize(haptic.held, contact.rows);
    s.constraint.solve = summarize(haptic.solve);
  }
  s.friction = summarize(haptic.slip);
  s.passivity = summarize(config.haptic.passivity, state.passivity);
  s.dropped_contacts = contact.dropped;
  s.state_hash = haptic.hash.value;
  return s;
}

}  // namespace thigma
