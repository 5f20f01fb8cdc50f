#include "benchmarks/baselines/bullet_baseline.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "thigma/mesh/shapes.h"

namespace thigma::bench {
namespace {

class BulletBaseline : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_bullet()) GTEST_SKIP() << "built without libbullet-dev";
  }
};

double deepest(const std::vector<BulletContact>& contacts) {
  double depth = -1e300;
  for (const BulletContact& c : contacts) depth = std::max(depth, c.depth);
  return depth;
}

TEST_F(BulletBaseline, BoxesAreApartByTheirGap) {
  const TriangleMesh box = make_box(Vec3(0.1, 0.1, 0.1), {4, 4, 4});
  const double d = 0.002;
  BulletPairPtr pair = make_bullet_pair(box, box, d, 0.1);
  std::vector<BulletContact> contacts;
  for (const double gap : {0.0015, 0.0005}) {
    Pose pose;
    pose.position = Vec3(0.0003, 0.0007, 0.1 + gap);
    query_bullet(*pair, pose, contacts);
    ASSERT_FALSE(contacts.empty()) << gap;
    EXPECT_NEAR(deepest(contacts), -gap, 0.02 * d) << gap;
    for (const BulletContact& c : contacts) {
      EXPECT_GE(c.depth, -1.001 * d);
      EXPECT_NEAR(c.point.z(), 0.05, 2.0 * d);
    }
  }
  Pose away;
  away.position = Vec3(0.0, 0.0, 0.103);
  query_bullet(*pair, away, contacts);
  EXPECT_TRUE(contacts.empty());
}

// Triangles through each other are clipped along either face, so some depths are those of side
// faces.
TEST_F(BulletBaseline, OverlappingBoxesHaveContactsOfTheirOverlap) {
  const TriangleMesh box = make_box(Vec3(0.1, 0.1, 0.1), {4, 4, 4});
  BulletPairPtr pair = make_bullet_pair(box, box, 0.002, 0.1);
  std::vector<BulletContact> contacts;
  Pose pose;
  pose.position = Vec3(0.0003, 0.0007, 0.0995);
  query_bullet(*pair, pose, contacts);
  double along_z = -1.0;
  for (const BulletContact& c : contacts) {
    if (c.normal.z() < -0.999) along_z = std::max(along_z, c.depth);
  }
  EXPECT_NEAR(along_z, 0.0005, 4e-5);
}

TEST_F(BulletBaseline, NormalsPointOutOfTheObject) {
  const TriangleMesh ball = make_ball(1.0, 12);
  BulletPairPtr pair = make_bullet_pair(ball, ball, 0.02, 1.0);
  std::vector<BulletContact> contacts;
  Pose pose;
  pose.position = Vec3(2.0, 0.0, 0.0);
  query_bullet(*pair, pose, contacts);
  ASSERT_FALSE(contacts.empty());
  for (const BulletContact& c : contacts) EXPECT_LT(c.normal.x(), -0.9);
}

}  // namespace
}  // namespace thigma::bench
