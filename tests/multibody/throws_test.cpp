// Thin plates and sharp things thrown at each other, both free: nothing passes through.
//   THIGMA_THROWS=10000 THIGMA_THROWS_STATE=FILE multibody_tests --gtest_filter='Throws*'
// goes on where it was. How many were made is printed.

#include <cstdio>

#include "attack/cases.h"
#include "multibody/world_bench.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::WorldBench;

struct Shapes {
  std::shared_ptr<test::BodyMesh> plate = test::body_mesh(make_box(Vec3(0.08, 0.06, 0.0001)));
  std::vector<std::shared_ptr<test::BodyMesh>> thrown = {
      test::body_mesh(make_cone(0.015, 0.04, 12)), test::body_mesh(make_torus(0.02, 0.004, 16, 8)),
      test::body_mesh(make_l_shape(0.04, 0.005)),
      test::body_mesh(make_box(Vec3(0.05, 0.03, 1e-4)))};
};

/// A throw by its number: speeds 0.05 to 5 m/s, spins up to 50 rad/s, a third of them bouncing.
WorldBench throw_of(std::uint64_t number, const Shapes& shapes, double& speed) {
  Random random(1000 + number);
  WorldBench bench;
  bench.add(shapes.plate, BodyKind::moving, Vec3::Zero());
  const auto& mesh = shapes.thrown[number % shapes.thrown.size()];
  bench.add(mesh, BodyKind::moving, Vec3(0.02 * random.normal(), 0.015 * random.normal(), 0.065),
            random.orientation());
  for (WorldBody& body : bench.bodies) {
    body.restitution = number % 3 == 0 ? 0.7 : 0.0;
    const double friction = random.uniform(0.0, 0.8);
    body.friction = {friction, friction};
    body.start.angular_momentum = rotation_matrix(body.start.orientation) *
                                  (body.inertia * (50.0 * random.uniform() * random.direction()));
  }
  speed = 0.05 * std::pow(100.0, random.uniform());
  const Vec3 way = Vec3(0.2 * random.normal(), 0.2 * random.normal(), -1.0).normalized();
  bench.bodies[1].start.linear_momentum = speed * bench.bodies[1].mass * way;
  bench.make(Vec3::Zero());
  return bench;
}

/// What a throw did.
struct Thrown {
  bool has_met = false, has_passed = false, has_gained = false;
  double waited = 0.0;
};

Thrown follow(WorldBench& bench, double speed) {
  Thrown out;
  const double energy = bench.energy();
  const int steps = std::min(500, static_cast<int>(0.12 / speed * 1000.0));
  for (int i = 0; i < steps && !out.has_passed; ++i) {
    const WorldStep step = bench.step();
    out.waited += step.waited;
    out.has_met = out.has_met || step.pressing > 0;
    out.has_gained = out.has_gained || !(bench.energy() <= energy * (1.0 + 1e-9));
    // Every step near each other, and now and then whatever the engine says.
    if (step.rows > 0 || i % 4 == 0) out.has_passed = !(bench.distance(0, 1) > 0.0);
  }
  return out;
}

TEST(Throws, NothingPassesThroughAThinPlate) {
  const test::Cases cases("THIGMA_THROWS", test::is_full() ? 10000 : 200);
  const Shapes shapes;
  std::uint64_t met = 0, waited = 0;
  for (std::uint64_t number = cases.first; number < cases.end; ++number) {
    double speed = 0.0;
    WorldBench bench = throw_of(number, shapes, speed);
    const Thrown thrown = follow(bench, speed);
    EXPECT_FALSE(thrown.has_passed) << "throw " << number;
    EXPECT_FALSE(thrown.has_gained) << "throw " << number;
    met += thrown.has_met ? 1 : 0;
    waited += thrown.waited > 0.0 ? 1 : 0;
    if (number % 20 == 19) cases.done(number + 1);
  }
  cases.done(cases.end);
  std::printf("throws: %llu made, %llu met, %llu waited\n",
              static_cast<unsigned long long>(cases.count()), static_cast<unsigned long long>(met),
              static_cast<unsigned long long>(waited));
  if (cases.count() > 0) {
    EXPECT_GT(met, cases.count() / 3);
  }
}

/// Planes of a ring's faces sweep farther than the ring itself where they reach the far end of a
/// plate's edge: that end is not out of reach because it is higher than the ring may go.
TEST(Throws, PlanesOfATurningBodyReachTheFarEndOfAnEdge) {
  const Shapes shapes;
  double speed = 0.0;
  WorldBench bench = throw_of(4037, shapes, speed);
  const Thrown thrown = follow(bench, speed);
  EXPECT_TRUE(thrown.has_met);
  EXPECT_FALSE(thrown.has_passed);
}

}  // namespace
}  // namespace thigma
