#include "thigma/session/world_hand.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

/// haptic_step's stepper.
ConstrainedStep step_held(void* self, const BodyAtState& at, const StepForces& forces,
                          double dt) THIGMA_RT {
  auto& loop = *static_cast<WorldHandLoop*>(self);
  const ConstrainedStep step =
      step_hand(loop.news.value().model, at, forces, dt, loop.memory, loop.scratch);
  WorldHapticSummary& counts = loop.summary;
  counts.rows_max = std::max(counts.rows_max, loop.memory.rows);
  counts.bodies_max = std::max(counts.bodies_max, loop.memory.bodies);
  counts.newton_max = std::max(counts.newton_max, loop.memory.newton);
  counts.cut_short += loop.memory.is_cut_short ? 1 : 0;
  counts.held_back += step.is_held_back ? 1 : 0;
  return step;
}

/// Takes hold of what the world says, where the world has it: both springs as they are there.
void take_grip(const HandNews& news, WorldHandLoop& loop) THIGMA_RT {
  const HandBody& body = news.model.bodies[0];
  HapticState& state = loop.state;
  loop.params.body = body.rigid;
  loop.params.coupling = news.coupling;
  state.body = body.state;
  state.coupling = news.coupling;
  state.anchor = news.anchor;
  state.is_grasped = state.was_pressed = true;
  loop.device.holds = true;
}

void take_news(WorldHandLoop& loop) THIGMA_RT {
  if (!loop.news.fetch()) return;
  const HandNews& news = loop.news.value();
  LinearContactModel& age = loop.ages.draft();
  age.time = news.time;
  age.sequence = news.sequence;
  loop.ages.publish();
  const bool is_new = news.grip != loop.grip;
  loop.grip = news.grip;
  if (news.grip == 0) {
    loop.device.holds = false;
    return;
  }
  if (is_new) take_grip(news, loop);
  const HandCorrection correction = take_hand_model(news.model, loop.state.body, loop.memory);
  if (!(correction.way > 0.0) || is_new) return;
  ++loop.summary.corrections;
  loop.summary.correction_max = std::max(loop.summary.correction_max, correction.way);
}

void count(const HapticSample& sample, WorldHandLoop& loop) THIGMA_RT {
  WorldHapticSummary& summary = loop.summary;
  ++summary.steps;
  summary.force_max = std::max(summary.force_max, sample.command.force.norm());
  summary.port_energy = loop.state.energy.energy;
  summary.port_energy_min = loop.state.energy.energy_min;
  add_frame(loop.hash, sample.body, sample.command);
  summary.state_hash = loop.hash.value;
  if (sample.is_grasped) summary.model_age_max = std::max(summary.model_age_max, sample.model_age);
}

void tell(const HapticSample& sample, WorldHandLoop& loop) THIGMA_RT {
  HandNote& note = loop.notes.draft();
  note.frame = 1 + static_cast<std::uint64_t>(std::llround(sample.time / loop.period));
  note.time = sample.time;
  note.period = loop.period;
  note.device = loop.device.sample;
  note.openings = loop.device.openings;
  note.grip = sample.is_grasped ? loop.grip : 0;
  note.body = sample.body;
  note.wanted_speed = sample.wanted_speed;
  note.energy = sample.energy;
  note.sent = sample.command;
  loop.notes.publish();
}

}  // namespace

void GripDevice::turn(double now) THIGMA_RT {
  constexpr double kLongest = 0.05;  // step that is turned for, as after a gap [s]
  WorkspaceAnchor anchor;
  anchor.world.orientation = turned_;
  turn_by_buttons({}, sample.buttons, kButtonTurnRate, std::clamp(now - last_read_, 0.0, kLongest),
                  anchor);
  last_read_ = now;
  turned_ = sample.motion.pose.orientation = anchor.world.orientation;
  sample.motion.twist.angular = anchor.turn_rate;
  if (sample.has_true_handle) sample.true_handle.orientation = turned_;
}

