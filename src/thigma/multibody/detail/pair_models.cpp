#include "thigma/multibody/detail/pair_models.h"

#include <algorithm>

#include "thigma/constraint/coarse_rows.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

constexpr std::size_t kContacts = 16384;  // of a pair
constexpr std::size_t kMostPairs = 6000;  // of patches, before a query looks less far ahead
// Front nodes of a pair, at most; more are traversed without memory.
constexpr std::size_t kMostFront = 65536;

std::int32_t front_capacity(const ClodHierarchy& a, const ClodHierarchy& b) noexcept {
  return static_cast<std::int32_t>(
      std::clamp<std::size_t>(2 * (a.nodes.size() + b.nodes.size()), 128, kMostFront));
}

std::unique_ptr<NearPair> make_pair(const World& world, std::int32_t kind) {
  auto pair = std::make_unique<NearPair>();
  pair->kind = kind;
  const PairKind& k = pair_kind(world, kind);
  const ClodHierarchy& a = *world.shapes[idx(k.first)].hierarchy;
  const ClodHierarchy& b = *world.shapes[idx(k.second)].hierarchy;
  reserve_front(pair->front, a, b, front_capacity(a, b));
  pair->history.reserve(kMaxRows);
  return pair;
}

NearPair& take_free(const World& world, std::int32_t kind, PairModels& models) {
  for (const auto& pair : models.pool)
    if (pair->kind == kind && pair->first < 0) return *pair;
  models.pool.push_back(make_pair(world, kind));
  models.near.reserve(models.pool.capacity());
  return *models.pool.back();
}

BodyPairIndex index_of(const NearPair& pair) noexcept {
  return {std::min(pair.first, pair.second), std::max(pair.first, pair.second)};
}

void forget(NearPair& pair) noexcept {
  clear_front(pair.front);
  pair.first = pair.second = -1;
  pair.has_model = false;
  pair.looked_ahead = 0.0;
  pair.worth = kInfinity;
  pair.history.clear();
}

/// Impulses of the rows before, for those that are there again.
void carry_over(NearPair& pair, std::vector<RowHistory>& before) noexcept {
  before.assign(pair.history.begin(), pair.history.end());
  pair.history.clear();
  for (const ContactRow& row : pair.model.rows) {
    RowHistory next{row.id, Vec3::Zero(), false};
    for (const RowHistory& old : before)
      if (old.id == row.id) next = old;
    pair.history.push_back(next);
  }
}

bool has_levels(const World& world, const PairKind& kind) noexcept {
  return world.threshold > 0.0 && !world.shapes[idx(kind.first)].hierarchy->level_patches.empty() &&
         !world.shapes[idx(kind.second)].hierarchy->level_patches.empty();
}

/// How far from each other patches are the finest ones: what bodies at rest look at, or their way
/// where that is less; where coarse rows have pressed more of the way, then everything (0).
double exact_within(const ConstraintWorld& constraints, double way, const NearPair& pair,
                    double tolerance) noexcept {
  constexpr double kSpare = 1.1;   // of the way
  constexpr double kLeast = 0.25;  // of the least look-ahead
  constexpr double kPressed = 8.0;
  constexpr double kMost = 0.5;  // of what is looked ahead
  if (pair.pressed > 1) return 0.0;
  const double least = constraints.least_look_ahead;
  const double most = pair.pressed > 0 ? kPressed * least : least;
  return std::min(std::clamp(kSpare * way, kLeast * least, most), kMost * tolerance);
}

/// Rows of what stays coarse, of the last query.
std::span<const FoundRow> find_coarse(const World& world, const BodyState& relative,
                                      double separation, const NearPair& pair,
                                      PairModels& models) noexcept {
  const PairKind& kind = pair_kind(world, pair.kind);
  const BodyShape &first = world.shapes[idx(kind.first)], &second = world.shapes[idx(kind.second)];
  const Pose second_from_first =
      Pose{relative.position, relative.orientation} * first.body_from_mesh;
  const SceneBody body{second.hierarchy, second.body_from_mesh};
  std::vector<FoundRow>& rows = models.scratch.coarse;
  rows.clear();
  find_coarse_rows({*first.hierarchy, second_from_first}, {&body, 1}, models.contacts.contacts,
                   row_reach(kind.constraints, separation), rows);
  return rows;
}

void ask(const World& world, const BodyState& relative, const ContactQuery& query, NearPair& pair,
         PairModels& models) noexcept {
  const PairKind& kind = pair_kind(world, pair.kind);
  const BodyShape &first = world.shapes[idx(kind.first)], &second = world.shapes[idx(kind.second)];
  clear(models.contacts);
  const Pose second_from_first =
      Pose{relative.position, relative.orientation} * first.body_from_mesh;
  query_contacts({*first.hierarchy, second_from_first}, {*second.hierarchy, second.body_from_mesh},
                 query, pair.front, models.contacts);
}

}  // namespace

BodyState relative_state(const BodyState& first, const BodyState& second) noexcept {
  BodyState relative;
  const Quat back = second.orientation.conjugate();
  relative.position = back._transformVector(first.position - second.position);
  relative.orientation = (back * first.orientation).normalized();
  return relative;
}

void reserve_pairs(const World& world, std::size_t pairs, PairModels& models) {
  models.contacts.contacts.reserve(kContacts);
  models.before.reserve(kMaxRows);
  if (world.threshold > 0.0) models.scratch.coarse.reserve(kContacts);
  const std::vector<PairKind>& kinds = world.pair_kinds->list;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    reserve_constraints(kinds[k].constraints, kContacts, models.scratch);
    for (std::size_t i = 0; i < pairs; ++i)
      models.pool.push_back(make_pair(world, static_cast<std::int32_t>(k)));
  }
  models.near.reserve(models.pool.size());
}

