#include "thigma/session/check_device.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "thigma/session/rt_thread.h"

namespace thigma {
namespace {

constexpr double kStill = 0.25;        // length of a window of which the stillest counts [s]
constexpr double kUnit = 1e-6;         // off 1 that a quaternion's norm may be
constexpr double kJump = 0.005;        // of the position in a frame, as safety has it [m]
constexpr double kVelocityOff = 0.02;  // of the way that velocities tell, beyond a fifth of it [m]

/// Mean and spread, one number after the other.
struct Spread {
  Vec3 mean = Vec3::Zero(), squares = Vec3::Zero();
  int count = 0;
  void add(const Vec3& value) {
    const Vec3 off = value - mean;
    mean += off / ++count;
    squares += off.cwiseProduct(value - mean);
  }
  double deviation() const { return count > 1 ? std::sqrt(squares.sum() / (count - 1)) : 0.0; }
};

/// What the frames add up to. Thread: the one that makes frames; read after it has stopped.
struct Watch {
  HapticDevice* device = nullptr;
  double period = 1e-3;
  std::int64_t begin_ns = 0, last_ns = 0;
  std::uint64_t frames = 0, fresh = 0, bad_numbers = 0, bad_turns = 0, old_times = 0, jumps = 0;
  std::uint64_t lost = 0, weights = 0;
  DurationHistogram late, read, write;
  DeviceState last;
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity()), greatest = -least;
  Vec3 told = Vec3::Zero(), first = Vec3::Zero();  // told: the way that velocities add up to
  double told_off = 0.0, way = 0.0, speed_max = 0.0;
  double noise = std::numeric_limits<double>::infinity(), turn_noise = noise;
  Spread place, turn;
  std::uint32_t buttons = 0;

