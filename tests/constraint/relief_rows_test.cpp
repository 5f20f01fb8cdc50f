#include "thigma/constraint/relief_rows.h"

#include <cmath>

#include "constraint/relief_bench.h"
#include <gtest/gtest.h>

#include "thigma/depth/depth.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::ReliefBench;

constexpr double kTravel = 1e-4;

TEST(ReliefRows, GapAndGradientAreThoseOfTheDepth) {
  ReliefBench bench;
  bench.ask({}, kTravel);
  const FoundRow& row = bench.scratch.rows.at(0);
  ASSERT_EQ(bench.scratch.rows.size(), 1u);
  EXPECT_EQ(row.row.kind, RowKind::relief);
  // The same depth by the search over all texels, the object moved.
  const auto depth = [&](const Vec6& by) {
    const auto backend = make_branch_depth({});
    DepthContact contact = bench.scratch.textures.contacts.at(0);
    const Pose motion{by.head<3>(), rotation_from_vector(by.tail<3>())};
    contact.object.world_from_body = motion * contact.object.world_from_body;
    DepthSamples sample;
    backend->sample({&contact, 1}, {}, {&sample, 1});
    return sample.depth[0];
  };
  const RowAtState here = row_at(row.row, Vec3::Zero(), Mat3::Identity());
  EXPECT_NEAR(here.gap, row.gap, 1e-12);
  // In metres: over the length of the depth's gradient, which is 1 along the contact's normal.
  const double length = 1.0 / here.normal.dot(bench.scratch.textures.contacts.at(0).normal);
  EXPECT_NEAR(here.gap * length, -depth(Vec6::Zero()), 1e-7);
  Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Vec6 by;
    by << 0.7 * kTravel * random.in_cube(1.0), 5e-4 * random.in_cube(1.0);
    const RowAtState there =
        row_at(row.row, by.head<3>(), rotation_matrix(rotation_from_vector(by.tail<3>())));
    const double slope = 1.0 / there.normal.dot(bench.scratch.textures.contacts.at(0).normal);
    EXPECT_NEAR(there.gap * slope, -depth(by), 2e-7) << trial;
  }
}

// A row told along its own tangent instead of the contact's plane is 46 um off here: the object
// goes along a slope, and not square to the plane.
TEST(ReliefRows, ASlopeIsToldAllTheWay) {
  constexpr double kCurvature = 150.0, kTop = 6e-3, kWay = 3e-3;
  ReliefBench bench(kCurvature, kCurvature);
  // Down the hill, so that the surfaces lean; a parabola on a parabola.
  const double lean = kCurvature * kTop / 2.0;
  const Pose start{Vec3(kTop, 0.0, -0.5 * lean * kTop), Quat::Identity()};
  bench.ask(start, kWay);
  ASSERT_FALSE(bench.scratch.rows.empty());
  const auto backend = make_branch_depth({});
  for (double way = -kWay; way <= kWay; way += 0.25 * kWay) {
    Pose moved{start.position + Vec3(way, 0.0, 0.0), start.orientation};
    DepthContact contact = bench.scratch.textures.contacts.at(0);
    contact.object.world_from_body = moved * bench.body_from_mesh;
    DepthSamples sample;
    backend->sample({&contact, 1}, {}, {&sample, 1});
    moved.position.z() += sample.depth[0];  // touching
    double least = 1.0;
    for (const FoundRow& row : bench.scratch.rows)
      least = std::min(least, row_at(row.row, moved.position, Mat3::Identity()).gap);
    EXPECT_NEAR(least, 0.0, 2e-5) << way;  // climbs may leave out 1.5e-5
  }
}

TEST(ReliefRows, APlaceKeepsItsIdAsTheObjectSlides) {
  ReliefBench bench;
  bench.ask({}, kTravel);
  const std::uint64_t id = bench.scratch.rows.at(0).row.id;
  for (int step = 1; step < 20; ++step) {
    bench.ask({Vec3(5e-5 * step, 0.0, 0.0), Quat::Identity()}, kTravel);
    ASSERT_EQ(bench.scratch.rows.size(), 1u);
    EXPECT_EQ(bench.scratch.rows[0].row.id, id) << step;
  }
}

TEST(ReliefRows, ParabolasHoldAllTheWay) {
  ReliefBench bench;
  bench.ask({}, 1e-3);
  EXPECT_EQ(bench.scratch.travel, 1e-3);
  EXPECT_EQ(bench.scratch.stats.bent, 0);
}

TEST(ReliefRows, PatchesWithoutReliefKeepTheirFeatures) {
  ReliefBench bench;
  EXPECT_EQ(bench.patches.object, std::vector<std::uint8_t>(bench.object_tree.patches.size(), 1));
  const HapticTexture plain = make_plain_texture(bench.object.coarse, "plain");
  TexturedWorld world = bench.world;
  world.object = make_textured_body(plain, bench.object_tree);
  const ReliefPatches patches = find_relief_patches(world);
  EXPECT_EQ(patches.object, std::vector<std::uint8_t>(bench.object_tree.patches.size(), 0));
  bench.patches.object.assign(bench.patches.object.size(), 0);
  bench.ask({}, kTravel);
  EXPECT_EQ(bench.scratch.rows.size(), 1u);  // one side with relief is enough
  bench.patches.scene[0].assign(bench.patches.scene[0].size(), 0);
  bench.ask({}, kTravel);
  EXPECT_TRUE(bench.scratch.rows.empty());
  EXPECT_EQ(bench.scratch.plain.contacts.size(), bench.contacts.contacts.size());
}

}  // namespace
}  // namespace thigma
