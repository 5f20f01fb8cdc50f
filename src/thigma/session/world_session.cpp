#include "thigma/session/world_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/loop/samples.h"
#include "thigma/math/infinity.h"

namespace thigma {
namespace {

void add_state(const BodyState& y, StateHash& hash) noexcept {
  add_vector(hash, y.position);
  add_quaternion(hash, y.orientation);
  add_vector(hash, y.linear_momentum);
  add_vector(hash, y.angular_momentum);
}

void add_frame(const WorldState& state, std::span<const Wrench> commands,
               StateHash& hash) noexcept {
  for (const BodyState& y : state.bodies) add_state(y, hash);
  for (const Wrench& command : commands) {
    add_vector(hash, command.force);
    add_vector(hash, command.torque);
  }
}

Wrench within(const DeviceLimits& limits, Wrench wrench) noexcept {
  const auto cut = [](Vec3& v, double most) {
    const double size = v.norm();
    if (!std::isfinite(size))
      v.setZero();
    else if (size > most)
      v *= most / size;
  };
  cut(wrench.force, limits.max_force);
  cut(wrench.torque, limits.max_torque);
  return wrench;
}

/// A hand of a session: its handle in the world, and what it has put in.
struct Hand {
  const World& world;
  const WorldHand& config;
  HapticDevice* device = nullptr;
  HandHold hold{};
  WorkspaceAnchor anchor{};
  SafetyState safety{};
  Vec3 last_position = Vec3::Zero();
  Quat last_orientation = Quat::Identity();
  bool has_started = false;
  bool has_finished = false;

  void read(double now, double dt, const WorldState& state) {
    const DeviceState sample = device->read(now);
    has_finished = sample.status == DeviceStatus::finished;
    if (has_finished || !check_device(config.limits, sample, now, dt, safety)) return;
    if (sample.status == DeviceStatus::not_ready) return;
    if (!has_started) {
      const BodyState& body = state.bodies[idx(config.body)];
      anchor = anchor_at(sample.motion.pose, {config.at.value_or(body.position), body.orientation});
      hold.body = config.body;
      hold.coupling = config.coupling;
    }
    hold.handle =
        world_motion(config.workspace, anchor, sample.motion, device->limits().senses_rotation);
    if (has_started) return;
    grasp(hold.coupling, state.bodies[idx(config.body)], hold.handle.pose);
    last_position = hold.handle.pose.position;
    last_orientation = hold.handle.pose.orientation;
    has_started = true;
  }

  /// Sends what the hand feels, and counts it.
  Wrench write(const WorldState& state, WorldHandSummary& summary) {
    if (!has_started) return {};
    const BodyState& body = state.bodies[idx(config.body)];
    const Wrench reaction =
        coupling_reaction(hold.coupling, hold.handle, world.rigid[idx(config.body)], body);
    DeviceLimits limits = device->limits();
    limits.max_force = std::min(limits.max_force, config.limits.max_force);
    limits.max_torque = std::min(limits.max_torque, config.limits.max_torque);
    const Wrench sent = within(limits, device_wrench(config.workspace, reaction));
    device->write(sent);
    const Vec3 turn = 2.0 * (hold.handle.pose.orientation * last_orientation.conjugate()).vec();
    summary.port_energy -=
        reaction.force.dot(hold.handle.pose.position - last_position) + reaction.torque.dot(turn);
    summary.port_energy_min = std::min(summary.port_energy_min, summary.port_energy);
    summary.force_max = std::max(summary.force_max, sent.force.norm());
    last_position = hold.handle.pose.position;
    last_orientation = hold.handle.pose.orientation;
    return sent;
  }
};

/// All hands of a session.
struct Hands {
  std::vector<Hand> list;
  std::vector<HandHold> holds;  // of those that have started
  std::vector<Motion> handles;
  std::vector<Wrench> commands;

  Hands(const WorldSessionConfig& config, std::span<HapticDevice* const> devices)
      : handles(devices.size()), commands(devices.size()) {
    for (std::size_t i = 0; i < devices.size(); ++i)
      list.push_back({config.world, config.hands[i], devices[i]});
    holds.reserve(devices.size());
  }
  /// Reads all devices; false where the session ends: a device has finished or is at fault.
  bool read(double now, double dt, const WorldState& state, WorldSummary& summary) {
    bool goes_on = true;
    holds.clear();
    for (std::size_t i = 0; i < list.size(); ++i) {
      Hand& hand = list[i];
      if (hand.device == nullptr) continue;
      hand.read(now, dt, state);
      summary.hands[i].fault = hand.safety.fault;
      if (summary.fault == Fault::none) summary.fault = hand.safety.fault;
      goes_on = goes_on && !hand.has_finished && hand.safety.fault == Fault::none;
      if (hand.has_started) holds.push_back(hand.hold);
    }
    return goes_on;
  }
  void write(const WorldState& state, WorldSummary& summary) {
    summary.port_energy = 0.0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].device != nullptr) commands[i] = list[i].write(state, summary.hands[i]);
      handles[i] = list[i].hold.handle;
      const WorldHandSummary& hand = summary.hands[i];
      summary.port_energy += hand.port_energy;
      summary.port_energy_min = std::min(summary.port_energy_min, hand.port_energy_min);
      summary.force_max = std::max(summary.force_max, hand.force_max);
    }
  }
  /// Zero to every device, whatever another does.
  void let_go() noexcept {
    for (const Hand& hand : list) {
      if (hand.device == nullptr) continue;
      try {
        hand.device->write({});
      } catch (...) {  // the others are still to be let go
      }
    }
  }
  void fail(WorldSummary& summary) noexcept {
    for (WorldHandSummary& hand : summary.hands) hand.fault = Fault::not_finite;
    summary.fault = Fault::not_finite;
  }
};

