#pragma once
// Bullet's mesh against mesh, GImpact, the one public baseline besides the shell that finds every
// contact within a tolerance. Built only where Debian's libbullet-dev is; absent otherwise.

#include <memory>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bench {

bool has_bullet();

/// Two meshes in GImpact shapes, in single precision and in units of `unit`, as Bullet has absolute
/// tolerances: give it about the objects' radius.
struct BulletPair;
struct BulletPairDeleter {
  void operator()(BulletPair* pair) const;
};
using BulletPairPtr = std::unique_ptr<BulletPair, BulletPairDeleter>;

/// tolerance  contacts within it are found: half of it is each shape's margin [m]
/// returns    null without Bullet
BulletPairPtr make_bullet_pair(const TriangleMesh& object, const TriangleMesh& scene,
                               double tolerance, double unit);

/// A contact of two triangles, as Bullet clips them along a face's normal.
struct BulletContact {
  Vec3 point = Vec3::Zero();    // [m; world]
  Vec3 normal = Vec3::UnitZ();  // out of the grasped object [world]
  double depth = 0.0;           // minus the separation of the surfaces [m]
};

/// Every contact at a pose of the object, the scene at the identity; no reduction to four points.
/// contacts: emptied first. Thread: one at a time.
void query_bullet(BulletPair& pair, const Pose& world_from_object,
                  std::vector<BulletContact>& contacts);

}  // namespace thigma::bench