  void frame() noexcept;
  void take(const DeviceState& state, double now) noexcept;
  void window(const DeviceState& state) noexcept;
};

void Watch::window(const DeviceState& state) noexcept {
  place.add(state.motion.pose.position);
  const Quat q = state.motion.pose.orientation;
  turn.add(q.w() < 0.0 ? Vec3(-2.0 * q.vec()) : Vec3(2.0 * q.vec()));
  if (place.count * period < kStill) return;
  noise = std::min(noise, place.deviation());
  turn_noise = std::min(turn_noise, turn.deviation());
  place = turn = {};
}

void Watch::take(const DeviceState& state, double now) noexcept {
  if (state.status == DeviceStatus::lost) ++lost;
  if (state.status != DeviceStatus::ok) return;
  const Motion& motion = state.motion;
  const Vec3& p = motion.pose.position;
  const bool is_finite = p.allFinite() && motion.pose.orientation.coeffs().allFinite() &&
                         motion.twist.linear.allFinite() && motion.twist.angular.allFinite();
  if (!is_finite) {
    ++bad_numbers;
    return;
  }
  if (std::abs(motion.pose.orientation.norm() - 1.0) > kUnit) ++bad_turns;
  if (state.time > now + period || now - state.time > 0.05 || state.time < last.time) ++old_times;
  if (state.weight != 1.0) ++weights;
  if (frames == 0) {
    first = told = p;
  } else {
    const double step = (p - last.motion.pose.position).norm();
    fresh += step > 0.0 ? 1 : 0;
    jumps += step > kJump ? 1 : 0;
    way += step;
    told += (state.time - last.time) * motion.twist.linear;
    told_off = std::max(told_off, (told - p).norm());
  }
  least = least.cwiseMin(p);
  greatest = greatest.cwiseMax(p);
  speed_max = std::max(speed_max, motion.twist.linear.norm());
  buttons |= state.buttons;
  window(state);
  last = state;
}

void Watch::frame() noexcept {
  const std::int64_t now_ns = monotonic_ns();
  if (begin_ns == 0) begin_ns = now_ns;
  const auto period_ns = static_cast<std::int64_t>(1e9 * period);
  if (last_ns != 0) record(late, std::max<std::int64_t>(0, now_ns - last_ns - period_ns));
  last_ns = now_ns;
  const double now = 1e-9 * static_cast<double>(now_ns - begin_ns);
  const DeviceState state = device->read(now);
  const std::int64_t has_read = monotonic_ns();
  device->write(Wrench{});
  record(read, has_read - now_ns);
  record(write, monotonic_ns() - has_read);
  take(state, now);
  ++frames;
}

bool is_told(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

void watch_by_engine(Watch& watch, const DeviceCheckParams& params, const std::atomic<bool>* stop) {
  DeadlineClock clock = clock_of(params.rate);
  const auto last = static_cast<std::int64_t>(params.seconds * params.rate);
  start_clock(clock);
  while (clock.tick < last && !is_told(stop)) {
    wait_for_tick(clock);
    watch.frame();
  }
}

void watch_by_device(Watch& watch, const DeviceCheckParams& params, const std::atomic<bool>* stop) {
  const auto on_tick = [](void* context) noexcept { static_cast<Watch*>(context)->frame(); };
  watch.device->start_ticks(params.rate, {on_tick, &watch});
  const std::int64_t end = monotonic_ns() + static_cast<std::int64_t>(1e9 * params.seconds);
  while (monotonic_ns() < end && !is_told(stop)) sleep_ns(5'000'000);
  watch.device->stop_ticks();
}

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::vector<DeviceRule> rules_of(const Watch& w, const DeviceLimits& limits,
                                 const DeviceReport& report) {
  const auto none = [](const char* rule, std::uint64_t count) {
    return DeviceRule{rule, count == 0, std::to_string(count)};
  };
  const bool has_limits = limits.max_force > 0.0 && limits.max_stiffness > 0.0 &&
                          limits.workspace_radius > 0.0 &&
                          (!limits.actuates_rotation || limits.max_torque > 0.0);
  const double reach = w.frames > 0 ? (w.greatest - w.least).norm() : 0.0;
  const double kMostReach = 4.0 * limits.workspace_radius;
  const double slowest = std::max(report.read.p99, report.write.p99);
  return {
      {"it has a name", !report.device.empty(), report.device},
      {"its limits are above zero", has_limits, number("%.3g N", limits.max_force)},
      none("never lost", w.lost),
      none("no NaN or infinity", w.bad_numbers),
      none("orientations are unit quaternions", w.bad_turns),
      none("time stamps are fresh and never go back", w.old_times),
      {"a device that holds a person never weighs less than 1",
       !limits.holds_person || w.weights == 0, std::to_string(w.weights)},
      none("no step of more than 5 mm a frame", w.jumps),
      {"velocities add up to the way", w.told_off <= kVelocityOff + 0.2 * w.way,
       number("%.2g m off", w.told_off)},
      {"stays within twice its workspace", !(reach > kMostReach), number("%.3g m wide", reach)},
      {"nine of ten frames are made", report.rate > 0.9 / w.period, number("%.0f Hz", report.rate)},
      {"read and write take less than half a period, p99", slowest < 0.5 * w.period,
       number("%.3g s", slowest)},
  };
}

}  // namespace

DeviceReport check_device(HapticDevice& device, const DeviceCheckParams& params,
                          const std::atomic<bool>* stop) {
  Watch watch;
  watch.device = &device;
  watch.period = 1.0 / params.rate;
  if (device.limits().clock == DeviceClock::device) {
    watch_by_device(watch, params, stop);
  } else {
    watch_by_engine(watch, params, stop);
    device.write(Wrench{});
  }
  DeviceReport report;
  report.device = device.name();
  report.trouble = device.trouble();
  report.frames = watch.frames;
  const double seconds = 1e-9 * static_cast<double>(watch.last_ns - watch.begin_ns);
  const double intervals = static_cast<double>(watch.frames) - 1.0;
  if (seconds > 0.0) report.rate = intervals / seconds;
  if (intervals > 0.0) report.new_share = static_cast<double>(watch.fresh) / intervals;
  report.late = summarize(watch.late);
  report.read = summarize(watch.read);
  report.write = summarize(watch.write);
  if (std::isfinite(watch.noise)) report.noise = watch.noise;
  if (std::isfinite(watch.turn_noise)) report.turn_noise = watch.turn_noise;
  if (watch.least.allFinite()) {
    report.least = watch.least;
    report.greatest = watch.greatest;
  }
  report.speed_max = watch.speed_max;
  report.buttons = watch.buttons;
  report.rules = rules_of(watch, device.limits(), report);
  return report;
}

}  // namespace thigma
