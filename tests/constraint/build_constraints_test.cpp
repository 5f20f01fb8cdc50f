#include "thigma/constraint/build_constraints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "support/apart.h"
#include "support/row_query.h"
#include <gtest/gtest.h>

#include "thigma/dynamics/constrained_step.h"
#include "thigma/dynamics/coupling.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

constexpr double kStep = 1e-3;

/// A hand that presses an object into a body and moves it there, contacts every so many frames and
/// in use a frame later.
struct Pressed {
  test::RowQuery rows;
  std::unique_ptr<ConstraintModel> used = std::make_unique<ConstraintModel>();
  std::unique_ptr<ConstraintModel> made = std::make_unique<ConstraintModel>();
  RigidBody body;
  Coupling coupling;
  ConstraintParams params;
  RowMemory memory;
  BodyState state;
  int every = 1;
  double wanted = 0.0;
  // of the last run
  double tangential_most = 0.0, given_out = 0.0, spent = 0.0;
  int held_back = 0;

  Pressed(const TriangleMesh& a, const TriangleMesh& b, const Vec3& start, double friction = 0.0)
      : rows(a, b, friction) {
    const double mass = 0.05, reach = rows.world.reach;
    body = make_body(mass, Mat3(0.4 * mass * reach * reach * Mat3::Identity()));
    coupling.linear_stiffness = 1000.0;
    coupling.linear_damping = 2.0;
    coupling.angular_stiffness = 0.5;
    coupling.angular_damping = 5e-4;
    params.slop = rows.world.slop;
    state.position = start;
    grasp(coupling, state, {start, Quat::Identity()});
  }

  void query(ConstraintModel& model) {
    double tolerance = 2e-4;
    while (tolerance < 2.0 * wanted * (every + 1) * kStep && tolerance < 1e-3) tolerance *= 2.0;
    rows.ask(state, tolerance, model);
  }

  void frame(const Motion& hand) {
    StepForces forces;
    forces.wrench = coupling_wrench(coupling, hand, body, state, &forces.jacobian);
    const ConstrainedStep step =
        constrained_step(at_state(body, state), forces, {*used, params, kStep}, memory);
    state = step.state;
    wanted = step.wanted_speed;
    held_back += step.is_held_back;
    tangential_most =
        std::max(tangential_most, std::hypot(step.contact.force.x(), step.contact.force.y()));
  }

  /// Returns how often the surfaces met, looked at every `look` frames.
  int run(int frames, const std::function<Pose(double)>& hand, int look) {
    const test::TriangleTree still = test::build_triangle_tree(rows.scene);
    int met = 0;
    Pose last = hand(0.0);
    Wrench felt;
    query(*used);
    for (int k = 0; k < frames; ++k) {
      if (k > 0 && (k - 1) % every == 0) *used = *made;
      if (k % every == 0) query(*made);
      const Pose now = hand(k * kStep);
      const Motion motion{
          now,
          {(now.position - last.position) / kStep,
           vector_from_rotation(now.orientation * last.orientation.conjugate()) / kStep}};
      spent -= felt.force.dot(now.position - last.position) +
               felt.torque.dot(kStep * motion.twist.angular);
      given_out = std::max(given_out, -spent);
      last = now;
      frame(motion);
      felt = coupling_reaction(coupling, motion, body, state);
      if (k % look == 0) met += test::meet(rows.object, {state.position, state.orientation}, still);
    }
    return met;
  }
};

std::function<Pose(double)> press(const Vec3& start, double depth, const Vec3& slide,
                                  const Vec3& twist) {
  return [=](double t) {
    const double in = std::clamp(t / 0.2, 0.0, 1.0), by = std::clamp((t - 0.2) / 0.5, 0.0, 1.0);
    const double swing = std::sin(2.0 * M_PI * by);
    return Pose{start - in * depth * Vec3::UnitZ() + swing * slide,
                rotation_from_vector(swing * twist)};
  };
}

