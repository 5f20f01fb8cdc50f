#include "thigma/multibody/joint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

[[noreturn]] void refuse(const WorldJoint& joint, const std::string& what) {
  throw InputError("joint '" + joint.name + "': " + what);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

bool is_pose(const Pose& pose) {
  constexpr double kUnit = 1e-6;
  return pose.position.allFinite() && std::fabs(pose.orientation.norm() - 1.0) <= kUnit;
}

// Squares and products of three are doubles still.
constexpr double kMostNumber = 1e100;

bool is_bounded(double value) { return std::fabs(value) <= kMostNumber; }

bool is_at_least_zero(double value) { return value >= 0.0 && is_bounded(value); }

bool is_motor(const JointMotor& motor) {
  return is_bounded(motor.target) && is_at_least_zero(motor.most) &&
         is_at_least_zero(motor.stiffness) && is_at_least_zero(motor.damping);
}

void check_numbers(const WorldJoint& joint) {
  if (!is_pose(joint.a_from_joint) || !is_pose(joint.b_from_joint))
    refuse(joint, "place or axis, expected finite numbers and unit quaternions");
  if (!is_at_least_zero(joint.stiffness) || !is_at_least_zero(joint.damping) ||
      !is_bounded(joint.rest))
    refuse(joint, "stiffness, damping or rest, expected numbers to 1e100, the first two >= 0");
  if (joint.motor.is_on && !is_motor(joint.motor))
    refuse(joint, "motor, expected numbers to 1e100, all but the target >= 0");
  if (std::isnan(joint.lower) || std::isnan(joint.upper) || !(joint.lower < joint.upper))
    refuse(joint, "limits " + number(joint.lower) + " to " + number(joint.upper) +
                      ", expected the lower one below the upper one");
}

void check_kind(const WorldJoint& joint) {
  const bool is_limited = std::isfinite(joint.lower) || std::isfinite(joint.upper);
  const bool has_axis = joint.kind == JointKind::hinge || joint.kind == JointKind::slider;
  if ((is_limited || joint.motor.is_on) && !has_axis)
    refuse(joint, "limits or a motor, expected them on a hinge or a slider");
  if ((joint.stiffness > 0.0 || joint.damping > 0.0) && !has_coordinate(joint.kind))
    refuse(joint, "stiffness or damping, expected them on a hinge, a slider or a spring");
  if (joint.kind == JointKind::spring && !(joint.stiffness > 0.0 || joint.damping > 0.0))
    refuse(joint, "a spring without stiffness and damping, expected one of them above 0");
  constexpr double kMostAngle = 3.0;  // an angle is known to a turn only
  const auto is_angle = [](double x) { return std::fabs(x) <= kMostAngle; };
  if (joint.kind != JointKind::hinge) return;
  if ((std::isfinite(joint.lower) && !is_angle(joint.lower)) ||
      (std::isfinite(joint.upper) && !is_angle(joint.upper)) || !is_angle(joint.rest) ||
      (joint.motor.is_on && joint.motor.is_servo && !is_angle(joint.motor.target)))
    refuse(joint, "an angle of its limits, its rest or its motor, expected -3 to 3 rad");
}

}  // namespace

JointEnds joint_ends(const JointLaw& joint, std::span<const BodyState> bodies) noexcept {
  JointEnds ends;
  const BodyState& a = bodies[idx(joint.a)];
  const Mat3 turn_a = rotation_matrix(a.orientation);
  ends.arm_a = turn_a * joint.a_from_joint.position;
  ends.axes_a = turn_a * rotation_matrix(joint.a_from_joint.orientation);
  Vec3 centre_b = Vec3::Zero();
  Mat3 turn_b = Mat3::Identity();
  if (joint.b >= 0) {
    centre_b = bodies[idx(joint.b)].position;
    turn_b = rotation_matrix(bodies[idx(joint.b)].orientation);
  }
  ends.arm_b = turn_b * joint.b_from_joint.position;
  ends.axes_b = turn_b * rotation_matrix(joint.b_from_joint.orientation);
  ends.apart = (a.position - centre_b) + ends.arm_a - ends.arm_b;
  return ends;
}

Pose joint_frame(const Vec3& place, const Vec3& axis) noexcept {
  return {place, Quat::FromTwoVectors(Vec3::UnitZ(), axis)};
}

