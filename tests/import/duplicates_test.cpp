#include "thigma/import/duplicates.h"

#include <algorithm>
#include <array>
#include <map>

#include "support/mesh_samples.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/import/inspect.h"
#include "thigma/import/repair.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;

/// Triangles by their positions, the way round kept: equal for equal surfaces, however numbered.
std::vector<std::array<std::array<double, 3>, 3>> faces_of(const TriangleMesh& mesh) {
  std::vector<std::array<std::array<double, 3>, 3>> faces;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<double, 3>, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[idx(t[k])];
      face[k] = {p.x(), p.y(), p.z()};
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

enum class Copies { same, reversed, same_twice, reversed_twice, one_of_each };

void add_copies(TriangleMesh& mesh, std::size_t t, Copies how) {
  const Triangle face = mesh.triangles[t];
  const Triangle back{face[1], face[0], face[2]};
  if (how != Copies::reversed && how != Copies::reversed_twice) mesh.triangles.push_back(face);
  if (how == Copies::same_twice) mesh.triangles.push_back(face);
  if (how == Copies::reversed || how == Copies::reversed_twice || how == Copies::one_of_each)
    mesh.triangles.push_back(back);
  if (how == Copies::reversed_twice) mesh.triangles.push_back(back);
}

void shuffle(TriangleMesh& mesh, Random& random) {
  for (std::size_t i = mesh.triangles.size(); i > 1; --i)
    std::swap(mesh.triangles[i - 1], mesh.triangles[random.below(i)]);
}

void expect_restored(const TriangleMesh& damaged, const TriangleMesh& whole) {
  const MeshReport found = inspect_mesh(damaged, {.self_intersections = false});
  ASSERT_EQ(found.verdict, MeshVerdict::repairable)
      << (found.reasons.empty() ? "usable" : found.reasons.front());
  const RepairResult result = repair_mesh(damaged, "part");
  EXPECT_EQ(faces_of(result.mesh), faces_of(whole));
  const MeshReport before = inspect_mesh(whole, {.self_intersections = false});
  const MeshReport after = inspect_mesh(result.mesh, {.self_intersections = false});
  EXPECT_EQ(after.verdict, MeshVerdict::usable);
  EXPECT_EQ(after.boundary_edges, before.boundary_edges);
  EXPECT_NEAR(after.area, before.area, 1e-12 * before.area);
  ASSERT_EQ(after.volume.has_value(), before.volume.has_value());
  if (before.volume) {
    EXPECT_NEAR(*after.volume, *before.volume, 1e-12 * *before.volume);
  }
}

/// Triangles reached over edges from a first one, breadth first.
std::vector<std::size_t> neighbours(const TriangleMesh& mesh, std::size_t first,
                                    std::size_t count) {
  const EdgeTable table = build_edge_table(mesh);
  std::vector<bool> is_reached(mesh.triangles.size(), false);
  std::vector<std::size_t> reached(1, first);
  is_reached[first] = true;
  for (std::size_t i = 0; i < reached.size() && reached.size() < count; ++i)
    for (const std::int32_t e : table.of_triangle[reached[i]])
      for (const EdgeUse& use : table.uses_of(table.edges[idx(e)]))
        if (!is_reached[idx(use.triangle)]) {
          is_reached[idx(use.triangle)] = true;
          reached.push_back(idx(use.triangle));
        }
  reached.resize(std::min(reached.size(), count));
  return reached;
}

TEST(Duplicates, copies_are_grouped_and_counted_either_way_round) {
  TriangleMesh mesh = make_box({1, 1, 1}, {1, 1, 1});
  add_copies(mesh, 2, Copies::reversed);
  add_copies(mesh, 5, Copies::reversed_twice);
  add_copies(mesh, 7, Copies::same);
  const DistinctFaces faces = list_distinct_faces(mesh);
  ASSERT_EQ(faces.triangle.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(faces.triangle[i], static_cast<std::int32_t>(i));
    EXPECT_EQ(faces.copies[i], i == 2 || i == 7 ? 2 : i == 5 ? 3 : 1);
    EXPECT_EQ(faces.net[i], i == 2 ? 0 : i == 5 ? -1 : i == 7 ? 2 : 1);
  }
}

TEST(Duplicates, a_doubled_region_of_a_ball_leaves_the_ball) {
  const TriangleMesh ball = make_ball(1.0, 4);
  ASSERT_EQ(ball.triangles.size(), 320u);
  for (const Copies how : {Copies::same, Copies::reversed, Copies::same_twice,
                           Copies::reversed_twice, Copies::one_of_each}) {
    SCOPED_TRACE(static_cast<int>(how));
    TriangleMesh doubled = ball;
    for (const std::size_t t : neighbours(ball, 17, 88)) add_copies(doubled, t, how);
    expect_restored(doubled, ball);
    std::reverse(doubled.triangles.begin(), doubled.triangles.end());
    expect_restored(doubled, ball);
  }
}

TEST(Duplicates, a_mesh_of_every_face_twice_leaves_the_mesh) {
  for (const TriangleMesh& whole :
       {make_ball(1.0, 4), make_torus(1.0, 0.4, 12, 8), make_box({1, 1, 1}, {2, 2, 2})})
    for (const Copies how : {Copies::same, Copies::reversed, Copies::same_twice,
                             Copies::reversed_twice, Copies::one_of_each}) {
      SCOPED_TRACE(static_cast<int>(how));
      TriangleMesh doubled = whole;
      for (std::size_t t = 0; t < whole.triangles.size(); ++t) add_copies(doubled, t, how);
      expect_restored(doubled, whole);
      std::reverse(doubled.triangles.begin(), doubled.triangles.end());
      expect_restored(doubled, whole);
    }
}

TriangleMesh closed_sample(Random& random) {
  switch (random.below(5)) {
    case 0:
      return make_ball(1.0, 2 + static_cast<int>(random.below(4)));
    case 1:
      return make_torus(1.0, 0.4, 8 + static_cast<int>(random.below(8)), 6);
    case 2:
      return make_hollow_ball(1.0, 0.5, 2);
    case 3:
      return make_box({1, 2, 3}, {2, 3, 1 + static_cast<int>(random.below(4))});
    default:
      return joined(make_ball(1.0, 2), test::moved(make_torus(1.0, 0.3, 9, 5), {3, 0, 0}));
  }
}

TEST(Duplicates, random_sets_of_doubled_faces_leave_the_surface) {
  for (int number = 0; number < 300; ++number) {
    SCOPED_TRACE(number);
    Random random(400 + static_cast<std::uint64_t>(number));
    TriangleMesh whole = closed_sample(random);
    const double scale = std::array{1.0, 1e-9, 1e3}[random.below(3)];
    for (Vec3& p : whole.positions) p *= scale;
    TriangleMesh doubled = whole;
    const std::size_t n = whole.triangles.size();
    // Scattered, or in one region; always the same way, or each face its own.
    std::vector<std::size_t> chosen;
    const std::uint64_t rarity = 1 + random.below(5);
    if (random.below(2) == 0) {
      chosen = neighbours(whole, random.below(n), 1 + random.below(n / 2));
    } else {
      for (std::size_t t = 0; t < n; ++t)
        if (random.below(rarity + 1) != 0) chosen.push_back(t);
    }
    const bool is_mixed = random.below(2) == 0;
    const auto one_way = static_cast<Copies>(random.below(5));
    if (chosen.empty()) chosen.push_back(0);
    for (const std::size_t t : chosen)
      add_copies(doubled, t, is_mixed ? static_cast<Copies>(random.below(5)) : one_way);
    shuffle(doubled, random);
    expect_restored(doubled, whole);
  }
}

/// Two triangles upright on one edge of a surface around the origin.
TriangleMesh fin_of(const TriangleMesh& box, std::size_t triangle, std::size_t side,
                    double height) {
  TriangleMesh fin;
  fin.positions = box.positions;
  const std::int32_t a = box.triangles[triangle][side];
  const std::int32_t b = box.triangles[triangle][(side + 1) % 3];
  const auto base = static_cast<std::int32_t>(fin.positions.size());
  for (const std::int32_t v : {a, b})
    fin.positions.push_back(box.positions[idx(v)] * (1.0 + height));
  fin.triangles = {{a, b, base}, {b, base + 1, base}};
  return fin;
}

TEST(Duplicates, fins_of_several_faces_go_wherever_the_surface_is_doubled) {
  const TriangleMesh ball = make_ball(1.0, 4);
  for (const bool is_doubled : {false, true})
    for (const int count : {1, 2, 3}) {
      SCOPED_TRACE(count);
      TriangleMesh mesh = ball;
      for (int i = 0; i < count; ++i) {  // all along one edge
        const TriangleMesh fin = fin_of({mesh.positions, ball.triangles}, 100, 0, 0.2 * (i + 1));
        mesh.positions = fin.positions;
        for (const Triangle& t : fin.triangles) {
          mesh.triangles.push_back(t);
          mesh.triangles.push_back({t[1], t[0], t[2]});
        }
      }
      if (is_doubled)
        for (const std::size_t t : neighbours(ball, 100, 88)) add_copies(mesh, t, Copies::reversed);
      expect_restored(mesh, ball);
    }
}

TEST(Duplicates, a_wall_between_two_touching_boxes_goes) {
  const TriangleMesh box = make_box({1, 1, 1}, {2, 2, 2});
  const TriangleMesh both = joined(box, test::moved(box, {1, 0, 0}));
  const MeshReport r = inspect_mesh(repair_mesh(both, "part").mesh);
  EXPECT_EQ(r.verdict, MeshVerdict::usable);
  EXPECT_TRUE(r.closed);
  EXPECT_EQ(r.components, 1);
  EXPECT_NEAR(*r.volume, 2.0, 1e-12);
}

TEST(Duplicates, a_sheet_seen_from_both_sides_keeps_the_side_that_its_single_faces_have) {
  const TriangleMesh sheet = make_sheet(1, 1, 8, 8);
  TriangleMesh mesh;
  mesh.positions = sheet.positions;
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {  // the reversed copy first
    const Triangle& f = sheet.triangles[t];
    if (t % 5 != 0) mesh.triangles.push_back({f[1], f[0], f[2]});
    mesh.triangles.push_back(f);
  }
  expect_restored(mesh, sheet);
}

TEST(Duplicates, a_sheet_written_twice_is_a_sheet_and_one_with_its_own_back_has_no_volume) {
  const TriangleMesh sheet = make_sheet(1, 1, 4, 4);
  TriangleMesh twice = sheet, folded = sheet;
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    add_copies(twice, t, Copies::same);
    add_copies(folded, t, Copies::reversed);
  }
  expect_restored(twice, sheet);
  // Neither side is more the sheet's than the other, and closed it encloses nothing.
  const MeshReport r = inspect_mesh(folded);
  EXPECT_EQ(r.verdict, MeshVerdict::rejected);
  EXPECT_EQ(r.zero_volume_components, 1);
  EXPECT_THROW(repair_mesh(folded, "part"), InputError);
}

