#include "thigma/multibody/step_world.h"

#include <cmath>
#include <numbers>

#include "multibody/world_bench.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/pair_kinds.h"

namespace thigma {
namespace {

using test::WorldBench;

constexpr double kGravity = 9.81;

double bounce_height(double e, double start) {
  WorldBench bench;
  test::add_floor(bench);
  bench.add(test::body_mesh(make_ball(0.02, 4)), BodyKind::moving, Vec3(0.0, 0.0, 0.02 + start));
  bench.bodies[1].restitution = e;
  bench.make();
  const double radius = bench.state.bodies[1].position.z() - bench.distance(0, 1);
  double most = 0.0, energy = bench.energy();
  bool has_hit = false;
  for (int i = 0; i < 800; ++i) {
    const WorldStep step = bench.step();
    if (step.impacts > 0 && has_hit) break;
    has_hit = has_hit || step.impacts > 0;
    if (has_hit) most = std::max(most, bench.state.bodies[1].position.z() - radius);
    EXPECT_LE(bench.energy(), energy * (1.0 + 1e-12));
    energy = bench.energy();
  }
  return most;
}

TEST(StepWorld, BouncesAsItsRestitutionSays) {
  for (const double e : {1.0, 0.8, 0.5, 0.2}) {
    const double start = 0.2;
    EXPECT_NEAR(std::sqrt(bounce_height(e, start) / start), e, 0.01 * e) << e;
  }
}

TEST(StepWorld, TowerOfThirtyStands) {
  WorldBench bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.02)));
  for (int i = 0; i < 30; ++i) bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.01 + i * 0.02));
  bench.make();
  const double slop = bench.world.pair_kinds->list.back().constraints.slop;
  for (int i = 0; i < 30; ++i)
    bench.state.bodies[static_cast<std::size_t>(i) + 1].position.z() += (i + 1) * slop;
  bench.world.sleeps = false;
  const WorldState start = bench.state;
  const double energy = bench.energy();
  const int steps = test::is_full() ? 60000 : 1000;
  double drift = 0.0;
  for (int i = 0; i < steps; ++i) {
    const WorldStep step = bench.step();
    ASSERT_TRUE(step.is_whole);
    ASSERT_EQ(step.waited, 0.0);
    for (std::size_t k = 1; k <= 30; ++k)
      drift = std::max(drift, (bench.state.bodies[k].position - start.bodies[k].position).norm());
    ASSERT_LE(bench.energy(), energy * (1.0 + 1e-6));
  }
  EXPECT_LE(drift, 10e-6);
  RecordProperty("drift_um", std::to_string(1e6 * drift));
  for (std::size_t k = 0; k < 30; ++k) EXPECT_GT(bench.distance(k, k + 1), 0.0);
}

TEST(StepWorld, BlockSlidesAndStopsWhereCoulombSays) {
  WorldBench bench;
  test::add_floor(bench, 2.0);
  bench.bodies[0].friction = {0.3, 0.3};
  bench.add(test::body_mesh(make_box(Vec3(0.06, 0.06, 0.02))), BodyKind::moving,
            Vec3(-0.3, 0.1, 0.01 + 2e-6));
  bench.make();
  bench.world.sleeps = false;
  const Vec3 along = Vec3(2.0, -1.0, 0.0).normalized();
  const double speed = 1.5;
  // On its stand-off first.
  for (int i = 0; i < 5; ++i) bench.step();
  bench.state.bodies[1].linear_momentum = speed * bench.world.rigid[1].mass * along;
  const Vec3 start = bench.state.bodies[1].position;
  double energy = bench.energy();
  int stop = 0;
  for (int i = 0; i < 1000; ++i) {
    bench.step();
    ASSERT_LE(bench.energy(), energy + 1e-12);
    energy = bench.energy();
    if (stop == 0 && bench.state.bodies[1].linear_momentum.norm() < 1e-9) stop = i;
  }
  const double way = (bench.state.bodies[1].position - start).dot(along);
  const double expected = speed * speed / (2.0 * 0.3 * kGravity);
  EXPECT_NEAR(way, expected, 1e-3 * expected);
  EXPECT_LT((bench.state.bodies[1].position - start - way * along).norm(), 1e-3 * expected);
}

