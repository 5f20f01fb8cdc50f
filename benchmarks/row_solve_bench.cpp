#include "benchmarks/row_solve_bench.h"

#include <algorithm>
#include <memory>

#include "benchmarks/probe.h"
#include <time.h>

#include "thigma/device/haptic_device.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/math/elementary.h"

namespace thigma::bench {
namespace {

constexpr double kStep = 1e-3, kFriction = 0.3, kHeight = 0.01;

std::int64_t cpu_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

/// A hand that presses 3 mm deep, in circles and tilts.
class LedDevice final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "led"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    const double size = 1e-3 * (1.0 + 0.9 * sine(1.7 * now));
    const SinCos turn = sin_cos(6.0 * now);
    const double down = std::min(now, 0.1) * 0.03;
    state.motion.pose.position = Vec3(size * turn.cos, size * turn.sin, -down);
    state.motion.pose.orientation =
        Quat(1.0, 0.01 * sine(5.0 * now), 0.01 * sine(7.0 * now), 0.05 * sine(3.0 * now))
            .normalized();
    state.buttons = kClutchButton;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  DeviceLimits limits_;
};

LinearContactModel foot(int rows) {
  LinearContactModel model;
  model.constraints.travel = 1.0;
  model.constraints.reach = 0.03;
  for (int i = 0; i < rows * rows; ++i) {
    ContactRow row = make_row(RowKind::scene_plane);
    row.id = static_cast<std::uint64_t>(i) + 1;
    const double pitch = 0.04 / (rows - 1);
    row.object_point = Vec3(pitch * (i % rows) - 0.02, pitch * (i / rows) - 0.02, -kHeight);
    row.scene_direction = -Vec3::UnitZ();
    row.friction = {kFriction, kFriction};
    model.constraints.rows.push_back(row);
  }
  return model;
}

HapticParams params() {
  HapticParams p;
  p.response = ResponseKind::constrained;
  p.constraint.slop = 1e-6;
  p.body = make_body(0.05, 1e-5 * Mat3::Identity());
  p.coupling.linear_stiffness = 500.0;
  p.coupling.linear_damping = 4.0;
  p.coupling.angular_stiffness = 0.5;
  p.coupling.angular_damping = 2e-3;
  return p;
}

/// The load of the last step, spread over all rows.
void spread(const LinearContactModel& model, RowMemory& memory) {
  double load = 0.0;
  for (const RowMemory::Entry& e : memory.entries) load += e.normal;
  if (!(load > 0.0)) return;
  const double each = load / static_cast<double>(model.constraints.rows.size());
  RowMemory all;
  for (const ContactRow& row : model.constraints.rows) {
    RowMemory::Entry entry{row.id, each, {0.0, 0.0}, false, false};
    for (const RowMemory::Entry& e : memory.entries) {
      if (e.id != row.id) continue;
      entry = e;
      entry.normal = 0.5 * (e.normal + each);
    }
    all.entries.push_back(entry);
  }
  memory.entries = all.entries;
}

}  // namespace

RowSolveTiming time_row_solve(int rows, int frames) {
  const HapticParams p = params();
  LedDevice device;
  const auto models = std::make_unique<Latest<LinearContactModel>>();
  HapticState state = initial_state(p, {Vec3(0.0, 0.0, kHeight + 2e-6), Quat::Identity()});
  const HapticPorts ports{&device, models.get(), nullptr, nullptr, cpu_ns};
  LinearContactModel model = foot(rows);
  model.constraints.state = state.body;
  RowSolveTiming timing;
  double sticking = 0.0, sliding = 0.0;
  for (int k = 0; k < frames; ++k) {
    const double now = kStep * (k + 1);
    model.time = now;
    model.sequence = static_cast<std::uint64_t>(k) + 1;
    models->publish(model);
    spread(model, state.rows);
    const double pressed = static_cast<double>(state.rows.entries.size());
    const std::int64_t begin = cpu_ns();
    const std::int64_t read = cpu_ns();
    const HapticSample s = haptic_step(p, ports, {now, kStep, Fault::none}, state);
    const std::int64_t end = cpu_ns();
    if (now < 0.2) continue;  // until it presses
    timing.solve.push_back(1e-9 * static_cast<double>(s.solve_ns));
    timing.step.push_back(1e-9 * static_cast<double>(end - read));
    timing.clock.push_back(1e-9 * static_cast<double>(read - begin));
    timing.rows_pressed += pressed;
    timing.residual_max = std::max(timing.residual_max, s.solve_residual);
    sticking += s.slip.sticking;
    sliding += s.slip.sliding;
  }
  timing.rows_pressed /= static_cast<double>(std::max<std::size_t>(timing.solve.size(), 1));
  timing.sliding_share = sliding / std::max(sticking + sliding, 1.0);
  return timing;
}

}  // namespace thigma::bench