TEST(Duplicates, a_doubled_strip_without_sides_is_rejected_as_the_strip_is) {
  TriangleMesh mesh = make_moebius(1.0, 0.3, 20);
  const std::size_t n = mesh.triangles.size();
  for (std::size_t t = 0; t < n; ++t) add_copies(mesh, t, Copies::same);
  EXPECT_EQ(inspect_mesh(mesh).verdict, MeshVerdict::rejected);
  EXPECT_EQ(inspect_mesh(mesh).nonorientable_components, 1);
}

TEST(Duplicates, where_all_sheets_at_an_edge_are_double_none_is_a_fin) {
  // Three half planes that meet in a line, each with its back, and one single face beyond.
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  for (std::size_t t = 0; t < 3; ++t) add_copies(mesh, t, Copies::reversed);
  const auto fins = [&] {
    const std::vector<bool> is_fin = find_fins(mesh, list_distinct_faces(mesh));
    return std::count(is_fin.begin(), is_fin.end(), true);
  };
  EXPECT_EQ(fins(), 0);
  // Once two of them are a surface for certain, the third is a fin on it.
  mesh.triangles.push_back({0, 1, 2});
  mesh.triangles.push_back({1, 0, 3});
  EXPECT_EQ(fins(), 1);
}

}  // namespace
}  // namespace thigma
