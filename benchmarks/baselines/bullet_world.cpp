#include "benchmarks/baselines/bullet_world.h"

#include <cmath>
#include <vector>

#ifdef THIGMA_HAVE_BULLET

#include <btBulletDynamicsCommon.h>

namespace thigma::bench {
namespace {

btVector3 to_bullet(const Vec3& v, double unit) {
  return {static_cast<btScalar>(v.x() / unit), static_cast<btScalar>(v.y() / unit),
          static_cast<btScalar>(v.z() / unit)};
}

btQuaternion to_bullet(const Quat& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

}  // namespace

struct BulletWorld {
  double unit = 1.0;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broad, &solver, &configuration};
  std::vector<std::unique_ptr<btBoxShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;

  ~BulletWorld() {
    for (const auto& body : bodies) world.removeRigidBody(body.get());
  }
};

void BulletWorldDeleter::operator()(BulletWorld* world) const { delete world; }

BulletWorldPtr make_bullet_world(std::span<const BulletBox> boxes, const Vec3& gravity, double unit,
                                 int rounds) {
  BulletWorldPtr made(new BulletWorld);
  made->unit = unit;
  made->world.getSolverInfo().m_numIterations = rounds;
  made->world.setGravity(to_bullet(gravity, unit));
  for (const BulletBox& box : boxes) {
    made->shapes.push_back(std::make_unique<btBoxShape>(to_bullet(0.5 * box.size, unit)));
    btBoxShape& shape = *made->shapes.back();
    const auto mass = static_cast<btScalar>(box.mass);
    btVector3 inertia(0, 0, 0);
    if (box.mass > 0.0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform =
        btTransform(to_bullet(box.start.orientation), to_bullet(box.start.position, unit));
    // Bullet multiplies the friction of two.
    info.m_friction = static_cast<btScalar>(std::sqrt(box.friction));
    made->bodies.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *made->bodies.back();
    body.setLinearVelocity(to_bullet(box.velocity, unit));
    body.setActivationState(DISABLE_DEACTIVATION);
    made->world.addRigidBody(&body);
  }
  return made;
}

void step_bullet(BulletWorld& world, double dt) {
  world.world.stepSimulation(static_cast<btScalar>(dt), 0);
}

Pose bullet_pose(const BulletWorld& world, std::size_t box) {
  const btTransform& at = world.bodies[box]->getWorldTransform();
  const btQuaternion q = at.getRotation();
  const btVector3& p = at.getOrigin();
  return {world.unit * Vec3(p.x(), p.y(), p.z()), Quat(q.w(), q.x(), q.y(), q.z())};
}

double bullet_speed(const BulletWorld& world, std::size_t box) {
  return world.unit * static_cast<double>(world.bodies[box]->getLinearVelocity().length());
}

}  // namespace thigma::bench

#else

namespace thigma::bench {

struct BulletWorld {};
void BulletWorldDeleter::operator()(BulletWorld* world) const { delete world; }
BulletWorldPtr make_bullet_world(std::span<const BulletBox>, const Vec3&, double, int) {
  return {};
}
void step_bullet(BulletWorld&, double) {}
Pose bullet_pose(const BulletWorld&, std::size_t) { return {}; }
double bullet_speed(const BulletWorld&, std::size_t) { return 0.0; }

}  // namespace thigma::bench

#endif
