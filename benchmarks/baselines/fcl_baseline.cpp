#include "benchmarks/baselines/fcl_baseline.h"

#ifdef THIGMA_HAVE_FCL

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>

namespace thigma::bench {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> make_model(const TriangleMesh& mesh) {
  auto model = std::make_shared<Model>();
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                           static_cast<std::size_t>(t[2]));
  }
  model->beginModel();
  model->addSubModel(mesh.positions, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform(const Pose& pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = pose.orientation.toRotationMatrix();
  t.translation() = pose.position;
  return t;
}

std::shared_ptr<fcl::Convexd> make_convex(const TriangleMesh& mesh) {
  auto vertices = std::make_shared<const std::vector<fcl::Vector3d>>(mesh.positions.begin(),
                                                                     mesh.positions.end());
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& t : mesh.triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(mesh.triangles.size()), faces);
}

}  // namespace

struct FclPair {
  std::shared_ptr<Model> object, scene;
};

struct FclConvexPair {
  std::shared_ptr<fcl::Convexd> a, b;
};

void FclPairDeleter::operator()(FclPair* pair) const { delete pair; }
void FclConvexPairDeleter::operator()(FclConvexPair* pair) const { delete pair; }

bool has_fcl() { return true; }

FclPairPtr make_fcl_pair(const TriangleMesh& object, const TriangleMesh& scene) {
  return FclPairPtr(new FclPair{make_model(object), make_model(scene)});
}

FclDistance fcl_distance(FclPair& pair, const Pose& world_from_object) {
  fcl::DistanceRequestd request(true);  // with the nearest points
  fcl::DistanceResultd result;
  const fcl::Transform3d scene = fcl::Transform3d::Identity();
  fcl::distance(pair.object.get(), transform(world_from_object), pair.scene.get(), scene, request,
                result);
  return {result.min_distance, result.nearest_points[0], result.nearest_points[1]};
}

FclConvexPairPtr make_fcl_convex_pair(const TriangleMesh& a, const TriangleMesh& b) {
  return FclConvexPairPtr(new FclConvexPair{make_convex(a), make_convex(b)});
}

double fcl_convex_distance(FclConvexPair& pair, const Pose& a_from_b) {
  fcl::DistanceRequestd request(false);
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::DistanceResultd result;
  const fcl::Transform3d a = fcl::Transform3d::Identity();
  fcl::distance(pair.a.get(), a, pair.b.get(), transform(a_from_b), request, result);
  return result.min_distance;
}

}  // namespace thigma::bench

#else

namespace thigma::bench {

struct FclPair {};
struct FclConvexPair {};
void FclPairDeleter::operator()(FclPair* pair) const { delete pair; }
void FclConvexPairDeleter::operator()(FclConvexPair* pair) const { delete pair; }
bool has_fcl() { return false; }
FclPairPtr make_fcl_pair(const TriangleMesh&, const TriangleMesh&) { return {}; }
FclDistance fcl_distance(FclPair&, const Pose&) { return {}; }
FclConvexPairPtr make_fcl_convex_pair(const TriangleMesh&, const TriangleMesh&) { return {}; }
double fcl_convex_distance(FclConvexPair&, const Pose&) { return 0.0; }

}  // namespace thigma::bench

#endif
