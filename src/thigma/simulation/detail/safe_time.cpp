#include "thigma/simulation/detail/safe_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

// How long a gap lasts: closing speed now, and how fast that may grow.
double time_to_close(double gap, double speed, double acceleration) {
  const double v = std::max(speed, 0.0);
  const double root = std::sqrt(v * v + 2.0 * acceleration * gap);
  return root > 0.0 ? 2.0 * gap / (v + root) : 1e300;
}

// Size of a patch about the place of a contact: points of it may approach faster than that place.
double patch_reach(const ClodHierarchy& hierarchy, const Contact& c, const Pose& world_from_mesh) {
  const auto i = static_cast<std::size_t>(c.object_patch);
  Vec3 center;
  double radius = 0.0;
  if (i < hierarchy.patches.size()) {
    const ClodNode& node = hierarchy.nodes[static_cast<std::size_t>(hierarchy.patches[i].node)];
    center = node.center;
    radius = node.radius;
  } else {
    const LevelPatch& patch = hierarchy.level_patches[i - hierarchy.patches.size()];
    center = patch.center;
    radius = patch.radius;
  }
  return radius + (transform_point(world_from_mesh, center) - c.point).norm();
}

}  // namespace

double least_gap(const SimulationWorld& world, const ContactSet& contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const Contact& c : contacts.contacts) least = std::min(least, gap_of(world, c));
  return least;
}

ApproachingContact approaching(const SimulationWorld& world, const BodyState& state,
                               const Contact& c) {
  const Vec3 arm = c.point - state.position;
  return {arm, c.normal.dot(point_velocity(world.body, state, arm)), gap_of(world, c)};
}

double safe_time(const SimulationWorld& world, const BodyState& state, const ContactSet& contacts,
                 double reach, const PushedFlight& flight) {
  const Wrench& push = flight.push;
  const RigidBody& body = world.body;
  const Twist v = velocity(body, state);
  const Mat3 R = rotation_matrix(state.orientation);
  const Vec3 linear = body.gravity + push.force / body.mass;
  const Vec3 angular = R * (body.inverse_inertia * (R.transpose() * push.torque));
  // The spin of a free body never exceeds |L| over its least moment of inertia.
  const double most = state.angular_momentum.norm() + flight.time * push.torque.norm();
  const double fastest = std::max(v.angular.norm(), most * body.inverse_inertia.norm());
  const double swing = fastest * fastest * reach;
  double least = time_to_close(world.tolerance, v.linear.norm() + fastest * reach,
                               linear.norm() + angular.norm() * reach + swing);
  const Pose world_from_mesh = Pose{state.position, state.orientation} * world.body_from_mesh;
  const double near = collision_gap(world);
  for (const Contact& c : contacts.contacts) {
    const ApproachingContact t = approaching(world, state, c);
    const double patch = patch_reach(*world.object, c, world_from_mesh);
    const double turning = c.normal.cross(v.angular).norm() * patch;
    const double falls = std::max(c.normal.dot(linear + angular.cross(t.arm)), 0.0) +
                         c.normal.cross(angular).norm() * patch + swing;
    const double gap = t.gap > near ? t.gap - 0.5 * near : kShortestFall * near;
    least = std::min(least, time_to_close(gap, t.approach + turning, falls));
  }
  return least;
}

}  // namespace thigma::detail
