#pragma once
// Pressing one object into another: how contacts turn and jump.

#include <cstdio>
#include <map>
#include <utility>

#include "support/query_path.h"

namespace thigma::test {

struct PressingReport {
  std::int64_t pair_steps = 0, penetrating_steps = 0;  // steps of pairs reported before and after; of those, penetrating
  std::int64_t jumps = 0;                              // |change of depth * normal| > 4 x step, of the penetrating
  std::int64_t turned = 0;                             // normals more than 90 degrees off the one before contact
  double deepest = 0.0;                                // [radius]
  double smooth_share() const {
    return penetrating_steps > 0 ? 1.0 - static_cast<double>(jumps) / static_cast<double>(penetrating_steps) : 1.0;
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
  std::map<std::pair<int, int>, Vec3> before, last, now;  // normal before contact; depth times normal
  std::map<std::pair<int, int>, bool> was_penetrating, is_penetrating;
  PressingReport report;
  const int steps = 20 + static_cast<int>(depth / 1e-4);
  for (int i = 0; i <= steps; ++i, pose.position += step * approach.direction) {
    clear(set);
    query_contacts(pair.object, pose, pair.scene, Pose{}, {.tolerance = 0.01 * pair.radius, .keep_directions = true},
                   front, set);
    now.clear();
    is_penetrating.clear();
    for (const Contact& c : set.contacts) {
      const std::pair key(c.object_patch, c.scene_patch);
      const bool inside = c.status != ContactStatus::separated;
      now[key] = c.depth * c.normal;
      is_penetrating[key] = inside;
      report.deepest = std::max(report.deepest, c.depth / pair.radius);
      if (!inside) before[key] = c.normal;
      else if (const auto known = before.find(key); known != before.end() && known->second.dot(c.normal) < 0.0) ++report.turned;
      const auto previous = last.find(key);
      if (previous == last.end()) continue;
      ++report.pair_steps;
      if (!inside && !was_penetrating[key]) continue;
      ++report.penetrating_steps;
      if ((now[key] - previous->second).norm() > 4.0 * step) ++report.jumps;
    }
    last.swap(now);
    was_penetrating.swap(is_penetrating);
  }
  std::printf("  %-14s %lld pair-steps, %lld penetrating, deepest %.4f of the radius; depth * normal within 4 steps in "
              "%.3f %%; turned by more than 90 degrees: %lld\n",
              pair.name.c_str(), static_cast<long long>(report.pair_steps),
              static_cast<long long>(report.penetrating_steps), report.deepest, 100.0 * report.smooth_share(),
              static_cast<long long>(report.turned));
  return report;
}

inline void expect_smooth(const PressingReport& report) {
  EXPECT_GT(report.penetrating_steps, 50);
  EXPECT_EQ(report.turned, 0);
  EXPECT_GE(report.smooth_share(), 0.995);
}

}  // namespace thigma::test
