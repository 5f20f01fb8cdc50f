// The potential response on real surfaces: one energy, its gradient, what it depends on and what it
// does not.
#include "thigma/response/potential_contacts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTolerance = 1e-4;
constexpr double kStiffness = 2000.0;

/// An object at its centre of mass against one body at the world's origin.
struct Pair {
  ClodHierarchy object, scene;
  PotentialWorld world;
  Pair(const TriangleMesh& held, const TriangleMesh& fixed)
      : object(build_exact_hierarchy(held)), scene(build_exact_hierarchy(fixed)) {
    const std::vector<SceneBody> bodies = {{&scene, Pose{}}};
    world = make_potential_world(object, Pose{}, bodies);
  }
};

PotentialContact measure(const Pair& pair, const BodyState& state, const PotentialLaw& law) {
  PotentialScratch scratch;
  reserve_potential(pair.world, scratch);
  return measure_potential(pair.world, state, law, kTolerance, scratch);
}

PotentialForce force_at(const Pair& pair, const Pose& pose, const PotentialLaw& law) {
  BodyState state;
  state.position = pose.position;
  state.orientation = pose.orientation;
  return potential_force(measure(pair, state, law).moments, kStiffness, law);
}

TriangleMesh plate(std::array<int, 3> segments) {
  return transformed(make_box({0.08, 0.08, 0.01}, segments),
                     {{0.0, 0.0, -0.005}, Quat::Identity()});
}

PotentialLaw law_of(int exponent) { return {exponent, 2e-5}; }

/// Central differences of the energy, against the force [N; N m].
void expect_gradient(const Pair& pair, const Pose& pose, int p, double share) {
  const PotentialLaw law = law_of(p);
  const PotentialForce f = force_at(pair, pose, law);
  ASSERT_GT(f.energy, 0.0);
  constexpr double kStep = 2e-5;
  const double reach = pair.world.reach;
  for (int k = 0; k < 6; ++k) {
    const double h = k < 3 ? kStep : kStep / reach;
    const auto moved = [&](double way) {
      Pose to = pose;
      if (k < 3)
        to.position[k] += way;
      else
        to.orientation = rotation_from_vector(way * Vec3::Unit(k - 3)) * to.orientation;
      return force_at(pair, to, law).energy;
    };
    const double slope = -(moved(h) - moved(-h)) / (2.0 * h);
    const double size = f.wrench.force.norm();
    if (k < 3)
      EXPECT_NEAR(slope, f.wrench.force[k], share * size) << "p " << p << ", " << k;
    else
      EXPECT_NEAR(slope, f.wrench.torque[k - 3], share * size * reach) << "p " << p << ", " << k;
  }
}

TEST(PotentialContacts, ForceIsTheGradientOfTheEnergyOnRealContacts) {
  Random random(21);
  const Pair cubes(make_box(Vec3(0.02, 0.016, 0.012), {2, 2, 2}), plate({3, 2, 1}));
  const Pair rings(make_torus(0.012, 0.004, 32, 16), make_torus(0.02, 0.006, 40, 20));
  for (const int p : {2, 4}) {
    for (int i = 0; i < 6; ++i) {
      const Vec3 turn = random.in_cube(0.05);
      expect_gradient(cubes,
                      {{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), 0.0058},
                       rotation_from_vector(turn)},
                      p, 0.015);
      // Ring over ring, as links of a chain are pulled.
      expect_gradient(rings,
                      {{0.020 + random.uniform(-0.001, 0.001), random.uniform(-0.002, 0.002),
                        0.0095 + random.uniform(-0.0005, 0.0005)},
                       rotation_from_vector(random.in_cube(0.3))},
                      p, 0.015);
    }
  }
}

TEST(PotentialContacts, WorkAlongAWayIsTheChangeOfEnergy) {
  // Of the sum as it is divided at each pose: no more is lost than where that changes.
  const Pair cubes(make_box(Vec3(0.02, 0.016, 0.012), {2, 2, 2}), plate({3, 2, 1}));
  const Pair rings(make_torus(0.012, 0.004, 32, 16), make_torus(0.02, 0.006, 40, 20));
  const auto follow = [](const Pair& pair, const Vec3& from, const Vec3& way, int p) {
    constexpr int kSteps = 100;
    const PotentialLaw law = law_of(p);
    double work = 0.0, before = 0.0, first = 0.0, last = 0.0, most = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
      const double share = static_cast<double>(i) / kSteps;
      const PotentialForce f =
          force_at(pair, {from + share * way, rotation_from_vector(Vec3(0.02, 0.013, 0.3))}, law);
      const double along = f.wrench.force.dot(way) / kSteps;
      if (i == 0) first = f.energy;
      if (i > 0) work += 0.5 * (along + before);
      before = along;
      last = f.energy;
      most = std::max(most, f.energy);
    }
    EXPECT_NEAR(first - last, work, 2e-3 * most) << "p " << p << ", way " << way.transpose();
  };
  for (const int p : {2, 4}) {
    follow(cubes, {0.003, 0.002, 0.0058}, {0.004, 0.001, 0.0}, p);
    follow(cubes, {0.003, 0.002, 0.0062}, {0.0, 0.0, -0.0008}, p);
    follow(rings, {0.020, 0.0, 0.0095}, {0.001, -0.002, 0.0005}, p);
  }
}

