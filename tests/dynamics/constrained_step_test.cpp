#include "thigma/dynamics/constrained_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "thigma/dynamics/coupling.h"
#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr double kStep = 1e-3;

/// A body of 50 g on a coupling, over the plane z = 0, held at its corner.
struct Held {
  RigidBody body = make_body(0.05, Mat3(1e-5 * Mat3::Identity()));
  Coupling coupling;
  BodyState state;
  ConstraintParams params{1e-6, 0.2, 2e-3};
  std::unique_ptr<ConstraintModel> model = std::make_unique<ConstraintModel>();
  RowMemory memory;

  Held() {
    coupling.linear_stiffness = 1000.0;
    coupling.linear_damping = 5.0;
    coupling.angular_stiffness = 0.5;
    coupling.angular_damping = 2e-3;
    state.position = {0.0, 0.0, 0.02};
    grasp(coupling, state, {state.position, Quat::Identity()});
    model->travel = std::numeric_limits<double>::infinity();
    model->reach = 0.02;
    model->state = state;
  }

  void add_corner(const Vec3& arm, double friction = 0.0) {
    ContactRow row = make_row(RowKind::scene_plane);
    row.id = 100 + model->rows.size();
    row.friction = {friction, friction};
    row.object_point = arm;
    row.scene_direction = -Vec3::UnitZ();
    model->rows.push_back(row);
  }

  StepForces pull(const Vec3& hand, const Quat& turn = Quat::Identity()) const {
    StepForces forces;
    const Motion motion{{hand, turn}, {}};
    forces.wrench = coupling_wrench(coupling, motion, body, state, &forces.jacobian);
    return forces;
  }

  ConstrainedStep step(const Vec3& hand, const Quat& turn = Quat::Identity()) {
    const ConstrainedStep result =
        constrained_step(at_state(body, state), pull(hand, turn), {*model, params, kStep}, memory);
    state = result.state;
    return result;
  }
};

double least_gap(const ConstraintModel& model, const BodyState& state) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContactRow& row : model.rows)
    least = std::min(least, row_at(row, state.position, rotation_matrix(state.orientation)).gap);
  return least;
}

TEST(ConstrainedStep, IsTheImplicitStepWhereNothingPresses) {
  Held held;
  const StepForces forces = held.pull({0.001, 0.0, 0.021});
  const BodyState expected =
      implicit_step(held.body, held.state, forces.wrench, forces.jacobian, kStep);
  held.step({0.001, 0.0, 0.021});
  EXPECT_EQ(to_vector(held.state), to_vector(expected));
}

TEST(ConstrainedStep, StaysOutAndHandsTheCouplingToTheHand) {
  Held held;
  for (const double x : {-0.01, 0.01})
    for (const double y : {-0.01, 0.01}) held.add_corner({x, y, -0.01});
  ConstrainedStep last;
  double deepest = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const double turn = k < 500 ? 0.2 : 0.0;  // rocked on an edge, then put down
    last = held.step({0.0, 0.0, 0.006}, rotation_from_vector({turn, 0.5 * turn, 0.0}));
    deepest = std::min(deepest, last.least_gap);
  }
  EXPECT_GE(deepest, 0.0);
  EXPECT_NEAR(held.state.position.z(), 0.01 + held.params.slop, 1e-9);
  EXPECT_NEAR(last.contact.force.z(), 1000.0 * (0.01 + held.params.slop - 0.006), 1e-6);
  EXPECT_LE(held.state.linear_momentum.norm(), 1e-9);
}

TEST(ConstrainedStep, TheRowsThatPressAddUpToTheContact) {
  for (const double friction : {0.0, 0.4}) {
    Held held;
    for (const double x : {-0.01, 0.01})
      for (const double y : {-0.01, 0.01}) held.add_corner({x, y, -0.01}, friction);
    int most = 0, slid = 0;
    for (int k = 0; k < 600; ++k) {
      const Vec3 hand(1e-5 * k, 0.0, 0.007);
      const ConstrainedStep step = held.step(hand, rotation_from_vector({0.1, 0.0, 0.02}));
      EXPECT_FALSE(step.is_squeezed);
      EXPECT_EQ(step.pressing.empty(), step.solution.active == 0);
      Vec3 sum = Vec3::Zero();
      double last = std::numeric_limits<double>::infinity();
      for (const PressingRow& row : step.pressing) {
        EXPECT_GE(row.id, 100u);
        EXPECT_LE(row.id, 103u);
        EXPECT_LE(row.force.norm(), last);  // the strongest first
        last = row.force.norm();
        const double across = row.force.head<2>().norm();
        EXPECT_GT(row.force.z(), 0.0);  // it pushes the object off
        EXPECT_LE(across, friction * row.force.z() * (1.0 + 1e-6) + 1e-9);
        if (across > 1e-3) ++slid;
        sum += row.force;
      }
      most = std::max(most, static_cast<int>(step.pressing.size()));
      const double size = std::max(step.contact.force.norm(), 1e-3);
      EXPECT_LE((sum - step.contact.force).norm(), (friction > 0.0 ? 1e-3 : 1e-9) * size) << k;
    }
    EXPECT_GE(most, 2);
    EXPECT_EQ(slid > 0, friction > 0.0);
  }
}

