#pragma once
// One frame of the contact side under constraints: from a pose to the rows of the haptic thread.

#include <memory>
#include <span>
#include <vector>

#include "thigma/constraint/feature_rows.h"
#include "thigma/constraint/implied_rows.h"
#include "thigma/constraint/relief_rows.h"
#include "thigma/constraint/surface_features.h"
#include "thigma/contact/contact.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/math/infinity.h"

namespace thigma {

/// What rows are made from. Constant while a session runs; hierarchies outlive it.
struct ConstraintWorld {
  SurfaceFeatures object;
  Pose body_from_mesh;
  std::vector<SceneBody> bodies;
  std::vector<std::shared_ptr<const SurfaceFeatures>> scene;  // one a body
  ReliefPatches relief;                                       // of a textured world, else empty
  double reach = 0.0;  // of the object's farthest vertex from its centre of mass [m]
  double slop = 0.0;   // the gap that is kept [m]
  // tolerance of the query: at rest, half of it where models follow each other soon; and at most,
  // whatever the speed [m]
  double least_look_ahead = 0.0, most_look_ahead = 0.0;
};

/// What is looked ahead at least where surfaces lie on each other, however many pairs that is:
/// beyond the gap that is kept. Nearer than that no row would say where the object stops, and it
/// would be moved by the end of its travel alone, without coming to rest [m].
/// Thread  [contact]
inline double crowded_look_ahead(const ConstraintWorld& world) noexcept { return 2.0 * world.slop; }

/// Features of an object and of the bodies of a scene; bodies of one hierarchy share theirs.
///
/// body_from_mesh  of the object, its body frame at the centre of mass
/// Thread          [offline]; throws std::bad_alloc
ConstraintWorld make_constraint_world(const ClodHierarchy& object, const Pose& body_from_mesh,
                                      std::span<const SceneBody> bodies);

/// Keeps more of a gap, where a step may use up more of it: rows of relief leave out what is small,
/// a world of bodies is solved in rounds.
void widen(ConstraintWorld& world) noexcept;

/// Working memory. Grows while warming up, never after.
struct ConstraintScratch {
  RowScratch rows;
  std::vector<FoundRow> found;
  ImpliedScratch implied;
  ReliefScratch relief;          // where the world is textured
  std::vector<FoundRow> coarse;  // of pairs far away, with levels of detail
  // Of the loop: the state the last model was made at, and the way that was likely then.
  BodyState last_state;
  LikelyWay last_way;
};

/// What a query has found.
struct NearContacts {
  const ContactSet& contacts;  // of the exact query at the state
  // of all it did not report, at least: its tolerance, or, where nothing is near, what its
  // traversal has proven (unreported_separation), > 0 [m]
  double separation = 0.0;
  // rows of contacts that touch relief, which `contacts` is without, and how far they hold [m]; or
  // those of coarse contacts, which have no others
  std::span<const FoundRow> relief{};
  double relief_travel = kInfinity;
  LikelyWay way{};  // of the object until the model after the next
};

/// Counts of one frame.
struct ConstraintStats {
  std::int64_t rows = 0;      // found
  std::int64_t left_out = 0;  // candidates and contacts for want of room: nothing may move then
  // times the travel was halved, as more rows were needed than fit, or far more found; rounded up
  std::int32_t halvings = 0;
};

/// How far the next query is worth asking for. A model of which more rows are needed than fit holds
/// for less than was looked, and what was searched beyond was in vain; else more may be tried.
///
/// travel   that the model holds for [m]
/// looked   by its query, or what was worth asking for, the larger [m]
/// more     so many times as far may be tried, > 1
/// returns  [m]
/// Thread   any
inline double worth_asking(const ConstraintStats& stats, double travel, double looked,
                           double more) noexcept {
  return more * (stats.halvings > 0 ? travel : looked);
}

/// Room for so many contacts, candidates and rows a frame.
/// Thread [offline]; throws std::bad_alloc.
void reserve_constraints(const ConstraintWorld& world, std::size_t capacity,
                         ConstraintScratch& scratch);

/// What rows have to hold for when no point of the object moves farther than a travel [m].
/// Thread [contact].
RowReach row_reach(const ConstraintWorld& world, double travel) noexcept;

/// The rows that are needed into a model; where there are too many, for less travel.
///
/// found    of one state of the body; object points and directions in the frame of the body
/// slop     the gap that is kept [m]
/// model    its state, reach and travel are given; gets the rows, nearest first
/// returns  how often its travel was halved, rounded up
/// Thread   [contact]; no failure
std::int32_t take_needed_rows(std::span<const FoundRow> found, double slop, ImpliedScratch& scratch,
                              ConstraintModel& model) noexcept;

/// Rows for a body at a state, good for nearly as much travel as the query has looked ahead.
/// model      overwritten; rows know their body and have no friction
/// Thread     [contact]; no failure
ConstraintStats build_constraints(const ConstraintWorld& world, const BodyState& state,
                                  const NearContacts& near, ConstraintScratch& scratch,
                                  ConstraintModel& model) noexcept;

}  // namespace thigma