DeviceState GripDevice::read(double now) THIGMA_RT {
  sample = device_->read(now);
  if (!device_->limits().senses_rotation) turn(now);
  // A page that is lost keeps its buttons as they were, and the world may not see that it was.
  const bool is_closed =
      (sample.buttons & kClutchButton) != 0 && sample.status != DeviceStatus::lost;
  if (has_clutch_ && !is_closed) {
    openings += was_closed_ ? 1 : 0;
    holds = false;  // until the world says that it has taken hold anew
  }
  was_closed_ = is_closed;
  DeviceState seen = sample;
  seen.buttons = holds ? seen.buttons | kClutchButton : seen.buttons & ~kClutchButton;
  return seen;
}

WorldHandLoop::WorldHandLoop(const WorldHand& config, HapticDevice& of, double rate)
    : device(of, config.may_let_go()),
      is_free(config.is_free),
      has_clutch(config.may_let_go()),
      period(1.0 / rate) {
  params.workspace = config.workspace;
  params.safety = config.limits;
  params.response = ResponseKind::constrained;
  params.safety.rides_out_gaps = true;  // taken away where a person is held
  use_device_limits(device.limits(), params);
  state = initial_state(params, Pose{});
  ports.device = &device;
  ports.models = &ages;
  ports.stepper = {this, step_held};
  reserve_hand_step(scratch);
}

HapticSample step_world_hand(WorldHandLoop& loop, const HapticTick& tick) THIGMA_RT {
  take_news(loop);
  const HapticSample sample = haptic_step(loop.params, loop.ports, tick, loop.state);
  // Whoever comes next to a page's hand begins anew.
  const bool is_back = loop.is_free && sample.fault == Fault::device_lost &&
                       loop.device.sample.status == DeviceStatus::ok;
  if (is_back) clear_fault(loop.state.safety);
  count(sample, loop);
  tell(sample, loop);
  return sample;
}

HandTick tick_of(std::int32_t hand, const HapticTick& tick, const HapticSample& sample,
                 const WorldHandLoop& loop) THIGMA_RT {
  HandTick made;
  made.hand = hand;
  made.step = loop.summary.steps - 1;
  made.tick = tick;
  made.device = loop.device.sample;
  made.news = loop.news.value().sequence;
  made.sent = sample.command;
  made.energy = sample.energy;
  return made;
}

/// Of the way to a pose, what the world may go in a step.
double HandRelay::share_of(const Pose& pose, const Twist& twist, double energy) const THIGMA_RT {
  // While it holds nothing nothing follows it: only what a device may do at most is kept to.
  constexpr double kMost = 0.9;  // of the limits that the world's hand is judged by
  const SafetyLimits& limits = loop_->params.safety;
  const double fast = kMost * limits.max_speed, fast_turn = kMost * limits.max_turn_speed;
  const double speed = border.is_held ? std::min(kCatchUp, fast) : fast;
  const double turn_speed = border.is_held ? std::min(kCatchUpTurn, fast_turn) : fast_turn;
  const double most = step_ * std::max(speed, twist.linear.norm());
  const double most_turn = step_ * std::max(turn_speed, twist.angular.norm());
  const Vec3 by = pose.position - passed_.position;
  const Vec3 turn = vector_from_rotation(pose.orientation * passed_.orientation.conjugate());
  double share = 1.0;
  if (by.norm() > most) share = std::min(share, most / by.norm());
  if (turn.norm() > most_turn) share = std::min(share, most_turn / turn.norm());
  if (!border.is_held) return share;
  // Work of the hand at a share s of the way: at most -s given + s^2 grows.
  // The body may be stopped in the step: what its motion saves is not counted.
  const double by_dampers = border.dampers.force.dot(by) + border.dampers.torque.dot(turn);
  const double given =
      border.springs.force.dot(by) + border.springs.torque.dot(turn) + std::min(by_dampers, 0.0);
  const double grows =
      border.stiffness * by.squaredNorm() + border.angular_stiffness * turn.squaredNorm();
  const double inside = given * given + 4.0 * grows * (energy - border.energy + kBorderCredit);
  if (!(grows > 0.0)) return share;
  if (!(inside > 0.0)) return 0.0;
  return std::clamp((given + std::sqrt(inside)) / (2.0 * grows), 0.0, share);
}

