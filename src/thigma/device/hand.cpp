// The simulated hand and device. Handle and arm mass are one rigid body of isotropic inertia, so
// translation and rotation are six independent damped oscillators with Coulomb friction. A sub-step
// is the trapezoidal rule, which neither adds nor removes energy from mass and spring: what the
// loop gains or loses is then due to sampling, delay and quantisation, as on hardware. Friction is
// an impulse that can stop the handle but never turn it round.
#include "thigma/device/hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "thigma/device/detail/address.h"
#include "thigma/device/detail/hand_table.h"
#include "thigma/device/detail/tremor.h"
#include "thigma/device/detail/velocity_estimate.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using detail::shortest;

// [s] 16 in a millisecond: error of the fastest arm (100 Hz) below 1e-4
constexpr double kSubstep = 6.25e-5;
constexpr int kMaxSubsteps = 1600;   // 0.1 s
constexpr double kTimeSlack = 1e-9;  // [s] rounding of clock sums; samples are 62.5 us apart

// Mass, spring, damper and friction of one half, linear or angular.
struct Oscillator {
  double inertia, damping, friction, arm_stiffness, arm_damping;

  // Velocity after h: trapezoidal without friction, then the friction impulse of the same step.
  // error, target_rate: from the handle to the target at the start of the step, and its rate.
  Vec3 step(const Vec3& velocity, const Vec3& load, const Vec3& error, const Vec3& target_rate,
            double h) const THIGMA_RT {
    const double a = 2.0 * inertia / h;
    const double resistance = a + 0.5 * h * arm_stiffness + arm_damping + damping;
    const Vec3 drive =
        load + arm_stiffness * error + (0.5 * h * arm_stiffness + arm_damping) * target_rate;
    const Vec3 middle = (a * velocity + drive) / resistance;
    const Vec3 free = 2.0 * middle - velocity;
    if (friction == 0.0) return free;
    const double loss = 2.0 * friction / resistance;
    const double speed = std::sqrt(free.squaredNorm());
    if (speed <= loss) return Vec3::Zero();
    return (1.0 - loss / speed) * free;
  }
};

double quantised(double value, double step) THIGMA_RT {
  return step > 0.0 ? std::floor(value / step + 0.5) * step : value;
}

// A component of the vector part changes by half the angle; rounding all four keeps q and -q the
// same.
Quat quantised(const Quat& q, double step) THIGMA_RT {
  if (!(step > 0.0)) return q;
  const double s = 0.5 * step;
  Quat r;
  for (int k = 0; k < 4; ++k) r.coeffs()[k] = std::floor(q.coeffs()[k] / s + 0.5) * s;
  return unit(r);
}

Vec3 cut(const Vec3& v, double limit) THIGMA_RT {
  const double n = std::sqrt(v.squaredNorm());
  if (!(n < std::numeric_limits<double>::infinity())) return Vec3::Zero();
  return n > limit ? Vec3(v * (limit / n)) : v;
}

struct HandleSample {
  double time = 0.0;
  Pose pose;
};

// Samples on their way to the computer.
struct Transport {
  std::vector<HandleSample> ring;
  std::uint64_t written = 0;  // samples ever
  std::uint64_t current = 0;  // index of the last one delivered

  void push(const HandleSample& sample) THIGMA_RT {
    ring[written % ring.size()] = sample;
    ++written;
  }
  const HandleSample& at(std::uint64_t i) const THIGMA_RT { return ring[i % ring.size()]; }
  // Newest sample taken at `time` or before; never older than the one delivered last.
  const HandleSample& deliver(double time) THIGMA_RT {
    if (written > ring.size()) current = std::max(current, written - ring.size());
    while (current + 1 < written && at(current + 1).time <= time + kTimeSlack) ++current;
    return at(current);
  }
};

std::size_t transport_capacity(const HandParams& p) {
  // Eight times what 62.5 us steps need: reads may come faster. Beyond that the delay gets shorter,
  // never wrong.
  const double samples = 8.0 * (p.delay + p.jitter) / kSubstep;
  return static_cast<std::size_t>(samples) + 2 * kMaxSubsteps;
}

DeviceLimits limits_of(const HandParams& p) {
  DeviceLimits limits;
  limits.max_force = p.max_force;
  limits.max_torque = p.actuates_rotation ? p.max_torque : 0.0;
  limits.max_stiffness = p.max_stiffness;
  limits.max_angular_stiffness = p.max_angular_stiffness;
  limits.workspace_radius = p.workspace_radius;
  limits.senses_rotation = p.senses_rotation;
  limits.actuates_rotation = p.actuates_rotation;
  limits.holds_person = false;
  limits.delay = p.delay + 0.5 * p.jitter + (p.sampling > 0.0 ? 0.5 / p.sampling : 0.0);
  return limits;
}

