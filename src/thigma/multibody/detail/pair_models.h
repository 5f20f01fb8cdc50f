#pragma once
// What is known of each pair of bodies that are near each other: rows, how far they hold, and the
// memory of the query.

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "thigma/constraint/build_constraints.h"
#include "thigma/contact/front.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/multibody/detail/broad_phase.h"
#include "thigma/multibody/detail/pair_kinds.h"
#include "thigma/multibody/world.h"

namespace thigma::detail {

/// What pressed between two bodies in the last step, by row of the pair's model.
struct RowHistory {
  std::uint64_t id = 0;
  Vec3 impulse = Vec3::Zero();  // along the normal and its tangents [N s]
  bool is_sliding = false;
};

/// A pair of bodies that are near each other. Its model is in the frame of `second`.
struct NearPair {
  std::int32_t first = -1, second = -1;  // bodies, in the order of the kind's shapes
  std::int32_t kind = -1;                // into World::pair_kinds
  bool is_used = false;                  // near in this step
  ContactFront front;
  ConstraintModel model;
  bool has_model = false;
  double looked_ahead = 0.0;  // of the last query [m]
  double asked = 0.0;         // a way it turned out to need in this step [m]
  double fresh = -1.0;        // the way that the model was made for, at the poses of this step [m]
  std::int64_t left_out = 0;  // of the last query: nothing may move
  // To look farther ahead serves nothing: there are more rows than have room [m].
  double worth = kInfinity;
  double exact_within = 0.0;  // of the last query, with levels of detail; 0: all was exact [m]
  int pressed = 0;            // so often coarse rows pressed in this part: it was asked more finely
  std::vector<RowHistory> history;  // as many as rows
};

/// Counts of a step.
struct PairCounts {
  std::int64_t queries = 0, coarse = 0, contacts = 0, rows = 0, left_out = 0;
};

/// All pairs. Memory of a pair that ends is kept for the next of its kind: grows while warming up,
/// that is until as many pairs of a kind as there ever are were near at once, never after.
struct PairModels {
  std::vector<std::unique_ptr<NearPair>> pool;
  std::vector<NearPair*> near;  // of this step, by (lower, higher) body
  ContactSet contacts;
  ConstraintScratch scratch;
  std::vector<RowHistory> before;
};

/// Pose and momentum-free state of one body in the frame of another.
BodyState relative_state(const BodyState& first, const BodyState& second) noexcept;

/// Room for contacts and rows, and for so many pairs of each kind.
/// Thread [offline]; throws std::bad_alloc.
void reserve_pairs(const World& world, std::size_t pairs, PairModels& models);

/// The pairs of a step: those there were keep what they know.
void take_pairs(const World& world, std::span<const BodyPairIndex> pairs, PairModels& models);

/// Most that a query may look ahead [m].
inline double most_ahead(const World& world, const NearPair& pair) noexcept {
  const ConstraintWorld& constraints = pair_kind(world, pair.kind).constraints;
  return std::clamp(pair.worth, constraints.least_look_ahead, constraints.most_look_ahead);
}

/// Whether the model of a pair holds where it is now, and for a way from there [m].
bool holds(const World& world, const NearPair& pair, const BodyState& relative,
           double way) noexcept;

/// Contacts of a pair within a tolerance, measured to the end: into models.contacts.
void find_contacts(const World& world, const BodyState& relative, double tolerance, NearPair& pair,
                   PairModels& models) noexcept;

/// Whether a row of a model is of coarse surfaces: none of these may press.
inline bool is_coarse_row(const ContactRow& row) noexcept { return row.body < 0; }

/// Asks for contacts and makes rows that hold for a way, as far as there is room. With levels of
/// detail the surfaces are coarse beyond `exact_within`, farther away the more often they pressed.
void renew(const World& world, const BodyState& relative, double way, NearPair& pair,
           PairModels& models, PairCounts& counts) noexcept;

}  // namespace thigma::detail
