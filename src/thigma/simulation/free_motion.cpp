#include "thigma/simulation/free_motion.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr double kLargestTurn = 0.05;  // of a step [rad]
constexpr double kMostTurns = 1e5;

Vec3 spin(const RigidBody& body, const Quat& q, const Vec3& momentum) noexcept {
  const Mat3 R = rotation_matrix(q);
  return R * (body.inverse_inertia * (R.transpose() * momentum));
}

double spin_energy(const RigidBody& body, const Quat& q, const Vec3& momentum) noexcept {
  return 0.5 * momentum.dot(spin(body, q, momentum));
}

Vec4 rate(const RigidBody& body, const Vec4& q, const Vec3& momentum) noexcept {
  const Quat unit = Quat(q).normalized();
  return rate_matrix(unit) * spin(body, unit, momentum);
}

Quat runge_kutta(const RigidBody& body, const Quat& from, const Vec3& momentum,
                 double dt) noexcept {
  const Vec4 q = from.coeffs();
  const Vec4 k1 = rate(body, q, momentum);
  const Vec4 k2 = rate(body, q + 0.5 * dt * k1, momentum);
  const Vec4 k3 = rate(body, q + 0.5 * dt * k2, momentum);
  const Vec4 k4 = rate(body, q + dt * k3, momentum);
  return Quat(Vec4(q + dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4))).normalized();
}

// Turning by u changes the energy by u . (omega x L). Where body and momentum are aligned it cannot
// change, nor err.
Quat with_energy(const RigidBody& body, const Quat& q, const Vec3& momentum,
                 double energy) noexcept {
  const Vec3 omega = spin(body, q, momentum);
  const Vec3 slope = omega.cross(momentum);
  const double squared = slope.squaredNorm();
  const double scale = momentum.squaredNorm() * omega.squaredNorm();
  if (!(squared > 1e-12 * scale)) return q;
  const double excess = 0.5 * momentum.dot(omega) - energy;
  return (rotation_from_vector(-excess / squared * slope) * q).normalized();
}

Quat turned(const RigidBody& body, const Quat& from, const Vec3& momentum, double time) noexcept {
  const double fastest = spin(body, from, momentum).norm();
  if (!(fastest > 0.0) || !(time > 0.0)) return from;
  const double energy = spin_energy(body, from, momentum);
  // The spin of a free body changes, but never beyond |L| over its least moment of inertia.
  const double bound = std::max(fastest, momentum.norm() * body.inverse_inertia.norm());
  const double steps = std::clamp(std::ceil(bound * time / kLargestTurn), 1.0, kMostTurns);
  Quat q = from;
  for (double i = 0.0; i < steps; i += 1.0) {
    q = with_energy(body, runge_kutta(body, q, momentum, time / steps), momentum, energy);
  }
  return q;
}

}  // namespace

double mechanical_energy(const RigidBody& body, const BodyState& state) noexcept {
  return kinetic_energy(body, state) - body.mass * body.gravity.dot(state.position);
}

BodyState free_motion(const RigidBody& body, const BodyState& state, double time) noexcept {
  BodyState next = state;
  next.position += time * (state.linear_momentum / body.mass + 0.5 * time * body.gravity);
  next.linear_momentum += time * body.mass * body.gravity;
  next.orientation = turned(body, state.orientation, state.angular_momentum, time);
  return next;
}

BodyState pushed_motion(const RigidBody& body, const BodyState& state, const Wrench& push,
                        double time) noexcept {
  BodyState next = state;
  const Vec3 acceleration = push.force / body.mass + body.gravity;
  next.position += time * (state.linear_momentum / body.mass + 0.5 * time * acceleration);
  next.linear_momentum += time * body.mass * acceleration;
  next.angular_momentum += time * push.torque;
  next.orientation =
      turned(body, state.orientation, state.angular_momentum + 0.5 * time * push.torque, time);
  return next;
}

}  // namespace thigma