void take_pairs(const World& world, std::span<const BodyPairIndex> pairs, PairModels& models) {
  for (NearPair* pair : models.near) pair->is_used = false;
  const auto find = [&](const BodyPairIndex& wanted) -> NearPair* {
    const auto at = std::lower_bound(
        models.near.begin(), models.near.end(), wanted,
        [](const NearPair* p, const BodyPairIndex& key) { return index_of(*p) < key; });
    return at != models.near.end() && index_of(**at) == wanted ? *at : nullptr;
  };
  for (const BodyPairIndex& wanted : pairs)
    if (NearPair* pair = find(wanted)) pair->is_used = true;
  const std::size_t known = models.near.size();
  for (const BodyPairIndex& wanted : pairs) {
    const auto count = world.shapes.size();
    const std::int32_t kind =
        world.kind_of[idx(world.shape[idx(wanted.a)]) * count + idx(world.shape[idx(wanted.b)])];
    if (kind < 0) continue;
    NearPair* const* begin = models.near.data();
    const auto at = std::lower_bound(
        begin, begin + known, wanted,
        [](const NearPair* p, const BodyPairIndex& key) { return index_of(*p) < key; });
    if (at != begin + known && index_of(**at) == wanted) continue;
    NearPair& pair = take_free(world, kind, models);
    const bool in_order = world.shape[idx(wanted.a)] == pair_kind(world, kind).first;
    pair.first = in_order ? wanted.a : wanted.b;
    pair.second = in_order ? wanted.b : wanted.a;
    pair.is_used = true;
    models.near.push_back(&pair);
  }
  for (NearPair* pair : models.near)
    if (!pair->is_used) forget(*pair);
  std::erase_if(models.near, [](const NearPair* pair) { return !pair->is_used; });
  std::sort(models.near.begin(), models.near.end(),
            [](const NearPair* a, const NearPair* b) { return index_of(*a) < index_of(*b); });
}

bool holds(const World& world, const NearPair& pair, const BodyState& relative,
           double way) noexcept {
  if (!pair.has_model) return false;
  const double reach = pair_kind(world, pair.kind).constraints.reach;
  return travel_between(pair.model.state, relative, reach) + way <= pair.model.travel;
}

void find_contacts(const World& world, const BodyState& relative, double tolerance, NearPair& pair,
                   PairModels& models) noexcept {
  ask(world, relative, {.tolerance = tolerance, .most_pairs = kMostPairs}, pair, models);
}

void renew(const World& world, const BodyState& relative, double way, NearPair& pair,
           PairModels& models, PairCounts& counts) noexcept {
  const ConstraintWorld& constraints = pair_kind(world, pair.kind).constraints;
  // A model serves some steps where it is cheap to look a little farther.
  constexpr double kMore = 1.25;
  ContactQuery query;
  query.tolerance = std::clamp(kMore * way, constraints.least_look_ahead, most_ahead(world, pair));
  query.most_pairs = kMostPairs;
  query.least_tolerance = crowded_look_ahead(constraints);
  // Rows are of features, whichever way their patches were found to be near: hulls are enough, and
  // of surfaces that lie on each other they take a fraction.
  query.measures_hulls = true;
  pair.exact_within = has_levels(world, pair_kind(world, pair.kind))
                          ? exact_within(constraints, way, pair, query.tolerance)
                          : 0.0;
  if (pair.exact_within > 0.0) {
    query.most_pairs = 0;  // as many as there are: else the step would go in parts
    query.resolution.is_exact = false;
    query.resolution.metric = {.haptic = world.threshold};
    query.resolution.exact_within = pair.exact_within;
    query.resolution.turn = row_reach(constraints, query.tolerance).turn;
  }
  ask(world, relative, query, pair, models);
  pair.looked_ahead = query.tolerance;
  if (pair.front.tolerance >= 0.0)
    pair.looked_ahead = std::min(pair.looked_ahead, pair.front.tolerance);
  const bool is_far = models.contacts.contacts.empty();
  const double separation = is_far ? unreported_separation(pair.front) : pair.looked_ahead;
  NearContacts near{models.contacts, separation};
  if (pair.exact_within > 0.0) near.relief = find_coarse(world, relative, separation, pair, models);
  const ConstraintStats stats =
      build_constraints(constraints, relative, near, models.scratch, pair.model);
  // Where rows had no room they hold for less: twice as much is tried again, more once they have.
  constexpr double kAgain = 2.0;
  if (pair.exact_within == 0.0)
    pair.worth =
        worth_asking(stats, pair.model.travel, std::max(pair.worth, query.tolerance), kAgain);
  const Friction friction =
      friction_between(world.bodies[idx(pair.first)], world.bodies[idx(pair.second)]);
  for (ContactRow& row : pair.model.rows)
    if (!is_coarse_row(row)) row.friction = friction;
  carry_over(pair, models.before);
  pair.has_model = true;
  pair.left_out = stats.left_out;
  ++counts.queries;
  counts.contacts += static_cast<std::int64_t>(models.contacts.contacts.size());
  counts.coarse += static_cast<std::int64_t>(near.relief.size());
  counts.rows += static_cast<std::int64_t>(pair.model.rows.size());
  counts.left_out += stats.left_out;
}

}  // namespace thigma::detail
