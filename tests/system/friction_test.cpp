// Friction through query, model and step: a block on a slope, a block pushed by the hand, teeth
// that stick and slip.

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/plane_session.h"
#include "support/row_query.h"
#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/dynamics/bristle.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/dynamics/coupling.h"
#include "thigma/loop/contact_step.h"
#include "thigma/mesh/shapes.h"
#include "thigma/scene/load_scene.h"

namespace thigma {
namespace {

constexpr double kStep = 1e-3, kGravity = 9.81;

Vec3 tilted(double angle) { return {kGravity * std::sin(angle), 0.0, -kGravity * std::cos(angle)}; }

/// A block of 50 g by constraints on a plate cut into tiles, contacts queried at every frame.
struct OnPlate {
  test::RowQuery rows;
  RigidBody body;
  BodyState state;
  RowMemory memory;
  ConstraintParams params;

  OnPlate(const Friction& friction, const Vec3& gravity)
      : rows(make_box({0.02, 0.02, 0.02}, {2, 2, 2}), make_box({0.3, 0.06, 0.01}, {30, 6, 1})) {
    rows.friction = friction;
    body = make_body(0.05, Mat3(0.05 * 4e-4 / 6.0 * Mat3::Identity()), gravity);
    params.slop = 5e-5 * rows.world.reach;
    state.position = {-0.1, 0.0007, 0.015 + params.slop};
  }

  ConstrainedStep step(const StepForces& forces = {}) {
    rows.ask(state, 5e-4);
    const ConstrainedStep result =
        constrained_step(at_state(body, state), forces, {*rows.model, params, kStep}, memory);
    state = result.state;
    return result;
  }
};

TEST(Friction, ByConstraintsABlockOnASlopeSticksOrSlidesAsCoulombSays) {
  const double mu = 0.5;
  OnPlate below({mu, mu}, tilted(0.97 * std::atan(mu)));
  const Vec3 start = below.state.position;
  for (int k = 0; k < 10000; ++k) below.step();
  EXPECT_LE((below.state.position - start).norm(), 1e-6);

  const double angle = 1.2 * std::atan(mu);
  OnPlate above({mu, mu}, tilted(angle));
  for (int k = 0; k < 300; ++k) above.step();
  const double expected = 0.3 * kGravity * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_NEAR(above.state.linear_momentum.x() / 0.05, expected, 1e-3 * expected);
}

TEST(Friction, ByConstraintsABlockPushedByTheHandBreaksAwayAtItsStaticForce) {
  for (const Friction& friction : {Friction{0.4, 0.4}, Friction{0.3, 0.6}}) {
    OnPlate block(friction, Vec3::Zero());
    Coupling coupling;
    coupling.linear_stiffness = 1000.0;
    coupling.linear_damping = 5.0;
    coupling.angular_stiffness = 0.5;
    coupling.angular_damping = 5e-4;
    const Vec3 start = block.state.position;
    grasp(coupling, block.state, {start, Quat::Identity()});
    double most = 0.0, slid = 0.0, crept = 0.0;
    for (int k = 0; k < 3000 && slid < 1e-3; ++k) {
      Motion hand{{start, Quat::Identity()}, {}};
      hand.pose.position.z() -= 0.003;
      hand.pose.position.x() += 0.002 * k * kStep;  // 2 mm/s
      StepForces forces;
      forces.wrench = coupling_wrench(coupling, hand, block.body, block.state, &forces.jacobian);
      const ConstrainedStep step = block.step(forces);
      slid = block.state.position.x() - start.x();
      most = std::max(most, -step.contact.force.x() / step.contact.force.z());
      if (most < 0.95 * friction.at_rest) crept = slid;
    }
    EXPECT_NEAR(most, friction.at_rest, 0.02 * friction.at_rest);
    EXPECT_LE(std::fabs(crept), 1e-7);
    EXPECT_GE(slid, 1e-3);
  }
}

/// The cube of plane_session by itself under a tilted gravity, its corners clustered anew at every
/// frame.
struct OnPlane {
  SessionConfig config = test::plane_session(0.0);
  ContactScratch scratch;
  std::unique_ptr<ContactSample> sample = std::make_unique<ContactSample>();
  BristleMemory memory;
  BodyState state;
  int frame = 0;

