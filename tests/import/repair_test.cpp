#include "thigma/import/repair.h"

#include "support/mesh_samples.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/import/inspect.h"
#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

// Repairs, then looks at what a reader of the written file would find.
MeshReport repaired(const TriangleMesh& mesh, std::size_t least_repairs = 1) {
  const RepairResult result = repair_mesh(mesh, "part");
  EXPECT_GE(result.repairs.size(), least_repairs);
  const MeshReport report =
      inspect_mesh(parse_mesh(format_mesh(result.mesh, MeshFormat::obj, "x"), "x"), "x");
  EXPECT_EQ(report.verdict, MeshVerdict::usable)
      << (report.reasons.empty() ? "" : report.reasons.front());
  return report;
}

TEST(Repair, a_usable_mesh_stays_as_it_is) {
  const TriangleMesh ball = make_ball(1.0, 4);
  const RepairResult result = repair_mesh(ball, "part");
  EXPECT_TRUE(result.repairs.empty());
  EXPECT_EQ(result.mesh.positions, ball.positions);
  EXPECT_EQ(result.mesh.triangles, ball.triangles);
}

TEST(Repair, turned_triangles_and_inside_out_components_come_back) {
  const TriangleMesh ball = make_ball(1.0, 4);
  const double volume = *inspect_mesh(ball).volume;
  TriangleMesh mixed = ball;
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  EXPECT_NEAR(*repaired(mixed).volume, volume, 1e-14);
  TriangleMesh mostly = ball;
  for (std::size_t t = 0; t < mostly.triangles.size(); ++t) {
    if (t % 3 != 0) std::swap(mostly.triangles[t][0], mostly.triangles[t][1]);
  }
  EXPECT_NEAR(*repaired(mostly).volume, volume, 1e-14);
  EXPECT_NEAR(*repaired(flipped(ball)).volume, volume, 1e-14);
  // The cavity stays one.
  const TriangleMesh hollow = make_hollow_ball(1.0, 0.5, 4);
  const double shell = *inspect_mesh(hollow).volume;
  EXPECT_NEAR(*repaired(joined(hollow, flipped(test::moved(ball, {5, 0, 0})))).volume,
              shell + volume, 1e-12);
}

TEST(Repair, a_noisy_soup_becomes_closed) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const TriangleMesh ball = make_ball(scale, 4);
    TriangleMesh soup = unwelded(ball);
    for (std::size_t i = 0; i < soup.positions.size(); ++i)
      soup.positions[i].y() += 1e-7 * scale * static_cast<double>(i % 4);
    const MeshReport r = repaired(soup);
    EXPECT_TRUE(r.closed);
    EXPECT_EQ(r.vertices, static_cast<std::int64_t>(ball.positions.size()));
  }
}

TEST(Repair, duplicates_go_without_leaving_a_hole) {
  TriangleMesh twice = make_box({1, 1, 1}, {3, 3, 3});
  const std::size_t before = twice.triangles.size();
  twice.triangles.push_back(twice.triangles[5]);
  twice.triangles.push_back(flipped(twice).triangles[9]);
  const MeshReport r = repaired(twice);
  EXPECT_TRUE(r.closed);
  EXPECT_EQ(r.triangles, static_cast<std::int64_t>(before));
}

TEST(Repair, a_doubled_fin_goes_and_a_single_one_stands_apart) {
  TriangleMesh box = make_box({1, 1, 1}, {3, 3, 3});
  const std::size_t before = box.triangles.size();
  box.positions.emplace_back(0, 0, 3);
  const std::int32_t tip = static_cast<std::int32_t>(box.positions.size()) - 1;
  TriangleMesh single = box;
  single.triangles.push_back({box.triangles[0][0], box.triangles[0][1], tip});
  TriangleMesh doubled = single;
  doubled.triangles.push_back({box.triangles[0][1], box.triangles[0][0], tip});
  const MeshReport one = repaired(single);
  EXPECT_EQ(one.components, 2);
  EXPECT_EQ(one.boundary_edges, 3);
  const MeshReport two = repaired(doubled);
  EXPECT_TRUE(two.closed);
  EXPECT_EQ(two.triangles, static_cast<std::int64_t>(before));
}

TEST(Repair, solids_that_touch_are_parted) {
  const TriangleMesh box = make_box({1, 1, 1}, {2, 2, 2});
  for (const Vec3& at : {Vec3(1, 1, 1), Vec3(1, 1, 0)}) {  // at a corner, along an edge
    for (const double scale : {1e-9, 1.0, 1e9}) {
      const MeshReport r =
          repaired(test::moved(joined(box, test::moved(box, at)), Vec3::Zero(), scale));
      EXPECT_TRUE(r.closed);
      EXPECT_EQ(r.components, 2);
      EXPECT_NEAR(*r.volume / (scale * scale * scale), 2.0, 1e-4);
      EXPECT_EQ(r.self_intersections, 0);
    }
  }
}

TEST(Repair, a_ring_that_touches_itself_along_an_edge_is_parted) {
  // Blocks around a hole; the first and the last touch along one edge only, so both sides of it are
  // one surface.
  const std::array<double, 4> xs{0, 1, 2, 3};
  const std::array<double, 2> zs{0, 1};
  const TriangleMesh ring = make_blocks(xs, xs, zs, [](int i, int j, int) {
    return !(i == 1 && j == 1) && !(i == 0 && j == 0) && !(i == 2 && j == 1) && !(i == 1 && j == 0);
  });
  const MeshReport before = inspect_mesh(ring);
  const MeshReport after = repaired(ring, before.verdict == MeshVerdict::usable ? 0 : 1);
  EXPECT_TRUE(after.closed);
}

TEST(Repair, what_is_rejected_is_refused_with_its_reason) {
  for (const TriangleMesh& mesh : {make_moebius(1.0, 0.3, 20), TriangleMesh{},
                                   test::stretched(make_ball(1.0, 4), {1, 1, 0})}) {
    try {
      repair_mesh(mesh, "part.obj");
      FAIL() << "repaired";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("part.obj: ", 0), 0u);
    }
  }
}

TEST(Repair, the_shared_repairable_meshes_become_usable) {
  THIGMA_NEEDS_SHARED(folder);
  for (const char* name : {"a08_nut_m16_loose.obj", "a11_spoon_ycb.obj", "a12_mug_ycb.obj"}) {
    SCOPED_TRACE(name);
    const MeshFile file = read_mesh(folder / "meshes" / name);
    const MeshReport before = inspect_mesh(file, name);
    const MeshReport after = repaired(file.mesh);
    EXPECT_EQ(after.boundary_edges, before.boundary_edges);
    EXPECT_LE(after.self_intersections, before.self_intersections);
    EXPECT_NEAR(after.area, before.area, 1e-3 * before.area);
  }
}

}  // namespace
}  // namespace thigma
