#include "handle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "board.h"

namespace standin {
namespace {

constexpr double kStep = 0.00025;  // s; far below every time constant of the model
constexpr double kLongest = 0.1;   // s; a machine that slept does not catch up
constexpr double kTwoPi = 6.283185307179586;

Vec vec(int unit, Key first) {
  return {get(unit, first), get(unit, static_cast<Key>(first + 1)),
          get(unit, static_cast<Key>(first + 2))};
}

void put_vec(int unit, Key first, const Vec& v) {
  for (int i = 0; i < 3; ++i) {
    put(unit, static_cast<Key>(first + i), v[i]);
  }
}

Quat orientation(int unit) {
  return {get(unit, k_qw), get(unit, k_qx), get(unit, k_qy), get(unit, k_qz)};
}

void put_orientation(int unit, const Quat& q) {
  const Key keys[] = {k_qw, k_qx, k_qy, k_qz};
  for (int i = 0; i < 4; ++i) {
    put(unit, keys[i], q[i]);
  }
}

Vec target_at(int unit, double time) {
  Vec target = vec(unit, k_target_x);
  const int axis = std::clamp(static_cast<int>(get(unit, k_sweep_axis)), 0, 2);
  const double phase = kTwoPi * get(unit, k_sweep_hz) * (time - get(unit, k_start_time));
  target[axis] += get(unit, k_sweep_amplitude) * std::sin(phase);
  return target;
}

// One step; `w` is the velocity of turning.
void step_turn(int unit, double dt) {
  const Quat q = orientation(unit);
  const Vec error =
      turn_vector(multiply(turn(vec(unit, k_target_rx)), {q[0], -q[1], -q[2], -q[3]}));
  const Vec torque = vec(unit, k_applied_tx);
  Vec w = vec(unit, k_wx);
  Vec angle{};
  for (int i = 0; i < 3; ++i) {
    const double a =
        get(unit, k_rot_spring) * error[i] + torque[i] - get(unit, k_rot_damping) * w[i];
    w[i] += dt * a / get(unit, k_inertia);
    angle[i] = dt * w[i];
  }
  put_vec(unit, k_wx, w);
  put_orientation(unit, multiply(turn(angle), q));
}

void step_move(int unit, const Vec& target, double dt) {
  Vec p = vec(unit, k_px);
  Vec v = vec(unit, k_vx);
  const Vec force = vec(unit, k_applied_fx);
  const Vec push = vec(unit, k_push_x);
  const double damping =
      get(unit, k_damping) + (get(unit, k_mode) == 2.0 ? get(unit, k_brake_damping) : 0.0);
  for (int i = 0; i < 3; ++i) {
    double f = get(unit, k_spring) * (target[i] - p[i]) + force[i] + push[i] - damping * v[i];
    if (i == static_cast<int>(get(unit, k_up_axis))) {
      f -= get(unit, k_weight);
    }
    v[i] += dt * f / get(unit, k_mass);
    p[i] += dt * v[i];
  }
  put_vec(unit, k_px, p);
  put_vec(unit, k_vx, v);
}

}  // namespace

double norm(const Vec& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Quat multiply(const Quat& a, const Quat& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Quat turn(const Vec& v) {
  const double angle = norm(v);
  const double s = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5;
  return {std::cos(0.5 * angle), s * v[0], s * v[1], s * v[2]};
}

Vec turn_vector(const Quat& q) {
  const Vec v{q[1], q[2], q[3]};
  const double s = norm(v);
  if (s == 0.0) {
    return {0, 0, 0};
  }
  const double angle = 2.0 * std::atan2(q[0] < 0.0 ? -s : s, std::fabs(q[0]));
  return {angle * v[0] / s, angle * v[1] / s, angle * v[2] / s};
}

std::array<Vec, 3> matrix(const Quat& u) {
  const double n = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2] + u[3] * u[3]);
  const double w = u[0] / n, x = u[1] / n, y = u[2] / n, z = u[3] / n;
  return {Vec{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          Vec{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          Vec{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

void move_handle(int unit, double time) {
  double at = get(unit, k_step_time);
  if (time - at > kLongest) {
    at = time - kLongest;
  }
  if (is_on(unit, k_hold)) {
    put_vec(unit, k_px, vec(unit, k_target_x));
    put_vec(unit, k_vx, {0, 0, 0});
    put_vec(unit, k_wx, {0, 0, 0});
    put_orientation(unit, turn(vec(unit, k_target_rx)));
    put(unit, k_step_time, time);
    return;
  }
  for (; at + kStep <= time; at += kStep) {
    step_move(unit, target_at(unit, at), kStep);
    step_turn(unit, kStep);
  }
  put(unit, k_step_time, at);
}

Pose told_pose(int unit) {
  Pose pose;
  const Vec p = vec(unit, k_px);
  const Vec jump = vec(unit, k_jump_x);
  for (int i = 0; i < 3; ++i) {
    pose.position[i] = p[i] + jump[i];
  }
  pose.orientation = multiply(turn(vec(unit, k_jump_rx)), orientation(unit));
  if (is_on(unit, k_nan_pose)) {
    pose.position[0] = std::numeric_limits<double>::quiet_NaN();
    pose.orientation[0] = std::numeric_limits<double>::quiet_NaN();
  }
  return pose;
}

}  // namespace standin
