#include "thigma/import/inspect.h"

#include <limits>

#include "support/mesh_samples.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

bool says(const std::vector<std::string>& lines, const char* part) {
  for (const std::string& line : lines) {
    if (line.find(part) != std::string::npos) return true;
  }
  return false;
}

void expect_verdict(const TriangleMesh& mesh, MeshVerdict verdict, const char* reason) {
  const MeshReport r = inspect_mesh(mesh);
  EXPECT_EQ(r.verdict, verdict) << (r.reasons.empty() ? reason : r.reasons.front());
  EXPECT_TRUE(verdict == MeshVerdict::usable || says(r.reasons, reason))
      << (r.reasons.empty() ? "-" : r.reasons.front());
}

TEST(Inspect, usable_are_closed_and_open_shapes_of_any_size_and_place) {
  for (const double scale : {1e-9, 1e-3, 1.0, 1e9}) {
    for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1e7, -1e7, 3e6)}) {
      for (const TriangleMesh& shape :
           {make_ball(1.0, 8), make_box({1, 2, 3}, {2, 3, 4}), make_torus(1.0, 0.3, 30, 12),
            make_sheet(1.0, 1.0, 20, 20), make_hollow_ball(1.0, 0.5, 4)}) {
        expect_verdict(test::moved(shape, at * scale, scale), MeshVerdict::usable, "usable");
      }
    }
  }
  expect_verdict(test::stretched(make_ball(1.0, 6), {1.0, 1.0, 1e-6}), MeshVerdict::usable,
                 "usable");
  expect_verdict(test::stretched(make_ball(1.0, 6), {1.0, 1e-6, 1e-6}), MeshVerdict::usable,
                 "usable");
  expect_verdict(test::stretched(make_box({1, 1, 1}, {8, 8, 8}), {1.0, 1.0, 1e-6}),
                 MeshVerdict::usable, "usable");
  expect_verdict(test::stretched(make_sheet(1, 1, 50, 3), {1.0, 1e-6, 1.0}), MeshVerdict::usable,
                 "usable");
  expect_verdict(joined(make_ball(1.0, 5), test::moved(make_ball(1.0, 5), {0.7, 0, 0})),
                 MeshVerdict::usable, "usable");
}

TEST(Inspect, rejected_are_meshes_without_sense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_verdict({}, MeshVerdict::rejected, "no triangle");
  expect_verdict({{Vec3(0, 0, 0)}, {{0, 0, 0}}}, MeshVerdict::rejected, "no triangle");
  expect_verdict({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, {{0, 1, 2}}},
                 MeshVerdict::rejected, "area");
  expect_verdict({{Vec3(0, 0, 0), Vec3(1, nan, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}},
                 MeshVerdict::rejected, "not finite");
  expect_verdict({{Vec3(0, 0, 0), Vec3(1e200, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}},
                 MeshVerdict::rejected, "range");
  expect_verdict({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 3}}},
                 MeshVerdict::rejected, "does not exist");
  expect_verdict({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, -1}}},
                 MeshVerdict::rejected, "does not exist");
  expect_verdict(make_moebius(1.0, 0.3, 20, 2), MeshVerdict::rejected, "cannot be oriented");
  expect_verdict(joined(make_ball(1.0, 3), test::moved(make_moebius(1.0, 0.3, 20), {5, 0, 0})),
                 MeshVerdict::rejected, "cannot be oriented");
}

TEST(Inspect, a_closed_surface_without_volume_is_rejected_wherever_it_is) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const TriangleMesh flat = test::stretched(make_ball(scale, 6), {1.0, 1.0, 0.0});
    expect_verdict(flat, MeshVerdict::rejected, "no volume");
    // Tilted and far away: its volume is rounding and nothing else.
    Pose pose;
    pose.orientation = Quat(0.6, 0.3, -0.5, 0.55).normalized();
    pose.position = Vec3(1e7, 2e7, -1e7) * scale;
    expect_verdict(transformed(flat, pose), MeshVerdict::rejected, "no volume");
    expect_verdict(test::stretched(make_box({scale, scale, scale}), {1, 1, 0}),
                   MeshVerdict::rejected, "no volume");
  }
}