TEST(BuildConstraints, PressedSlidAndTwistedNothingEnters) {
  struct Case {
    const char* name;
    TriangleMesh object, scene;
    double height;
  };
  const Case cases[] = {
      {"cube on plate", make_box({0.02, 0.02, 0.02}, {2, 2, 2}),
       make_box({0.06, 0.06, 0.01}, {4, 4, 1}), 0.0152},
      {"ball on ball", make_ball(0.01, 6), make_ball(0.02, 8), 0.0302},
      {"ring on ring", make_torus(0.012, 0.004, 24, 12), make_torus(0.014, 0.004, 24, 12), 0.0082},
  };
  for (const Case& c : cases) {
    for (const int every : {1, 10}) {
      const Vec3 start(0.0005, 0.0007, c.height);
      Pressed pressed(c.object, c.scene, start);
      pressed.every = every;
      const int met =
          pressed.run(800, press(start, 0.009, {0.006, 0.003, 0.0}, {0.1, 0.1, 0.3}), 7);
      EXPECT_EQ(met, 0) << c.name << ", contacts every " << every;
      EXPECT_LE(pressed.given_out, 1e-6) << c.name << ", contacts every " << every;
    }
  }
}

TEST(BuildConstraints, SlidesOverFlatTilesAsOverOne) {
  for (const int tiles : {1, 8, 64}) {
    const Vec3 start(-0.02, 0.0007, 0.0152);
    Pressed pressed(make_box({0.02, 0.02, 0.02}, {3, 3, 3}),
                    make_box({0.1, 0.1, 0.01}, {tiles, tiles, 1}), start);
    const auto hand = [&](double t) {
      const double in = std::clamp(t / 0.1, 0.0, 1.0), by = std::clamp((t - 0.1) / 0.4, 0.0, 1.0);
      return Pose{start + Vec3(0.04 * by, 0.0, -0.004 * in), Quat::Identity()};
    };
    EXPECT_EQ(pressed.run(500, hand, 50), 0) << tiles;
    EXPECT_LE(pressed.tangential_most, 0.01 * 3.8) << tiles;  // of the normal force [N]
    EXPECT_NEAR(pressed.state.position.x(), 0.02, 2e-4) << tiles;
  }
}

TEST(BuildConstraints, InTheAirNothingIsHeldBack) {
  const Vec3 start(0.0, 0.0, 0.08);
  Pressed pressed(make_ball(0.01, 6), make_ball(0.02, 8), start);
  const auto hand = [&](double t) {  // 0.5 m/s, to 2 mm from touching and back
    return Pose{start - (0.024 + 0.024 * std::cos(20.8 * t)) * Vec3::UnitZ(), Quat::Identity()};
  };
  EXPECT_EQ(pressed.run(600, hand, 60), 0);
  EXPECT_LE(pressed.held_back, 6);
}

TEST(BuildConstraints, AThinPlateIsNotPassed) {
  const TriangleMesh plate = make_box({0.06, 0.06, 1e-4}, {3, 3, 1});
  for (const double speed : {0.2, 1.0, 5.0}) {
    for (const int every : {1, 10, 33}) {
      const Vec3 start(0.0003, 0.0004, 0.03);
      Pressed pressed(make_box({0.01, 0.012, 0.014}), plate, start);
      pressed.every = every;
      pressed.state.orientation = rotation_from_vector({0.3, 0.5, 0.2});
      grasp(pressed.coupling, pressed.state, {start, Quat::Identity()});
      const auto hand = [&](double t) {
        return Pose{start - std::min(speed * t, 0.06) * Vec3::UnitZ(),
                    rotation_from_vector({0.0, 5.0 * std::min(t, 0.1), 0.0})};
      };
      EXPECT_EQ(pressed.run(600, hand, 20), 0) << speed << " m/s, every " << every;
      EXPECT_GT(pressed.state.position.z(), 0.0) << speed << " m/s, every " << every;
    }
  }
}

TEST(BuildConstraints, SameStateSameModel) {
  const Vec3 start(0.0005, 0.0007, 0.0301);
  Pressed a(make_ball(0.01, 6), make_ball(0.02, 8), start);
  Pressed b(make_ball(0.01, 6), make_ball(0.02, 8), start);
  a.rows.ask(a.state, 1e-3, *a.used);
  BodyState away = b.state;
  away.position.x() += 0.004;
  b.rows.ask(away, 5e-4, *b.used);
  b.rows.ask(b.state, 1e-3, *b.used);
  ASSERT_EQ(a.used->rows.size(), b.used->rows.size());
  EXPECT_EQ(a.used->travel, b.used->travel);
  for (std::size_t i = 0; i < a.used->rows.size(); ++i) {
    EXPECT_EQ(a.used->rows[i].id, b.used->rows[i].id);
    EXPECT_EQ(a.used->rows[i].scene_point, b.used->rows[i].scene_point);
  }
}

}  // namespace
}  // namespace thigma
