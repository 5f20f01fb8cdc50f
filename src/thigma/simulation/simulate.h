#pragma once
// One rigid body among static ones, driven by events: free flight, collisions located in time,
// impulses (Sec. 3.5.4).

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "thigma/contact/query_contacts.h"
#include "thigma/simulation/collision.h"

namespace thigma {

/// What never changes during a simulation.
struct SimulationWorld {
  RigidBody body;
  const ClodHierarchy* object = nullptr;  // of the moving body
  Pose body_from_mesh;                    // the mesh in body axes about the centre of mass
  std::vector<SceneBody> scene;
  CollisionLaw law;
  // d: surfaces this near are in contact; collisions happen within a quarter of it [m]
  double tolerance = 0.0;
  // of contact queries. step_time is set by the simulation, blending is never used: collisions have
  // a moment, not a weight (Sec. 3.4.4)
  Resolution resolution{};
  // Contacts of simplified levels are as near as what they stand for may be, by `bound` nearer than
  // they look; where that is touching, what the exact query finds holds the body as well. Off, as
  // in the text, a body that slows down may find itself deep in the finer levels it is measured on
  // then.
  bool allows_for_bounds = true;
  double longest_step = 1e-3;  // between two queries [s]
};

/// What moves.
struct SimulationState {
  BodyState body;
  double time = 0.0;         // [s]
  double since_query = 0.0;  // time that the last query is old, for speeds [s]
  bool is_resting = false;   // held by contacts and still: stays so until the caller says otherwise
  // held and still by simplified levels alone: queries are exact until it rests or falls on
  bool is_settling = false;
  // Where the body was when it was last seen to move.
  BodyState moved_from;
  double moved_at = -1.0;       // [s]; < 0: not watched yet
  double weight_impulse = 0.0;  // of its momentum by gravity, contacts have taken since [N s]
};

/// A simulation that can be run.
struct SimulatedStart {
  SimulationWorld world;
  SimulationState state;
};

/// A contact that holds the body, with the force found for it.
struct SupportPoint {
  Vec3 arm = Vec3::Zero();     // from the centre of mass [m; world]
  Vec3 out = Vec3::UnitZ();    // away from the obstacle
  Vec3 force = Vec3::Zero();   // on the body [N]
  Vec3 couple = Vec3::Zero();  // against rolling [N m]
  double speed = 0.0;          // outward, that it shall have on the mean [m/s]
  double per_speed = 0.0;      // force for a change of that speed [N s/m]
  double per_slide = 0.0;      // the same along the surface, at most
  double per_turn = 0.0;       // couple for a change of angular velocity, at most [N m s]
};

/// Memory of the contact queries of one simulation, owned by the caller. Constant capacity after
/// reserve_simulation.
struct SimulationScratch {
  std::vector<ContactFront> fronts;
  ContactSet contacts;
  std::vector<ContactFront> exact_fronts;  // of the queries beside simplified levels that may touch
  ContactSet exact;
  std::vector<std::int32_t> touching;  // of contacts
  std::vector<std::int32_t> hits;      // of each contact within one event
  std::vector<SupportPoint> supports;  // of touching
};

/// One impulse.
struct CollisionEvent {
  double time = 0.0;            // [s]
  Vec3 point = Vec3::Zero();    // [m; world]
  Vec3 normal = Vec3::UnitZ();  // into the obstacle
  Vec3 impulse = Vec3::Zero();  // on the body [N s]
  double approach = 0.0;        // speed along the normal before it [m/s]
  double energy_change = 0.0;   // <= 0 but for rounding [J]
  // of the contact as it was measured, negative in penetration [m]
  double gap = 0.0;
  std::int32_t object_level = 0, scene_level = 0;
};

/// What a stretch of simulation took.
struct SimulationCounts {
  std::int64_t steps = 0;   // queries
  std::int64_t events = 0;  // instants with at least one impulse
  std::int64_t impulses = 0;
  std::int64_t supported = 0;  // flights that contacts held
  // events between two queries that saw other levels of detail (Sec. 3.4.4)
  std::int64_t interpolated = 0;
  // queries whose levels might touch, so that the exact one was asked too
  std::int64_t doubted = 0;
  std::int64_t unresolved = 0;  // events after which some contact still approached
  double query_cpu = 0.0;       // CPU time of the queries [s]
  double front = 0.0;           // sum over queries of node pairs held
  // penetration seen by a query, the exact one where it was asked, at most [m]
  double deepest = 0.0;
  // the same, less the bound of the contact: what levels of detail do not explain [m]
  double beyond_bound = 0.0;
};

/// Hears of what happens; empty: nobody does. query: after each one, with the state it was asked at
/// and the contacts of the levels that the resolution asks for.
struct SimulationPorts {
  std::function<void(const CollisionEvent&)> event;
  std::function<void(const SimulationState&, const ContactSet&)> query;
};

/// Makes room for a world. contacts: most of a query. Throws InputError for a world that cannot be
/// simulated: no object, a tolerance or step that is not positive, a restitution outside 0..1,
/// negative friction. Thread [offline].
SimulationScratch reserve_simulation(const SimulationWorld& world, std::size_t contacts = 20'000);

/// Simulates for a time.
///
/// Between queries the body moves freely, no farther than the nearest surfaces allow: by at most
/// the tolerance where nothing is within it, else by what the patches in contact leave, along their
/// normals. Within a quarter of the tolerance a contact that approaches collides: all that touch,
/// the fastest first, until none approaches. Impacts of less speed than lifts the body an eighth of
/// that quarter against gravity end without a bounce; from where a contact has sunk below half of
/// the quarter they bounce back whole, so that it moves off. What touches holds the body on its way
/// to the next query: by the mean force of the train of impulses that Sec. 2.4.3 would give, with
/// Coulomb friction (detail/support.h). It never gives work on balance: what lifts a sunk contact
/// is taken from what friction takes in the same flight, so energy does not grow, and a body that
/// creeps does not sink. A body whose weight is carried and no point of which has moved by half the
/// tolerance for 25 ms is at rest: it loses what speed it has and is simulated no more. Where
/// nothing but what levels may lie off carries it, it is queried exactly from then on and settles.
/// Where a query sees a penetration of more than a quarter of the tolerance although the one before
/// saw a gap, levels of detail have changed in between: the collision is taken to be at the time
/// where the line from gap to depth is zero, and the body goes on from there. So time always
/// advances.
/// duration  >= 0 [s]
/// returns   counts of this call
/// Thread    any, alone with state and scratch; the same inputs give the same bits. No failure; a
///           state that is not finite stays as it is.
/// Source    Secs. 2.4.3, 3.4.4, 3.5.4; conservative advancement instead of a search for roots.
SimulationCounts simulate(const SimulationWorld& world, double duration, SimulationState& state,
                          SimulationScratch& scratch, const SimulationPorts& ports = {});

}  // namespace thigma