TEST(ConstrainedStep, OfManyRowsThatPressTheStrongestAreTold) {
  Held held;
  constexpr int kMany = 40;
  for (int i = 0; i < kMany; ++i) {
    const double angle = 2.0 * 3.141592653589793 * i / kMany;
    held.add_corner({0.01 * std::cos(angle), 0.01 * std::sin(angle), -0.01}, 0.3);
  }
  for (int i = 0; i < kMany; ++i)  // all pressed in the step before
    held.memory.entries.push_back({100 + static_cast<std::uint64_t>(i), 1e-4, {0.0, 0.0}, false});
  held.state.position.z() = 0.01 + held.params.slop;
  const ConstrainedStep step = held.step({0.0, 0.0, 0.005});
  EXPECT_GT(held.memory.entries.size(), static_cast<std::size_t>(kMaxPressing));
  ASSERT_EQ(step.pressing.size(), static_cast<std::size_t>(kMaxPressing));
  double least = std::numeric_limits<double>::infinity();
  for (const PressingRow& row : step.pressing) least = std::min(least, row.force.norm());
  int stronger = 0;
  for (const RowMemory::Entry& entry : held.memory.entries)
    stronger += entry.normal / kStep > least * (1.0 + 1e-9) ? 1 : 0;
  EXPECT_LE(stronger, kMaxPressing);
  for (std::size_t i = 1; i < step.pressing.size(); ++i)
    EXPECT_LE(step.pressing[i].force.norm(), step.pressing[i - 1].force.norm());
}

TEST(ConstrainedStep, WaitsAtTheEndOfItsTravel) {
  Held held;
  held.model->travel = 1e-3;
  ConstrainedStep last;
  for (int k = 0; k < 200; ++k) {
    last = held.step({0.05, 0.0, 0.02});
    EXPECT_LE(travel_between(held.model->state, held.state, held.model->reach), 1e-3);
  }
  EXPECT_TRUE(last.is_held_back);
  EXPECT_GT(last.wanted_speed, 0.0);  // what a query should look ahead for
}

TEST(ConstrainedStep, GoesToTheEndOfATravelThatIsLittleOfWhatIsWanted) {
  Held held;
  held.model->travel = 1e-8;
  const ConstrainedStep first = held.step({5.0, 0.0, 0.02});
  EXPECT_GT(first.wanted_speed * kStep, 1e4 * held.model->travel);
  const double way = travel_between(held.model->state, held.state, held.model->reach);
  EXPECT_LE(way, 1e-8);
  EXPECT_GE(way, 0.3e-8);
}

TEST(ConstrainedStep, WaitsWhereAModelCameTooLate) {
  Held held;
  held.add_corner({0.0, 0.0, -0.02 - 1e-4});  // by a row that means nothing out here
  held.model->travel = 1e-3;
  held.model->state.position.x() = 0.01;
  const Vec3 before = held.state.position;
  const ConstrainedStep late = held.step({0.005, 0.0, 0.0});
  EXPECT_TRUE(late.is_held_back);
  EXPECT_EQ(held.state.position, before);
  EXPECT_TRUE(std::isinf(late.least_gap));
}

TEST(ConstrainedStep, LeavesAGapThatClosedByItself) {
  Held held;
  held.add_corner({0.0, 0.0, -0.02 - 1e-5});  // 10 um in
  ConstrainedStep first = held.step({0.0, 0.0, 0.0});
  EXPECT_NEAR(first.least_gap, -1e-5, 1e-12);
  for (int k = 0; k < 100; ++k) first = held.step({0.0, 0.0, 0.0});
  EXPECT_NEAR(first.least_gap, held.params.slop, 1e-7);
}

