#include "thigma/session/detail/world_hands.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

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

Motion motion_of(const SessionHand& hand) {
  return world_motion(hand.config->workspace, hand.anchor, hand.sample.motion,
                      hand.device->limits().senses_rotation);
}

/// Takes hold of a body where it is: both springs at rest.
void take(std::int32_t body, const Vec3& at, const Coupling& coupling, const WorldState& state,
          SessionHand& hand) {
  const BodyState& y = state.bodies[idx(body)];
  hand.anchor = anchor_at(hand.sample.motion.pose, {at, y.orientation});
  hand.hold.body = body;
  hand.hold.coupling = coupling;
  hand.hold.handle = motion_of(hand);
  grasp(hand.hold.coupling, y, hand.hold.handle.pose);
  hand.taken = hand.hold.coupling;
  ++hand.takings;
  hand.last_position = hand.hold.handle.pose.position;
  hand.last_orientation = hand.hold.handle.pose.orientation;
  hand.is_holding = true;
}

/// Lets go. Each grip takes an aim of its own: to take hold again is to be aimed again.
void open(SessionHand& hand) noexcept {
  if (hand.config->is_free && hand.is_holding && !hand.has_new_aim) hand.aim.body = -1;
  hand.is_holding = false;
  hand.hold.body = -1;
}

bool may_hold(const SessionHand& hand, std::int32_t body) noexcept {
  if (!hand.config->is_free) return body >= 0;  // its own
  if (body < 0 || idx(body) >= hand.config->couplings.size()) return false;
  return moves_freely(hand.world->bodies[idx(body)].kind);
}

/// A hand that holds its body from the first sample on.
void move_tied(const WorldState& state, SessionHand& hand) {
  if (hand.is_holding) {
    hand.hold.handle = motion_of(hand);
    return;
  }
  const std::int32_t body = hand.config->body;
  take(body, hand.config->at.value_or(state.bodies[idx(body)].position), hand.config->coupling,
       state, hand);
}

/// One that takes hold and lets go.
void move_free(const WorldState& state, SessionHand& hand) {
  const bool is_closed = (hand.sample.buttons & kClutchButton) != 0;
  const bool wants = is_closed && may_hold(hand, hand.aim.body);
  if (hand.is_holding && (!wants || hand.has_new_aim)) open(hand);
  if (wants && !hand.is_holding) {
    const BodyState& y = state.bodies[idx(hand.aim.body)];
    take(hand.aim.body, transform_point({y.position, y.orientation}, hand.aim.point),
         hand.config->is_free ? hand.config->couplings[idx(hand.aim.body)] : hand.config->coupling,
         state, hand);
    hand.has_new_aim = false;
  }
  hand.hold.handle = motion_of(hand);
  if (hand.is_holding) hand.hold.coupling = faded(hand.taken, hand.sample.weight);
}

void move(double now, double dt, const WorldState& state, SessionHand& hand) {
  hand.has_finished = hand.sample.status == DeviceStatus::finished;
  if (hand.has_finished) return;
  if (hand.config->is_free && hand.sample.status == DeviceStatus::lost) {
    open(hand);
    clear_fault(hand.safety);  // whoever comes next begins anew
    return;
  }
  if (!check_device(hand.config->limits, hand.sample, now, dt, hand.safety)) return;
  if (hand.sample.status == DeviceStatus::not_ready) return;
  if (hand.config->may_let_go())
    move_free(state, hand);
  else
    move_tied(state, hand);
}

/// Sends what the hand feels, and counts it.
Wrench write(const WorldState& state, SessionHand& hand, WorldHandSummary& summary) {
  if (!hand.is_holding) {
    if (hand.config->may_let_go()) hand.device->write({});
    return {};
  }
  const HandHold& hold = hand.hold;
  const Wrench reaction = coupling_reaction(
      hold.coupling, hold.handle, hand.world->rigid[idx(hold.body)], state.bodies[idx(hold.body)]);
  DeviceLimits limits = hand.device->limits();
  limits.max_force = std::min(limits.max_force, hand.config->limits.max_force);
  limits.max_torque = std::min(limits.max_torque, hand.config->limits.max_torque);
  const Wrench sent = within(limits, device_wrench(hand.config->workspace, reaction));
  hand.device->write(sent);
  const Vec3 turn = 2.0 * (hold.handle.pose.orientation * hand.last_orientation.conjugate()).vec();
  summary.port_energy -= reaction.force.dot(hold.handle.pose.position - hand.last_position) +
                         reaction.torque.dot(turn);
  summary.port_energy_min = std::min(summary.port_energy_min, summary.port_energy);
  summary.force_max = std::max(summary.force_max, sent.force.norm());
  hand.last_position = hold.handle.pose.position;
  hand.last_orientation = hold.handle.pose.orientation;
  return sent;
}

