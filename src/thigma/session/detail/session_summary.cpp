#include "thigma/session/detail/session_summary.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thigma::detail {
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

PassivitySummary summarize(const PassivityParams& params, const PassivityControl& control) {
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
  s.rate = config.rate;
  s.frames = haptic.frames;
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
  s.unrefined = contact.unrefined;
  s.level_changes = contact.level_changes;
  s.texture_depths = contact.texture_depths;
  s.texture_folds = contact.texture_folds;
  s.texture_coarse = contact.texture_coarse;
  s.texture_bent = contact.texture_bent;
  s.texture_left_out = contact.texture_left_out;
  s.bound_max = contact.bound_max;
  s.object_levels = contact.object_levels;
  s.scene_levels = contact.scene_levels;
  s.decided_by = contact.decided_by;
  s.triangles_below_mean =
      contact.triangles_below / std::max(1.0, static_cast<double>(contact.contacts));
  const double frames = std::max(1.0, static_cast<double>(haptic.frames));
  s.force_max = haptic.force_max;
  s.force_rms = std::sqrt(haptic.force_square_sum / frames);
  s.torque_max = haptic.torque_max;
  s.torque_rms = std::sqrt(haptic.torque_square_sum / frames);
  // Of simulated bodies the frames' own, of which there may be no contact frame.
  s.penetration_max =
      std::max(0.0, contact.updates > 0 ? contact.depth_max : haptic.penetration_max);
  s.stretch_max = haptic.stretch_max;
  s.energy_min = state.energy.energy_min;
  if (config.haptic.response == ResponseKind::constrained) {
    s.constraint = thigma::summarize(haptic.held, contact.rows);
    s.constraint.solve = summarize(haptic.solve);
  }
  s.friction = thigma::summarize(haptic.slip);
  s.ridden_out = haptic.ridden_out;
  s.passivity = summarize(config.haptic.passivity, state.passivity);
  s.dropped_contacts = contact.dropped;
  s.state_hash = haptic.hash.value;
  return s;
}

}  // namespace thigma::detail