  OnPlane(const Friction& friction, const Vec3& gravity) {
    config.contact.friction = {friction};
    config.haptic.body.gravity = gravity;
    state.position = config.world_from_body.position;
    reserve_contact_scratch(config.contact, scratch);
  }
  void step(double pull = 0.0) {
    contact_step(config.contact, {state, ++frame * kStep}, scratch, *sample);
    const BodyAtState at = at_state(config.haptic.body, state);
    StepForces forces;
    forces.wrench = contact_wrench(sample->model, at, 1.0, &forces.jacobian);
    forces.wrench.force.x() += pull;
    state = bristle_step(at, forces, {sample->model, 1.0, kStep}, memory);
  }
};

TEST(Friction, ByPenaltyABlockOnASlopeCreepsLessThanAMicrometreOrSlides) {
  const double mu = 0.5;
  OnPlane below({mu, mu}, tilted(0.9 * std::atan(mu)));
  for (int k = 0; k < 1000; ++k) below.step();
  const Vec3 settled = below.state.position;
  for (int k = 0; k < 10000; ++k) below.step();
  EXPECT_LE((below.state.position - settled).norm(), 1e-6);

  const double angle = 1.3 * std::atan(mu);
  OnPlane above({mu, mu}, tilted(angle));
  for (int k = 0; k < 500; ++k) above.step();
  const double before = above.state.linear_momentum.x();
  for (int k = 0; k < 500; ++k) above.step();
  const double expected = 0.5 * kGravity * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_NEAR((above.state.linear_momentum.x() - before) / 0.01, expected, 0.01 * expected);
}

TEST(Friction, ByPenaltyABlockBreaksAwayAtItsStaticForce) {
  const Friction friction{0.3, 0.5};
  OnPlane block(friction, tilted(0.0));
  for (int k = 0; k < 1000; ++k) block.step();
  const Vec3 start = block.state.position;
  const double weight = 0.01 * kGravity;
  double pull = 0.0;
  while (pull < weight && block.state.position.x() - start.x() < 5e-4) block.step(pull += 1e-5);
  EXPECT_NEAR(pull, friction.at_rest * weight, 0.02 * friction.at_rest * weight);
}

TEST(Friction, ByPenaltyAndDirectContactsStayInTheirConeAndReachIt) {
  for (const ResponseKind response : {ResponseKind::coupled, ResponseKind::direct}) {
    SessionConfig config = test::plane_session();
    config.haptic.response = response;
    config.contact.friction = {{0.3, 0.3}};
    config.duration = 3.0;
    HandDevice hand(test::plane_hand(HandPath::slide));
    double most = 0.0;
    const SessionSinks sinks{[&](const HapticSample& s) {
                               const Vec3& f = s.contact.force;
                               const double along = std::hypot(f.x(), f.y());
                               EXPECT_LE(along, 0.3 * f.z() * (1.0 + 1e-9));
                               if (f.z() > 0.0) most = std::max(most, along / f.z());
                             },
                             {},
                             {}};
    run_lockstep(config, hand, sinks);
    EXPECT_NEAR(most, 0.3, 0.003);
  }
}

SessionSummary rub_jaws(ResponseKind response, const Friction& friction) {
  SceneDescription description = test::small_jaws();
  description.contact.response = response;
  description.contact.friction = friction;
  const Scene scene = load_scene(std::move(description));
  // Without encoders, which leak energy of their own.
  SceneSession session = open_session(
      scene, {.device = "hand:?encoder=0&angular_encoder=0&path=slide", .duration = 2.0});
  return run_lockstep(session);
}

TEST(Friction, TeethThatStickAndSlipGiveNoEnergy) {
  for (const ResponseKind response : {ResponseKind::constrained, ResponseKind::coupled}) {
    const SessionSummary felt = rub_jaws(response, {0.3, 0.6});
    EXPECT_EQ(felt.end, SessionEnd::duration);
    EXPECT_GE(felt.energy_min, -1e-6);
    EXPECT_GT(felt.force_max, 0.3);
  }
}

}  // namespace
}  // namespace thigma
