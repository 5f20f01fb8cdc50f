#include "thigma/models/conforming.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"

namespace thigma::models {
namespace {

/// Least distance of two meshes as they stand, at most `tolerance`; negative where they cross.
double gap_between(const TriangleMesh& a, const TriangleMesh& b, double tolerance) {
  const ClodHierarchy object = build_exact_hierarchy(a), scene = build_exact_hierarchy(b);
  ContactFront front;
  ContactSet contacts;
  contacts.contacts.reserve(1 << 20);
  ContactQuery query;
  query.tolerance = tolerance;
  query_contacts({object}, {scene}, query, front, contacts);
  return least_distance(contacts);
}

TEST(ConformingDiscs, StandTheGapApartAndNowhereTouch) {
  for (const int triangles : {20'000, 60'000}) {
    SCOPED_TRACE(triangles);
    const TriangleMesh lower = make_conforming_lower(triangles, 1);
    const TriangleMesh upper = make_conforming_upper(triangles, 1);
    const double gap = gap_between(upper, lower, 2e-4);
    EXPECT_GT(gap, 0.2 * kConformingGap);
    EXPECT_LT(gap, 1.01 * kConformingGap);
  }
}

TEST(ConformingDiscs, WavySidesHoldMostTriangles) {
  const TriangleMesh lower = make_conforming_lower(50'000, 1);
  std::size_t above = 0;
  for (const auto& t : lower.triangles) {
    if (lower.positions[static_cast<std::size_t>(t[0])].z() > -0.003) ++above;
  }
  EXPECT_GT(static_cast<double>(above), 0.85 * static_cast<double>(lower.triangles.size()));
}

TEST(BallJoint, FitsWithItsClearanceAllAround) {
  const TriangleMesh ball = make_joint_ball(40'000, 3);
  const TriangleMesh socket = make_joint_socket(40'000, 3);
  double outermost = 0.0, innermost = 1.0;
  for (const Vec3& p : ball.positions) {
    if (p.z() < 0.5 * kJointRadius) outermost = std::max(outermost, p.norm());
  }
  for (const Vec3& p : socket.positions) innermost = std::min(innermost, p.norm());
  EXPECT_NEAR(outermost, kJointRadius, 0.5 * kJointClearance);
  EXPECT_NEAR(innermost, kJointRadius + kJointClearance, 0.5 * kJointClearance);
  EXPECT_GT(gap_between(ball, socket, 2.0 * kJointClearance), 0.1 * kJointClearance);
}

}  // namespace
}  // namespace thigma::models