TEST(Inspect, repairable_are_the_defects_repair_knows) {
  const TriangleMesh box = make_box({1, 1, 1}, {3, 3, 3});
  TriangleMesh twice = box;
  twice.triangles.push_back(twice.triangles[5]);
  expect_verdict(twice, MeshVerdict::repairable, "1 triangle repeats another");
  TriangleMesh fin = box;
  fin.positions.emplace_back(0, 0, 3);
  fin.triangles.push_back({fin.triangles[0][0], fin.triangles[0][1],
                           static_cast<std::int32_t>(fin.positions.size()) - 1});
  expect_verdict(fin, MeshVerdict::repairable, "1 edge has three or more faces");
  expect_verdict(joined(make_box({1, 1, 1}), test::moved(make_box({1, 1, 1}), {1, 1, 1})),
                 MeshVerdict::repairable, "1 vertex joins more than one fan");
  TriangleMesh mixed = make_ball(1.0, 4);
  for (std::size_t t = 0; t < mixed.triangles.size() / 2; ++t)
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  expect_verdict(mixed, MeshVerdict::repairable, "opposite orientation");
  for (const double scale : {1e-9, 1.0, 1e9}) {
    expect_verdict(flipped(make_ball(scale, 4)), MeshVerdict::repairable,
                   "1 closed component is inside out");
    TriangleMesh soup = unwelded(make_ball(scale, 4));
    for (std::size_t i = 0; i < soup.positions.size(); ++i)
      soup.positions[i].x() += 1e-7 * scale * static_cast<double>(i % 3);
    expect_verdict(soup, MeshVerdict::repairable, "nearly equal others");
  }
}

TEST(Inspect, an_inside_out_component_is_a_cavity_only_inside_another) {
  const TriangleMesh ball = make_ball(1.0, 5);
  const TriangleMesh small = flipped(test::moved(ball, {0.1, 0.2, 0.1}, 0.3));
  expect_verdict(joined(ball, small), MeshVerdict::usable, "usable");
  expect_verdict(joined(ball, test::moved(small, {3, 0, 0})), MeshVerdict::repairable,
                 "inside out");
  // Beside it in a box whose faces are level with its own: the search must not be fooled by
  // grazing.
  const TriangleMesh box = make_box({1, 1, 1}, {2, 2, 2});
  expect_verdict(joined(box, flipped(test::moved(box, {1.5, 0, 0}))), MeshVerdict::repairable,
                 "inside out");
  expect_verdict(joined(box, flipped(test::moved(box, {0.25, 0, 0}, 0.25))), MeshVerdict::usable,
                 "usable");
  // An open bowl around it encloses nothing.
  expect_verdict(joined(make_dome(3.0, 24, 8), test::moved(small, {0, 0, 1})),
                 MeshVerdict::repairable, "inside out");
}

TEST(Inspect, an_exact_soup_is_whole_after_reading) {
  const MeshReport r = inspect_mesh(unwelded(make_ball(1.0, 4)));
  EXPECT_EQ(r.verdict, MeshVerdict::usable);
  EXPECT_TRUE(r.closed);
  EXPECT_EQ(r.vertices, 162);
  EXPECT_EQ(r.vertices_in_file, 960);
}

TEST(Inspect, measures_are_there_when_they_mean_something) {
  const MeshReport ball = inspect_mesh(make_ball(1.0, 8));
  ASSERT_TRUE(ball.volume && ball.center_of_mass && ball.inertia);
  EXPECT_GT(*ball.volume, 4.0);
  EXPECT_NEAR(ball.radius, 1.0, 1e-9);
  const MeshReport sheet = inspect_mesh(make_sheet(1.0, 2.0, 3, 3));
  EXPECT_FALSE(sheet.volume || sheet.center_of_mass || sheet.inertia);
  EXPECT_NEAR(sheet.area, 2.0, 1e-14);
  EXPECT_TRUE(says(sheet.warnings, "open"));
}

TEST(Inspect, warnings_name_what_to_look_at) {
  EXPECT_TRUE(inspect_mesh(make_ball(1.0, 4)).warnings.empty());
  EXPECT_TRUE(says(inspect_mesh(make_ball(100.0, 4)).warnings, "--scale 0.001"));
  EXPECT_TRUE(says(inspect_mesh(make_ball(1e-9, 4)).warnings, "unit"));
  EXPECT_TRUE(
      says(inspect_mesh(test::moved(make_ball(1.0, 4), {1e7, 0, 0})).warnings, "radii away"));
  EXPECT_TRUE(says(inspect_mesh(test::stretched(make_ball(1.0, 4), {1, 1e-8, 1e-8})).warnings,
                   "volume") == false);
  EXPECT_TRUE(says(
      inspect_mesh(joined(make_ball(1, 5), test::moved(make_ball(1, 5), {0.7, 0, 0}))).warnings,
      "pairs of triangles"));
}

