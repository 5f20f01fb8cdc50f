#include "experiments/common/led_session.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "experiments/common/assets.h"
#include "experiments/common/replay.h"

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/measure.h"
#include "thigma/session/session_config.h"

namespace thigma::experiments {
namespace {

constexpr double kNoLimit = 1e9;

class LedHand : public HapticDevice {
 public:
  LedHand(const HandPath& path, double period) : path_(path), period_(period) {
    limits_.max_force = limits_.max_torque = kNoLimit;
    limits_.workspace_radius = 10.0;
    limits_.holds_person = false;
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "led"; }
  DeviceState read(double now) THIGMA_RT override {
    const Pose before = path_(std::max(now - period_, 0.0)), here = path_(now);
    DeviceState state;
    state.time = now;
    state.motion.pose = here;
    state.motion.twist.linear = (here.position - before.position) / period_;
    state.motion.twist.angular =
        vector_from_rotation(here.orientation * before.orientation.conjugate()) / period_;
    state.buttons = kClutchButton;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  const HandPath& path_;
  double period_;
  DeviceLimits limits_;
};

bool is_same(const BodyState& a, const BodyState& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs() &&
         a.linear_momentum == b.linear_momentum && a.angular_momentum == b.angular_momentum;
}

/// Computes the session's constrained steps again.
class Shadow {
 public:
  static constexpr std::size_t kModels = 64;  // late ones are used long after they are made

  explicit Shadow(const SessionConfig& config) : config_(config) {
    body_.position = config.world_from_body.position;
    body_.orientation = config.world_from_body.orientation;
    coupling_ = config.haptic.coupling;
  }
  void add(const LinearContactModel& model) {
    models_.push_back(model);
    if (models_.size() > kModels) models_.pop_front();
  }
  LedStep step(const HapticSample& sample) {
    LedStep step;
    const auto model = std::find_if(
        models_.begin(), models_.end(),
        [&](const LinearContactModel& m) { return m.sequence == sample.model_sequence; });
    if (sample.is_grasped && model != models_.end() &&
        config_.haptic.response == ResponseKind::constrained)
      repeat(sample, model->constraints, step);
    body_ = sample.body;
    return step;
  }

 private:
  void repeat(const HapticSample& sample, const ConstraintModel& model, LedStep& step) {
    if (!is_held_) grasp(coupling_, body_, sample.handle.pose);
    is_held_ = true;
    const double from = thread_cpu_seconds();
    const BodyAtState at = at_state(config_.haptic.body, body_);
    StepForces forces;
    forces.wrench = coupling_wrench(faded(coupling_, sample.device.weight), sample.handle, at,
                                    &forces.jacobian);
    const ConstrainedStep done =
        constrained_step(at, forces, {model, config_.haptic.constraint, sample.elapsed}, memory_);
    step.cpu = thread_cpu_seconds() - from;
    step.is_known = true;
    step.is_held_back = done.is_held_back;
    step.rows = static_cast<int>(model.rows.size());
    step.active = done.solution.active;
    for (const RowMemory::Entry& entry : memory_.entries) {
      if (!entry.is_active) continue;
      step.active_set += (entry.id + 1) * 0x9e3779b97f4a7c15ull;
      for (const ContactRow& row : model.rows)
        step.active_edges += row.id == entry.id && row.kind == RowKind::edges;
    }
    step.travel = model.travel;
    step.is_same = is_same(done.state, sample.body);
  }

