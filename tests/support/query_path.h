#pragma once
// Paths into contact, and the whole check of a pair of objects along them.

#include <cmath>
#include <cstdio>
#include <string>

#include "support/full.h"
#include "support/query_check.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma::test {

inline Quat turn(const Vec3& axis, double degrees) {
  const SinCos half = sin_cos(0.5 * degrees * kPi / 180.0);
  const Vec3 v = half.sin * axis;
  return Quat(half.cos, v.x(), v.y(), v.z());
}

/// Where the object starts outside the scene, and the way in.
struct Approach {
  Pose start;
  Vec3 direction = -Vec3::UnitZ();
};

/// A path from 3 % of the radius outside through touch to 1 % inside, wobbling and sliding by a
/// little.
inline Pose on_path(const CheckedPair& pair, const Pose& touch, const Vec3& direction, double s) {
  const double r = pair.radius;
  Pose pose = touch;
  pose.position += (-0.03 + 0.04 * s) * r * direction;
  Vec3 side =
      direction.cross(std::fabs(direction.x()) < 0.5 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY()))
          .normalized();
  pose.position += 0.01 * r * sine(9.0 * s) * side;
  pose.orientation = turn(side, 0.5 * sine(7.0 * s)) * pose.orientation;
  pose.orientation.normalize();
  return pose;
}

/// A turned object at -1 to 2 % of the radius from touch, from any side.
inline Pose random_pose_near(const CheckedPair& pair, Random& random) {
  Pose start;
  start.orientation = random.orientation();
  const Vec3 direction = random.direction();
  const double apart = 1.1 * (pair.object.radius + pair.scene.radius);
  start.position = pair.scene.center - apart * direction - start.orientation * pair.object.center;
  return pose_at_gap(pair, start, direction, random.uniform(-0.01, 0.02) * pair.radius);
}

inline void query_pose(const CheckedPair& pair, const Pose& pose, double d, ContactFront& front,
                       ContactSet& set) {
  clear(set);
  query_contacts({pair.object, pose}, {pair.scene}, {.tolerance = d}, front, set);
  ASSERT_EQ(set.dropped, 0);
}

inline void check_pair(const CheckedPair& pair, const Approach& approach, double d) {
  const int coherent = is_full() ? 1000 : 46;
  const int random_poses = is_full() ? 200 : 4;
  ContactFront front, fresh;
  ContactSet set, fresh_set;
  set.contacts.reserve(400'000);
  fresh_set.contacts.reserve(400'000);
  CheckCounts counts;
  auto check = [&](const Pose& pose) {
    query_pose(pair, pose, d, front, set);
    clear_front(fresh);
    query_pose(pair, pose, d, fresh, fresh_set);
    EXPECT_EQ(first_difference(set, fresh_set), -1)
        << pair.name << ": remembering changed the answer";
    check_against_search(pair, pose, d, set, counts);
  };
  const Pose touch = pose_at_gap(pair, approach.start, approach.direction, 0.0);
  for (int i = 0; i < coherent; ++i) {
    SCOPED_TRACE("coherent pose " + std::to_string(i));
    check(on_path(pair, touch, approach.direction, i / (coherent - 1.0)));
    if (::testing::Test::HasFailure()) return;
  }
  Random random(17);
  for (int i = 0; i < random_poses; ++i) {
    SCOPED_TRACE("random pose " + std::to_string(i));
    check(random_pose_near(pair, random));
    if (::testing::Test::HasFailure()) return;
  }
  std::printf(
      "  %-22s %lld poses, %lld contacts, %lld triangle pairs, %lld poses intersecting; worst "
      "error of the "
      "smallest separation %.1e, of a contact %.1e of the radius\n",
      pair.name.c_str(), static_cast<long long>(counts.poses),
      static_cast<long long>(counts.contacts), static_cast<long long>(counts.triangle_pairs),
      static_cast<long long>(counts.intersecting), counts.worst_distance, counts.worst_contact);
}

inline CheckedPair checked(const std::string& name, const TriangleMesh& object,
                           const TriangleMesh& scene) {
  return make_checked_pair(name, object, scene, build_exact_hierarchy(object),
                           build_exact_hierarchy(scene));
}

inline Approach from_above(const CheckedPair& pair) {
  Approach approach;
  approach.start.position = pair.scene.center - pair.object.center +
                            Vec3(0, 0, 1.05 * (pair.scene.radius + pair.object.radius));
  return approach;
}

}  // namespace thigma::test
