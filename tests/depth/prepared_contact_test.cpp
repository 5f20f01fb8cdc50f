#include "thigma/depth/detail/prepared_contact.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/depth/detail/rim_search.h"

namespace thigma {
namespace {

using detail::PreparedContact;

/// Part of the plates' triangles are those of the contact, the others lie around them.
void split_sides(test::PlateContact& plates, Random& random) {
  const auto split = [&](std::vector<std::int32_t>& triangles, TexturedPatch& side) {
    const std::size_t own = triangles.size() / 2 + random.below(9);
    side.triangles = std::span(triangles).first(own);
    side.around = std::span(triangles).subspan(own);
  };
  split(plates.object_triangles, plates.contact.object);
  split(plates.scene_triangles, plates.contact.scene);
}

void expect_same_within(Random& random, PreparedContact& all, PreparedContact& some) {
  const MapGrid grid{all.box, 40, 40};
  HeightMap of_all, of_some;
  for (const auto side : {&PreparedContact::object, &PreparedContact::scene}) {
    render_heights(all.*side, grid, {}, of_all);
    render_heights(some.*side, grid, {}, of_some);
    EXPECT_EQ(of_all.heights, of_some.heights);
  }
  for (int k = 0; k < 60; ++k) {
    // on the border of the box too
    const Vec2 at =
        (grid.at(0, 0) +
         Vec2(random.uniform(-1.0, 41.0), random.uniform(-1.0, 41.0)).cwiseProduct(grid.spacing()))
            .cwiseMax(all.box.low)
            .cwiseMin(all.box.high);
    detail::NearTriangles near_all, near_some;
    EXPECT_EQ(depth_at(all, at, near_all), depth_at(some, at, near_some));
    EXPECT_EQ(is_upright(all, at), is_upright(some, at));
  }
  const auto of = [&](PreparedContact& prepared) {
    return detail::rivals_on_rims(prepared, 0.5 * grid.spacing(), {}, kNoDepth);
  };
  const detail::Rivals rims_all = of(all), rims_some = of(some);
  ASSERT_EQ(rims_all.size(), rims_some.size());
  for (std::size_t i = 0; i < rims_all.size(); ++i) {
    EXPECT_EQ(rims_all[i].hope, rims_some[i].hope);
    EXPECT_EQ(rims_all[i].at, rims_some[i].at);
  }
}

TEST(PreparedContact, what_lies_beside_the_box_changes_nothing_in_it) {
  Random random(5);
  std::size_t of_all = 0, of_some = 0;
  int prepared = 0;
  for (int i = 0; i < 60; ++i) {
    test::PlateContact plates(random, {.cells = 8, .amplitude = 4e-4, .bend = 20.0, .noise = 1e-4});
    split_sides(plates, random);
    plates.contact.reach = random.uniform(1e-3, 8e-3);
    PreparedContact all, some;
    const bool is_there = prepare_contact(plates.contact, all);
    ASSERT_EQ(prepare_within_box(plates.contact, some), is_there);
    if (!is_there) continue;
    ++prepared;
    EXPECT_EQ(all.box.low, some.box.low);
    EXPECT_EQ(all.box.high, some.box.high);
    EXPECT_EQ(all.texel, some.texel);
    expect_same_within(random, all, some);
    ASSERT_FALSE(testing::Test::HasFailure()) << i;
    of_all += all.object.triangles.size() + all.scene.triangles.size();
    of_some += some.object.triangles.size() + some.scene.triangles.size();
  }
  EXPECT_GT(prepared, 40);
  EXPECT_LT(2 * of_some, of_all);
}

}  // namespace
}  // namespace thigma
