#include "thigma/session/detail/session_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace thigma::detail {

void check_config(const SessionConfig& config) {
  const auto refuse = [](const char* text) {
    throw std::invalid_argument(std::string("session: ") + text);
  };
  if (!(config.rate >= 1.0 && config.rate <= 1e5)) refuse("rate must be 1 to 100000 Hz");
  if (!(config.duration >= 0.0 && config.duration < 1e9)) refuse("duration must be 0 s or more");
  if (!(config.after_fault >= 0.0)) refuse("after_fault must be 0 s or more");
  if (!(config.deep_contact >= 0.0)) refuse("deep_contact must be 0 m or more");
  if (config.contact_every < 1) refuse("contact_every must be 1 frame or more");
  if (config.contact_latency < 1) refuse("contact_latency must be 1 frame or more");
  if (!(config.haptic.body.mass > 0.0)) refuse("the body has no mass");
  if (!(config.contact.tolerance >= 0.0)) refuse("the contact tolerance must be 0 m or more");
  if (!config.contact.scene.empty() && config.contact.object == nullptr)
    refuse("there is no grasped object");
}

std::uint64_t frame_limit(const SessionConfig& config) noexcept {
  if (config.duration <= 0.0) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(std::llround(config.duration * config.rate));
}

double step_length(const SessionConfig& config, std::uint64_t frames) noexcept {
  constexpr std::uint64_t kMostTicks = 10;
  return static_cast<double>(std::clamp<std::uint64_t>(frames, 1, kMostTicks)) / config.rate;
}

double effective_watchdog(const SessionConfig& config) noexcept {
  constexpr double kLeastPeriods = 3.0;
  return std::max(config.haptic.safety.watchdog, kLeastPeriods / config.rate);
}

void timed_contact_step(const SessionConfig& config, const StampedBody& at, ContactScratch& scratch,
                        ContactSample& sample) noexcept {
  const std::int64_t begin = thread_cpu_ns();
  find_contacts(config.contact, at, scratch);
  const std::int64_t found = thread_cpu_ns();
  make_model(config.contact, at, scratch, sample);
  const std::int64_t end = thread_cpu_ns();
  sample.query_cpu = 1e-9 * static_cast<double>(found - begin);
  sample.step_cpu = 1e-9 * static_cast<double>(end - begin);
}

DeepContactLimits deep_contact_limits(const SessionConfig& config) noexcept {
  // The direct response lets the object through anything.
  const bool is_held_apart = config.haptic.response != ResponseKind::direct;
  double deep = std::numeric_limits<double>::infinity();
  if (is_held_apart && config.contact.object != nullptr)
    deep = kDeepShare * config.contact.object->radius;
  if (is_held_apart && config.deep_contact > 0.0) deep = config.deep_contact;
  return {deep, config.contact.tolerance};
}

void EventDetector::add(const SessionEvent& event) {
  if (event.kind == "fault") safety_events_.push_back(event);
  if (!event.text.empty()) texts_.push_back(event.text);
  if (sink_) sink_(event);
}

void EventDetector::look_for_old_models(const HapticSample& sample) {
  constexpr double kPatience = 1.0;  // [s]
  if (!sample.is_grasped || !was_grasped_ || sample.is_armed || sample.model_weight >= 1.0) {
    grasp_time_ = sample.time;
    youngest_model_ = std::numeric_limits<double>::infinity();
    return;
  }
  youngest_model_ = std::min(youngest_model_, sample.model_age);
  if (has_told_of_old_models_ || sample.time - grasp_time_ < kPatience) return;
  has_told_of_old_models_ = true;
  char text[160] = "nothing arms: there is no contact model";
  if (std::isfinite(youngest_model_)) {
    std::snprintf(text, sizeof text,
                  "nothing arms: the contact model is always too old, %.1f ms at best",
                  1e3 * youngest_model_);
  }
  add({sample.time, sample.frame, "not_armed", "contact_model_too_old", text});
}

