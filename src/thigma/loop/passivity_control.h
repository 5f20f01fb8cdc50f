#pragma once
// Time-domain passivity controller at the device's port: late samples must not make a rendered
// world give more than it got. docs/passivity.md explains the idea.

#include <array>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Constant while a session runs.
struct PassivityParams {
  bool is_on = false;
  double period = 1e-3;      // of the haptic frames [s]
  double delay = 0.0;        // of the device's samples, as far as known; at most 500 frames [s]
  double max_damping = 5.0;  // most that is injected [N s/m]
  double max_angular_damping = 0.0;  // the same for rotation [N m s/rad]
  // Of the springs the hand feels: a wrench F has to be backed by the energy F^2 / 2K it can give
  // back. 0: it need not.
  double stiffness = 0.0, angular_stiffness = 0.0;  // [N/m, N m/rad; device]
  // By how much the handle may change its velocity unseen: what it may be off by since the last
  // sample is set aside.
  double acceleration = 2.0, angular_acceleration = 20.0;  // [m/s^2, rad/s^2]
  double velocity_lag = 0.0075;  // age of the velocity of a sample, beyond its own [s]
  double credit = 1e-5;          // what a world that got nothing yet may already give [J]
};

/// Parameters, switched on, for springs of these stiffnesses, as the hand feels them [N/m, N m/rad;
/// device]: what a spring gives away by being late is that of a negative damping K (T + delay), so
/// as much at most is put in.
/// Thread    [haptic].
PassivityParams passivity_for(double stiffness, double angular_stiffness, double period,
                              double delay) THIGMA_RT;

/// What the controller remembers.
struct PassivityControl {
  static constexpr std::uint64_t kMostFrames = 512;
  struct Sent {
    double time = 0.0;  // [s; session clock]
    Wrench wrench;      // on the hand [device frame], until the next
  };
  std::array<Sent, kMostFrames> sent{};  // ring
  std::uint64_t count = 0;               // wrenches ever sent
  // index of the one that acted when the last sample was taken
  std::uint64_t acting = 0;
  bool has_sample = false;
  Pose last;               // handle of the last one
  double last_time = 0.0;  // when it came [s]
  double energy = 0.0;     // put in by the hand up to the time of the last sample [J]
  double predicted = 0.0;  // up to now, had the handle kept its last velocity [J]
  double reserve = 0.0;    // by how much that may be wrong [J]
  double damping = 0.0;    // injected in the last frame [N s/m]
  // of the wanted wrench that was sent in the last frame, before damping
  double share = 1.0;
  std::uint64_t acted_frames = 0;  // that were damped or cut
  double share_sum = 0.0;          // over frames with a wanted wrench
  std::uint64_t wanted_frames = 0;
  double damping_max = 0.0;  // [N s/m]
};

/// Accounts for a sample of the handle that came at `now`: the motion it tells of was driven by the
/// wrench that acted `delay` before.
/// Thread    [haptic].
void observe_handle(const PassivityParams& params, const Motion& handle, double now,
                    PassivityControl& control) THIGMA_RT;

/// The wrench to send for the one that is wanted.
///
/// 1. It is cut to what is backed: its springs hold no more than the hand has put in for certain,
///    so that letting go cannot give more. Force and torque are cut by the same share.
/// 2. Where the energy is short of that, damping along the handle's velocity c = deficit / (T
///    |v|^2), max_damping at most, brings it back; rotation shares it in the ratio of the two
///    maxima. It never turns force or torque around.
///
/// A wanted wrench of zero, as after a fault, stays zero.
///
/// handle   the sample given to observe_handle in this frame
/// wanted   on the hand about the handle [N, N m; device frame]
/// Thread   [haptic]; no failure.
/// Source   docs/sources.md, E4, after Hannaford and Ryu 2002, predictive. Deviates: D95.
Wrench passive_wrench(const PassivityParams& params, const Motion& handle, const Wrench& wanted,
                      double now, PassivityControl& control) THIGMA_RT;

/// Replaces the wrench of the last passive_wrench by what was really sent, as after a clamp behind
/// it.
/// Thread    [haptic].
void correct_sent(const Wrench& sent, PassivityControl& control) THIGMA_RT;

}  // namespace thigma
