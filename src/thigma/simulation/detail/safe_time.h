#pragma once
// How long a body may fly before its surfaces could meet others: conservative advancement.

#include "thigma/simulation/simulate.h"

namespace thigma::detail {

// of the collision distance: what may be closed between two events
inline constexpr double kShortestFall = 0.125;

/// Within this distance a contact that approaches collides [m].
inline double collision_gap(const SimulationWorld& world) { return 0.25 * world.tolerance; }

/// How far apart the surfaces of a contact are to the motion; negative in penetration [m].
inline double gap_of(const SimulationWorld& world, const Contact& c) {
  return -c.depth - (world.allows_for_bounds ? c.bound : 0.0);
}

/// The least gap of a set; infinite without contacts [m].
double least_gap(const SimulationWorld& world, const ContactSet& contacts);

/// One contact as the motion sees it.
struct ApproachingContact {
  Vec3 arm;         // from the centre of mass to the point on the body [m; world]
  double approach;  // speed along the normal, into the obstacle [m/s]
  double gap;       // gap_of the contact [m]
};

ApproachingContact approaching(const SimulationWorld& world, const BodyState& state,
                               const Contact& contact);

/// A flight under a constant wrench about the centre of mass.
struct PushedFlight {
  double time = 0.0;  // at most [s]
  Wrench push{};
};

/// A time in which nothing that is farther apart than the tolerance comes together, no contact
/// beyond the collision distance comes nearer than half of it, and one within closes by an eighth
/// of it at most, as the patches in contact are convex: the plane between them keeps them apart.
/// contacts  all within the tolerance, at this state
/// reach     of the mesh from the centre of mass [m]
/// flight    the wrench on the way, and for how long at most
/// returns   > 0 [s]
double safe_time(const SimulationWorld& world, const BodyState& state, const ContactSet& contacts,
                 double reach, const PushedFlight& flight = {});

}  // namespace thigma::detail