void place_joint(JointLaw& joint, const Pose& frame, std::span<const BodyState> bodies) noexcept {
  const auto local = [&](std::int32_t body) {
    if (body < 0) return frame;
    const BodyState& y = bodies[idx(body)];
    return inverse(Pose{y.position, y.orientation}) * frame;
  };
  joint.a_from_joint = local(joint.a);
  joint.b_from_joint = local(joint.b);
}

double joint_coordinate(JointKind kind, const JointEnds& ends) noexcept {
  if (kind == JointKind::slider) return ends.axes_b.col(2).dot(ends.apart);
  if (kind == JointKind::spring) return ends.apart.norm();
  if (kind != JointKind::hinge) return 0.0;
  const Vec3 across = ends.axes_a.col(0);
  return arc_tangent2(ends.axes_b.col(1).dot(across), ends.axes_b.col(0).dot(across));
}

double coordinate_difference(JointKind kind, double x, double y) noexcept {
  const double by = x - y;
  if (kind != JointKind::hinge || std::fabs(by) <= kPi) return by;
  return by > 0.0 ? by - 2.0 * kPi : by + 2.0 * kPi;
}

int joint_errors(JointKind kind, const JointEnds& ends, double arm,
                 std::span<double, 6> out) noexcept {
  if (kind == JointKind::spring) return 0;
  const Mat3 &a = ends.axes_a, &b = ends.axes_b;
  std::size_t count = 0;
  if (kind == JointKind::slider) {
    for (int k = 0; k < 2; ++k) out[count++] = b.col(k).dot(ends.apart);
  } else {
    for (int k = 0; k < 3; ++k) out[count++] = ends.apart[k];
  }
  if (kind == JointKind::hinge) {
    for (int k = 0; k < 2; ++k) out[count++] = arm * a.col(2).dot(b.col(k));
  } else if (kind != JointKind::ball) {
    for (int k = 0; k < 3; ++k) out[count++] = arm * a.col(k).dot(b.col((k + 1) % 3));
  }
  return static_cast<int>(count);
}

double joint_energy(const JointLaw& joint, std::span<const BodyState> bodies) noexcept {
  if (!(joint.stiffness > 0.0)) return 0.0;
  const double x = joint_coordinate(joint.kind, joint_ends(joint, bodies));
  const double stretch = coordinate_difference(joint.kind, x, joint.rest);
  return 0.5 * joint.stiffness * stretch * stretch;
}

void check_joint(const WorldJoint& joint, std::span<const BodyState> bodies, double size) {
  const auto count = static_cast<std::int32_t>(bodies.size());
  if (joint.a < 0 || joint.a >= count || joint.b < -1 || joint.b >= count)
    refuse(joint, "a body that is not there, expected one of the world's");
  if (joint.a == joint.b) refuse(joint, "the same body twice, expected two");
  check_numbers(joint);
  check_kind(joint);
  const JointEnds ends = joint_ends(joint, bodies);
  constexpr double kMostArm = 1e4;  // of the size: a turn of 1e-12 is still met to 1e-8 of it
  const double arm = std::max(ends.arm_a.norm(), joint.b < 0 ? 0.0 : ends.arm_b.norm());
  if (!(arm <= kMostArm * size))
    refuse(joint, "place " + number(arm) + " m from a body's centre, expected at most " +
                      number(kMostArm * size));
  std::array<double, 6> errors{};
  const int numbers = joint_errors(joint.kind, ends, size, errors);
  double worst = 0.0;
  for (int k = 0; k < numbers; ++k) worst = std::max(worst, std::fabs(errors[idx(k)]));
  constexpr double kMet = 1e-6;  // of the size: what is typed with seven digits
  if (worst > kMet * size)
    refuse(joint, "its halves start " + number(1e3 * worst) + " mm apart, expected them together");
  // Turned by half all products are zero as well.
  const auto is_turned = [&](int k) { return ends.axes_a.col(k).dot(ends.axes_b.col(k)) < 0.0; };
  const bool has_turn_free = joint.kind == JointKind::ball || joint.kind == JointKind::spring;
  if (!has_turn_free && (is_turned(2) || (joint.kind != JointKind::hinge && is_turned(0))))
    refuse(joint, "its halves start turned by half, expected them together");
  const double x = joint_coordinate(joint.kind, ends);
  const double room = kMet * (joint.kind == JointKind::hinge ? 1.0 : size);
  if (x < joint.lower - room || x > joint.upper + room)
    refuse(joint, "starts at " + number(x) + ", expected within its limits " + number(joint.lower) +
                      " to " + number(joint.upper));
}

}  // namespace thigma
