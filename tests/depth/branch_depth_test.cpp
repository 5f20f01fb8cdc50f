#include "depth/textured_plates.h"
#include "support/full.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(BranchDepth, equals_the_maximum_over_all_texels) {
  Random random(1);
  const auto backend = make_branch_depth({});
  const int plates = test::is_full() ? 1700 : 12;  // six contacts each
  int found = 0;
  for (int i = 0; i < plates; ++i) {
    const test::PlateShape shape{.cells = 1 + i % 3,
                                 .texels = 17 + 8 * (i % 4),
                                 .bend = random.uniform(-2.0, 2.0),
                                 .noise = i % 2 ? 3e-5 : 0.0};  // more turns over
    test::PlateContact p(random, shape);
    for (int k = 0; k < 6; ++k) {
      test::shuffle_contact(random, p, shape.size);
      if (k % 2) p.contact.reach = random.uniform(0.1, 0.4) * shape.size;
      const double want = test::slow_depth(p.contact);
      const DepthSamples got = test::depth_of(*backend, p.contact);
      EXPECT_EQ(got.is_found, want != kNoDepth);
      if (want == kNoDepth) continue;
      // as near as fine points are looked for
      EXPECT_NEAR(got.depth[0], want, 1e-11) << i << ' ' << k;
      EXPECT_EQ(got.remaining, 0.0);
      ++found;
    }
  }
  EXPECT_GT(found, 5 * plates);
}

TEST(BranchDepth, a_spent_budget_says_what_it_may_have_missed) {
  Random random(2);
  int spent = 0, over = 0;
  for (int i = 0; i < 20; ++i) {
    const test::PlateContact p(random, {.texels = 65, .bend = 2.0, .noise = 1e-4});
    const double want = test::depth_of(*make_branch_depth({}), p.contact).depth[0];
    for (const int nodes : {0, 1, 10, 40, 200}) {
      const DepthSamples got = test::depth_of(*make_branch_depth({.max_nodes = nodes}), p.contact);
      ASSERT_TRUE(got.is_found);
      over += got.nodes > nodes;
      EXPECT_LE(got.depth[0], want);
      EXPECT_GE(got.depth[0] + got.remaining, want);
      spent += got.remaining > 0.0;
    }
  }
  EXPECT_GT(spent, 20);
  EXPECT_LE(over, 5);  // where no texel amidst a pair of triangles is in the domain
}

TEST(BranchDepth, a_warm_search_finds_the_same_in_no_more_cells) {
  Random random(3);
  const auto warm = make_branch_depth({});
  int nodes_warm = 0, nodes_cold = 0;
  for (int i = 0; i < 5; ++i) {
    test::PlateContact p(random, {.texels = 129, .waves = 10.0});
    for (int k = 0; k < 10; ++k) {
      p.contact.object.world_from_body.position += 2e-5 * p.contact.normal.unitOrthogonal();
      const DepthSamples cold = test::depth_of(*make_branch_depth({}), p.contact);
      const DepthSamples got = test::depth_of(*warm, p.contact);
      EXPECT_EQ(got.depth[0], cold.depth[0]);
      nodes_cold += cold.nodes;
      nodes_warm += got.nodes;
    }
  }
  EXPECT_LE(nodes_warm, nodes_cold);
}

// What a search remembers belongs to other textures by then.
TEST(BranchDepth, memory_of_another_contact_is_harmless) {
  Random random(4);
  const auto backend = make_branch_depth({});
  for (int i = 0; i < 20; ++i) {
    const test::PlateContact p(random, {.cells = 1 + i % 3, .texels = i % 2 ? 9 : 80});
    EXPECT_EQ(test::depth_of(*backend, p.contact).depth[0],
              test::depth_of(*make_branch_depth({}), p.contact).depth[0]);
  }
}

TEST(BranchDepth, near_maxima_hold_the_maximum_first) {
  Random random(5);
  const test::PlateContact p(random, {.texels = 64});
  const DepthSamples got = test::depth_of(*make_branch_depth({}), p.contact, {.near = 8e-4});
  ASSERT_GT(got.near.size(), 2u);
  EXPECT_EQ(got.near[0].at, got.at);
  for (const NearMaximum& near : got.near)
    EXPECT_LE(near.weight, got.near[0].weight * (1.0 + 1e-6));
}

}  // namespace
}  // namespace thigma