HandParams checked(HandParams p) {
  const std::string problem = what_is_wrong(p);
  if (!problem.empty()) throw std::invalid_argument("hand: " + problem);
  if (p.arm_stiffness > 0.0) p.program.arm_stiffness = p.arm_stiffness;
  p.program.twist_by_buttons = !p.senses_rotation;
  p.program.approach.normalize();
  p.program.slide -= p.program.slide.dot(p.program.approach) * p.program.approach;
  p.program.slide.normalize();
  return p;
}

}  // namespace

struct HandDevice::Impl {
  explicit Impl(const HandParams& params)
      : p(checked(params)),
        limits(limits_of(p)),
        linear{p.mass + p.arm_mass, p.damping, p.friction, p.arm_stiffness, p.arm_damping},
        angular{p.inertia + p.arm_inertia, p.angular_damping, p.angular_friction,
                p.arm_angular_stiffness, p.arm_angular_damping},
        tremor(p.seed),
        random(p.seed ^ 0x6a69747465720000ull),
        velocity(p.encoder, p.angular_encoder, p.velocity_window, 2.0 * p.velocity_window) {
    transport.ring.resize(transport_capacity(p));
    if (!p.script.empty()) {
      program.phase = HandPhase::script;
      p.program.start = p.script.front().pose;
    }
    handle.pose = p.program.start;
    target.pose = p.program.start;
    buttons = p.script.empty() ? kClutchButton : p.script.front().buttons;
  }

  HandParams p;
  DeviceLimits limits;
  Oscillator linear, angular;
  detail::Tremor tremor;
  Random random;
  detail::VelocityEstimate velocity;
  Transport transport;
  HandProgram program;
  ScriptCursor cursor;

  double start = 0.0, now = 0.0;  // [s; the caller's clock]
  bool started = false;
  double next_sample = 0.0;  // [s since start], with p.sampling
  Motion handle;             // true
  Motion target;             // pose at `now`, twist of the last read
  std::uint32_t buttons = 0;
  Wrench applied;
  DeviceState state;

  void begin(double time) THIGMA_RT;
  void aim(double dt) THIGMA_RT;
  void advance(double time) THIGMA_RT;
  void substep(double h, const Quat& turn) THIGMA_RT;
  void sample(double time) THIGMA_RT;
  void sense() THIGMA_RT;
};

void HandDevice::Impl::begin(double time) THIGMA_RT {
  started = true;
  start = time;
  now = time;
  sample(time);
}

// Moves the target to the end of dt; its constant rate on the way is target.twist.
void HandDevice::Impl::aim(double dt) THIGMA_RT {
  Pose goal;
  const double time = now + dt - start;
  if (program.phase == HandPhase::script) {
    goal = script_motion(p.script, time, cursor).pose;
    buttons = p.script[cursor.row].buttons;
  } else {
    const HandTarget next = advance_program(p.program, applied.force, dt, program);
    goal = next.pose;
    buttons = next.buttons;
  }
  Vec3 shake = Vec3::Zero();
  Vec3 angular_shake = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (p.tremor > 0.0) shake[k] = p.tremor * tremor.value(k, time);
    if (p.angular_tremor > 0.0) angular_shake[k] = p.angular_tremor * tremor.value(3 + k, time);
  }
  goal.position += shake;
  goal.orientation = unit(rotation_from_vector(angular_shake) * goal.orientation);
  target.twist.linear = (goal.position - target.pose.position) / dt;
  target.twist.angular =
      vector_from_rotation(goal.orientation * target.pose.orientation.conjugate()) / dt;
}

void HandDevice::Impl::substep(double h, const Quat& turn) THIGMA_RT {
  const Vec3 error = target.pose.position - handle.pose.position;
  const Vec3 v = linear.step(handle.twist.linear, applied.force, error, target.twist.linear, h);
  handle.pose.position += 0.5 * h * (handle.twist.linear + v);
  handle.twist.linear = v;

  const Quat off = target.pose.orientation * handle.pose.orientation.conjugate();
  const Vec3 w = angular.step(handle.twist.angular, applied.torque, vector_from_rotation(off),
                              target.twist.angular, h);
  const Vec3 turned = 0.5 * h * (handle.twist.angular + w);
  handle.pose.orientation = unit(rotation_from_vector(turned) * handle.pose.orientation);
  handle.twist.angular = w;

  target.pose.position += h * target.twist.linear;
  target.pose.orientation = unit(turn * target.pose.orientation);
}

void HandDevice::Impl::sample(double time) THIGMA_RT {
  if (p.sampling > 0.0) {
    const double since = time - start + kTimeSlack;
    if (since < next_sample) return;
    next_sample = (std::floor(since * p.sampling) + 1.0) / p.sampling;
  }
  transport.push({time, handle.pose});
}

