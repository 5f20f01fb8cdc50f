#include "thigma/session/world_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/loop/samples.h"
#include "thigma/math/infinity.h"
#include "thigma/session/detail/world_hands.h"
#include "thigma/session/rt_thread.h"

namespace thigma {
namespace {

void add_state(const BodyState& y, StateHash& hash) noexcept {
  add_vector(hash, y.position);
  add_quaternion(hash, y.orientation);
  add_vector(hash, y.linear_momentum);
  add_vector(hash, y.angular_momentum);
}

/// What a hand that may let go sends counts while it holds something: one that only watches changes
/// no bit.
void add_frame(const WorldState& state, const detail::SessionHands& hands,
               StateHash& hash) noexcept {
  for (const BodyState& y : state.bodies) add_state(y, hash);
  for (std::size_t i = 0; i < hands.list.size(); ++i) {
    if (hands.list[i].config->may_let_go() && !hands.list[i].is_holding) continue;
    add_vector(hash, hands.commands[i].force);
    add_vector(hash, hands.commands[i].torque);
  }
}

void fail(WorldSummary& summary) noexcept {
  for (WorldHandSummary& hand : summary.hands) hand.fault = Fault::not_finite;
  summary.fault = Fault::not_finite;
}

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
      throw std::invalid_argument(device->name() + ": " + kNoPersonInLockstep);
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

bool is_stopped(const std::atomic<bool>* stop) noexcept {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

}  // namespace

std::uint64_t frames_of(const WorldSessionConfig& config) {
  if (!(config.duration > 0.0)) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(std::llround(config.duration * config.rate));
}

struct WorldRun::Impl {
  Impl(const WorldSessionConfig& config_in, std::span<HapticDevice* const> devices)
      : config(&config_in),
        frames(frames_of(config_in)),
        state(config_in.start),
        scratch(reserve_world(config_in.world)),
        hands(config_in, devices),
        joints(config_in.world.joints.size()) {
    summary.hands.resize(devices.size());
    summary.energy_start = mechanical_energy(config->world, state);
    summary.gap_min = kInfinity;
  }
  // Every way out of a session, an exception too, ends in zero force.
  ~Impl() { detail::let_go(hands); }

  void aim(const WorldAim& aim) noexcept;
  WorldFrame* make_frame(Latest<WorldAim>* aims);

  const WorldSessionConfig* config;
  const std::uint64_t frames;
  WorldSummary summary;
  WorldState state;
  WorldScratchPtr scratch;
  detail::SessionHands hands;
  std::vector<JointReading> joints;
  StateHash hash;
  WorldFrame frame;
  std::optional<WorldAim> aimed;
  std::uint32_t changes = 0;  // of the world
  bool is_over = false;
};

void WorldRun::Impl::aim(const WorldAim& aim) noexcept {
  // What was chosen among other numbers could be another body: rather nothing is taken.
  aimed = aim.world == changes ? aim : WorldAim{};
  detail::aim(*aimed, hands);
}

WorldFrame* WorldRun::Impl::make_frame(Latest<WorldAim>* aims) {
  const std::int64_t begin = thread_cpu_ns();
  const std::uint64_t i = summary.frames;
  const double dt = 1.0 / config->rate;
  is_over = is_over || i >= frames;
  if (is_over) return nullptr;
  const double now = static_cast<double>(i) * dt;
  detail::sample_hands(now, hands);
  if (aims != nullptr && aims->fetch()) aim(aims->value());
  is_over = !detail::move_hands(now, dt, state, hands, summary);
  if (is_over) return nullptr;
  frame.step = step_world(config->world, {.hands = hands.holds, .drives = config->drives}, dt,
                          state, *scratch);
  if (!is_finite(state)) {
    fail(summary);
    is_over = true;
    return nullptr;
  }
  detail::write_hands(state, hands, summary);
  const double made =
      mechanical_energy(config->world, state) - summary.energy_start - summary.port_energy;
  summary.energy_made = std::max(summary.energy_made, made);
  add_frame(state, hands, hash);
  count(frame.step, summary);
  ++summary.frames;
  for (std::size_t k = 0; k < joints.size(); ++k)
    joints[k] = read_joint(config->world, state, *scratch, static_cast<std::int32_t>(k), dt);
  frame.frame = i;
  frame.time = static_cast<double>(i + 1) * dt;
  frame.bodies = state.bodies;
  frame.is_asleep = state.is_asleep;
  frame.joints = joints;
  frame.handles = hands.handles;
  frame.commands = hands.commands;
  frame.grips = hands.grips;
  frame.aimed = std::exchange(aimed, std::nullopt);
  frame.step_cpu = 1e-9 * static_cast<double>(thread_cpu_ns() - begin);
  return &frame;
}

WorldRun::WorldRun(const WorldSessionConfig& config, std::span<HapticDevice* const> devices) {
  check_devices(config, devices);
  check_motors(config);
  impl_ = std::make_unique<Impl>(config, devices);
}

WorldRun::~WorldRun() = default;

void WorldRun::aim(const WorldAim& aim) noexcept { impl_->aim(aim); }

WorldFrame* WorldRun::make_frame(Latest<WorldAim>* aims) { return impl_->make_frame(aims); }

void WorldRun::lose(std::uint64_t frames) noexcept {
  WorldSummary& summary = impl_->summary;
  impl_->frame.lost = frames;
  summary.late_frames += frames > 0 ? 1 : 0;
  summary.lost_time += static_cast<double>(frames) / impl_->config->rate;
}

const WorldState& WorldRun::state() const noexcept { return impl_->state; }

const World& WorldRun::world() const noexcept { return impl_->config->world; }

const WorldScratch& WorldRun::scratch() const noexcept { return *impl_->scratch; }

std::uint32_t WorldRun::changes() const noexcept { return impl_->changes; }

void WorldRun::go_on(const WorldSessionConfig& next, const WorldState& state,
                     std::span<const std::int32_t> was) {
  Impl& run = *impl_;
  WorldScratchPtr scratch = reserve_world(next.world);
  std::vector<JointReading> joints(next.world.joints.size());
  WorldState carried = state;
  // What comes and goes is neither made nor lost.
  const double come =
      mechanical_energy(next.world, state) - mechanical_energy(run.config->world, run.state);
  // From here on nothing can fail.
  static_assert(std::is_nothrow_move_assignable_v<WorldState>);
  run.summary.energy_start += come;
  run.state = std::move(carried);
  run.scratch = std::move(scratch);
  run.joints = std::move(joints);
  run.config = &next;
  ++run.changes;
  detail::renumber(next, was, run.hands);
}

WorldSummary WorldRun::end() {
  detail::let_go(impl_->hands);
  impl_->is_over = true;
  WorldSummary summary = impl_->summary;
  summary.state_hash = impl_->hash.value;
  summary.energy_end = mechanical_energy(impl_->config->world, impl_->state);
  return summary;
}

WorldSummary run_world(const WorldSessionConfig& config, std::span<HapticDevice* const> devices,
                       const std::function<void(const WorldFrame&)>& sink,
                       const std::atomic<bool>* stop) {
  WorldRun run(config, devices);
  bool was_stopped = false;
  while (!was_stopped) {
    const WorldFrame* frame = run.make_frame();
    if (frame == nullptr) break;
    if (sink) sink(*frame);
    was_stopped = is_stopped(stop);
  }
  WorldSummary summary = run.end();
  summary.was_stopped = was_stopped;
  return summary;
}

}  // namespace thigma
