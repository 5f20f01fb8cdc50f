#include "experiments/common/coupled_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "experiments/common/statistics.h"

#include "thigma/contact/query_contacts.h"
#include "thigma/device/open_device.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace {

constexpr double kGone = 1.0;  // [m]

/// What acts on the body in a frame.
struct Forces {
  const CoupledSetup& setup;
  const Motion& handle;
  const LinearContactModel* model;  // null: none yet, or forces are held
  const Wrench& held;

  Wrench operator()(const BodyState& state, WrenchJacobian* jacobian) const {
    Wrench sum = coupling_wrench(setup.coupling, handle, setup.body, state, jacobian);
    sum = sum + held;
    if (model == nullptr) return sum;
    WrenchJacobian by_contact;
    sum = sum + contact_wrench(*model, setup.body, state, 1.0, jacobian ? &by_contact : nullptr);
    if (jacobian) *jacobian += by_contact;
    return sum;
  }
};

/// The contact thread on a virtual clock.
struct Contacts {
  const CoupledSetup& setup;
  bool is_empty;
  ContactScratch scratch{};
  ContactSample sample{}, next{};
  Wrench held{};
  RowMemory rows{};           // of the constrained response
  double wanted_speed = 0.0;  // as StampedBody has it [m/s]

  explicit Contacts(const CoupledSetup& s)
      : setup(s), is_empty(s.contact.scene.empty() && !s.contact.source) {
    if (!is_empty) reserve_contact_scratch(s.contact, scratch);
  }
  void frame(std::size_t k, const BodyState& state) {
    if (is_empty) return;
    const auto every = static_cast<std::size_t>(setup.contact_every);
    if (k % every == 1 % every) {
      sample = next;
      if (!setup.is_linearized) held = contact_wrench(sample.model, setup.body, sample.model.state);
    }
    if (k % every == 0) {
      contact_step(setup.contact, {state, static_cast<double>(k) * setup.period, k, wanted_speed},
                   scratch, next);
      if (every == 1 && k == 0) sample = next;
    }
  }
  bool is_constrained() const { return setup.contact.constraints != nullptr; }
  /// A step of the constrained response; returns the wrench of the rows.
  Wrench advance(const Motion& handle, BodyState& state) {
    const BodyAtState at = at_state(setup.body, state);
    StepForces forces;
    forces.wrench = coupling_wrench(setup.coupling, handle, at, &forces.jacobian);
    const ConstrainedStep step = constrained_step(
        at, forces, {sample.model.constraints, setup.constraint, setup.period}, rows);
    state = step.state;
    wanted_speed = step.wanted_speed;
    return step.contact;
  }
  const LinearContactModel* model() const {
    return !is_empty && setup.is_linearized && sample.model.sequence > 0 ? &sample.model : nullptr;
  }
};

double mean_level(const ContactSample& sample) {
  double sum = 0.0, count = 0.0;
  for (std::size_t level = 0; level < sample.object_levels.size(); ++level) {
    const double n = sample.object_levels[level] + sample.scene_levels[level];
    sum += static_cast<double>(level) * n;
    count += n;
  }
  return count > 0.0 ? sum / count : 0.0;
}

bool is_here(const BodyState& y, const Pose& handle) {
  const double distance = (y.position - handle.position).norm();
  return distance < kGone && y.orientation.coeffs().allFinite() && y.linear_momentum.allFinite() &&
         y.angular_momentum.allFinite();
}

std::vector<double> norms(std::span<const CoupledFrame> frames, Wrench CoupledFrame::*which) {
  std::vector<double> sizes;
  for (const CoupledFrame& f : frames) sizes.push_back((f.*which).force.norm());
  return sizes;
}

}  // namespace

std::vector<CoupledFrame> run_coupled(const CoupledSetup& setup, std::span<const Motion> handle) {
  std::vector<CoupledFrame> frames;
  frames.reserve(handle.size());
  Contacts contacts(setup);
  BodyState state = setup.start;
  for (std::size_t k = 0; k < handle.size(); ++k) {
    contacts.frame(k, state);
    const Forces forces{setup, handle[k], contacts.model(), contacts.held};
    Wrench of_rows;
    if (contacts.is_constrained())
      of_rows = contacts.advance(handle[k], state);
    else
      state = step_body(setup.integrator, setup.body, state, forces, setup.period);
    if (!is_here(state, handle[k].pose)) break;
    CoupledFrame frame;
    frame.body = state;
    frame.coupling = coupling_wrench(setup.coupling, handle[k], setup.body, state);
    frame.contact = contacts.is_constrained() ? of_rows
                    : contacts.model() != nullptr
                        ? contact_wrench(*contacts.model(), setup.body, state)
                        : contacts.held;
    const CouplingStretch stretch = coupling_stretch(setup.coupling, handle[k].pose, state);
    frame.stretch = stretch.linear.norm();
    frame.turn = stretch.angular.norm();
    frame.contacts = contacts.sample.contacts;
    frame.level = mean_level(contacts.sample);
    frames.push_back(frame);
  }
  return frames;
}

