#include "thigma/import/shell.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "support/mesh_samples.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/import/inspect.h"
#include "thigma/import/read_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

constexpr double kCell = 0.1;

Vec3 anywhere(Random& random) {
  return {2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0};
}

// Everything that is wrong with scans and with assemblies, on a ball of radius 1: no triangle knows
// its neighbours, gaps between them, turned at random, some twice, rubbish inside.
TriangleMesh broken_ball(std::uint64_t seed) {
  Random random(seed);
  TriangleMesh mesh = unwelded(make_ball(1.0, 4));
  for (Vec3& p : mesh.positions) p += 0.01 * anywhere(random);
  for (auto& t : mesh.triangles)
    if (random.uniform() < 0.5) std::swap(t[0], t[1]);
  for (std::size_t i = 0; i < 40; ++i) mesh.triangles.push_back(std::array(mesh.triangles[7 * i]));
  for (int i = 0; i < 100; ++i) {
    const auto first = static_cast<std::int32_t>(mesh.positions.size());
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(0.5 * anywhere(random));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleTree tree_of(const TriangleMesh& mesh) {
  std::vector<std::int32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return build_triangle_tree(mesh, std::move(all));
}

// What a shell is, by inspection and by points all over both surfaces.
void expect_shell(const Shell& shell, const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(shell.mesh);
  EXPECT_EQ(report.verdict, MeshVerdict::usable);
  EXPECT_TRUE(report.closed && report.manifold && report.oriented);
  EXPECT_EQ(report.self_intersections, 0);
  EXPECT_TRUE(report.self_intersections_counted);
  EXPECT_EQ(report.degenerate_triangles, 0);
  EXPECT_GT(report.volume.value_or(-1.0), 0.0);
  EXPECT_LE(shell.to_mesh.bound, 1.3 * shell.cell);
  EXPECT_LE(shell.from_mesh.bound, 2.0 * shell.cell);
  const TriangleTree tree = tree_of(mesh), of_shell = tree_of(shell.mesh);
  double farthest = 0.0, deepest = 0.0;
  for (const auto& t : shell.mesh.triangles) {
    Vec3 middle = Vec3::Zero();
    for (const std::int32_t v : t)
      middle += shell.mesh.positions[static_cast<std::size_t>(v)] / 3.0;
    farthest = std::max(farthest, nearest_point(mesh, tree, middle).distance);
  }
  for (const Vec3& p : mesh.positions)
    deepest = std::max(deepest, nearest_point(shell.mesh, of_shell, p).distance);
  EXPECT_LE(farthest, shell.to_mesh.bound * (1.0 + 1e-9));
  EXPECT_LE(deepest, std::max(shell.from_mesh.bound, shell.hidden.bound) * (1.0 + 1e-9));
}

TEST(Shell, of_a_broken_ball_is_a_ball) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const TriangleMesh mesh = broken_ball(seed);
    EXPECT_NE(inspect_mesh(mesh).verdict, MeshVerdict::usable);
    const Shell shell = wrap_in_shell(mesh, "ball", {.cell = kCell});
    expect_shell(shell, mesh);
    const MeshReport report = inspect_mesh(shell.mesh);
    EXPECT_EQ(report.components, 1);
    EXPECT_NEAR(*report.volume, 4.0 / 3.0 * 3.14159265, 0.1);
    EXPECT_GT(shell.hidden_share, 0.02);  // the rubbish
    EXPECT_GT(shell.hidden.met, 0.4);
  }
}

TEST(Shell, keeps_corners_that_point_outwards) {
  const TriangleMesh box = make_box({1, 1, 1}, {1, 1, 1});
  const Shell shell = wrap_in_shell(box, "box", {.cell = kCell});
  expect_shell(shell, box);
  const TriangleTree tree = tree_of(shell.mesh);
  for (const Vec3& corner : box.positions)
    EXPECT_LT(nearest_point(shell.mesh, tree, corner).distance, 0.25 * shell.cell);
}

TEST(Shell, goes_around_sheets_strips_and_lines) {
  const TriangleMesh sheet = make_sheet(2.0, 1.0, 3, 3);
  const Shell thin = wrap_in_shell(sheet, "sheet", {.cell = kCell});
  expect_shell(thin, sheet);
  EXPECT_LT(*inspect_mesh(thin.mesh).volume, 2.0 * 0.3 * thin.cell);  // of the sheet's area
  for (const TriangleMesh& mesh :
       {make_moebius(1.0, 0.4, 24, 2), TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
        TriangleMesh{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}}},
        test::stretched(make_ball(1.0, 3), {1, 1, 0})}) {
    const Shell shell = wrap_in_shell(mesh, "part", {.cell = kCell});
    expect_shell(shell, mesh);
  }
}

