#include "thigma/convex/patch_separation.h"

#include <cmath>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

#include "thigma/convex/triangle_distance.h"
#include "thigma/math/infinity.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

// Two open bowls (lower halves of an octahedron): their hulls have a virtual lid.
struct Bowl {
  std::vector<Vec3> p{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  test::Triangles t{{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
  test::MeshPatch patch = test::make_patch(p, t, {0, 1, 2, 3});
};

TEST(PatchSeparation, IsThatOfTheTrianglesNotOfTheHull) {
  const Bowl bowl, ball;
  RelativePose x;
  GjkCache cache;
  // b above a's opening: the lid is nearer than any triangle, so triangles must be measured.
  x.translation = Vec3(0.2, 0.1, 1.05);
  const PatchSeparation above =
      patch_separation({bowl.patch.view(), ball.patch.view(), x}, kInfinity, cache);
  double least = kInfinity;
  for (const auto& ta : bowl.t) {
    for (const auto& tb : ball.t) {
      Vec3 a[3], b[3];
      for (std::size_t k = 0; k < 3; ++k) {
        a[k] = bowl.p[static_cast<std::size_t>(ta[k])];
        b[k] = ball.p[static_cast<std::size_t>(tb[k])] + x.translation;
      }
      least = std::min(least, triangle_distance(a, b).distance);
    }
  }
  EXPECT_NEAR(above.distance, least, 1e-14);
  EXPECT_GT(above.distance, 0.05 + 1e-3);
  EXPECT_GT(above.triangle_pairs, 0);
  EXPECT_NEAR((above.point_b - above.point_a).norm(), least, 1e-14);
  // Side by side the closest features are real: no triangle needs to be measured.
  x.translation = Vec3(2.5, 0, 0);
  const PatchSeparation beside =
      patch_separation({bowl.patch.view(), ball.patch.view(), x}, kInfinity, cache);
  EXPECT_NEAR(beside.distance, 0.5, 1e-12);
  EXPECT_EQ(beside.triangle_pairs, 0);
  // Nested a little apart: hulls overlap, triangles do not.
  x.translation = Vec3(0, 0, 0.3);
  const PatchSeparation nested =
      patch_separation({bowl.patch.view(), ball.patch.view(), x}, kInfinity, cache);
  EXPECT_FALSE(nested.intersecting);
  EXPECT_NEAR(nested.distance, 0.3 / std::sqrt(3.0), 1e-14);
  x.translation = Vec3(0.5, 0, 0);
  EXPECT_TRUE(
      patch_separation({bowl.patch.view(), ball.patch.view(), x}, kInfinity, cache).intersecting);
}

TEST(PatchSeparation, StopsWithABoundAtOrAboveStop) {
  const Bowl bowl, other;
  RelativePose x;
  for (const double height : {0.8, 1.05, 1.4, 3.0}) {
    x.translation = Vec3(0.2, 0.1, height);
    GjkCache cache;
    const double exact =
        patch_separation({bowl.patch.view(), other.patch.view(), x}, kInfinity, cache).distance;
    for (const double part : {0.2, 0.9, 1.0, 1.1}) {
      const PatchSeparation s =
          patch_separation({bowl.patch.view(), other.patch.view(), x}, part * exact, cache);
      if (part >= 1.0) {
        EXPECT_NEAR(s.distance, exact, 1e-12);
      } else {
        EXPECT_GT(s.distance, part * exact);
        EXPECT_LE(s.distance, exact * (1.0 + 1e-12));
      }
    }
  }
}

struct Truth {
  double distance = kInfinity;
  Vec3 point = Vec3::Zero();  // the mean over the pairs that intersect
  int intersecting = 0;
  std::uint32_t met_a = 0, met_b = 0;  // corners of the triangles that intersect
};

// Every pair of triangles by itself.
Truth all_pairs(const test::MeshPatch& a, const test::MeshPatch& b, const RelativePose& x) {
  Truth truth;
  for (const HullTriangle& ta : a.triangles) {
    for (const HullTriangle& tb : b.triangles) {
      Vec3 p[3], q[3];
      for (int k = 0; k < 3; ++k) {
        p[k] = a.points[ta.corner[k]];
        q[k] = x.rotation * b.points[tb.corner[k]] + x.translation;
      }
      const TriangleDistance d = triangle_distance(p, q);
      truth.distance = std::min(truth.distance, d.distance);
      truth.point += d.intersecting ? d.point_a : Vec3::Zero();
      truth.intersecting += d.intersecting;
      truth.met_a |= d.intersecting ? ta.mask : 0;
      truth.met_b |= d.intersecting ? tb.mask : 0;
    }
  }
  if (truth.intersecting > 0) truth.point /= truth.intersecting;
  return truth;
}

bool same_bits(const PatchSeparation& x, const PatchSeparation& y) {
  return x.intersecting == y.intersecting && x.distance == y.distance && x.point_a == y.point_a &&
         x.point_b == y.point_b && x.triangle_a == y.triangle_a && x.triangle_b == y.triangle_b &&
         x.feature_a == y.feature_a && x.feature_b == y.feature_b;
}

TEST(TriangleSeparation, EqualsAllPairsWhateverTheHint) {
  const test::MeshPatch patches[] = {test::ball_cap(1, -2.0), test::ball_cap(2, 0.1),
                                     test::ball_cap(2, 0.5)};
  ASSERT_LE(patches[1].points.size(), static_cast<std::size_t>(kMaxHullVertices));
  Random random(3);
  int meetings = 0, distances = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const test::MeshPatch &a = patches[trial % 3], &b = patches[trial / 3 % 3];
    RelativePose x = test::random_pose(1.3, random);
    if (trial % 10 == 0) x.rotation = Mat3::Identity();  // parallel faces
    const Truth truth = all_pairs(a, b, x);
    TriangleHint none;
    const PatchSeparation s = triangle_separation({a.view(), b.view(), x}, kInfinity, false, none);
    ASSERT_EQ(s.intersecting, truth.intersecting > 0) << trial;
    ASSERT_NEAR(s.distance, truth.distance, 1e-14) << trial;
    if (s.intersecting) {
      ASSERT_LE((s.point_a - truth.point).norm(), 1e-12) << trial;
      ASSERT_EQ(s.feature_a, truth.met_a) << trial;
      ASSERT_EQ(s.feature_b, truth.met_b) << trial;
    }
    meetings += s.intersecting;
    distances += !s.intersecting;
    ASSERT_EQ(none.a, s.triangle_a);
    ASSERT_EQ(none.b, s.triangle_b);
    EXPECT_EQ(none.meet, s.intersecting);
    PatchSeparation pierced;
    TriangleHint other;
    ASSERT_EQ(triangles_pierce({a.view(), b.view(), x}, other, pierced), s.intersecting) << trial;
    ASSERT_TRUE(!s.intersecting || same_bits(s, pierced)) << trial;
    for (const TriangleHint& hint :
         {none, TriangleHint{0, 0}, TriangleHint{9, 3}, TriangleHint{200, 1}}) {
      TriangleHint used = hint;
      const PatchSeparation hinted =
          triangle_separation({a.view(), b.view(), x}, kInfinity, false, used);
      ASSERT_TRUE(same_bits(s, hinted)) << trial;
      used = hint;
      ASSERT_TRUE(same_bits(triangle_separation({a.view(), b.view(), x}, 0.3, false, none),
                            triangle_separation({a.view(), b.view(), x}, 0.3, false, used)))
          << trial;
    }
  }
  EXPECT_GT(meetings, 100);
  EXPECT_GT(distances, 100);
}

TEST(TriangleSeparation, KnowsTouchingTrianglesAndEmptyPatches) {
  const test::MeshPatch patch = test::ball_cap(2, 0.1);
  TriangleHint hint;
  // The same patch twice: every triangle lies in its twin.
  const PatchSeparation twin =
      triangle_separation({patch.view(), patch.view(), {}}, kInfinity, false, hint);
  EXPECT_TRUE(twin.intersecting);
  EXPECT_EQ(twin.distance, 0.0);
  HullView bare = patch.view();
  bare.triangle_count = 0;
  const PatchSeparation none = triangle_separation({patch.view(), bare, {}}, 1.0, false, hint);
  EXPECT_GT(none.distance, 1.0);
  EXPECT_EQ(none.triangle_a, -1);
}

}  // namespace
}  // namespace thigma
