#include "thigma/multibody/detail/joint_rows.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// Derivatives of a number by the velocities of both bodies.
struct Gradient {
  Vec6 on_a = Vec6::Zero(), on_b = Vec6::Zero();
};

JointEnds mean_of(const JointEnds& x, const JointEnds& y) noexcept {
  JointEnds mean;
  mean.arm_a = 0.5 * (x.arm_a + y.arm_a);
  mean.arm_b = 0.5 * (x.arm_b + y.arm_b);
  mean.apart = 0.5 * (x.apart + y.apart);
  mean.axes_a = 0.5 * (x.axes_a + y.axes_a);
  mean.axes_b = 0.5 * (x.axes_b + y.axes_b);
  return mean;
}

/// Of `apart` along a direction that stands still.
Gradient along_fixed(const JointEnds& at, const Vec3& direction) noexcept {
  Gradient g;
  g.on_a << direction, at.arm_a.cross(direction);
  g.on_b << -direction, -at.arm_b.cross(direction);
  return g;
}

/// Of `apart` along a direction that b carries.
Gradient along_carried(const JointEnds& at, const Vec3& direction) noexcept {
  Gradient g;
  g.on_a << direction, at.arm_a.cross(direction);
  g.on_b << -direction, -(at.arm_b + at.apart).cross(direction);
  return g;
}

/// Of turning a against b about an axis.
Gradient about(const Vec3& axis) noexcept {
  Gradient g;
  g.on_a.tail<3>() = axis;
  g.on_b.tail<3>() = -axis;
  return g;
}

/// Gradients of joint_errors, in its order; returns how many.
int hold_gradients(JointKind kind, const JointEnds& at, double arm,
                   std::array<Gradient, 6>& out) noexcept {
  if (kind == JointKind::spring) return 0;
  const Mat3 &a = at.axes_a, &b = at.axes_b;
  std::size_t count = 0;
  if (kind == JointKind::slider) {
    for (int k = 0; k < 2; ++k) out[count++] = along_carried(at, b.col(k));
  } else {
    for (int k = 0; k < 3; ++k) out[count++] = along_fixed(at, Vec3::Unit(k));
  }
  const auto crossed = [&](int i, int k) -> Vec3 { return arm * a.col(i).cross(Vec3(b.col(k))); };
  if (kind == JointKind::hinge) {
    for (int k = 0; k < 2; ++k) out[count++] = about(crossed(2, k));
  } else if (kind != JointKind::ball) {
    for (int k = 0; k < 3; ++k) out[count++] = about(crossed(k, (k + 1) % 3));
  }
  return static_cast<int>(count);
}

double speed_of(const Gradient& g, const JointPart& part) noexcept {
  return g.on_a.dot(part.u_a) + g.on_b.dot(part.u_b);
}

/// What an angle of the joint is multiplied with.
double scale_of(const JointPart& part) noexcept {
  return part.joint.kind == JointKind::hinge ? part.arm : 1.0;
}

/// Gradient of the coordinate, times its scale, between two ends; zero where it has no direction.
Gradient coordinate_gradient(const JointPart& part, const JointEnds& begin,
                             const JointEnds& end) noexcept {
  const JointEnds mean = mean_of(begin, end);
  const JointKind kind = part.joint.kind;
  if (kind == JointKind::slider) return along_carried(mean, mean.axes_b.col(2));
  if (kind == JointKind::spring) {
    const double sum = begin.apart.norm() + end.apart.norm();
    if (!(sum > 0.0)) return {};
    return along_fixed(mean, 2.0 * mean.apart / sum);
  }
  return about(part.arm * mean.axes_b.col(2).normalized());
}

/// The same, as long as the way that the coordinate goes: an angle is no bilinear number.
Gradient mean_gradient(const JointPart& part) noexcept {
  Gradient g = coordinate_gradient(part, part.begin, part.end);
  const JointKind kind = part.joint.kind;
  if (kind != JointKind::hinge) return g;
  const double way = scale_of(part) * coordinate_difference(kind, joint_coordinate(kind, part.end),
                                                            joint_coordinate(kind, part.begin));
  const double linear = part.dt * speed_of(g, part);
  constexpr double kMost = 0.1;  // of it: a turn differs from its rate by less in a step
  if (!(std::fabs(way - linear) <= kMost * std::fabs(linear)) || linear == 0.0) return g;
  g.on_a *= way / linear;
  g.on_b *= way / linear;
  return g;
}

JointRow row_of(const JointPart& part, const Gradient& g) noexcept {
  JointRow row;
  row.a = part.a;
  row.b = part.b;
  row.on_a = g.on_a;
  row.on_b = g.on_b;
  return row;
}

void push(const JointRow& row, std::size_t place, JointRowKind kind, const JointPart& part,
          const JointImpulses& before, JointRowList& list) {
  list.rows.push_back(row);
  list.rows.back().impulse = std::clamp(before[place], row.low, row.high);
  list.sources.push_back({part.number, place, kind});
}

