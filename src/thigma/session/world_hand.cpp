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
  if (sample.is_grasped)
    summary.model_age_max = std::max(summary.model_age_max, sample.model_age);
}

void tell(const HapticSample& sample, WorldHandLoop& loop) THIGMA_RT {
  HandNote& note = loop.notes.draft();
  note.frame = loop.summary.steps;
  note.time = sample.time;
  note.period = loop.period;
  note.device = loop.device.sample;
  note.openings = loop.device.openings;
  note.grip = sample.is_grasped ? loop.grip : 0;
  note.body = sample.body;
  note.wanted_speed = sample.wanted_speed;
  loop.notes.publish();
}

double angle_between(const Quat& from, const Quat& to) THIGMA_RT {
  return vector_from_rotation(to * from.conjugate()).norm();
}

}  // namespace

DeviceState GripDevice::read(double now) THIGMA_RT {
  const bool was_closed = (sample.buttons & kClutchButton) != 0;
  sample = device_->read(now);
  const bool is_closed = (sample.buttons & kClutchButton) != 0;
  if (is_free_ && !is_closed) {
    openings += was_closed ? 1 : 0;
    holds = false;  // until the world says that it has taken hold anew
  }
  DeviceState seen = sample;
  seen.buttons = holds ? seen.buttons | kClutchButton : seen.buttons & ~kClutchButton;
  return seen;
}

WorldHandLoop::WorldHandLoop(const WorldHand& config, HapticDevice& of, double rate)
    : device(of, config.is_free), is_free(config.is_free), period(1.0 / rate) {
  params.workspace = config.workspace;
  params.safety = config.limits;
  params.response = ResponseKind::constrained;
  params.turn_rate = 0.0;
  params.safety.rides_out_gaps = true;  // a slow step of the world is no fault
  use_device_limits(of.limits(), params);
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

DeviceState HandRelay::read(double) THIGMA_RT {
  loop_->notes.fetch();
  const HandNote& note = loop_->notes.value();
  DeviceState sample = note.device;
  if (note.frame == 0) sample.status = DeviceStatus::not_ready;
  if (sample.status != DeviceStatus::ok) return sample;
  const std::uint64_t ticks = note.frame - frame_;
  // A clutch that was open meanwhile has let go, whatever it is now.
  const bool was_open = note.openings != openings_;
  frame_ = note.frame;
  openings_ = note.openings;
  if (has_passed_) {
    Pose& pose = sample.motion.pose;
    // While it holds nothing nothing follows it: only what a device may do at most is kept to.
    constexpr double kMost = 0.9;  // of the limits that the world's hand is judged by
    const SafetyLimits& limits = loop_->params.safety;
    const bool is_held = !loop_->is_free || is_closed_;
    const double speed = is_held ? kCatchUp : kMost * limits.max_speed;
    const double turn_speed = is_held ? kCatchUpTurn : kMost * limits.max_turn_speed;
    const Twist& twist = sample.motion.twist;
    const double most = step_ * std::max(speed, twist.linear.norm());
    const double most_turn = step_ * std::max(turn_speed, twist.angular.norm());
    const double way = (pose.position - passed_.position).norm();
    const double turn = angle_between(passed_.orientation, pose.orientation);
    double share = 1.0;
    if (way > most) share = std::min(share, most / way);
    if (turn > most_turn) share = std::min(share, most_turn / turn);
    const bool is_behind = share < 1.0 && (ticks > 1 || is_behind_);
    if (is_behind) {
      const Vec3 by = vector_from_rotation(pose.orientation * passed_.orientation.conjugate());
      pose.position = passed_.position + share * (pose.position - passed_.position);
      pose.orientation = unit(rotation_from_vector(share * by) * passed_.orientation);
    }
    if (is_behind || is_behind_ || ticks > 1) {
      sample.motion.twist.linear = (pose.position - passed_.position) / step_;
      sample.motion.twist.angular =
          vector_from_rotation(pose.orientation * passed_.orientation.conjugate()) / step_;
    }
    is_behind_ = is_behind;
    // It takes hold where the hand is, not where it was.
    if (loop_->is_free && (was_open || (is_behind && !is_closed_)))
      sample.buttons &= ~kClutchButton;
  }
  is_closed_ = (sample.buttons & kClutchButton) != 0;
  has_passed_ = true;
  passed_ = sample.motion.pose;
  return sample;
}

void publish_news(const WorldRun& run, const WorldGrip& grip, double step, WorldHandLoop& loop,
                  HandModelScratch& scratch, double& last) {
  loop.notes.fetch();
  const HandNote& note = loop.notes.value();
  HandNews& news = loop.news.draft();
  ++loop.published;
  news.sequence = loop.published;
  news.time = note.time;
  news.grip = grip.body >= 0 ? grip.number : 0;
  news.coupling = grip.coupling;
  news.anchor = grip.anchor;
  news.model.sequence = loop.published;
  if (grip.body >= 0) {
    const BodyState& y = run.state().bodies[idx(grip.body)];
    const double reach = run.world().boxes[idx(run.world().shape[idx(grip.body)])].reach;
    HandModelRequest request;
    request.body = grip.body;
    request.step = step;
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
