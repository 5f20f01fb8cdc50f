// Closed bodies that stand apart are reported apart: truth is the distance of all their triangles.
#include "support/apart.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

double deepest(const ClodHierarchy& object, const Pose& pose, const ClodHierarchy& scene,
               double tolerance) {
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(2000);
  query_contacts({object, pose}, {scene}, {.tolerance = tolerance}, front, set);
  double depth = -tolerance;
  for (const Contact& contact : set.contacts) depth = std::max(depth, contact.depth);
  return depth;
}

void expect_apart(const TriangleMesh& object, const TriangleMesh& scene, double reach, int poses) {
  const ClodHierarchy moving = build_exact_hierarchy(object),
                      standing = build_exact_hierarchy(scene);
  const test::TriangleTree tree = test::build_triangle_tree(scene);
  Random random{7};
  int touched = 0;
  for (int i = 0; i < poses; ++i) {
    const Vec3 from = random.direction();
    Pose pose;
    pose.orientation = random.orientation();
    pose.position = 2.0 * reach * from;
    const double gap = reach * random.uniform(1e-6, 3e-3);
    pose = test::brought_near(object, pose, -from, tree, gap);
    const double distance =
        test::least_triangle_distance(test::build_triangle_tree(object, pose), tree);
    if (distance > 1.01 * gap) continue;  // passed through the hole
    ++touched;
    EXPECT_NEAR(deepest(moving, pose, standing, 0.01 * reach), -distance, 1e-9 * reach) << i;
  }
  EXPECT_GT(touched, poses / 2);
}

// At a vertex where several patches meet, the segment between closest points may lie behind all
// faces of one patch and yet run outside the body: a ball was 41 to 141 um deep in a ring it did
// not touch.
TEST(ApartContacts, VerticesWhereSeveralPatchesMeetAreNotThrough) {
  const TriangleMesh ball = make_ball(0.05, 4), ring = make_torus(0.04, 0.015, 25, 10);
  const ClodHierarchy moving = build_exact_hierarchy(ball), standing = build_exact_hierarchy(ring);
  const test::TriangleTree tree = test::build_triangle_tree(ring);
  Pose poses[3];
  poses[0].position = {0.0075376546831659045, -0.0009613115785698006, 0.05579667628186649};
  poses[0].orientation =
      Quat(0.09626066228195349, -0.7617823770066854, -0.11491954694872039, -0.6302499446316397);
  poses[1].position = {-0.013415867080030732, -0.0034825959530129275, 0.059258716440964254};
  poses[1].orientation =
      Quat(-0.5222218168739362, -0.1058062221451638, -0.4542925136111869, -0.7139381831875101);
  poses[2].position = {0.02273345175978725, 0.0030792354073354675, 0.06212431683350885};
  poses[2].orientation =
      Quat(-0.46509096422827484, 0.3477482931001038, -0.177689815923205, 0.7944733154463752);
  for (const Pose& pose : poses) {
    const double distance =
        test::least_triangle_distance(test::build_triangle_tree(ball, pose), tree);
    EXPECT_GT(distance, 0.0);
    EXPECT_NEAR(deepest(moving, pose, standing, 0.001), -distance, 1e-10);
  }
}

TEST(ApartContacts, BallsAndRings) {
  const TriangleMesh ball = make_ball(0.05, 4), ring = make_torus(0.04, 0.015, 25, 10);
  expect_apart(ball, ring, 0.12, 600);
  expect_apart(ring, ball, 0.12, 200);
}

TEST(ApartContacts, BoxesAndRings) {
  const TriangleMesh box = make_box({0.05, 0.03, 0.02}), ring = make_torus(0.04, 0.015, 16, 8);
  expect_apart(box, ring, 0.1, 300);
  expect_apart(ring, ring, 0.12, 300);
}

}  // namespace
}  // namespace thigma