/// Spring and damper towards a place: the force at the mean of the part.
bool soften(JointRow& row, const JointPart& part, double stiffness, double damping,
            double stretch) noexcept {
  const double scale = scale_of(part), time = part.share * part.dt;
  const double slope = time * stiffness + damping;
  if (!(slope > 0.0)) return false;
  row.firmness = time * slope / (scale * scale);
  row.target = -scale * stiffness * stretch / slope;
  return true;
}

void list_soft_rows(const JointPart& part, const JointImpulses& before, JointRowList& list) {
  const JointLaw& joint = part.joint;
  const Gradient g = mean_gradient(part);
  const double x = joint_coordinate(joint.kind, part.begin);
  JointRow spring = row_of(part, g);
  const double stretch = coordinate_difference(joint.kind, x, joint.rest);
  if (soften(spring, part, joint.stiffness, joint.damping, stretch))
    push(spring, kSpringPlace, JointRowKind::spring, part, before, list);
  const JointMotor& motor = part.motor;
  if (!motor.is_on || !motor.is_servo) return;
  JointRow servo = row_of(part, g);
  const double off = coordinate_difference(joint.kind, x, motor.target);
  servo.high = part.share * part.dt * motor.most / scale_of(part);
  servo.low = -servo.high;
  if (soften(servo, part, motor.stiffness, motor.damping, off))
    push(servo, kMotorPlace, JointRowKind::servo, part, before, list);
}

/// A motor at a speed.
JointRow motor_row(const JointPart& part, const Gradient& g, double given) noexcept {
  JointRow row = row_of(part, g);
  const double scale = scale_of(part), most = part.dt * part.motor.most / scale;
  row.target = scale * part.motor.target;
  row.high = std::max(most - given, 0.0);
  row.low = std::min(-most - given, 0.0);
  return row;
}

/// What acts at the beginning: its gradient there, its target what brings the end where it may be.
void list_beginning_rows(const JointPart& part, const JointImpulses& before, JointRowList& list) {
  const JointLaw& joint = part.joint;
  const Gradient g = coordinate_gradient(part, part.begin, part.begin);
  const double x = joint_coordinate(joint.kind, part.end), scale = scale_of(part);
  if (part.motor.is_on && !part.motor.is_servo) {
    JointRow motor = motor_row(part, g, 0.0);
    const double from = joint_coordinate(joint.kind, part.begin);
    const double way = scale * coordinate_difference(joint.kind, x, from);
    motor.target += speed_of(g, part) - way / part.dt;
    push(motor, kMotorPlace, JointRowKind::motor, part, before, list);
  }
  const auto limit = [&](double at, double side, std::size_t place, JointRowKind kind) {
    if (!std::isfinite(at)) return;
    JointRow row = row_of(part, {side * g.on_a, side * g.on_b});
    row.low = 0.0;
    const double room = side * scale * coordinate_difference(joint.kind, at, x);
    row.target = room / part.dt + side * speed_of(g, part);
    push(row, place, kind, part, before, list);
  };
  limit(joint.lower, -1.0, kLowerPlace, JointRowKind::lower);
  limit(joint.upper, 1.0, kUpperPlace, JointRowKind::upper);
}

void list_hold_rows(const JointPart& part, const JointEnds& at, bool is_end,
                    const JointImpulses& before, JointRowList& list) {
  std::array<Gradient, 6> gradients;
  std::array<double, 6> errors{};
  const int count = hold_gradients(part.joint.kind, at, part.arm, gradients);
  joint_errors(part.joint.kind, part.end, part.arm, errors);
  for (std::size_t k = 0; k < idx(count); ++k) {
    JointRow row = row_of(part, gradients[k]);
    if (!is_end) row.target = speed_of(gradients[k], part) - errors[k] / part.dt;
    push(row, k, JointRowKind::hold, part, before, list);
  }
}

}  // namespace

void list_part_rows(const JointPart& part, const JointImpulses& before, JointRowList& list) {
  list_hold_rows(part, mean_of(part.begin, part.end), false, before, list);
  if (!has_coordinate(part.joint.kind)) return;
  list_soft_rows(part, before, list);
  list_beginning_rows(part, before, list);
}

void list_end_rows(const JointPart& part, const JointImpulses& given, const JointImpulses& before,
                   JointRowList& list) {
  list_hold_rows(part, part.end, true, before, list);
  if (!has_coordinate(part.joint.kind)) return;
  const Gradient g = coordinate_gradient(part, part.end, part.end);
  if (part.motor.is_on && !part.motor.is_servo)
    push(motor_row(part, g, given[kMotorPlace]), kMotorPlace, JointRowKind::motor, part, before,
         list);
  const auto limit = [&](double side, std::size_t place, JointRowKind kind) {
    if (!(given[place] > 0.0)) return;
    JointRow row = row_of(part, {side * g.on_a, side * g.on_b});
    row.low = 0.0;
    push(row, place, kind, part, before, list);
  };
  limit(-1.0, kLowerPlace, JointRowKind::lower);
  limit(1.0, kUpperPlace, JointRowKind::upper);
}

}  // namespace thigma::detail
