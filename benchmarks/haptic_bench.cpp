#include "benchmarks/haptic_bench.h"

#include "benchmarks/probe.h"

#include "thigma/device/null_device.h"
#include "thigma/dynamics/implicit_step.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/math/elementary.h"

namespace thigma::bench {
namespace {

constexpr int kBlock = 16;

/// A hand that holds still but for a slow circle, clutch pressed.
class CirclingDevice final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "circle"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    const SinCos turn = sin_cos(2.0 * now);
    state.motion.pose.position = Vec3(0.002 * turn.cos, 0.002 * turn.sin, -0.001);
    state.motion.twist.linear = Vec3(-0.004 * turn.sin, 0.004 * turn.cos, 0.0);
    state.buttons = kClutchButton;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  DeviceLimits limits_;
};

LinearContactModel planes(int count) {
  LinearContactModel model;
  model.sequence = 1;
  for (int i = 0; i < count; ++i) {
    PlaneTerm plane;
    const SinCos around = sin_cos(1.3 * i);
    plane.arm_body = Vec3(0.02 * around.cos, 0.02 * around.sin, -0.01);
    plane.normal = Vec3(0.1 * around.cos, 0.1 * around.sin, -1.0).normalized();
    plane.scene_point = Vec3(0.02 * around.cos, 0.02 * around.sin, -0.0098);
    plane.stiffness = 400.0;
    plane.damping = 1.0;
    plane.tolerance = 4e-4;
    plane.id = i;
    model.planes.push_back(plane);
  }
  return model;
}

HapticParams params() {
  HapticParams p;
  p.body = make_body(0.010, 4e-6 * Mat3::Identity());
  p.coupling.linear_stiffness = 300.0;
  p.coupling.linear_damping = 2.0;
  p.coupling.angular_stiffness = 0.3;
  p.coupling.angular_damping = 2e-3;
  return p;
}

}  // namespace

HapticTiming time_haptic_step(int clusters, int frames) {
  const HapticParams p = params();
  CirclingDevice device;
  Latest<LinearContactModel> models;
  Latest<StampedBody> bodies;
  HapticState state = initial_state(p, {});
  const HapticPorts ports{&device, &models, &bodies, nullptr};
  HapticTiming timing;
  double now = 0.0;
  LinearContactModel model = planes(clusters);
  for (int block = 0; block < frames / kBlock; ++block) {
    model.time = now;
    model.sequence = static_cast<std::uint64_t>(block) + 1;
    models.publish(model);
    const double start = thread_cpu();
    for (int i = 0; i < kBlock; ++i) haptic_step(p, ports, {now += 1e-3, 1e-3, Fault::none}, state);
    timing.step.push_back((thread_cpu() - start) / kBlock);
    const Motion hand = device.read(now).motion;
    BodyState dense = state.body;
    const double begin = thread_cpu();
    for (int i = 0; i < kBlock; ++i) {
      WrenchJacobian of_coupling, of_contact;
      Coupling held = p.coupling;
      held.is_grasped = true;
      const Wrench a = coupling_wrench(held, hand, p.body, dense, &of_coupling);
      const Wrench b = contact_wrench(model, p.body, dense, 1.0, &of_contact);
      dense = implicit_step_13(p.body, dense, a + b, of_coupling + of_contact, 1e-3);
    }
    timing.dense.push_back((thread_cpu() - begin) / kBlock);
  }
  return timing;
}

}  // namespace thigma::bench