void HandDevice::Impl::advance(double time) THIGMA_RT {
  const double gap = time - now;
  if (!(gap > 0.0) || !(gap < 1e9)) return;
  aim(gap);
  const double wanted = std::ceil(gap / kSubstep - 1e-6);
  const int n = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMaxSubsteps)));
  const double h = gap / n;
  const Quat turn = rotation_from_vector(h * target.twist.angular);
  for (int i = 1; i <= n; ++i) {
    substep(h, turn);
    // The last one at `time` itself, so that delays of whole reads find their sample exactly.
    sample(i == n ? time : now + h * i);
  }
  now = time;
}

void HandDevice::Impl::sense() THIGMA_RT {
  const std::uint64_t before = transport.current;
  const double age = p.jitter > 0.0 ? p.delay + p.jitter * random.uniform() : p.delay;
  const HandleSample& arrived = transport.deliver(now - age);
  Pose pose;
  for (int k = 0; k < 3; ++k) pose.position[k] = quantised(arrived.pose.position[k], p.encoder);
  if (p.senses_rotation) pose.orientation = quantised(arrived.pose.orientation, p.angular_encoder);
  // A driver stamps arrivals; a device that samples by itself stamps its samples, less the delay
  // nobody knows.
  const bool is_new = transport.current != before || transport.current == 0;
  if (is_new) {
    const double stamp = p.sampling > 0.0 && p.jitter == 0.0 ? arrived.time : now;
    state.motion.twist = velocity.update(stamp, pose);
  }
  state.time = now;
  state.motion.pose = pose;
  state.buttons = buttons;
  state.status = DeviceStatus::ok;
  state.has_true_handle = true;
  state.true_handle = handle.pose;
}

HandDevice::HandDevice(const HandParams& params) : impl_(std::make_unique<Impl>(params)) {}
HandDevice::~HandDevice() = default;

const DeviceLimits& HandDevice::limits() const { return impl_->limits; }
std::string HandDevice::name() const { return "hand (" + impl_->p.device + ")"; }

DeviceState HandDevice::read(double now) THIGMA_RT {
  Impl& s = *impl_;
  if (!s.started) {
    s.begin(now);
  } else {
    s.advance(now);
  }
  s.sense();
  return s.state;
}

void HandDevice::write(const Wrench& wrench) THIGMA_RT {
  Impl& s = *impl_;
  s.applied.force = cut(wrench.force, s.p.max_force);
  s.applied.torque =
      s.p.actuates_rotation ? cut(wrench.torque, s.p.max_torque) : Vec3(Vec3::Zero());
}

const Motion& HandDevice::true_motion() const THIGMA_RT { return impl_->handle; }
const Motion& HandDevice::target_motion() const THIGMA_RT { return impl_->target; }
const Wrench& HandDevice::applied_wrench() const THIGMA_RT { return impl_->applied; }
HandPhase HandDevice::phase() const THIGMA_RT { return impl_->program.phase; }

double HandDevice::stored_energy() const THIGMA_RT {
  const Impl& s = *impl_;
  const Vec3 error = s.target.pose.position - s.handle.pose.position;
  const Vec3 turn =
      vector_from_rotation(s.target.pose.orientation * s.handle.pose.orientation.conjugate());
  return 0.5 * (s.linear.inertia * s.handle.twist.linear.squaredNorm() +
                s.angular.inertia * s.handle.twist.angular.squaredNorm() +
                s.linear.arm_stiffness * error.squaredNorm() +
                s.angular.arm_stiffness * turn.squaredNorm());
}

std::string what_is_wrong(const HandParams& params) {
  HandParams p = params;
  const auto say = [](std::string_view name, double value, const std::string& allowed) {
    return std::string(name) + " = " + shortest(value) + ", expected " + allowed;
  };
  for (const detail::HandNumber& number : detail::hand_numbers()) {
    const double value = number.field(p);
    if (value >= number.low && value <= number.high) continue;
    return say(number.name, value,
               "from " + shortest(number.low) + " to " + shortest(number.high) + " " +
                   std::string(number.unit));
  }
  // A body without inertia has no velocity to integrate.
  if (!(p.mass + p.arm_mass >= 1e-6)) {
    return say("mass + arm_mass", p.mass + p.arm_mass, "at least 1e-6 kg");
  }
  if (!(p.inertia + p.arm_inertia >= 1e-12)) {
    return say("inertia + arm_inertia", p.inertia + p.arm_inertia, "at least 1e-12 kg m^2");
  }
  const Vec3 across = p.program.approach.cross(p.program.slide);
  const double lengths = p.program.approach.squaredNorm() * p.program.slide.squaredNorm();
  if (!(across.squaredNorm() > 1e-12 * lengths) || !std::isfinite(lengths)) {
    return "approach and slide, expected two finite directions that are not parallel";
  }
  return {};
}

std::unique_ptr<HandDevice> make_hand(const HandParams& params) {
  return std::make_unique<HandDevice>(params);
}

}  // namespace thigma