/// Turns about y over a corner that every turn lowers, to second order.
struct Turning : Held {
  Turning(const Vec3& arm, double gap, double speed) {
    add_corner(arm);
    state.position.z() = gap - arm.z();
    state.angular_momentum = {0.0, 1e-5 * speed, 0.0};
  }
  ConstrainedStep step() {
    const ConstrainedStep result =
        constrained_step(at_state(body, state), StepForces{}, {*model, params, kStep}, memory);
    state = result.state;
    return result;
  }
};

TEST(ConstrainedStep, TurningTakesNothingOfAGapThatIsLessThanWhatIsKept) {
  const double speed = 30.0, angle = speed * kStep;
  for (const double share : {0.2, 0.9, 1.0}) {
    Turning body({0.0, 0.0, 0.01}, share * 1e-6, speed);
    const double slop = body.params.slop;
    ASSERT_GT(0.5 * angle * angle * 0.01, slop);
    const ConstrainedStep step = body.step();
    EXPECT_GE(least_gap(*body.model, step.state), std::min(0.99 * share, 0.5) * slop);
    EXPECT_NEAR(vector_from_rotation(step.state.orientation).y(), angle, 1e-9);  // all of it
  }
}

TEST(ConstrainedStep, HalfOfWhatIsKeptIsLeftHoweverOftenTurningTakesSome) {
  for (const double slop : {1e-6, 1e-9}) {
    for (const double x : {0.0, 0.004, 0.02}) {
      for (const double speed : {1.0, 3.0, 6.0, 10.0, 30.0, 60.0}) {
        Turning body({x, 0.0, 0.01}, slop, speed);
        body.params.slop = slop;
        for (int k = 0; k < 60; ++k) {
          body.step();
          ASSERT_GE(least_gap(*body.model, body.state), 0.499 * slop)
              << "at " << x << ", " << speed << " rad/s, step " << k;
        }
      }
    }
  }
}

TEST(ConstrainedStep, ACorrectionThatOtherRowsForbidIsTakenBack) {
  Turning body({0.0, 0.0, 0.01}, 1e-6, 30.0);
  ContactRow above = make_row(RowKind::scene_plane);  // the body fits with as little play
  above.id = 200;
  above.object_point = {0.0, 0.0, -0.01};
  above.scene_point = {0.0, 0.0, body.state.position.z() - 0.01 + 1e-6};
  above.scene_direction = Vec3::UnitZ();
  body.model->rows.push_back(above);
  const ConstrainedStep step = body.step();
  EXPECT_FALSE(step.is_squeezed);
  EXPECT_TRUE(step.solution.is_whole);
  EXPECT_GE(least_gap(*body.model, step.state), 0.0);
  EXPECT_GT(vector_from_rotation(step.state.orientation).y(), 0.0);
}

TEST(ConstrainedStep, RestsWhereRowsContradictEachOther) {
  Held held;
  ContactRow floor = make_row(RowKind::scene_plane), ceiling = floor;
  floor.object_point = {0.0, 0.0, -0.02 - 1e-5};
  floor.scene_direction = -Vec3::UnitZ();
  ceiling.object_point = {0.0, 0.0, 0.02 + 1e-5};
  ceiling.scene_point = {0.0, 0.0, 0.04};
  ceiling.scene_direction = Vec3::UnitZ();
  held.model->rows.push_back(floor);
  held.model->rows.push_back(ceiling);
  for (int k = 0; k < 100; ++k) EXPECT_TRUE(held.step({0.0, 0.0, 0.05}).is_squeezed) << k;
  EXPECT_NEAR(held.state.position.z(), 0.02, 1e-4);
  EXPECT_LE(held.state.linear_momentum.norm(), 1e-3);
}

TEST(ConstrainedStep, MetricIsMassAndWhatTheCouplingAdds) {
  Held held;
  const StepForces forces = held.pull(held.state.position);
  const Mat6 metric = step_metric(at_state(held.body, held.state), forces.jacobian, kStep);
  const double linear = 0.05 + kStep * 5.0 + kStep * kStep * 1000.0;
  const double angular = 1e-5 + kStep * 2e-3 + kStep * kStep * 0.5;
  Mat6 expected = Mat6::Zero();
  expected.topLeftCorner<3, 3>() = linear * Mat3::Identity();
  expected.bottomRightCorner<3, 3>() = angular * Mat3::Identity();
  EXPECT_LE((metric - expected).norm(), 1e-12);
}

