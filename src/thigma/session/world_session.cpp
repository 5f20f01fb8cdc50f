#include "thigma/session/world_session.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

Wrench within(const DeviceLimits& limits, Wrench wrench) noexcept {
  const auto cut = [](Vec3& v, double most) {
    const double size = v.norm();
    if (size > most) v *= most / size;
  };
  cut(wrench.force, limits.max_force);
  cut(wrench.torque, limits.max_torque);
  return wrench;
}

/// The hand of a session: its handle in the world, and what it has put in.
struct Hand {
  const WorldSessionConfig& config;
  HapticDevice* device = nullptr;
  HandHold hold{};
  WorkspaceAnchor anchor{};
  Vec3 last_position = Vec3::Zero();
  Quat last_orientation = Quat::Identity();
  bool has_started = false;
  bool has_finished = false;

  void read(double now, const WorldState& state) {
    const DeviceState sample = device->read(now);
    has_finished = sample.status == DeviceStatus::finished || sample.status == DeviceStatus::lost;
    if (sample.status == DeviceStatus::not_ready) return;
    if (!has_started) {
      const BodyState& body = state.bodies[idx(config.held)];
      anchor = anchor_at(sample.motion.pose, {body.position, body.orientation});
      hold.body = config.held;
      hold.coupling = config.coupling;
    }
    hold.handle =
        world_motion(config.workspace, anchor, sample.motion, device->limits().senses_rotation);
    if (has_started) return;
    grasp(hold.coupling, state.bodies[idx(config.held)], hold.handle.pose);
    last_position = hold.handle.pose.position;
    last_orientation = hold.handle.pose.orientation;
    has_started = true;
  }

  /// What is sent, and the energy that the hand has put in over the step [J].
  Wrench write(const WorldState& state, double& energy) {
    if (!has_started) return {};
    const BodyState& body = state.bodies[idx(config.held)];
    const Wrench reaction =
        coupling_reaction(hold.coupling, hold.handle, config.world.rigid[idx(config.held)], body);
    const Wrench sent = within(device->limits(), device_wrench(config.workspace, reaction));
    device->write(sent);
    const Vec3 turn = 2.0 * (hold.handle.pose.orientation * last_orientation.conjugate()).vec();
    energy =
        -reaction.force.dot(hold.handle.pose.position - last_position) - reaction.torque.dot(turn);
    last_position = hold.handle.pose.position;
    last_orientation = hold.handle.pose.orientation;
    return sent;
  }
};

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

WorldSummary run_world(const WorldSessionConfig& config, HapticDevice* device,
                       const std::function<void(const WorldFrame&)>& sink,
                       const std::atomic<bool>* stop) {
  if (device != nullptr && device->limits().holds_person)
    throw std::invalid_argument(device->name() +
                                ": holds a person, expected a simulated device: worlds of several "
                                "bodies have no safety limits yet");
  WorldSummary summary;
  WorldState state = config.start;
  const WorldScratchPtr scratch = reserve_world(config.world);
  Hand hand{config, config.held >= 0 ? device : nullptr};
  StateHash hash;
  summary.energy_start = mechanical_energy(config.world, state);
  summary.gap_min = kInfinity;
  const double dt = 1.0 / config.rate;
  const auto frames = static_cast<std::uint64_t>(std::llround(config.duration * config.rate));
  WorldFrame frame;
  std::vector<JointReading> joints(config.world.joints.size());
  for (std::uint64_t i = 0; i < frames && !summary.was_stopped; ++i) {
    if (hand.device != nullptr) hand.read(static_cast<double>(i) * dt, state);
    if (hand.has_finished) break;
    WorldInputs inputs;
    inputs.drives = config.drives;
    if (hand.has_started) inputs.hands = {&hand.hold, 1};
    frame.step = step_world(config.world, inputs, dt, state, *scratch);
    double energy = 0.0;
    frame.command = hand.device != nullptr ? hand.write(state, energy) : Wrench{};
    summary.port_energy += energy;
    summary.port_energy_min = std::min(summary.port_energy_min, summary.port_energy);
    const double made =
        mechanical_energy(config.world, state) - summary.energy_start - summary.port_energy;
    summary.energy_made = std::max(summary.energy_made, made);
    summary.force_max = std::max(summary.force_max, frame.command.force.norm());
    for (const BodyState& y : state.bodies) add_state(y, hash);
    add_vector(hash, frame.command.force);
    add_vector(hash, frame.command.torque);
    count(frame.step, summary);
    ++summary.frames;
    frame.frame = i;
    frame.time = static_cast<double>(i + 1) * dt;
    frame.bodies = state.bodies;
    for (std::size_t k = 0; sink && k < joints.size(); ++k)
      joints[k] = read_joint(config.world, state, *scratch, static_cast<std::int32_t>(k), dt);
    frame.joints = joints;
    frame.handle = hand.hold.handle;
    if (sink) sink(frame);
    summary.was_stopped = stop != nullptr && stop->load(std::memory_order_relaxed);
  }
  if (device != nullptr) device->write({});
  summary.state_hash = hash.value;
  summary.energy_end = mechanical_energy(config.world, state);
  return summary;
}

}  // namespace thigma
