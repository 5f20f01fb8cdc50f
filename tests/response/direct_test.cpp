#include "thigma/response/direct.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

ContactCluster plane_at(double x, double distance) {
  ContactCluster c;
  c.point = {x, 0.0, distance};
  c.scene_point = {x, 0.0, 0.0};
  c.normal = -Vec3::UnitZ();
  c.depth = -distance;
  c.weight = 1.0;
  return c;
}

TEST(DirectPenalty, GreatestForceAtZeroDistanceWithTheBestStiffness) {
  const PenaltyParams p = direct_penalty({.max_force = 3.3, .max_stiffness = 1100.0});
  EXPECT_DOUBLE_EQ(p.stiffness, 1100.0);
  EXPECT_DOUBLE_EQ(p.tolerance, 0.003);
  EXPECT_EQ(p.damping, 0.0);
}

TEST(DirectPenalty, ScalesKeepWhatTheDeviceFeels) {
  const double s = 2.5, f = 0.4;
  const PenaltyParams p = direct_penalty(
      {.max_force = 3.3, .max_stiffness = 1100.0, .motion_scale = s, .force_scale = f});
  EXPECT_NEAR(p.stiffness * p.tolerance * f, 3.3, 1e-12);  // device force at zero distance
  EXPECT_NEAR(p.stiffness * s * f, 1100.0, 1e-9);          // device stiffness
  EXPECT_NEAR(p.tolerance / s, 0.003, 1e-15);              // the way of the hand between the two
}

TEST(DirectWrench, APlaneGivesStiffnessTimesToleranceLessDistance) {
  const PenaltyParams p = direct_penalty({.max_force = 2.0, .max_stiffness = 500.0});
  for (const double distance : {0.004, 0.003, 0.0005, 0.0, -0.001}) {
    ContactClusters clusters;
    clusters.clusters.push_back(plane_at(0.02, distance));
    const Wrench w = direct_wrench(clusters, p, Vec3::Zero());
    EXPECT_NEAR(w.force.z(), 500.0 * (0.004 - distance), 1e-12);
    EXPECT_NEAR(w.torque.y(), -0.02 * w.force.z(), 1e-14);
    EXPECT_NEAR(direct_wrench(clusters, p, {0.02, 0.0, 1.0}).torque.norm(), 0.0, 1e-14);
  }
  ContactClusters away;
  away.clusters.push_back(plane_at(0.0, 0.0041));
  EXPECT_EQ(direct_wrench(away, p, Vec3::Zero()).force, Vec3::Zero());
}

TEST(DirectWrench, ForceDoesNotGrowWithTheNumberOfClusters) {
  const PenaltyParams p = direct_penalty({.max_force = 2.0, .max_stiffness = 500.0});
  ContactClusters clusters;
  for (int i = 0; i < 5; ++i) {
    clusters.clusters.push_back(plane_at(0.01 * (i - 2), 0.001));
    EXPECT_NEAR(direct_wrench(clusters, p, Vec3::Zero()).force.z(), 500.0 * 0.003, 1e-12);
  }
  EXPECT_NEAR(direct_wrench(clusters, p, Vec3::Zero()).torque.norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace thigma