TEST(PotentialContacts, ABallOnAPlateFollowsTheClosedForm) {
  constexpr double kRadius = 0.01;
  const Pair pair(make_ball(kRadius, 60), plate({1, 1, 1}));
  for (const int p : {2, 4}) {
    for (const double depth : {1e-4, 5e-4, 1e-3, 2e-3}) {
      const PotentialLaw law = law_of(p);
      const double all = depth + kTolerance;
      // Half of either surface; docs/potential.md.
      const auto sum = [&](double w) {
        return kPi *
               (kRadius * std::pow(w, p + 1) / (p + 1) +
                (kRadius + kTolerance) * std::pow(w, p + 1) / (p + 1) -
                std::pow(w, p + 2) / (p + 2)) /
               law.area;
      };
      const auto energy = [&](double w) { return 0.5 * kStiffness * std::pow(sum(w), 2.0 / p); };
      const double h = 1e-4 * all;
      const double force = (energy(all + h) - energy(all - h)) / (2.0 * h);
      const PotentialForce f =
          force_at(pair, {{0.002, 0.001, kRadius - depth}, Quat::Identity()}, law);
      EXPECT_NEAR(f.energy, energy(all), 0.02 * energy(all)) << "p " << p << ", " << depth;
      EXPECT_NEAR(f.wrench.force.z(), force, 0.01 * force) << "p " << p << ", " << depth;
      EXPECT_LT(f.wrench.force.head<2>().norm(), 0.002 * force);
    }
  }
}

TEST(PotentialContacts, TheForceGrowsWithDepthOnFineMeshes) {
  const Pair pair(make_ball(0.01, 40), plate({8, 8, 1}));
  double before = 0.0;
  for (int i = 1; i <= 12; ++i) {
    const double force =
        force_at(pair, {{0.0005, 0.0007, 0.01 - 3e-4 * i}, Quat::Identity()}, law_of(4))
            .wrench.force.z();
    EXPECT_GT(force, before);
    before = force;
  }
}

TEST(PotentialContacts, AFootMoreNeverLowersTheForce) {
  const double ys[] = {-0.002, 0.002};
  const auto feet = [&](double second) {
    const double xs[] = {-0.012, -0.008, 0.008, 0.012};
    const double zs[] = {-0.007, -0.007 + second, 0.0, 0.004};
    return make_blocks(xs, ys, zs,
                       [](int i, int, int k) { return k == 2 || i == 0 || (i == 2 && k == 1); });
  };
  // Foot 1 stands 1 mm deep.
  const Pose pose{{0.0, 0.0, 0.006}, Quat::Identity()};
  for (const int p : {2, 4}) {
    double before = 0.0, alone = 0.0;
    for (const double above : {1.3e-3, 1.0e-3, 8e-4, 5e-4, 2e-4, 1e-5}) {
      const Pair pair(feet(above), plate({4, 4, 1}));
      const double force = force_at(pair, pose, law_of(p)).wrench.force.z();
      if (before == 0.0) alone = force;
      EXPECT_GE(force, before * (1.0 - 1e-3)) << "p " << p << ", " << above;
      before = force;
    }
    // Both as deep: areas add up.
    EXPECT_NEAR(before / alone, std::pow(2.0, 2.0 / p), 0.02) << "p " << p;
  }
}

TEST(PotentialContacts, TheModelIsTheLawToSecondOrder) {
  const Pair pair(make_box(Vec3::Constant(0.02), {2, 2, 2}), plate({3, 2, 1}));
  BodyState state;
  state.position = {0.001, 0.002, 0.0095};
  state.orientation = rotation_from_vector({0.02, -0.01, 0.4});
  const RigidBody body = make_body(0.05, Mat3(1e-5 * Mat3::Identity()));
  for (const int p : {2, 4}) {
    const PotentialLaw law = law_of(p);
    const LinearContactModel model =
        potential_model(measure(pair, state, law),
                        {.stiffness = kStiffness, .tolerance = kTolerance}, law, {state, 0.0, 1});
    const double force = contact_wrench(model, body, state).force.norm();
    for (const Vec3& way : {Vec3(0, 0, 2e-5), Vec3(0, 0, -2e-5), Vec3(2e-5, 1e-5, 0)}) {
      for (const Vec3& turn : {Vec3(0, 0, 0), Vec3(1e-3, 0, 0), Vec3(0, -1e-3, 1e-3)}) {
        BodyState moved = state;
        moved.position += way;
        moved.orientation = rotation_from_vector(turn) * state.orientation;
        const Wrench is = contact_wrench(model, body, moved);
        const Wrench should =
            potential_force(measure(pair, moved, law).moments, kStiffness, law).wrench;
        EXPECT_LT((is.force - should.force).norm(), 0.01 * force) << "p " << p;
        EXPECT_LT((is.torque - should.torque).norm(), 0.01 * force * 0.01) << "p " << p;
      }
    }
    EXPECT_EQ(model.depths[0].body, 0);
  }
}

TEST(PotentialContacts, BodiesOfOneHierarchyShareTheirSurface) {
  const ClodHierarchy box = build_exact_hierarchy(make_box(Vec3::Ones()));
  const std::vector<SceneBody> bodies = {{&box, Pose{}},
                                         {&box, {{2.0, 0.0, 0.0}, Quat::Identity()}}};
  const PotentialWorld world = make_potential_world(box, Pose{}, bodies);
  EXPECT_EQ(world.scene[0], world.scene[1]);
  EXPECT_NEAR(world.reach, std::sqrt(0.75), 1e-15);
}

}  // namespace
}  // namespace thigma
