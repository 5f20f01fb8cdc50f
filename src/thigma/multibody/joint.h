#pragma once
// Joints between two bodies of a world, or between one and the world.

#include <cstdint>
#include <span>
#include <string>

#include "thigma/dynamics/body.h"
#include "thigma/math/infinity.h"
#include "thigma/math/pose.h"

namespace thigma {

/// What a joint leaves free.
enum class JointKind : std::uint8_t {
  fixed,   // nothing
  hinge,   // turning about its axis
  slider,  // going along its axis
  ball,    // turning
  spring,  // everything: it pulls its two places together or apart, along the line between them
};

/// A motor along the coordinate of a hinge or a slider.
struct JointMotor {
  bool is_on = false;
  bool is_servo = false;  // target is a place, which stiffness and damping hold; else a speed
  double target = 0.0;    // [m/s, rad/s], of a servo [m, rad]
  double most = 0.0;      // force or torque at most, >= 0 [N, N m]
  double stiffness = 0.0, damping = 0.0;  // of a servo [N/m, N s/m; N m/rad, N m s/rad]
};

/// What a joint is, by whatever name. Its frame has the axis as z. Coordinate of a hinge: angle of
/// a against b about the axis, 0 where both frames coincide, in (-pi, pi]; of a slider: way of a
/// against b along the axis; of a spring: distance of both places.
struct JointLaw {
  JointKind kind = JointKind::ball;
  std::int32_t a = -1, b = -1;                   // bodies; b = -1: the world
  Pose a_from_joint{};                           // [a's frame, from its centre of mass]
  Pose b_from_joint{};                           // likewise of b, or [world]
  double lower = -kInfinity, upper = kInfinity;  // of the coordinate of a hinge or a slider
  // along the coordinate of a hinge, a slider or a spring
  double stiffness = 0.0, damping = 0.0;  // [N/m, N s/m; N m/rad, N m s/rad]
  double rest = 0.0;                      // where it is at ease [m, rad]
  JointMotor motor{};
  bool touches = false;  // whether the two bodies may touch each other
};

/// A joint of a world.
struct WorldJoint : JointLaw {
  std::string name;
};

/// The frame of a joint on both of its bodies, at a state.
struct JointEnds {
  Vec3 arm_a = Vec3::Zero(), arm_b = Vec3::Zero();            // from the centres of mass [m; world]
  Vec3 apart = Vec3::Zero();                                  // of a's place, from b's [m; world]
  Mat3 axes_a = Mat3::Identity(), axes_b = Mat3::Identity();  // columns [world]
};
JointEnds joint_ends(const JointLaw& joint, std::span<const BodyState> bodies) noexcept;

/// Frame at a place whose z is an axis of any length above 0 [world].
Pose joint_frame(const Vec3& place, const Vec3& axis) noexcept;

/// Puts the frames of a joint where its bodies, as they stand, have it.
///
/// joint    a and b set
/// frame    [world]; of both bodies
void place_joint(JointLaw& joint, const Pose& frame, std::span<const BodyState> bodies) noexcept;

/// Whether a kind has a coordinate.
inline bool has_coordinate(JointKind kind) noexcept {
  return kind == JointKind::hinge || kind == JointKind::slider || kind == JointKind::spring;
}

/// The coordinate [m, rad]; 0 of kinds without.
double joint_coordinate(JointKind kind, const JointEnds& ends) noexcept;

/// x less y, of a hinge the shorter way round.
double coordinate_difference(JointKind kind, double x, double y) noexcept;

/// Numbers that have to be 0, as many as the kind takes freedoms away, 0 to 6.
///
/// arm      what an angle is multiplied with [m]
/// out      [m]
/// returns  how many
int joint_errors(JointKind kind, const JointEnds& ends, double arm,
                 std::span<double, 6> out) noexcept;

/// What the springs of a joint hold, those of servos not counted [J].
double joint_energy(const JointLaw& joint, std::span<const BodyState> bodies) noexcept;

/// Refuses a joint that makes no sense, or that a start does not meet.
///
/// bodies   at the start
/// names    of the bodies
/// size     of what it joins: errors are measured by it [m]
/// errors   InputError "joint 'NAME': ..."
/// Thread   [offline]
void check_joint(const WorldJoint& joint, std::span<const BodyState> bodies, double size);

}  // namespace thigma
