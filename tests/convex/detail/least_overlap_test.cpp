#include "thigma/convex/detail/least_overlap.h"

#include <cmath>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

#include "thigma/math/infinity.h"
#include "thigma/mesh/shapes.h"

namespace thigma::detail {
namespace {

// Whether a unit direction is a sum of positive parts of two others, to rounding.
bool is_between(const Vec3& n, const Vec3& from, const Vec3& to) {
  const Vec3 pole = from.cross(to);
  return std::fabs(n.dot(pole)) <= 1e-9 && from.cross(n).dot(pole) >= 0.0 &&
         n.cross(to).dot(pole) >= 0.0;
}

// Directions an edge allows: between its faces, at a border up to a slope of 0.3 outwards.
bool is_allowed(const test::MeshPatch& patch, const RealEdge& e, const Vec3& n) {
  const Vec3 from = patch.faces[static_cast<std::size_t>(e.face_left)].normal;
  if (e.face_right >= 0)
    return is_between(n, from, patch.faces[static_cast<std::size_t>(e.face_right)].normal);
  const Vec3 along = (patch.points[e.head] - patch.points[e.tail]).normalized();
  return is_between(n, from, (from + 0.3 * along.cross(from)).normalized());
}

// Every face and every cross of edges, each with its extent.
double search_all(const test::MeshPatch& a, const test::MeshPatch& b, const RelativePose& x,
                  bool checks_arcs) {
  const HullView va = a.view(), vb = b.view();
  const PlacedPair pair({va, vb, x});
  double least = kInfinity;
  const auto offer = [&](const Vec3& n) {
    double top = -kInfinity, bottom = kInfinity;
    for (const Vec3& p : a.points) top = std::max(top, n.dot(p));
    for (const Vec3& p : b.points) bottom = std::min(bottom, n.dot(x.rotation * p + x.translation));
    least = std::min(least, top - bottom);
  };
  for (const RealFace& f : a.faces) offer(f.normal);
  for (const RealFace& f : b.faces) offer(-(x.rotation * f.normal));
  for (const RealEdge& ea : a.edges) {
    for (const RealEdge& eb : b.edges) {
      const Vec3 cross = (a.points[ea.head] - a.points[ea.tail])
                             .cross(x.rotation * (b.points[eb.head] - b.points[eb.tail]));
      if (cross.norm() < 1e-9) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vec3 n = sign * cross.normalized();
        if (!checks_arcs ||
            (is_allowed(a, ea, n) && is_allowed(b, eb, -(x.rotation.transpose() * n))))
          offer(n);
      }
    }
  }
  return least;
}

TEST(LeastOverlap, OfClosedHullsIsTheLeastOfAllSeparatingAxes) {
  const test::MeshPatch ball = test::ball_cap(1, -2.0);
  const TriangleMesh cube = make_box(Vec3(1.0, 0.7, 1.4));
  const test::MeshPatch box =
      test::make_patch(cube.positions, cube.triangles, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  Random random(5);
  for (int trial = 0; trial < 300; ++trial) {
    const test::MeshPatch &a = trial % 2 == 0 ? ball : box, &b = trial % 3 == 0 ? ball : box;
    const RelativePose x = test::random_pose(0.8, random);
    const HullView va = a.view(), vb = b.view();
    const WayOut out = least_overlap(PlacedPair({va, vb, x}), nullptr);
    ASSERT_NEAR(out.overlap, search_all(a, b, x, false), 1e-9) << trial;
    ASSERT_NEAR(out.normal.norm(), 1.0, 1e-12);
  }
}

TEST(LeastOverlap, OfOpenPatchesIsTheLeastOfTheAllowedDirections) {
  const test::MeshPatch patches[] = {test::ball_cap(2, 0.1), test::ball_cap(2, 0.5),
                                     test::ball_cap(1, -0.4)};
  Random random(6);
  int edges = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const test::MeshPatch &a = patches[trial % 3], &b = patches[trial / 3 % 3];
    RelativePose x = test::random_pose(0.3, random);
    x.translation += Vec3(0.0, 0.0, trial % 2 == 0 ? 1.5 : 0.0);
    const HullView va = a.view(), vb = b.view();
    const PlacedPair pair({va, vb, x});
    const WayOut out = least_overlap(pair, nullptr);
    ASSERT_NEAR(out.overlap, search_all(a, b, x, true), 1e-9) << trial;
    bool is_face = false;
    for (const RealFace& f : a.faces) is_face |= f.normal.dot(out.normal) > 1.0 - 1e-12;
    for (const RealFace& f : b.faces)
      is_face |= (x.rotation * f.normal).dot(-out.normal) > 1.0 - 1e-12;
    edges += !is_face;
  }
  EXPECT_GT(edges, 100);
}

TEST(LeastOverlap, StaysNearARememberedDirection) {
  const test::MeshPatch a = test::ball_cap(2, 0.1), b = test::ball_cap(1, -0.4);
  Random random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const RelativePose x = test::random_pose(0.5, random);
    const HullView va = a.view(), vb = b.view();
    const PlacedPair pair({va, vb, x});
    const WayOut least = least_overlap(pair, nullptr);
    const Vec3 last = (least.normal + 0.05 * random.direction()).normalized();
    const WayOut kept = least_overlap(pair, &last);
    EXPECT_LE(kept.overlap, 1.05 * least.overlap * (1.0 + 1e-12));
    EXPECT_GE(kept.normal.dot(last), least.normal.dot(last));
  }
}

}  // namespace
}  // namespace thigma::detail