/// The same body by itself, on four corners of a block under a tilted gravity.
struct OnSlope : Held {
  OnSlope(double angle, double kinetic, double at_rest) {
    const double g = 9.81;
    body = make_body(0.05, Mat3(1e-5 * Mat3::Identity()),
                     Vec3(g * std::sin(angle), 0.0, -g * std::cos(angle)));
    state.position.z() = 0.01 + params.slop;
    for (const double x : {-0.01, 0.01})
      for (const double y : {-0.01, 0.01}) {
        add_corner({x, y, -0.01});
        ContactRow& row = model->rows.back();
        row.id = model->rows.size();
        row.friction = {kinetic, at_rest};
      }
  }
  ConstrainedStep slide() {
    const ConstrainedStep result =
        constrained_step(at_state(body, state), {}, {*model, params, kStep}, memory);
    state = result.state;
    return result;
  }
};

TEST(ConstrainedStep, OnASlopeItSticksBelowTheConeAndSlidesAsCoulombSays) {
  for (const double mu : {0.2, 0.5, 0.8}) {
    OnSlope below(0.97 * std::atan(mu), mu, mu), above(1.2 * std::atan(mu), mu, mu);
    const Vec3 start = below.state.position;
    for (int k = 0; k < 10000; ++k) {
      below.slide();
      ASSERT_LE((below.state.position - start).norm(), 1e-6) << mu << ", frame " << k;
    }
    for (int k = 0; k < 1000; ++k) above.slide();
    const double angle = 1.2 * std::atan(mu);
    const double expected = 9.81 * (std::sin(angle) - mu * std::cos(angle));
    EXPECT_NEAR(above.state.linear_momentum.x() / 0.05, expected, 1e-3 * expected) << mu;
    EXPECT_NEAR(above.state.position.x(), 0.5 * expected, 2e-3 * expected) << mu;
  }
}

TEST(ConstrainedStep, ManyRowsStickAndSlideAsFewDo) {
  for (const bool is_loaded : {false, true}) {
    OnSlope below(0.97 * std::atan(0.5), 0.5, 0.5), above(1.2 * std::atan(0.5), 0.5, 0.5);
    for (OnSlope* block : {&below, &above}) {
      for (int i = 0; i < 60; ++i) {
        block->add_corner({5e-3 * (i % 8 - 3.5) / 2.0, 5e-3 * (i / 8 - 3.5) / 2.0, -0.01}, 0.5);
        block->model->rows.back().id = 1000 + static_cast<std::uint64_t>(i);
      }
      if (!is_loaded) continue;  // the load on all of them from the beginning
      for (const ContactRow& row : block->model->rows)
        block->memory.entries.push_back({row.id, 7e-6, {0.0, 0.0}, false, false});
    }
    const Vec3 start = below.state.position;
    for (int k = 0; k < 10000; ++k) {
      below.slide();
      ASSERT_LE((below.state.position - start).norm(), 1e-6) << is_loaded << ", frame " << k;
    }
    for (int k = 0; k < 1000; ++k) above.slide();
    const double angle = 1.2 * std::atan(0.5);
    const double expected = 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
    EXPECT_NEAR(above.state.linear_momentum.x() / 0.05, expected, 1e-3 * expected) << is_loaded;
  }
}

TEST(ConstrainedStep, RowsThatComeInTheWayOfWhatSlidesSlideToo) {
  // Tan of the angle lies between the coefficients, and every row is new every 3 mm.
  const double angle = 0.45, kinetic = 0.3;
  OnSlope tiles(angle, kinetic, 0.6);
  tiles.state.linear_momentum.x() = 0.05 * 0.02;
  for (int k = 0; k < 500; ++k) {
    const auto tile = static_cast<std::uint64_t>(tiles.state.position.x() / 3e-3);
    std::uint64_t corner = 0;
    for (ContactRow& row : tiles.model->rows) row.id = 10 * tile + ++corner;
    tiles.slide();
  }
  const double expected = 0.02 + 0.5 * 9.81 * (std::sin(angle) - kinetic * std::cos(angle));
  EXPECT_NEAR(tiles.state.linear_momentum.x() / 0.05, expected, 5e-3 * expected);
}