void EventDetector::look_for_deep_contacts(const HapticSample& sample) {
  const double depth = std::max(0.0, sample.penetration);
  // It lasts until the surfaces are out of each other.
  if (!sample.is_grasped || depth == 0.0) is_deep_ = false;
  // What nobody saw come: deeper than when the model was made, or than the model before knew.
  double unseen = sample.sunk, age = sample.model_age;
  if (sample.model_sequence != last_model_ && depth - last_depth_ > unseen) {
    unseen = depth - last_depth_;
    age = last_age_;
  }
  last_model_ = sample.model_sequence;
  last_depth_ = depth;
  last_age_ = sample.model_age;
  const bool is_found = depth > deep_limits_.deep && unseen > deep_limits_.unseen;
  if (!sample.is_grasped || !is_found || is_deep_) return;
  is_deep_ = true;
  char text[160] = "";
  if (!has_told_of_depth_) {
    std::snprintf(text, sizeof text,
                  "a contact is %.2f mm deep, %.2f mm of it unseen by a contact model %.1f ms old",
                  1e3 * depth, 1e3 * unseen, 1e3 * age);
  }
  has_told_of_depth_ = true;
  add({sample.time, sample.frame, "deep_contact", "contact_model_too_old", text});
}

void EventDetector::look_for_late(const HapticSample& sample) {
  char text[120];
  if (rode_out_gap(sample)) {
    std::snprintf(text, sizeof text,
                  "%.1f ms without a haptic step; nobody is held: zero force, then the ramp anew",
                  1e3 * (sample.time - last_time_));
    tell_late(sample, Fault::watchdog, text);
  } else if (rode_out_model(sample, last_weight_)) {
    std::snprintf(text, sizeof text,
                  "contact model %.1f ms old; nobody is held: zero force, then the ramp anew",
                  1e3 * sample.model_age);
    tell_late(sample, Fault::contact_stale, text);
  }
  last_time_ = sample.time;
  last_weight_ = rode_out_gap(sample) ? 0.0 : sample.model_weight;
}

void EventDetector::tell_late(const HapticSample& sample, Fault cause, const char* text) {
  if (sink_) sink_({sample.time, sample.frame, "late", fault_name(cause), text});
}

void EventDetector::observe(const HapticSample& sample, double longest_gap) {
  const auto tell = [&](const char* kind, const char* detail) {
    add({sample.time, sample.frame, kind, detail, {}});
  };
  if (sample.fault == Fault::watchdog && last_fault_ != Fault::watchdog) {
    char text[80];
    std::snprintf(text, sizeof text, "watchdog: %.1f ms without a haptic step", 1e3 * longest_gap);
    add({sample.time, sample.frame, "fault", fault_name(sample.fault), text});
  } else if (sample.fault != last_fault_ && sample.fault != Fault::none) {
    tell("fault", fault_name(sample.fault));
  }
  if (sample.fault == Fault::none && last_fault_ != Fault::none)
    tell("resumed", fault_name(last_fault_));
  look_for_late(sample);
  look_for_old_models(sample);
  look_for_deep_contacts(sample);
  if (sample.is_grasped != was_grasped_) tell(sample.is_grasped ? "grasped" : "released", "");
  if (sample.is_armed != was_armed_) tell(sample.is_armed ? "armed" : "disarmed", "");
  last_fault_ = sample.fault;
  was_grasped_ = sample.is_grasped;
  was_armed_ = sample.is_armed;
}

namespace {

std::vector<StageHistogram> timed_stages(const HapticStatistics& haptic,
                                         const ContactStatistics& contact) {
  const std::pair<const char*, const DurationHistogram*> all[] = {
      {"haptic_wake_late", &haptic.wake_late},   {"haptic_device_read", &haptic.device_read},
      {"haptic_compute", &haptic.compute},       {"haptic_device_write", &haptic.device_write},
      {"haptic_whole", &haptic.whole},           {"haptic_step_cpu", &haptic.step_cpu},
      {"contact_query_cpu", &contact.query_cpu}, {"contact_model_cpu", &contact.model_cpu},
      {"contact_step_cpu", &contact.step_cpu},   {"contact_model_age", &haptic.model_age}};
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
  s.penetration_max = haptic.penetration_max;
  s.stretch_max = haptic.stretch_max;
  s.energy_min = state.energy.energy_min;
  s.ridden_out = haptic.ridden_out;
  s.passivity = summarize(config.haptic.passivity, state.passivity);
  s.dropped_contacts = contact.dropped;
  s.state_hash = haptic.hash.value;
  return s;
}

}  // namespace thigma::detail
