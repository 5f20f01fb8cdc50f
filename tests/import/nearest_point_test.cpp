#include "thigma/import/nearest_point.h"

#include <numeric>

#include "support/mesh_samples.h"
#include "support/triangle_search.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

Vec3 anywhere(Random& random, double size) {
  return size * Vec3(2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0,
                     2.0 * random.uniform() - 1.0);
}

double distance_by_loop(const Vec3& p, const test::Triangle& t) {
  double best = test::point_inside_triangle(p, t);
  for (std::size_t k = 0; k < 3; ++k)
    best = std::min(best, test::point_segment(p, t[k], t[(k + 1) % 3]));
  return best;
}

TriangleTree tree_of(const TriangleMesh& mesh) {
  std::vector<std::int32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return build_triangle_tree(mesh, std::move(all));
}

test::Triangle corners(const TriangleMesh& mesh, const std::array<std::int32_t, 3>& t) {
  const auto at = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
  return {at(0), at(1), at(2)};
}

TEST(NearestPoint, of_a_triangle_is_that_of_its_parts) {
  Random random(1);
  for (int round = 0; round < 20'000; ++round) {
    test::Triangle t{anywhere(random, 1.0), anywhere(random, 1.0), anywhere(random, 1.0)};
    if (round % 4 == 1) t[2] = t[0] + (0.3 + random.uniform()) * (t[1] - t[0]);  // a segment
    if (round % 4 == 2) t[2] = t[1];
    if (round % 4 == 3) t[2] = t[0] + random.uniform() * (t[1] - t[0]) + anywhere(random, 1e-9);
    const double scale = round % 3 == 0 ? 1e-40 : round % 3 == 1 ? 1.0 : 1e40;
    for (Vec3& p : t) p *= scale;
    const Vec3 p = scale * anywhere(random, 2.0);
    const Vec3 q = nearest_on_triangle(p, t[0], t[1], t[2]);
    EXPECT_NEAR((p - q).norm() / scale, distance_by_loop(p, t) / scale, 2e-9);
    EXPECT_LT(distance_by_loop(q, t), 1e-9 * scale);
  }
}

TEST(NearestPoint, of_a_surface_is_that_of_all_its_triangles) {
  Random random(2);
  const TriangleMesh mesh = make_hollow_ball(1.0, 0.5, 3);
  const TriangleTree tree = tree_of(mesh);
  for (int round = 0; round < 500; ++round) {
    const Vec3 p = anywhere(random, 1.5);
    double best = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles)
      best = std::min(best, distance_by_loop(p, corners(mesh, t)));
    const NearestPoint found = nearest_point(mesh, tree, p);
    EXPECT_NEAR(found.distance, best, 1e-12);
    EXPECT_NEAR((p - found.point).norm(), best, 1e-12);
    EXPECT_LT(nearest_point(mesh, tree, p, 0.99 * best).triangle, 0);
    EXPECT_GE(nearest_point(mesh, tree, p, 1.01 * best).triangle, 0);
  }
}

TEST(NearestPoint, the_largest_distance_lies_above_every_sample_and_near_the_largest) {
  Random random(3);
  const TriangleMesh ball = make_ball(1.0, 3);
  const TriangleTree tree = tree_of(ball);
  for (const Vec3& by : {Vec3(1, 1, 1), Vec3(1.2, 1, 0.7), Vec3(0.01, 0.02, 3)}) {
    const TriangleMesh other = test::stretched(make_ball(1.0, 3), by);
    std::vector<TrianglePiece> pieces;
    for (const auto& t : other.triangles) pieces.push_back(corners(other, t));
    const LargestDistance d = largest_distance(pieces, ball, tree, 1e-9);
    double sampled = 0.0;
    for (const TrianglePiece& t : pieces)
      for (int i = 0; i < 30; ++i) {
        double u = random.uniform(), v = random.uniform();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
        sampled = std::max(sampled, nearest_point(ball, tree, p).distance);
      }
    EXPECT_LE(sampled, d.bound + 1e-12);
    EXPECT_LE(d.met, d.bound);
    EXPECT_LE(d.bound, std::max(1.05 * d.met, 1e-9));
    EXPECT_GE(d.met + 1e-9, 0.9 * sampled);
  }
  EXPECT_EQ(largest_distance({}, ball, tree).bound, 0.0);
}

}  // namespace
}  // namespace thigma