DeviceState HandRelay::read(double now) THIGMA_RT {
  loop_->notes.fetch();
  const HandNote& note = loop_->notes.value();
  seen = note.frame;
  DeviceState sample = note.device;
  if (note.frame == 0) sample.status = DeviceStatus::not_ready;
  if (sample.status != DeviceStatus::ok) return sample;
  const std::uint64_t ticks = note.frame - frame_;
  // A clutch that was open meanwhile has let go, whatever it is now.
  const bool was_open = note.openings != openings_;
  frame_ = note.frame;
  openings_ = note.openings;
  // That a device is silent is its hand's to say: its steps may be late while others' are not.
  if (ticks == 0) sample.time = now;
  if (has_passed_ && (ticks != 1 || is_behind_)) {
    Pose& pose = sample.motion.pose;
    const double share = share_of(pose, sample.motion.twist, note.energy);
    Vec3 turn = vector_from_rotation(pose.orientation * passed_.orientation.conjugate());
    is_behind_ = share < 1.0;
    if (is_behind_) {
      turn *= share;
      pose.position = passed_.position + share * (pose.position - passed_.position);
      pose.orientation = unit(rotation_from_vector(turn) * passed_.orientation);
      // It takes hold where the hand is, not where it was.
      if (loop_->has_clutch && !is_closed_) sample.buttons &= ~kClutchButton;
    }
    sample.motion.twist.linear = (pose.position - passed_.position) / step_;
    sample.motion.twist.angular = turn / step_;
  }
  if (loop_->has_clutch && was_open) sample.buttons &= ~kClutchButton;
  is_closed_ = (sample.buttons & kClutchButton) != 0;
  has_passed_ = true;
  passed_ = sample.motion.pose;
  return sample;
}

namespace {

/// What a hand has put into the world, and by what it pulls at it now.
HandBorder border_of(const WorldRun& run, const HandInFrame& hand) {
  HandBorder border;
  border.is_held = hand.grip.body >= 0;
  if (!border.is_held) return border;
  const Workspace& workspace = hand.config.workspace;
  Coupling coupling = hand.grip.coupling;
  coupling.is_grasped = true;
  Coupling springs = coupling;
  springs.linear_damping = springs.angular_damping = 0.0;
  const std::size_t body = idx(hand.grip.body);
  const auto reaction = [&](const Coupling& of) {
    return device_wrench(workspace,
                         coupling_reaction(of, {hand.handle.pose, Twist{}}, run.world().rigid[body],
                                           run.state().bodies[body]));
  };
  border.energy = torque_scale(workspace) * hand.grip.energy;
  border.springs = reaction(springs);
  const Wrench all = reaction(coupling);
  border.dampers = {all.force - border.springs.force, all.torque - border.springs.torque};
  border.stiffness = workspace.force_scale * workspace.motion_scale *
                     (coupling.linear_stiffness + coupling.linear_damping / hand.step);
  border.angular_stiffness =
      torque_scale(workspace) * (coupling.angular_stiffness + coupling.angular_damping / hand.step);
  return border;
}

}  // namespace

void publish_news(const WorldRun& run, const HandInFrame& hand, WorldHandLoop& loop,
                  HandRelay& relay, HandModelScratch& scratch, double& last) {
  const WorldGrip& grip = hand.grip;
  relay.border = border_of(run, hand);
  loop.notes.fetch();
  const HandNote& note = loop.notes.value();
  HandNews& news = loop.news.draft();
  news.sequence = news.model.sequence = ++loop.published;
  news.time = note.time;
  news.grip = grip.body >= 0 ? grip.number : 0;
  news.coupling = grip.coupling;
  news.anchor = grip.anchor;
  if (grip.body >= 0) {
    const BodyState& y = run.state().bodies[idx(grip.body)];
    const double reach = run.world().boxes[idx(run.world().shape[idx(grip.body)])].reach;
    HandModelRequest request;
    request.body = grip.body;
    request.step = hand.step;
    // As far as it is from where the world has it, and as it goes until the next news.
    constexpr double kSpare = 2.0;
    const double apart = note.grip == news.grip ? travel_between(y, note.body, reach) : 0.0;
    const double interval = std::max(note.time - last, note.period);
    request.way = kSpare * (apart + interval * note.wanted_speed);
    make_hand_model(run.world(), run.state(), run.scratch(), request, scratch, news.model);
  }
  last = note.time;
  loop.news.publish();
}

}  // namespace thigma