TEST(Shell, of_random_triangles_is_sound) {
  Random random(11);
  for (int round = 0; round < 6; ++round) {
    TriangleMesh soup;
    for (std::int32_t i = 0; i < 60; ++i) {
      const Vec3 at = anywhere(random);
      for (int k = 0; k < 3; ++k) soup.positions.push_back(at + 0.4 * anywhere(random));
      soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    expect_shell(wrap_in_shell(soup, "soup", {.cell = 0.15}), soup);
  }
}

TEST(Shell, is_the_same_again_and_of_any_unit) {
  const TriangleMesh mesh = broken_ball(5);
  const Shell shell = wrap_in_shell(mesh, "ball", {.cell = 0.2});
  const Shell again = wrap_in_shell(mesh, "ball", {.cell = 0.2});
  EXPECT_EQ(shell.mesh.positions, again.mesh.positions);
  EXPECT_EQ(shell.mesh.triangles, again.mesh.triangles);
  for (const double scale : {0x1.0p-90, 0x1.0p90}) {
    const Shell other =
        wrap_in_shell(test::moved(mesh, Vec3::Zero(), scale), "ball", {.cell = 0.2});
    expect_shell(other, test::moved(mesh, Vec3::Zero(), scale));
    EXPECT_NEAR(other.to_mesh.bound / (scale * shell.to_mesh.bound), 1.0, 0.1);
  }
  const TriangleMesh far = test::moved(mesh, {1e7, -1e7, 1e7});
  expect_shell(wrap_in_shell(far, "far", {.cell = 0.2}), far);
}

TEST(Shell, progress_goes_up_to_one) {
  double last = 0.0;
  wrap_in_shell(make_ball(1.0, 3), "ball", {.cell = 0.2, .progress = [&](double share) {
                                              EXPECT_GE(share, last);
                                              last = share;
                                            }});
  EXPECT_EQ(last, 1.0);
}

TEST(Shell, what_cannot_be_wrapped_is_refused_with_a_reason) {
  const auto refusal = [](const TriangleMesh& mesh, double cell) -> std::string {
    try {
      wrap_in_shell(mesh, "part", {.cell = cell});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const TriangleMesh ball = make_ball(1.0, 3);
  for (const double cell : {0.0, -1.0, 0.6, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(refusal(ball, cell).find("of the radius, as given"), std::string::npos) << cell;
  EXPECT_NE(refusal(ball, 1e-4).find("lattice points"), std::string::npos);
  EXPECT_NE(refusal({}, 0.1).find("no triangle"), std::string::npos);
  EXPECT_NE(refusal({{{1, 2, 3}}, {{0, 0, 0}}}, 0.1).find("no triangle"), std::string::npos);
  EXPECT_NE(refusal(test::moved(ball, {1e15, 0, 0}), 0.1).find("nearer to the origin"),
            std::string::npos);
  // Vertices that no triangle uses are not wrapped.
  TriangleMesh stray = ball;
  stray.positions.emplace_back(1e6, 0, 0);
  EXPECT_NEAR(wrap_in_shell(stray, "part", {.cell = 0.2}).cell, 0.2, 1e-9);
}

TEST(Shell, the_largest_component_stays_alone) {
  const TriangleMesh ball = make_ball(1.0, 3);
  const TriangleMesh parts =
      joined(joined(test::moved(ball, {5, 0, 0}, 0.5), ball), make_moebius(0.3, 0.1, 24, 2));
  EXPECT_EQ(inspect_mesh(parts).verdict, MeshVerdict::rejected);
  const LargestComponent largest = keep_largest_component(parts);
  EXPECT_EQ(largest.left_out, 2);
  EXPECT_GT(largest.area_left_out, 0.2);
  EXPECT_EQ(inspect_mesh(largest.mesh).verdict, MeshVerdict::usable);
  EXPECT_EQ(largest.mesh.triangles.size(), ball.triangles.size());
  EXPECT_EQ(keep_largest_component({}).left_out, 0);
}

TEST(Shell, of_every_shared_mesh_is_sound) {
  THIGMA_NEEDS_SHARED(shared);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(shared / "meshes"))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_GE(files.size(), 16u);
  for (const auto& file : files) {
    SCOPED_TRACE(file);
    const MeshFile mesh = read_mesh(file.string());
    expect_shell(wrap_in_shell(mesh.mesh, file.string(), {.cell = 0.08}), mesh.mesh);
  }
}

}  // namespace
}  // namespace thigma