/// A ball of 5,120 triangles that sets out rolling: how far it gets [m], the most parts of a step,
/// and the most energy that a step gave it [J].
struct Rolled {
  double way = 0.0, waited = 0.0, gain = 0.0;
  std::int32_t parts = 0;
};

Rolled roll(double speed, int steps) {
  WorldBench bench;
  test::add_floor(bench);
  constexpr double kRadius = 0.01;
  bench.add(test::body_mesh(make_ball(kRadius, 4)), BodyKind::moving, Vec3(0.0, 0.0, kRadius));
  WorldBody& ball = bench.bodies[1];
  ball.start.linear_momentum = Vec3(ball.mass * speed, 0.0, 0.0);
  ball.start.angular_momentum = ball.inertia * Vec3(0.0, speed / kRadius, 0.0);
  bench.make();
  bench.state.bodies[1].position.z() += bench.world.pair_kinds->list.back().constraints.slop;
  Rolled rolled;
  double energy = bench.energy();
  for (int i = 0; i < steps; ++i) {
    const WorldStep step = bench.step();
    rolled.waited += step.waited;
    rolled.parts = std::max(rolled.parts, step.parts);
    rolled.gain = std::max(rolled.gain, bench.energy() - energy);
    energy = bench.energy();
  }
  rolled.way = bench.state.bodies[1].position.x();
  return rolled;
}

// Its corners are an edge of 0.6 mm apart and each takes some of the speed; nothing waits, where a
// step that goes along the tangents of such corners gains energy.
TEST(StepWorld, ABallOfManyFacetsRollsOnWithoutWaiting) {
  for (const double speed : {0.3, 0.05, 0.01}) {
    const Rolled rolled = roll(speed, 500);
    EXPECT_EQ(rolled.waited, 0.0) << speed;
    EXPECT_EQ(rolled.parts, 1) << speed;
    EXPECT_LE(rolled.gain, 1e-15) << speed;
    EXPECT_GT(rolled.way, 0.3 * 0.5 * speed) << speed;
  }
}

TEST(StepWorld, BlockOnSlopeHoldsBelowItsConeAndAcceleratesAboveIt) {
  for (const double mu : {0.5, 0.25}) {
    WorldBench bench;
    const double angle = std::atan(0.4);
    const Quat tilt(Eigen::AngleAxisd(angle, Vec3::UnitY()));
    const Vec3 up = tilt * Vec3::UnitZ(), down = tilt * Vec3::UnitX();
    bench.add(test::floor_mesh(2.0), BodyKind::fixed, -0.01 * up, tilt);
    bench.bodies[0].friction = {mu, mu};
    bench.add(test::body_mesh(make_box(Vec3(0.06, 0.06, 0.02))), BodyKind::moving,
              (0.01 + 2e-6) * up - 0.2 * down, tilt);
    bench.bodies[1].friction = {mu, mu};
    bench.make();
    bench.world.sleeps = false;
    const Vec3 start = bench.state.bodies[1].position;
    for (int i = 0; i < 400; ++i) bench.step();
    const double way = (bench.state.bodies[1].position - start).dot(down);
    const double a = kGravity * (std::sin(angle) - mu * std::cos(angle));
    if (a < 0.0)
      EXPECT_LT(std::fabs(way), 1e-6);
    else
      EXPECT_NEAR(way, 0.5 * a * 0.4 * 0.4, 1e-3 * way);
  }
}