TEST(Inspect, options_skip_the_slow_count_and_nothing_else) {
  const TriangleMesh two = joined(make_ball(1.0, 5), test::moved(make_ball(1.0, 5), {0.7, 0, 0}));
  const MeshReport r = inspect_mesh(two, {.self_intersections = false});
  EXPECT_EQ(r.verdict, MeshVerdict::usable);
  EXPECT_FALSE(r.self_intersections_counted);
  EXPECT_EQ(r.self_intersections, 0);
}

// MANIFEST.md of the shared meshes, counted by another program.
struct Known {
  const char* file;
  std::int64_t triangles, vertices, vertices_in_file, boundary, edges, fans, pairs, zero_area,
      duplicates, components;
  MeshVerdict verdict;
};

constexpr MeshVerdict kUsable = MeshVerdict::usable;
constexpr MeshVerdict kRepairable = MeshVerdict::repairable;

const Known kKnown[] = {
    {"a01_dental_cast_upper.obj", 24992, 12530, 14730, 0, 0, 0, 2032, 0, 0, 17, kUsable},
    {"a02_dental_cast_lower.obj", 23008, 11538, 13810, 0, 0, 0, 2164, 0, 0, 17, kUsable},
    {"a03_femur_right.obj", 40000, 20002, 20002, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a04_hip_bone_right_mirrored.obj", 50000, 25000, 25000, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a05_gear_large_60t.obj", 50566, 25164, 25281, 0, 0, 0, 0, 234, 0, 1, kUsable},
    {"a06_gear_medium_40t.obj", 35212, 17557, 17604, 0, 0, 0, 17, 96, 0, 1, kUsable},
    {"a07_bolt_m16_loose.obj", 25668, 12836, 22326, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a08_nut_m16_loose.obj", 15080, 7566, 13106, 108, 0, 12, 172, 32, 0, 2, kRepairable},
    {"a09_round_peg_16mm.obj", 24768, 12386, 12386, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a10_round_socket_tray_16mm.obj", 29388, 14688, 14688, 0, 0, 0, 328, 0, 0, 1, kUsable},
    {"a11_spoon_ycb.obj", 16384, 8179, 8180, 0, 1, 0, 1, 2, 1, 1, kRepairable},
    {"a12_mug_ycb.obj", 16384, 8185, 8188, 0, 3, 0, 16, 6, 3, 1, kRepairable},
    {"a13_hammer_scan.obj", 60160, 30082, 30082, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a14_skull.obj", 100002, 49999, 49999, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a15_koala.obj", 99994, 49999, 49999, 0, 0, 0, 0, 0, 0, 1, kUsable},
    {"a16_mountain_open.obj", 50562, 25600, 25600, 636, 0, 0, 0, 0, 0, 1, kUsable},
};

TEST(Inspect, the_shared_meshes_are_as_their_manifest_says) {
  THIGMA_NEEDS_SHARED(folder);
  for (const Known& k : kKnown) {
    SCOPED_TRACE(k.file);
    const std::string path = folder / "meshes" / k.file;
    const MeshReport r = inspect_mesh(read_mesh(path), path);
    EXPECT_EQ(r.triangles, k.triangles);
    EXPECT_EQ(r.vertices, k.vertices);
    EXPECT_EQ(r.vertices_in_file, k.vertices_in_file);
    EXPECT_EQ(r.boundary_edges, k.boundary);
    EXPECT_EQ(r.nonmanifold_edges, k.edges);
    EXPECT_EQ(r.nonmanifold_vertices, k.fans);
    EXPECT_EQ(r.misoriented_edges, 0);
    EXPECT_EQ(r.self_intersections, k.pairs);
    EXPECT_TRUE(r.self_intersections_counted);
    EXPECT_EQ(r.degenerate_triangles, k.zero_area);
    EXPECT_EQ(r.duplicate_triangles, k.duplicates);
    EXPECT_EQ(r.components, k.components);
    EXPECT_EQ(r.unwelded_vertices, 0);
    EXPECT_EQ(r.verdict, k.verdict);
    EXPECT_EQ(r.format, "obj");
  }
}

}  // namespace
}  // namespace thigma