LedMotion lead(const SessionPair& session, const std::string& uri, double before, double seconds) {
  const std::unique_ptr<HapticDevice> hand = open_device(uri, session.hand);
  SessionConfig config = session.config;
  config.haptic.device = hand->limits();
  std::vector<HapticSample> samples;
  run_lockstep(
      config, *hand,
      {.haptic = [&](const HapticSample& s) { samples.push_back(s); }, .contact = {}, .event = {}});
  const auto held = std::find_if(samples.begin(), samples.end(),
                                 [](const HapticSample& s) { return s.is_grasped; });
  const auto touch = std::find_if(samples.begin(), samples.end(),
                                  [](const HapticSample& s) { return s.touching > 0; });
  if (held == samples.end() || touch == samples.end())
    throw std::runtime_error(session.name + ": the hand touches nothing");
  LedMotion led;
  const auto ahead = static_cast<std::ptrdiff_t>(std::lround(before * config.rate));
  const auto first = std::max(held + 1, touch - std::min(ahead, touch - samples.begin()));
  led.body_from_grasp = inverse(config.world_from_body) * held->handle.pose;
  led.start = (first - 1)->body;
  led.first_touch = static_cast<double>(touch - first) / config.rate;
  const auto frames = static_cast<std::ptrdiff_t>(std::lround(seconds * config.rate));
  for (auto it = first; it != samples.end() && it - first < frames; ++it)
    led.handle.push_back(it->handle);
  return led;
}

CoupledSetup setup_of(const SessionPair& session, const LedMotion& motion) {
  CoupledSetup setup;
  setup.body = session.config.haptic.body;
  setup.coupling = session.config.haptic.coupling;
  setup.coupling.body_from_grasp = motion.body_from_grasp;
  setup.coupling.is_grasped = true;
  setup.start = motion.start;
  setup.period = 1.0 / session.config.rate;
  setup.contact = session.config.contact;
  return setup;
}

double ripple(std::span<const double> values, std::size_t from, std::size_t to, double period) {
  to = std::min(to, values.size());
  if (to < from + 50) return std::numeric_limits<double>::infinity();  // gone before
  const std::span<const double> window = values.subspan(from, to - from);
  std::vector<double> slow = low_pass(window, period, 20.0);
  for (std::size_t i = 0; i < slow.size(); ++i) slow[i] = window[i] - slow[i];
  return root_mean_square(slow);
}

std::vector<Motion> motion_along(std::span<const Pose> poses, double period) {
  std::vector<Motion> motion(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose& before = poses[i > 0 ? i - 1 : 0];
    const Pose& after = poses[std::min(i + 1, poses.size() - 1)];
    const double time = period * ((i > 0 ? 1.0 : 0.0) + (i + 1 < poses.size() ? 1.0 : 0.0));
    motion[i].pose = poses[i];
    if (!(time > 0.0)) continue;
    motion[i].twist.linear = (after.position - before.position) / time;
    motion[i].twist.angular =
        vector_from_rotation(after.orientation * before.orientation.conjugate()) / time;
  }
  return motion;
}

std::vector<double> exact_depths(const ContactWorld& world, std::span<const CoupledFrame> frames,
                                 int stride, double tolerance) {
  std::vector<ContactFront> fronts(world.scene.size());
  for (std::size_t i = 0; i < fronts.size(); ++i)
    reserve_front(fronts[i], *world.object, *world.scene[i].hierarchy);
  ContactSet set;
  set.contacts.reserve(400'000);
  ContactQuery query;
  query.tolerance = tolerance;
  query.keep_directions = true;
  std::vector<double> depths;
  for (std::size_t k = 0; k < frames.size(); k += static_cast<std::size_t>(stride)) {
    clear(set);
    const Pose pose =
        Pose{frames[k].body.position, frames[k].body.orientation} * world.body_from_mesh;
    query_scene({*world.object, pose}, world.scene, query, fronts, set);
    depths.push_back(set.contacts.empty() ? 0.0 : std::max(0.0, -least_distance(set)));
  }
  return depths;
}

std::vector<double> coupling_force(std::span<const CoupledFrame> frames) {
  return norms(frames, &CoupledFrame::coupling);
}

std::vector<double> contact_force(std::span<const CoupledFrame> frames) {
  return norms(frames, &CoupledFrame::contact);
}

void point_on_floor(const Pose& at, double tolerance, ContactSet& set) {
  if (at.position.z() > tolerance) return;
  Contact c;
  c.point = at.position;
  c.scene_point = {at.position.x(), at.position.y(), 0.0};
  c.normal = -Vec3::UnitZ();
  c.depth = -at.position.z();
  c.object_patch = c.scene_patch = 0;
  set.contacts.push_back(c);
}

}  // namespace thigma::experiments
