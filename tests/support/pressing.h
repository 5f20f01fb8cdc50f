#pragma once
// Pressing one object into another: how contacts turn and jump.

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "support/query_path.h"

namespace thigma::test {

struct PressingReport {
  // steps of pairs reported before and after; of those, penetrating
  std::int64_t pair_steps = 0, penetrating_steps = 0;
  std::int64_t jumps = 0;  // of these, |change of depth * normal| > 4 x step
  std::int64_t jumps_penetrating = 0;
  // Penetrating normals (depth > 0) more than 90 degrees off ...
  std::int64_t off_reference = 0;  // ... that of the closest pair before the objects touched
  std::int64_t off_before = 0;     // ... the pair's own before the objects touched
  // ... the pair's own when it was last separated, the objects touching elsewhere or not
  std::int64_t off_own = 0;
  double deepest = 0.0;  // [radius]
  static double share(std::int64_t bad, std::int64_t all) {
    return all > 0 ? 1.0 - static_cast<double>(bad) / static_cast<double>(all) : 1.0;
  }
};

inline const Contact& closest(const ContactSet& set) {
  return *std::max_element(set.contacts.begin(), set.contacts.end(),
                           [](const Contact& x, const Contact& y) { return x.depth < y.depth; });
}

inline bool is_opposed(const std::map<std::pair<int, int>, Vec3>& normals,
                       const std::pair<int, int>& key, const Vec3& normal) {
  const auto it = normals.find(key);
  return it != normals.end() && it->second.dot(normal) < 0.0;
}

/// Presses from 0.2 % of the radius outside to `depth` of the radius beyond touch, in steps of 1e-4
/// of the radius, through the full query: as a simulation runs it, or each pose for itself.
inline PressingReport press(const CheckedPair& pair, const Approach& approach, double depth,
                            bool keep_directions) {
  const double step = 1e-4 * pair.radius;
  Pose pose = pose_at_gap(pair, approach.start, approach.direction, 0.0);
  pose.position -= 20.0 * step * approach.direction;
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(200'000);
  std::map<std::pair<int, int>, Vec3> before, separated, last, now;
  std::map<std::pair<int, int>, bool> was_penetrating, is_penetrating;
  PressingReport report;
  Vec3 reference = Vec3::Zero();
  bool touched = false;
  const int steps = 20 + static_cast<int>(depth / 1e-4);
  for (int i = 0; i <= steps; ++i, pose.position += step * approach.direction) {
    clear(set);
    query_contacts({pair.object, pose}, {pair.scene},
                   {.tolerance = 0.01 * pair.radius, .keep_directions = keep_directions}, front,
                   set);
    now.clear();
    is_penetrating.clear();
    for (const Contact& c : set.contacts) touched |= c.status != ContactStatus::separated;
    if (!touched && !set.contacts.empty()) reference = closest(set).normal;
    for (const Contact& c : set.contacts) {
      const std::pair key(c.object_patch, c.scene_patch);
      const bool inside = c.depth > 0.0;
      now[key] = c.depth * c.normal;
      is_penetrating[key] = inside;
      report.deepest = std::max(report.deepest, c.depth / pair.radius);
      if (!touched) before[key] = c.normal;
      if (!inside) separated[key] = c.normal;
      report.off_reference += inside && reference.dot(c.normal) < 0.0;
      report.off_before += inside && is_opposed(before, key, c.normal);
      report.off_own += inside && is_opposed(separated, key, c.normal);
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
  std::printf(
      "  %-14s %s, deepest %.4f of the radius: depth * normal moved by at most 4 steps in %.3f %% "
      "of %lld "
      "pair-steps (%.2f %% of the %lld penetrating); penetrating normals over 90 degrees off the "
      "closest pair's "
      "before contact: %lld, off the pair's own before contact: %lld, off its last separated one: "
      "%lld\n",
      pair.name.c_str(), keep_directions ? "with memory" : "pose alone", report.deepest,
      100.0 * PressingReport::share(report.jumps, report.pair_steps),
      static_cast<long long>(report.pair_steps),
      100.0 * PressingReport::share(report.jumps_penetrating, report.penetrating_steps),
      static_cast<long long>(report.penetrating_steps),
      static_cast<long long>(report.off_reference), static_cast<long long>(report.off_before),
      static_cast<long long>(report.off_own));
  return report;
}

inline void expect_smooth_pressing(const CheckedPair& pair, const Approach& approach) {
  for (const bool keep_directions : {true, false}) {
    const PressingReport report = press(pair, approach, 0.005, keep_directions);
    EXPECT_GT(report.penetrating_steps, 50);
    EXPECT_EQ(report.off_reference, 0);
    EXPECT_EQ(report.off_before, 0);
    EXPECT_EQ(report.off_own, 0);
    EXPECT_GE(PressingReport::share(report.jumps, report.pair_steps), 0.995);
  }
}

}  // namespace thigma::test
