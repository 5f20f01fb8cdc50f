#include "thigma/runtime/passivity_control.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

std::uint64_t late_frames(const PassivityParams& params) THIGMA_RT {
  const double frames = std::floor(params.delay / params.period + 0.5);
  return static_cast<std::uint64_t>(
      std::clamp(frames, 0.0, static_cast<double>(PassivityControl::kMostFrames - 1)));
}

const Wrench& sent_at(const PassivityControl& control, std::uint64_t frame) THIGMA_RT {
  return control.sent[frame % PassivityControl::kMostFrames];
}

/// In springs that pull with this wrench [J].
double held_energy(const PassivityParams& params, const Wrench& w) THIGMA_RT {
  double energy = 0.0;
  if (params.stiffness > 0.0) energy += 0.5 * w.force.squaredNorm() / params.stiffness;
  if (params.angular_stiffness > 0.0)
    energy += 0.5 * w.torque.squaredNorm() / params.angular_stiffness;
  return energy;
}

Wrench cut(const Wrench& w, const DeviceLimits& limits) THIGMA_RT {
  const auto shorten = [](const Vec3& v, double most) {
    const double size = std::sqrt(v.squaredNorm());
    return size > most ? Vec3(v * (most / size)) : v;
  };
  return {shorten(w.force, limits.max_force),
          limits.actuates_rotation ? shorten(w.torque, limits.max_torque) : Vec3(Vec3::Zero())};
}

}  // namespace

PassivityParams passivity_for(double stiffness, double angular_stiffness, double period,
                              double delay) THIGMA_RT {
  const double late = period + delay;
  return {period, delay, stiffness * late, angular_stiffness * late, stiffness, angular_stiffness};
}

void observe_handle(const PassivityParams& params, const Motion& handle,
                    PassivityControl& control) THIGMA_RT {
  const std::uint64_t late = late_frames(params);
  // The step that ends with this sample began a frame before it: driven by the wrench of then.
  if (control.frame > late) {
    const Wrench& drove = sent_at(control, control.frame - 1 - late);
    const Vec3 moved = handle.pose.position - control.last.position;
    const Vec3 turned =
        vector_from_rotation(handle.pose.orientation * control.last.orientation.conjugate());
    control.energy -= drove.force.dot(moved) + drove.torque.dot(turned);
  }
  control.last = handle.pose;
  control.predicted = control.energy;
  for (std::uint64_t back = 1; back <= std::min(late, control.frame); ++back) {
    const Wrench& w = sent_at(control, control.frame - back);
    control.predicted -=
        params.period * (w.force.dot(handle.twist.linear) + w.torque.dot(handle.twist.angular));
  }
}

Wrench passive_wrench(const PassivityParams& params, const Motion& handle, const Wrench& wanted,
                      PassivityControl& control) THIGMA_RT {
  Wrench sent = wanted;
  control.damping = 0.0;
  const bool is_zero = wanted.force.isZero(0.0) && wanted.torque.isZero(0.0);
  const Vec3& v = handle.twist.linear;
  const Vec3& w = handle.twist.angular;
  const double share =
      params.max_damping > 0.0 ? params.max_angular_damping / params.max_damping : 0.0;
  const double square = v.squaredNorm() + share * w.squaredNorm();
  const double next = control.predicted - held_energy(params, wanted) -
                      params.period * (wanted.force.dot(v) + wanted.torque.dot(w));
  if (!is_zero && next < 0.0 && square > 0.0) {
    const double damping = std::min(-next / (params.period * square), params.max_damping);
    sent.force -= damping * v;
    sent.torque -= damping * share * w;
    control.damping = damping;
    ++control.damped_frames;
  }
  control.sent[control.frame % PassivityControl::kMostFrames] = sent;
  ++control.frame;
  return sent;
}

DeviceState PassiveDevice::read(double now) THIGMA_RT {
  const DeviceState state = device_.read(now);
  if (state.status == DeviceStatus::ok) handle_ = state.motion;
  observe_handle(params_, handle_, control_);
  return state;
}

void PassiveDevice::write(const Wrench& wrench) THIGMA_RT {
  sent_ = cut(passive_wrench(params_, handle_, wrench, control_), device_.limits());
  control_.sent[(control_.frame - 1) % PassivityControl::kMostFrames] = sent_;
  device_.write(sent_);
}

}  // namespace thigma