  const SessionConfig& config_;
  BodyState body_;
  Coupling coupling_;
  bool is_held_ = false;
  RowMemory memory_;
  std::deque<LinearContactModel> models_;
};

double farthest(const TriangleMesh& mesh) {
  double most = 0.0;
  for (const Vec3& p : mesh.positions) most = std::max(most, p.norm());
  return most;
}

}  // namespace

LedPair make_led_pair(std::string name, TriangleMesh object, TriangleMesh scene, Pose start) {
  const Vec3 center = mass_properties(object).center_of_mass;
  for (Vec3& p : object.positions) p -= center;
  start.position += start.orientation * center;
  LedPair pair{.name = std::move(name), .object = std::move(object), .scene = std::move(scene)};
  pair.start = start;
  pair.object_levels = std::make_shared<ClodHierarchy>(build_exact_hierarchy(pair.object));
  pair.scene_levels = std::make_shared<ClodHierarchy>(build_exact_hierarchy(pair.scene));
  pair.reach = farthest(pair.object);
  pair.tolerance = 0.01 * pair.reach;
  return pair;
}

LedPair placed_apart(LedPair pair, const Vec3& towards, double clearance) {
  Pair placed;
  placed.object = pair.object_levels.get();
  placed.scene = pair.scene_levels.get();
  placed.radius = std::min(placed.object->radius, placed.scene->radius);
  placed.start = pair.start;
  place_apart(placed, towards);
  pair.start = placed.start;
  pair.start.position += (placed.clearance - clearance) * placed.approach;
  pair.clearance = clearance;
  return pair;
}

LedPair with_levels(LedPair pair) {
  ClodParams params;
  params.threads = 2;
  pair.object_levels = std::make_shared<ClodHierarchy>(build_clod(pair.object, params));
  pair.scene_levels = std::make_shared<ClodHierarchy>(build_clod(pair.scene, params));
  return pair;
}

SessionConfig led_config(const LedPair& pair, const LedGains& gains, double seconds) {
  SessionConfig config;
  const double moment = 0.4 * pair.mass * pair.reach * pair.reach;
  HapticParams& haptic = config.haptic;
  haptic.body = make_body(pair.mass, Mat3(moment * Mat3::Identity()));
  haptic.coupling.linear_stiffness = gains.stiffness;
  haptic.coupling.linear_damping = gains.damping;
  haptic.coupling.angular_stiffness = gains.angular_stiffness;
  haptic.coupling.angular_damping = gains.angular_damping > 0.0
                                        ? gains.angular_damping
                                        : 1.4 * std::sqrt(gains.angular_stiffness * moment);
  haptic.grasp_place = GraspPlace::handle;
  SafetyLimits& safety = haptic.safety;
  safety.force_slew = safety.torque_slew = kNoLimit;
  safety.start_ramp = safety.clear_before_arming = 0.0;
  safety.max_speed = safety.pose_jump = safety.max_turn_speed = safety.orientation_jump = kNoLimit;
  config.contact.object = pair.object_levels.get();
  config.contact.scene = {SceneBody{pair.scene_levels.get(), Pose{}}};
  config.contact.tolerance = pair.tolerance;
  config.contact.response = {.stiffness = gains.contact_stiffness,
                             .damping = 1.4 * std::sqrt(gains.contact_stiffness * pair.mass)};
  config.world_from_body = pair.start;
  config.duration = seconds;
  config.contact_every = gains.every;
  config.contact_latency = gains.latency;
  config.contact.potential_law.area = 0.0625 * pair.reach * pair.reach;
  if (gains.is_potential) {
    use_potential(config);
  } else if (gains.is_constrained) {
    config.contact.friction.assign(1, {gains.friction, gains.friction});
    config.contact.resolution.is_exact = !(gains.threshold > 0.0);
    config.contact.resolution.metric.haptic = gains.threshold;
    use_constraints(config);
  }
  return config;
}

LedRun run_led(const SessionConfig& config, const HandPath& hand, const LedLook& look) {
  LedHand device(hand, 1.0 / config.rate);
  Shadow shadow(config);
  LedRun run;
  const auto frame = [&](const HapticSample& sample) {
    const LedStep step = shadow.step(sample);
    ++run.frames;
    run.held_back += step.is_held_back;
    run.unlike += step.is_known && !step.is_same;
    if (step.is_known) run.solve.push_back(step.cpu);
    run.energy_end = sample.energy;
    run.energy_min = std::min(run.energy_min, sample.energy);
    if (look) look(sample, step);
  };
  const auto contact = [&](const ContactSample& sample) {
    shadow.add(sample.model);
    run.query.push_back(sample.step_cpu);
    run.rows.push_back(static_cast<double>(sample.model.constraints.rows.size()));
    run.travel.push_back(sample.model.constraints.travel);
    run.coarse.push_back(static_cast<double>(sample.coarse));
  };
  run.summary = run_lockstep(config, device, {.haptic = frame, .contact = contact, .event = {}});
  return run;
}

}  // namespace thigma::experiments
