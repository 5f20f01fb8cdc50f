#pragma once
// Boxes that fall and slide, by Bullet's rigid bodies. Built only where Debian's libbullet-dev is.

#include <memory>
#include <span>

#include "thigma/math/pose.h"

namespace thigma::bench {

/// A box. mass 0: it stands still.
struct BulletBox {
  Vec3 size = Vec3::Ones();  // [m]
  double mass = 0.0;         // [kg]
  double friction = 0.3;     // of each pair of such boxes
  Pose start;
  Vec3 velocity = Vec3::Zero();  // [m/s; world]
};

struct BulletWorld;
struct BulletWorldDeleter {
  void operator()(BulletWorld* world) const;
};
using BulletWorldPtr = std::unique_ptr<BulletWorld, BulletWorldDeleter>;

/// Bullet's usual world: boxes, sequential impulses, nothing asleep.
///
/// rounds   of the impulses a step; Bullet's own default is 10
/// unit     a length that Bullet sees as 1, as it has absolute tolerances [m]
/// returns  null without Bullet
BulletWorldPtr make_bullet_world(std::span<const BulletBox> boxes, const Vec3& gravity, double unit,
                                 int rounds);

/// A step of dt, undivided [s].
void step_bullet(BulletWorld& world, double dt);

/// Pose and speed of a box.
Pose bullet_pose(const BulletWorld& world, std::size_t box);
double bullet_speed(const BulletWorld& world, std::size_t box);

}  // namespace thigma::bench
