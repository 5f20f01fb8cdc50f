#pragma once
// The list of safety limits that scene files and recordings follow.

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "thigma/loop/safety.h"

namespace thigma {

/// Calls visit(key, number) for every number of the limits.
template <class Limits, class Visit>
void visit_safety_limits(Limits& s, Visit&& visit) {
  visit("max_force", s.max_force);
  visit("max_torque", s.max_torque);
  visit("force_slew", s.force_slew);
  visit("torque_slew", s.torque_slew);
  visit("onset_window", s.onset_window);
  visit("start_ramp", s.start_ramp);
  visit("clear_before_arming", s.clear_before_arming);
  visit("max_speed", s.max_speed);
  visit("pose_jump", s.pose_jump);
  visit("max_turn_speed", s.max_turn_speed);
  visit("orientation_jump", s.orientation_jump);
  visit("silent_device", s.silent_device);
  visit("model_full_age", s.model_full_age);
  visit("model_stale_age", s.model_stale_age);
  visit("rows_full_age", s.rows_full_age);
  visit("rows_stale_age", s.rows_stale_age);
  visit("watchdog", s.watchdog);
}

/// The stricter of two, limit by limit: the shorter, slower or weaker, of waits the longer. Thread
/// [offline].
inline SafetyLimits stricter(SafetyLimits a, const SafetyLimits& b) {
  std::vector<double> others;
  visit_safety_limits(b, [&](const char*, double limit) { others.push_back(limit); });
  std::size_t next = 0;
  visit_safety_limits(a, [&](std::string_view key, double& limit) {
    const double other = others[next++];
    const bool is_wait = key == "start_ramp" || key == "clear_before_arming";
    limit = is_wait ? std::max(limit, other) : std::min(limit, other);
  });
  return a;
}

}  // namespace thigma
