// Textures over levels of detail in the contact model: whatever level a contact has, the original
// surface is felt.

#include "response/level_relief.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "thigma/loop/contact_step.h"
#include "thigma/math/rotation.h"
#include "thigma/response/texture_contacts.h"

namespace thigma {
namespace {

/// Over the box at a resolution, as one cluster.
struct Press {
  ContactWorld world;
  ContactScratch scratch;
  ContactSample sample;

  explicit Press(const Resolution& resolution, int clusters = 1) {
    world.object = &test::level_relief().ball.hierarchy;
    world.scene = {{&test::level_relief().box, Pose{}}};
    world.tolerance = test::kTolerance;
    world.resolution = resolution;
    world.max_clusters = clusters;
    world.response.stiffness = 2000.0;
    world.textures.object =
        make_textured_levels(test::level_relief().of_ball, test::level_relief().ball.hierarchy);
    world.textures.scene = {
        make_textured_body(test::level_relief().of_box, test::level_relief().box)};
    world.textures.params.gradient = GradientKind::envelope;
    reserve_contact_scratch(world, scratch);
  }
  const LinearContactModel& at(const Pose& pose) {
    StampedBody body;
    body.state.position = pose.position;
    body.state.orientation = pose.orientation;
    contact_step(world, body, scratch, sample);
    return sample.model;
  }
  std::int32_t coarsest() const {
    std::int32_t level = 0;
    for (const Contact& contact : scratch.contacts.contacts)
      level = std::max(level, contact.object_level);
    return level;
  }
};

Resolution at_threshold(double haptic) {
  Resolution r;
  r.is_exact = false;
  r.metric.haptic = haptic;
  r.deviation_cap = kNoCap;
  return r;
}

/// Turned by steps; its lowest vertex `depth` below the top of the box.
Pose pressed(int step, double depth) {
  Pose pose;
  pose.orientation = rotation_from_vector(Vec3(0.11 * step, 0.07 * step, 0.02 * step));
  double lowest = 0.0;
  for (const Vec3& p : test::level_relief().ball.meshes[0].positions)
    lowest = std::min(lowest, pose.orientation._transformVector(p).z());
  pose.position = Vec3(0.001 * step, 0.0, 0.01 - lowest - depth);
  return pose;
}

TEST(LevelRelief, FeelsTheOriginalAtEveryLevel) {
  Press exact(Resolution{});
  for (const double s0 : {0.001, 0.01, 0.05, 0.2}) {
    Press coarse(at_threshold(s0));
    std::int32_t coarsest = 0;
    double worst = 0.0;
    for (int i = 0; i < 40; ++i) {
      const Pose pose = pressed(i, 0.5 * test::kTolerance);
      const LinearContactModel& want = exact.at(pose);
      const LinearContactModel& got = coarse.at(pose);
      ASSERT_EQ(want.depths.size(), 1u) << i;
      ASSERT_EQ(got.depths.size(), 1u) << i << " at " << s0;
      const std::int32_t level = coarse.coarsest();
      coarsest = std::max(coarsest, level);
      const double off = std::fabs(got.depths[0].depth - want.depths[0].depth);
      EXPECT_LE(off, 1.25 * test::level_relief().fit(level))
          << "pose " << i << " level " << level << " s0 " << s0;
      EXPECT_NEAR(want.depths[0].depth, 0.5 * test::kTolerance, 1e-3 * test::kTolerance) << i;
      worst = std::max(worst, off);
    }
    std::printf("  s0 %.3f: levels up to %d, depth off by at most %.4f %% of the radius\n", s0,
                coarsest, 100.0 * worst / test::kRadius);
    if (s0 >= 0.05) {
      EXPECT_GE(coarsest, 3) << s0;
    }
  }
}

// Without textures the coarse surface lies elsewhere by far more than the fit.
TEST(LevelRelief, IsWhatLevelsAloneLeaveOut) {
  Press with(at_threshold(0.2)), without(at_threshold(0.2));
  without.world.textures = {};
  reserve_contact_scratch(without.world, without.scratch);
  double plain = 0.0, textured = 0.0;
  for (int i = 0; i < 40; ++i) {
    const Pose pose = pressed(i, 0.5 * test::kTolerance);
    with.at(pose);
    without.at(pose);
    textured = std::max(textured, std::fabs(with.sample.depth_max - 0.5 * test::kTolerance));
    plain = std::max(plain, std::fabs(without.sample.depth_max - 0.5 * test::kTolerance));
  }
  EXPECT_GT(plain, 5.0 * textured);
}

TEST(LevelRelief, MixesLevelsInACluster) {
  Press mixed(at_threshold(0.02), 4);
  int poses_with_two_levels = 0;
  for (int i = 0; i < 60; ++i) {
    const LinearContactModel& model = mixed.at(pressed(i, 2.0 * test::kTolerance));
    ASSERT_FALSE(model.depths.empty()) << i;
    double deepest = -1.0;
    for (const DepthTerm& term : model.depths) deepest = std::max(deepest, term.depth);
    EXPECT_NEAR(deepest, 2.0 * test::kTolerance, test::level_relief().fit(mixed.coarsest())) << i;
    const auto& contacts = mixed.scratch.contacts.contacts;
    poses_with_two_levels += std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
      return c.object_level != contacts[0].object_level;
    });
  }
  EXPECT_GT(poses_with_two_levels, 0);
}

}  // namespace
}  // namespace thigma