TEST(ConstrainedStep, SlidingTakesTheWorkOfItsFriction) {
  const double angle = 1.3 * std::atan(0.4);
  OnSlope block(angle, 0.4, 0.4);
  double told = 0.0, taken = 0.0;
  int sticking = 0;
  for (int k = 0; k < 1000; ++k) {
    const double x = block.state.position.x();
    const ConstrainedStep step = block.slide();
    told += step.slip.work;
    taken -= step.contact.force.x() * (block.state.position.x() - x);
    sticking += step.slip.sticking;
  }
  const double normal = 0.05 * 9.81 * std::cos(angle);
  EXPECT_NEAR(told, taken, 1e-6 * taken);
  EXPECT_NEAR(told, 0.4 * normal * block.state.position.x(), 1e-3 * told);
  EXPECT_EQ(sticking, 0);
  OnSlope held(0.5 * std::atan(0.4), 0.4, 0.4);
  ConstrainedStep last;
  for (int k = 0; k < 100; ++k) last = held.slide();
  EXPECT_GT(last.slip.sticking, 0);
  EXPECT_EQ(last.slip.sliding, 0);
  EXPECT_EQ(last.slip.work, 0.0);
}

/// A ball of 10 mm that falls on the plane z = 0.
struct Falling : OnSlope {
  ImpactPair pair;

  explicit Falling(double restitution) : OnSlope(0.0, 0.0, 0.0) {
    pair.restitution = restitution;
    model->rows.clear();
    add_corner({0.0, 0.0, -0.01});
  }
  ConstrainedStep fall() {
    const ConstrainedStep result = constrained_step(
        at_state(body, state), {}, {*model, params, kStep, std::span(&pair, 1)}, memory);
    state = result.state;
    return result;
  }
};

TEST(ConstrainedStep, ABallThatFallsComesBackAsItsRestitutionSays) {
  constexpr double kHeight = 0.5;
  for (const double e : {0.3, 0.5, 0.8, 1.0}) {
    Falling ball(e);
    ball.state.position.z() = 0.01 + kHeight;
    double least = 1.0, highest = 0.0, deepest = 0.0;
    for (int k = 0; k < 2000 && least - ball.params.slop < 0.01 + 1.0; ++k) {
      const ConstrainedStep step = ball.fall();
      deepest = std::min(deepest, step.least_gap);
      const double z = ball.state.position.z() - 0.01;
      const bool has_bounced = least < 1e-5;
      if (has_bounced && ball.state.linear_momentum.z() < 0.0 && highest > 0.0) break;
      least = std::min(least, z);
      if (has_bounced) highest = std::max(highest, z);
    }
    EXPECT_NEAR(std::sqrt(highest / kHeight), e, 0.01 * e) << e;
    EXPECT_GE(deepest, 0.0);
  }
}

TEST(ConstrainedStep, WithoutRestitutionAndAtRestNothingComesBack) {
  Falling dead(0.0), resting(1.0);
  dead.state.position.z() = 0.01 + 0.2;
  double speed = 0.0;
  for (int k = 0; k < 1000; ++k) {
    dead.fall();
    speed = std::max(speed, dead.state.linear_momentum.z());
  }
  EXPECT_LE(speed, 0.05 * dead.params.recovery_speed);
  EXPECT_NEAR(dead.state.position.z(), 0.01 + dead.params.slop, 1e-9);
  const Vec3 start = resting.state.position;
  for (int k = 0; k < 1000; ++k) EXPECT_TRUE(resting.fall().impacts.empty());
  EXPECT_NEAR((resting.state.position - start).norm(), 0.0, 1e-9);
}

TEST(ConstrainedStep, ABlockThatLandsFlatLeavesFlat) {
  OnSlope block(0.0, 0.3, 0.3);
  const ImpactPair pair{0.6, {}};
  block.state.position.z() += 1e-4;
  block.state.linear_momentum.z() = -0.05 * 0.5;
  std::size_t most = 0;
  for (int k = 0; k < 5; ++k) {
    const ConstrainedStep step =
        constrained_step(at_state(block.body, block.state), {},
                         {*block.model, block.params, kStep, std::span(&pair, 1)}, block.memory);
    block.state = step.state;
    most = std::max(most, step.impacts.size());
    for (const Impact& impact : step.impacts) EXPECT_NEAR(impact.speed, 0.502, 1e-3);
  }
  EXPECT_GE(most, 1u);
  EXPECT_NEAR(block.state.linear_momentum.z() / 0.05, 0.3 - 3.0 * 9.81e-3, 0.012);
  EXPECT_LE(block.state.angular_momentum.norm(), 1e-9);
}

}  // namespace
}  // namespace thigma
