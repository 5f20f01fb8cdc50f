#pragma once
// What a collision does to a rigid body: restitution and Coulomb friction at one point, without
// gain of energy.

#include "thigma/dynamics/body.h"

namespace thigma {

/// How two surfaces collide.
struct CollisionLaw {
  double restitution = 0.5;  // e of the normal velocity, 0..1
  double friction = 0.3;     // mu of Coulomb's law, >= 0
  // what rolls or spins on a contact that holds it is braked by this times the normal force, >= 0;
  // impacts know nothing of it [m]
  double rolling = 0.0;
};

/// K with du = K p: change of velocity of a point of the body by an impulse there. Symmetric
/// positive definite.
/// arm      from the centre of mass to the point [m; world]
/// returns  [1/kg]
/// Thread   any. Source  Mirtich's collision matrix (Sec. 2.4.3).
Mat3 collision_matrix(const RigidBody& body, const BodyState& state, const Vec3& arm) noexcept;

/// Velocity of a point of the body [m/s; world].
Vec3 point_velocity(const RigidBody& body, const BodyState& state, const Vec3& arm) noexcept;

/// Impulse of a collision at a point, against a surface at rest.
///
/// Compression until the point approaches no more, then restitution until the normal impulse has
/// given back e^2 of the work it took (Stronge): without friction, or through the centre of mass,
/// the point moves off at e times the speed it came at. Friction opposes the sliding of the moment,
/// or holds the point where the cone allows; it never gives work. So energy does not grow for any e
/// in 0..1, mu >= 0 and any K.
/// matrix    K [1/kg]
/// velocity  of the point [m/s]
/// normal    unit, into the body's obstacle: the point approaches when normal . velocity > 0
/// returns   [N s]; zero unless the point approaches
/// Thread    any; no failure.
/// Source    Mirtich's compression and restitution (Sec. 2.4.3), by straight steps of which each
///           has its exact work.
Vec3 collision_impulse(const Mat3& matrix, const Vec3& velocity, const Vec3& normal,
                       const CollisionLaw& law) noexcept;

/// The state after an impulse at a point.
BodyState with_impulse(const BodyState& state, const Vec3& arm, const Vec3& impulse) noexcept;

}  // namespace thigma
