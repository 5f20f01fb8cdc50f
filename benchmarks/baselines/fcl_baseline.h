#pragma once
// The baseline of Debian 12: FCL 0.7. Built only where its headers are; absent otherwise.

#include <memory>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bench {

bool has_fcl();

/// Two meshes in FCL's bounding volume hierarchies (OBBRSS, double).
struct FclPair;
struct FclPairDeleter {
  void operator()(FclPair* pair) const;
};
using FclPairPtr = std::unique_ptr<FclPair, FclPairDeleter>;

FclPairPtr make_fcl_pair(const TriangleMesh& object, const TriangleMesh& scene);

/// Smallest distance at a pose of the object, the scene at the identity, and the closest points; 0
/// where the surfaces intersect. One pair of points: FCL has no query for all regions nearer than a
/// tolerance.
struct FclDistance {
  double distance = 0.0;
  Vec3 point_object = Vec3::Zero(), point_scene = Vec3::Zero();  // [m; world]
};
FclDistance fcl_distance(FclPair& pair, const Pose& world_from_object);

/// Two convex hulls, for the signed distance of FCL's convex solver.
struct FclConvexPair;
struct FclConvexPairDeleter {
  void operator()(FclConvexPair* pair) const;
};
using FclConvexPairPtr = std::unique_ptr<FclConvexPair, FclConvexPairDeleter>;

FclConvexPairPtr make_fcl_convex_pair(const TriangleMesh& a, const TriangleMesh& b);
double fcl_convex_distance(FclConvexPair& pair, const Pose& a_from_b);

}  // namespace thigma::bench