TEST(StepWorld, FreeBodiesKeepMomentumAndNeverGainEnergy) {
  WorldBench bench;
  Random random(7);
  const auto ring = test::body_mesh(make_torus(0.03, 0.008, 24, 12));
  const auto block = test::body_mesh(make_box(Vec3(0.03, 0.02, 0.04)));
  for (int i = 0; i < 8; ++i) {
    const Quat turn = rotation_from_vector(Vec3(random.normal(), random.normal(), random.normal()));
    const Vec3 place(0.09 * (i % 2), 0.09 * (i / 2 % 2), 0.09 * (i / 4));
    WorldBody& body = bench.add(i % 2 == 0 ? ring : block, BodyKind::moving, place, turn);
    body.restitution = i < 4 ? 0.6 : 0.0;
    body.friction = {0.4, 0.4};
    const Vec3 to = Vec3(0.045, 0.045, 0.045) - place;
    body.start.linear_momentum =
        body.mass * (8.0 * to + 0.2 * Vec3(random.normal(), random.normal(), random.normal()));
    body.start.angular_momentum =
        body.inertia * Vec3(10.0 * random.normal(), 10.0 * random.normal(), 10.0 * random.normal());
  }
  bench.make(Vec3::Zero());
  const WorldMomentum start = momentum(bench.world, bench.state);
  const double energy = bench.energy();
  double last = energy, grown = 0.0, scale = 0.0, arm = 0.0;
  for (const BodyState& y : bench.state.bodies) {
    scale += y.linear_momentum.norm();
    arm += y.angular_momentum.norm() + y.position.norm() * y.linear_momentum.norm();
  }
  std::int64_t impacts = 0;
  std::int32_t most_parts = 0;
  for (int i = 0; i < 1000; ++i) {
    const WorldStep step = bench.step();
    impacts += step.impacts;
    most_parts = std::max(most_parts, step.parts);
    EXPECT_EQ(step.waited, 0.0) << i;
    grown = std::max(grown, bench.energy() - last);
    last = bench.energy();
  }
  const WorldMomentum end = momentum(bench.world, bench.state);
  EXPECT_GT(impacts, 5);
  EXPECT_LE(grown, 1e-9 * energy);
  EXPECT_LE((end.linear - start.linear).norm(), 1e-12 * scale);
  EXPECT_LE((end.angular - start.angular).norm(), 1e-12 * arm);
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT(bench.distance(a, b), 0.0) << a << ' ' << b;
}

TEST(StepWorld, PrescribedPlateCarriesABlockAndIsNotSlowed) {
  WorldBench bench;
  bench.add(test::floor_mesh(1.0), BodyKind::prescribed, Vec3(0.0, 0.0, -0.01));
  bench.add(test::body_mesh(make_box(Vec3(0.06, 0.06, 0.02))), BodyKind::moving,
            Vec3(0.0, 0.0, 0.01 + 2e-6));
  for (WorldBody& body : bench.bodies) body.friction = {0.3, 0.3};
  bench.make();
  const BodyDrive drive{0, {Vec3(0.1, 0.0, 0.0), Vec3::Zero()}};
  for (int i = 0; i < 500; ++i) bench.step(1e-3, {.drives = {&drive, 1}});
  EXPECT_NEAR(bench.state.bodies[0].position.x(), 0.05, 1e-6);
  const double catch_up = 0.1 * 0.1 / (2.0 * 0.3 * kGravity);  // slides until it is as fast
  EXPECT_NEAR(bench.state.bodies[1].position.x(), 0.05 - catch_up, 2e-4);
  EXPECT_NEAR(bench.state.bodies[1].linear_momentum.x() / bench.world.rigid[1].mass, 0.1, 1e-6);
  EXPECT_GT(bench.distance(0, 1), 0.0);
}

TEST(StepWorld, HeapOfRingsAndConesFallsAndStaysApart) {
  WorldBench bench;
  test::add_floor(bench);
  const auto ring = test::body_mesh(make_torus(0.025, 0.007, 16, 8));
  const auto cone = test::body_mesh(make_cone(0.015, 0.04, 12));
  Random random(21);
  for (int i = 0; i < 8; ++i) {
    const Vec3 axis(random.normal(), random.normal(), random.normal());
    bench.add(i % 2 == 0 ? ring : cone, BodyKind::moving,
              Vec3(0.01 * random.normal(), 0.01 * random.normal(), 0.05 + 0.07 * i),
              rotation_from_vector(axis));
  }
  bench.make();
  const double start = bench.energy();
  double last = start, grown = 0.0, waited = 0.0;
  int not_whole = 0;
  for (int i = 0; i < 1000; ++i) {
    const WorldStep step = bench.step();
    waited += step.waited;
    not_whole += step.is_whole ? 0 : 1;
    grown = std::max(grown, bench.energy() - last);
    last = bench.energy();
    if (i % 50 != 49) continue;
    for (std::size_t a = 0; a < bench.bodies.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) ASSERT_GT(bench.distance(a, b), 0.0) << i;
  }
  EXPECT_LE(grown, 1e-6 * start);
  EXPECT_LT(last, 0.3 * start);
  RecordProperty("heap", std::to_string(grown / start) + " waited " + std::to_string(waited) +
                             " not whole " + std::to_string(not_whole));
  EXPECT_EQ(not_whole, 0);
  EXPECT_LE(waited, 0.01);
}

}  // namespace
}  // namespace thigma