/// Every way out of a session, an exception too, ends in zero force.
struct LetGo {
  Hands& hands;
  ~LetGo() { hands.let_go(); }
};

bool is_finite(const WorldState& state) noexcept {
  return std::all_of(state.bodies.begin(), state.bodies.end(), [](const BodyState& y) {
    return y.position.allFinite() && y.orientation.coeffs().allFinite() &&
           y.linear_momentum.allFinite() && y.angular_momentum.allFinite();
  });
}

/// A turn of more than a radian a frame could be one the other way round.
void check_motors(const WorldSessionConfig& config) {
  for (const WorldJoint& joint : config.world.joints) {
    const bool is_turning =
        joint.kind == JointKind::hinge && joint.motor.is_on && !joint.motor.is_servo;
    if (!is_turning || std::fabs(joint.motor.target) <= config.rate) continue;
    char text[160];
    std::snprintf(text, sizeof text,
                  "': motor of %.4g rad/s at %g Hz, expected at most 1 rad a frame",
                  joint.motor.target, config.rate);
    throw InputError("joint '" + joint.name + text);
  }
}

void check_devices(const WorldSessionConfig& config, std::span<HapticDevice* const> devices) {
  if (devices.size() != config.hands.size())
    throw std::invalid_argument(std::to_string(devices.size()) + " devices, expected the " +
                                std::to_string(config.hands.size()) + " of the hands");
  for (HapticDevice* device : devices)
    if (device != nullptr && device->limits().holds_person)
      throw std::invalid_argument(device->name() +
                                  ": holds a person, expected a simulated device: worlds of "
                                  "several bodies have no ramps and no watchdog yet");
}

void count(const WorldStep& step, WorldSummary& summary) noexcept {
  summary.joint_error = std::max(summary.joint_error, step.joint_error);
  summary.residual_max = std::max(summary.residual_max, step.residual);
  summary.waited += step.waited;
  summary.gap_min = std::min(summary.gap_min, step.least_gap);
  summary.rows_max = std::max(summary.rows_max, step.rows);
  summary.queries += step.queries;
  summary.impacts += step.impacts;
  summary.newton += step.newton;
  summary.pairs_max = std::max(summary.pairs_max, step.pairs);
  summary.largest_island = std::max(summary.largest_island, step.largest_island);
  summary.pressing_max = std::max(summary.pressing_max, step.pressing);
  summary.parts_max = std::max(summary.parts_max, step.parts);
  summary.not_whole += step.is_whole ? 0 : 1;
  summary.awake = step.awake;
}

}  // namespace

WorldSummary run_world(const WorldSessionConfig& config, std::span<HapticDevice* const> devices,
                       const std::function<void(const WorldFrame&)>& sink,
                       const std::atomic<bool>* stop) {
  check_devices(config, devices);
  check_motors(config);
  WorldSummary summary;
  summary.hands.resize(devices.size());
  WorldState state = config.start;
  const WorldScratchPtr scratch = reserve_world(config.world);
  Hands hands(config, devices);
  const LetGo let_go{hands};
  StateHash hash;
  summary.energy_start = mechanical_energy(config.world, state);
  summary.gap_min = kInfinity;
  const double dt = 1.0 / config.rate;
  const auto frames = static_cast<std::uint64_t>(std::llround(config.duration * config.rate));
  WorldFrame frame;
  std::vector<JointReading> joints(config.world.joints.size());
  for (std::uint64_t i = 0; i < frames && !summary.was_stopped; ++i) {
    if (!hands.read(static_cast<double>(i) * dt, dt, state, summary)) break;
    frame.step = step_world(config.world, {.hands = hands.holds, .drives = config.drives}, dt,
                            state, *scratch);
    if (!is_finite(state)) {
      hands.fail(summary);
      break;
    }
    hands.write(state, summary);
    const double made =
        mechanical_energy(config.world, state) - summary.energy_start - summary.port_energy;
    summary.energy_made = std::max(summary.energy_made, made);
    add_frame(state, hands.commands, hash);
    count(frame.step, summary);
    ++summary.frames;
    for (std::size_t k = 0; sink && k < joints.size(); ++k)
      joints[k] = read_joint(config.world, state, *scratch, static_cast<std::int32_t>(k), dt);
    frame.frame = i;
    frame.time = static_cast<double>(i + 1) * dt;
    frame.bodies = state.bodies;
    frame.joints = joints;
    frame.handles = hands.handles;
    frame.commands = hands.commands;
    if (sink) sink(frame);
    summary.was_stopped = stop != nullptr && stop->load(std::memory_order_relaxed);
  }
  summary.state_hash = hash.value;
  summary.energy_end = mechanical_energy(config.world, state);
  return summary;
}

}  // namespace thigma
