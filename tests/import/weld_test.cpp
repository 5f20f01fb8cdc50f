#include "thigma/import/weld.h"

#include "support/mesh_samples.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TriangleMesh jittered(TriangleMesh mesh, double by) {
  Random random(2);
  for (Vec3& p : mesh.positions) p += random.in_cube(by);
  return mesh;
}

std::int64_t welds_of(const TriangleMesh& mesh, double radius) {
  return find_welds(mesh, build_edge_table(mesh), radius).count;
}

TEST(Weld, a_soup_with_noise_becomes_one_surface) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const TriangleMesh ball = make_ball(scale, 5);
    const TriangleMesh soup = jittered(unwelded(ball), 1e-6 * scale);
    EXPECT_EQ(welds_of(soup, scale),
              static_cast<std::int64_t>(soup.positions.size() - ball.positions.size()));
  }
}

TEST(Weld, nothing_is_welded_where_nothing_is_cracked) {
  EXPECT_EQ(welds_of(make_ball(1.0, 5), 1.0), 0);
  EXPECT_EQ(welds_of(make_sheet(1.0, 1.0, 30, 30), 0.7), 0);
  EXPECT_EQ(welds_of(jittered(unwelded(make_ball(1.0, 5)), 1e-3), 1.0), 0);  // the gaps are real
}

TEST(Weld, a_strip_thinner_than_the_tolerance_keeps_its_width) {
  EXPECT_EQ(welds_of(make_sheet(1.0, 1e-6, 1, 1), 0.5), 0);
  EXPECT_EQ(welds_of(make_sheet(1.0, 1e-6, 40, 2), 0.5), 0);
}

// A fine part of a large surface: all of it lies in one cell of the tolerance's size, and none is
// near another by its own. Looking at each pair would take minutes.
TEST(Weld, time_stays_bounded_where_edges_are_far_below_the_tolerance) {
  TriangleMesh mesh;
  mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  mesh.triangles = {{0, 1, 2}};
  Random random(5);
  for (int i = 0; i < 200'000; ++i) {
    const auto base = static_cast<std::int32_t>(mesh.positions.size());
    const Vec3 place = random.in_cube(1e-6);
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(place + 1e-9 * Vec3(k == 1, k == 2, 0.0));
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
  EXPECT_EQ(welds_of(mesh, 1.0), 0);
}

// Found from the side that reaches less far, whichever comes first.
TEST(Weld, cracks_between_long_and_short_edges_are_found) {
  for (const bool is_turned : {false, true}) {
    TriangleMesh mesh;
    mesh.positions = {{0.0, 0.0, 0.0},         {1e-3, 0.0, 0.0},        {0.0, 1e-3, 0.0},
                      {1e-3 + 1e-7, 0.0, 0.0}, {0.0, 1e-3 + 1e-7, 0.0}, {1.0, 1.0, 0.0}};
    mesh.triangles = {{0, 1, 2}, {3, 5, 4}};
    if (is_turned) std::swap(mesh.triangles[0], mesh.triangles[1]);
    EXPECT_EQ(welds_of(mesh, 1.0), 2) << is_turned;
  }
}

TEST(Weld, time_stays_bounded_when_everything_is_in_one_place) {
  TriangleMesh mesh;
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const std::int32_t base = static_cast<std::int32_t>(mesh.positions.size());
    for (int k = 0; k < 3; ++k)
      mesh.positions.push_back(Vec3(k == 1, k == 2, 0.0) + random.in_cube(1e-7));
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
  EXPECT_GT(welds_of(mesh, 1.0), 0);
}

}  // namespace
}  // namespace thigma
