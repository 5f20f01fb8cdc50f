#include "benchmarks/baselines/bullet_baseline.h"

#ifdef THIGMA_HAVE_BULLET

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

namespace thigma::bench {
namespace {

btVector3 scaled(const Vec3& p, double unit) {
  return {static_cast<btScalar>(p.x() / unit), static_cast<btScalar>(p.y() / unit),
          static_cast<btScalar>(p.z() / unit)};
}

Vec3 vec3(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

// Bullet keeps pointers to all of this.
struct Body {
  std::vector<btScalar> positions;
  std::vector<int> indices;
  std::unique_ptr<btTriangleIndexVertexArray> array;
  std::unique_ptr<btGImpactMeshShape> shape;
  btCollisionObject object;

  Body(const TriangleMesh& mesh, double margin, double unit) {
    for (const Vec3& p : mesh.positions) {
      const btVector3 q = scaled(p, unit);
      positions.insert(positions.end(), {q.x(), q.y(), q.z()});
    }
    for (const auto& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
    array = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh.triangles.size()), indices.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(mesh.positions.size()), positions.data(),
        static_cast<int>(3 * sizeof(btScalar)));
    shape = std::make_unique<btGImpactMeshShape>(array.get());
    shape->setMargin(static_cast<btScalar>(margin / unit));
    shape->updateBound();
    object.setCollisionShape(shape.get());
    object.setWorldTransform(btTransform::getIdentity());
  }
};

// Takes every contact; the manifold of four is bypassed.
struct Collector : btManifoldResult {
  std::vector<BulletContact>* out = nullptr;
  double unit = 1.0, margins = 0.0;
  Collector(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b)
      : btManifoldResult(a, b) {}
  // normal: on the second body, towards the first. The depth counts from the shapes with their
  // margins.
  void addContactPoint(const btVector3& normal, const btVector3& point, btScalar depth) override {
    out->push_back(
        {unit * vec3(point), -vec3(normal), -unit * static_cast<double>(depth) - margins});
  }
};

}  // namespace

struct BulletPair {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  Body object, scene;
  double unit = 1.0, tolerance = 0.0;
  btCollisionAlgorithm* algorithm = nullptr;

  BulletPair(const TriangleMesh& a, const TriangleMesh& b, double d, double length)
      : object(a, 0.5 * d, length), scene(b, 0.5 * d, length), unit(length), tolerance(d) {
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher);
    const btCollisionObjectWrapper wa = wrap(object), wb = wrap(scene);
    // The closest-point table has no entry for GImpact.
    algorithm = dispatcher.findAlgorithm(&wa, &wb, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  }
  ~BulletPair() {
    algorithm->~btCollisionAlgorithm();
    dispatcher.freeCollisionAlgorithm(algorithm);
  }
  BulletPair(const BulletPair&) = delete;
  BulletPair& operator=(const BulletPair&) = delete;

  static btCollisionObjectWrapper wrap(const Body& body) {
    return {nullptr, body.shape.get(), &body.object, body.object.getWorldTransform(), -1, -1};
  }
};

void BulletPairDeleter::operator()(BulletPair* pair) const { delete pair; }

bool has_bullet() { return true; }

BulletPairPtr make_bullet_pair(const TriangleMesh& object, const TriangleMesh& scene,
                               double tolerance, double unit) {
  return BulletPairPtr(new BulletPair(object, scene, tolerance, unit));
}

void query_bullet(BulletPair& pair, const Pose& world_from_object,
                  std::vector<BulletContact>& contacts) {
  contacts.clear();
  const Mat3 r = world_from_object.orientation.toRotationMatrix();
  auto f = [&](int i, int j) { return static_cast<btScalar>(r(i, j)); };
  pair.object.object.setWorldTransform(btTransform(
      btMatrix3x3(f(0, 0), f(0, 1), f(0, 2), f(1, 0), f(1, 1), f(1, 2), f(2, 0), f(2, 1), f(2, 2)),
      scaled(world_from_object.position, pair.unit)));
  const btCollisionObjectWrapper wa = BulletPair::wrap(pair.object),
                                 wb = BulletPair::wrap(pair.scene);
  Collector collector(&wa, &wb);
  collector.out = &contacts;
  collector.unit = pair.unit;
  collector.margins = pair.tolerance;
  const btDispatcherInfo info;
  pair.algorithm->processCollision(&wa, &wb, info, &collector);
}

}  // namespace thigma::bench

#else

namespace thigma::bench {

struct BulletPair {};
void BulletPairDeleter::operator()(BulletPair* pair) const { delete pair; }
bool has_bullet() { return false; }
BulletPairPtr make_bullet_pair(const TriangleMesh&, const TriangleMesh&, double, double) {
  return {};
}
void query_bullet(BulletPair&, const Pose&, std::vector<BulletContact>& contacts) {
  contacts.clear();
}

}  // namespace thigma::bench

#endif
