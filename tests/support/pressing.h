#pragma once
// Pressing one object into another: how contacts turn and jump.

#include <cstdio>
#include <map>
#include <utility>

#include "support/query_path.h"

namespace thigma::test {

struct PressingReport {
  std::int64_t pair_steps = 0, penetrating_steps = 0;  // steps of pairs reported before and after; of those, penetrating
  std::int64_t jumps = 0;     // of these, |change of depth * normal| > 4 x step
  std::int64_t jumps_penetrating = 0;
  std::int64_t off_before = 0;     // penetrating normals more than 90 degrees off the pair's before the objects touched
  std::int64_t off_own = 0;        // ... off the pair's last separated normal, objects touching elsewhere or not
  double deepest = 0.0;            // [radius]
  static double share(std::int64_t bad, std::int64_t all) {
    return all > 0 ? 1.0 - static_cast<double>(bad) / static_cast<double>(all) : 1.0;
  }
};

/// Presses from 0.2 % of the radius outside to `depth` of the radius beyond touch, in steps of 1e-4 of the radius,
/// through the full query as a simulation runs it.
inline PressingReport press(const CheckedPair& pair, const Approach& approach, double depth) {
  const double step = 1e-4 * pair.radius;
  Pose pose = pose_at_gap(pair, approach.start, approach.direction, 0.0);
  pose.position -= 20.0 * step * approach.direction;
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(200'000);
  std::map<std::pair<int, int>, Vec3> before, separated, last, now;
  std::map<std::pair<int, int>, bool> was_penetrating, is_penetrating;
  PressingReport report;
  bool touched = false;
  const int steps = 20 + static_cast<int>(depth / 1e-4);
  for (int i = 0; i <= steps; ++i, pose.position += step * approach.direction) {
    clear(set);
    query_contacts(pair.object, pose, pair.scene, Pose{}, {.tolerance = 0.01 * pair.radius, .keep_directions = true},
                   front, set);
    now.clear();
    is_penetrating.clear();
    bool any_inside = false;
    for (const Contact& c : set.contacts) any_inside |= c.status != ContactStatus::separated;
    touched |= any_inside;
    for (const Contact& c : set.contacts) {
      const std::pair key(c.object_patch, c.scene_patch);
      const bool inside = c.status != ContactStatus::separated;
      now[key] = c.depth * c.normal;
      is_penetrating[key] = inside;
      report.deepest = std::max(report.deepest, c.depth / pair.radius);
      if (!touched) before[key] = c.normal;
      if (inside) {
        if (const auto it = before.find(key); it != before.end() && it->second.dot(c.normal) < 0.0) ++report.off_before;
      }
      if (!inside) separated[key] = c.normal;
      else if (const auto own = separated.find(key); own != separated.end() && own->second.dot(c.normal) < 0.0) ++report.off_own;
      const auto previous = last.find(key);
      if (previous == last.end()) continue;
      const bool counts_inside = inside || was_penetrating[key];
      const bool jumps = (now[key] - previous->second).norm() > 4.0 * step;
      ++report.pair_steps;
      report.penetrating_steps += counts_inside ? 1 : 0;
      report.jumps += jumps ? 1 : 0;
      report.jumps_penetrating += jumps && counts_inside ? 1 : 0;
    }
    last.swap(now);
    was_penetrating.swap(is_penetrating);
  }
  std::printf("  %-14s pressed to %.4f of the radius: depth * normal moved by at most 4 steps in %.3f %% of %lld pair-steps "
              "(%.2f %% of the %lld penetrating); normals over 90 degrees off the one before contact: %lld (off the "
              "pair's last separated one: %lld)\n",
              pair.name.c_str(), report.deepest, 100.0 * PressingReport::share(report.jumps, report.pair_steps),
              static_cast<long long>(report.pair_steps),
              100.0 * PressingReport::share(report.jumps_penetrating, report.penetrating_steps),
              static_cast<long long>(report.penetrating_steps), static_cast<long long>(report.off_before),
              static_cast<long long>(report.off_own));
  return report;
}

inline void expect_smooth(const PressingReport& report) {
  EXPECT_GT(report.penetrating_steps, 50);
  EXPECT_EQ(report.off_before, 0);
  EXPECT_GE(PressingReport::share(report.jumps, report.pair_steps), 0.995);
}

}  // namespace thigma::test
