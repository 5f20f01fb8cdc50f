#include "thigma/session/detail/event_detector.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "thigma/clod/hierarchy.h"
#include "thigma/session/statistics.h"

namespace thigma::detail {

DeepContactLimits deep_contact_limits(const SessionConfig& config) noexcept {
  // The direct response lets the object through anything.
  const bool is_held_apart = config.haptic.response != ResponseKind::direct;
  double deep = std::numeric_limits<double>::infinity();
  if (is_held_apart && config.contact.object != nullptr)
    deep = kDeepShare * config.contact.object->radius;
  if (is_held_apart && config.deep_contact > 0.0) deep = config.deep_contact;
  return {deep, config.contact.tolerance};
}

bool Lasting::begins(bool is_there, double elapsed) noexcept {
  seconds = std::max(0.0, seconds + (is_there ? elapsed : -elapsed));
  if (is_told || seconds < kPatience) return false;
  is_told = true;
  return true;
}

void EventDetector::observe(const ContactSample& sample) {
  contact_period_ = sample.time - contact_time_;
  contact_time_ = sample.time;
  travel_ = sample.travel;
  halvings_ = sample.travel_halvings;
  left_out_ = sample.left_out;
}

void EventDetector::add(const SessionEvent& event) {
  if (event.kind == EventKind::fault) safety_events_.push_back(event);
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
  if (has_reported_old_models_ || sample.time - grasp_time_ < kPatience) return;
  has_reported_old_models_ = true;
  char text[160] = "nothing arms: there is no contact model";
  if (std::isfinite(youngest_model_)) {
    std::snprintf(text, sizeof text,
                  "nothing arms: the contact model is always too old, %.1f ms at best",
                  1e3 * youngest_model_);
  }
  add({sample.time, sample.frame, EventKind::not_armed, "contact_model_too_old", text});
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
  if (!has_reported_depth_) {
    std::snprintf(text, sizeof text,
                  "a contact is %.2f mm deep, %.2f mm of it unseen by a contact model %.1f ms old",
                  1e3 * depth, 1e3 * unseen, 1e3 * age);
  }
  has_reported_depth_ = true;
  add({sample.time, sample.frame, EventKind::deep_contact, "contact_model_too_old", text});
}

void EventDetector::look_for_waiting(const HapticSample& sample) {
  char text[240];
  if (held_back_.begins(sample.is_grasped && sample.is_held_back, sample.elapsed)) {
    const char* detail = "contacts_too_slow";
    int length =
        std::snprintf(text, sizeof text,
                      "the object waits for its contacts: it is to go %.2g m/s, and models "
                      "%.1f ms apart let it go %.2g mm each; ",
                      sample.wanted_speed, 1e3 * contact_period_, 1e3 * travel_);
    const char* what_to_do = "move it more slowly, or make contacts faster";
    if (halvings_ > 0) {
      detail = "too_many_rows";
      what_to_do = "more rows are needed than a model holds: coarser meshes, or move it slowly";
    }
    if (left_out_ > 0) {
      detail = "contacts_left_out";
      what_to_do = "contacts have no room, so nothing is free: lift it off, or use coarser meshes";
    }
    std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length), "%s", what_to_do);
    add({sample.time, sample.frame, EventKind::held_back, detail, text});
  }
  if (squeezed_.begins(sample.is_grasped && sample.is_squeezed, sample.elapsed)) {
    add({sample.time, sample.frame, EventKind::squeezed, "",
         "the object is squeezed: surfaces all around are nearer than the gap that is kept, so it "
         "only holds still or slides along them; move it back the way it came"});
  }
}

void EventDetector::look_for_late(const HapticSample& sample) {
  char text[120];
  if (rode_out_gap(sample)) {
    std::snprintf(text, sizeof text,
                  "%.1f ms without a haptic step; nobody is held: zero force, then the ramp anew",
                  1e3 * (sample.time - last_time_));
    add_late(sample, Fault::watchdog, text);
  } else if (rode_out_model(sample, last_weight_)) {
    std::snprintf(text, sizeof text,
                  "contact model %.1f ms old; nobody is held: zero force, then the ramp anew",
                  1e3 * sample.model_age);
    add_late(sample, Fault::contact_stale, text);
  }
  last_time_ = sample.time;
  last_weight_ = rode_out_gap(sample) ? 0.0 : sample.model_weight;
}

void EventDetector::add_late(const HapticSample& sample, Fault cause, const char* text) {
  if (sink_) sink_({sample.time, sample.frame, EventKind::late, fault_name(cause), text});
}

void EventDetector::observe(const HapticSample& sample, double longest_gap, const char* trouble) {
  const auto add_event = [&](EventKind kind, const char* detail) {
    add({sample.time, sample.frame, kind, detail, {}});
  };
  if (sample.fault == Fault::watchdog && last_fault_ != Fault::watchdog) {
    char text[80];
    std::snprintf(text, sizeof text, "watchdog: %.1f ms without a haptic step", 1e3 * longest_gap);
    add({sample.time, sample.frame, EventKind::fault, fault_name(sample.fault), text});
  } else if (sample.fault == Fault::device_lost && last_fault_ != Fault::device_lost) {
    add({sample.time, sample.frame, EventKind::fault, fault_name(sample.fault), trouble});
  } else if (sample.fault != last_fault_ && sample.fault != Fault::none) {
    add_event(EventKind::fault, fault_name(sample.fault));
  }
  if (sample.fault == Fault::none && last_fault_ != Fault::none)
    add_event(EventKind::resumed, fault_name(last_fault_));
  look_for_late(sample);
  look_for_old_models(sample);
  look_for_deep_contacts(sample);
  look_for_waiting(sample);
  if (sample.is_grasped != was_grasped_)
    add_event(sample.is_grasped ? EventKind::grasped : EventKind::released, "");
  if (sample.is_armed != was_armed_)
    add_event(sample.is_armed ? EventKind::armed : EventKind::disarmed, "");
  last_fault_ = sample.fault;
  was_grasped_ = sample.is_grasped;
  was_armed_ = sample.is_armed;
}

void add_note(const std::string& text, const std::string& known, std::vector<std::string>& notes) {
  const auto found = std::find(notes.begin(), notes.end(), known);
  if (found != notes.end()) notes.erase(found);
  notes.push_back(text);
}

}  // namespace thigma::detail