/// What a hand with a clutch holds when it is closed.
WorldAim aim_at_start(const WorldSessionConfig& config, const WorldHand& hand) {
  WorldAim aim;
  aim.body = hand.body;
  if (hand.body < 0 || !hand.at) return aim;
  const BodyState& y = config.start.bodies[idx(hand.body)];
  aim.point = transform_point(inverse(Pose{y.position, y.orientation}), *hand.at);
  return aim;
}

}  // namespace

SessionHands::SessionHands(const WorldSessionConfig& config, std::span<HapticDevice* const> devices)
    : handles(devices.size()), commands(devices.size()), grips(devices.size()) {
  for (std::size_t i = 0; i < devices.size(); ++i) {
    list.push_back({&config.world, &config.hands[i], devices[i]});
    list.back().aim = aim_at_start(config, config.hands[i]);
  }
  holds.reserve(devices.size());
}

void aim(const WorldAim& aim, SessionHands& hands) noexcept {
  for (SessionHand& hand : hands.list) {
    if (!hand.config->is_free) continue;
    hand.aim = aim;
    hand.has_new_aim = true;
  }
}

void sample_hands(double now, SessionHands& hands) {
  for (SessionHand& hand : hands.list)
    if (hand.device != nullptr) hand.sample = hand.device->read(now);
}

bool move_hands(double now, double dt, const WorldState& state, SessionHands& hands,
                WorldSummary& summary) {
  bool goes_on = true;
  hands.holds.clear();
  for (std::size_t i = 0; i < hands.list.size(); ++i) {
    SessionHand& hand = hands.list[i];
    if (hand.device == nullptr) continue;
    move(now, dt, state, hand);
    summary.hands[i].fault = hand.safety.fault;
    if (summary.fault == Fault::none) summary.fault = hand.safety.fault;
    goes_on = goes_on && !hand.has_finished && hand.safety.fault == Fault::none;
    if (hand.is_holding) hands.holds.push_back(hand.hold);
  }
  return goes_on;
}

void write_hands(const WorldState& state, SessionHands& hands, WorldSummary& summary) {
  summary.port_energy = 0.0;
  for (std::size_t i = 0; i < hands.list.size(); ++i) {
    SessionHand& hand = hands.list[i];
    WorldHandSummary& told = summary.hands[i];
    if (hand.device != nullptr) hands.commands[i] = write(state, hand, told);
    hands.handles[i] = hand.hold.handle;
    hands.grips[i] = {hand.is_holding ? hand.hold.body : -1,
                      hand.taken.body_from_grasp,
                      hand.sample,
                      told.port_energy,
                      hand.takings,
                      hand.taken,
                      hand.anchor};
    summary.port_energy += told.port_energy;
    summary.port_energy_min = std::min(summary.port_energy_min, told.port_energy_min);
    summary.force_max = std::max(summary.force_max, told.force_max);
  }
}

void renumber(const WorldSessionConfig& next, std::span<const std::int32_t> was,
              SessionHands& hands) noexcept {
  const auto now = [&](std::int32_t body) {
    const auto found = std::find(was.begin(), was.end(), body);
    return body < 0 || found == was.end() ? -1 : static_cast<std::int32_t>(found - was.begin());
  };
  for (std::size_t i = 0; i < hands.list.size(); ++i) {
    SessionHand& hand = hands.list[i];
    hand.world = &next.world;
    hand.config = &next.hands[i];
    hand.aim.body = now(hand.aim.body);
    hand.hold.body = now(hand.hold.body);
    if (hand.hold.body < 0) open(hand);
  }
}

void let_go(SessionHands& hands) noexcept {
  for (const SessionHand& hand : hands.list) let_go(hand.device);
}

void let_go(HapticDevice* device) noexcept {
  if (device == nullptr) return;
  try {
    device->write({});
  } catch (...) {  // others are still to be let go
  }
}

}  // namespace thigma::detail
