// The contact thread's frame, Sec. 5.1.2: query, cluster, linearise.

#include "thigma/loop/contact_step.h"

#include <algorithm>
#include <limits>
#include <span>

#include "thigma/constraint/build_constraints.h"
#include "thigma/constraint/coarse_rows.h"
#include "thigma/contact/distribute_contacts.h"
#include "thigma/math/infinity.h"
#include "thigma/math/rotation.h"
#include "thigma/response/linearize_contacts.h"
#include "thigma/response/potential_contacts.h"
#include "thigma/response/texture_contacts.h"

namespace thigma {
namespace {

static_assert(kLevelDeciders == kLevelDecisions);

void count_level(std::int32_t level, LevelCounts& counts) noexcept {
  ++counts[static_cast<std::size_t>(std::clamp<std::int32_t>(level, 0, kLevelBins - 1))];
}

/// d of the query: of the response, and what relief reaches beyond coarse surfaces.
double query_tolerance(const ContactWorld& world) noexcept {
  return world.tolerance + relief_of(world.textures);
}

Pose world_from_mesh(const ContactWorld& world, const BodyState& body) noexcept {
  return Pose{body.position, body.orientation} * world.body_from_mesh;
}

// Relief tells from a cluster's triangles itself where it presses.
bool distributes_wide_contacts(const ContactWorld& world) noexcept {
  return world.distributes_wide_contacts && world.object != nullptr && world.textures.is_empty();
}

// Rows of coarse surfaces where they are far apart. Relief lies on the finest.
bool has_levels_far(const ContactWorld& world) noexcept {
  return world.constraints && !world.resolution.is_exact && world.textures.is_empty();
}

/// What the frame's contacts are like, for telemetry. Thread [contact].
void describe_contacts(const ContactWorld& world, const ContactScratch& scratch,
                       ContactSample& sample) noexcept {
  sample.contacts = static_cast<std::int64_t>(scratch.contacts.contacts.size());
  sample.dropped = scratch.contacts.dropped;
  sample.front = scratch.contacts.stats.front;
  sample.tests = scratch.contacts.stats.tests;
  sample.clusters = static_cast<std::int32_t>(scratch.clusters.clusters.size());
  sample.depth_max = -std::numeric_limits<double>::infinity();
  sample.bound_max = 0.0;
  sample.object_levels.fill(0);
  sample.scene_levels.fill(0);
  sample.decided_by.fill(0);
  sample.coarse = 0;
  for (const DepthTerm& term : sample.model.depths)
    sample.depth_max = std::max(sample.depth_max, term.depth);
  for (const Contact& contact : scratch.contacts.contacts) {
    // Coarse surfaces under relief may well be through each other, and those that rows have proven
    // apart.
    const bool is_row = world.constraints && is_coarse(contact);
    sample.coarse += is_row ? 1 : 0;
    if (!is_row && (world.textures.is_empty() || !is_textured(world.textures, contact.body)))
      sample.depth_max = std::max(sample.depth_max, contact.depth);
    sample.bound_max = std::max(sample.bound_max, contact.bound);
    count_level(contact.object_level, sample.object_levels);
    count_level(contact.scene_level, sample.scene_levels);
    ++sample.decided_by[static_cast<std::size_t>(contact.decided_by)];
  }
  sample.mandatory_tests = scratch.contacts.stats.mandatory_tests;
  sample.unrefined = scratch.contacts.stats.unrefined;
  sample.texture_depths = sample.texture_folds = sample.texture_sheets = 0;
  sample.texture_coarse = sample.texture_bent = 0;
  sample.texture_left_out = 0;
  if (world.textures.is_empty() || world.potential) return;
  if (world.constraints) {
    const ReliefStats& relief = scratch.constraints->relief.stats;
    sample.depth_max = std::max(sample.depth_max, relief.deepest);
    sample.texture_depths = relief.depths;
    sample.texture_folds = relief.folds;
    sample.texture_coarse = relief.coarse;
    sample.texture_bent = relief.bent;
    sample.texture_left_out = relief.left_out;
    return;
  }
  for (std::size_t i = 0; i < scratch.textures->contacts.size(); ++i) {
    const DepthSamples& depth = scratch.textures->samples[i];
    if (!depth.is_found) continue;
    ++sample.texture_depths;
    sample.texture_folds += depth.is_height_field ? 0 : 1;
    sample.texture_sheets += depth.is_of_sheets ? 1 : 0;
  }
}

}  // namespace

void reserve_query(const ContactWorld& world, ContactScratch& scratch) {
  scratch.fronts.resize(world.scene.size());
  for (std::size_t i = 0; i < world.scene.size(); ++i) {
    reserve_front(scratch.fronts[i], *world.object, *world.scene[i].hierarchy);
    if (world.resolution.carry > 0.0) reserve_carried(scratch.fronts[i]);
  }
  scratch.contacts.contacts.reserve(world.capacity);
}

void reserve_contact_scratch(const ContactWorld& world, ContactScratch& scratch) {
  reserve_query(world, scratch);
  if (world.constraints) {
    if (!scratch.constraints) scratch.constraints = std::make_shared<ConstraintScratch>();
    reserve_constraints(*world.constraints, world.capacity, *scratch.constraints);
    reserve_pair_lists(scratch.constraints->rows);
    if (has_levels_far(world)) scratch.constraints->coarse.reserve(world.capacity);
    if (!world.textures.is_empty())
      reserve_relief(world.textures, world.capacity, scratch.constraints->relief);
    return;
  }
  if (world.potential) {
    if (!scratch.potential) scratch.potential = std::make_shared<PotentialScratch>();
    reserve_potential(*world.potential, *scratch.potential);
    return;
  }
  if (distributes_wide_contacts(world)) scratch.spread.reserve(world.capacity);
  reserve_clusters(scratch.clustering, world.capacity);
  if (!world.textures.is_empty()) {
    if (!scratch.textures) scratch.textures = std::make_shared<TextureScratch>();
    reserve_texture_scratch(world.textures, *scratch.textures);
  }
  if (world.object != nullptr && !world.resolution.is_exact) {
    reserve_level_history(*world.object, world.scene, world.capacity, scratch.levels);
  }
}

namespace {

template <class Terms>
void set_friction(const ContactWorld& world, Terms& terms) noexcept {
  for (auto& term : terms) {
    if (term.body < 0) continue;  // of a coarse row
    term.friction = friction_on(world, term.body);
  }
}

/// Pairs that a query looks at, at most; and contacts it finds with levels far away.
constexpr std::size_t kMostPairs = 6000, kMostPairsFar = 1500;

/// What the time between models leaves.
struct Pace {
  double least = 0.0;   // that rows look ahead by, however slow the hand [m]
  double pairs = 0.0;   // within the look-ahead that are cheap to measure
  double margin = 1.0;  // of what is wanted
  double growth = 4.0;  // of the look-ahead from a model to the next, at most
};

/// A hand that is slow may be fast by the model after the next. Models that follow each other soon
/// have half as far to say, and time for fewer pairs. Those that come late say more than is wanted
/// now: how fast the hand will be by the next is known less. Soon is between the whole numbers of
/// milliseconds and halves that they come after.
Pace pace_of(const ConstraintWorld& world, double period) noexcept {
  constexpr double kSoon = 1.45e-3;  // [s]
  if (period <= kSoon) return {.least = 0.5 * world.least_look_ahead, .pairs = 350.0};
  return {.least = world.least_look_ahead, .pairs = 600.0, .margin = 2.0, .growth = 8.0};
}

/// Over relief the query is the smaller part, and all that is near has to be known.
Pace pace_over_relief(const ConstraintWorld& world) noexcept {
  return {.least = world.least_look_ahead, .pairs = 1500.0};
}

/// After how long models follow each other, the longest of the last ones: one that is late is not
/// alone.
double usual_period(double step_time, double before) noexcept {
  constexpr double kFade = 0.95;  // a model
  return std::max(step_time, kFade * before);
}

/// How far rows have to look ahead: what the object would go until the model after the next, with
/// the margin of the pace, in steps from the least, as far as the query stays cheap. Pairs grow
/// with the square of it, so that steps of two would bring four times as many at once; where none
/// were found nothing is known of how, so that it grows step by step, or as far as was free. Where
/// surfaces lie on each other that may be less than the usual least: then the object goes in small
/// steps, as far as was not too much to look at. To ask for more each time, and learn on the way
/// that it is too much, would be most of a query's work.
double look_ahead(const ConstraintWorld& world, double wanted, const Pace& pace,
                  const ContactScratch& last) noexcept {
  constexpr double kStep = 1.189207115002721;  // the fourth root of two
  constexpr int kStepsDown = 20, kCrowdedStepsDown = 48;
  const double enough = std::min(pace.margin * wanted, world.most_look_ahead);
  const double free = std::min(last.crowded_ahead, last.worth_ahead);
  const double pairs = static_cast<double>(last.contacts.contacts.size());
  const double known = std::min(
      std::max({pace.growth * last.looked_ahead, last.separation, world.least_look_ahead}), free);
  const auto is_cheap = [&](double ahead) {
    const double growth = ahead / std::max(last.looked_ahead, world.slop);
    return pairs * growth * growth <= pace.pairs && ahead <= known;
  };
  double ahead = pace.least;
  for (int i = 0; i < kStepsDown && !is_cheap(ahead); ++i) ahead /= kStep;
  for (int i = 0; i < kCrowdedStepsDown && ahead > free; ++i) ahead /= kStep;
  while (ahead < enough && is_cheap(kStep * ahead)) ahead *= kStep;
  return std::min(ahead, world.most_look_ahead);
}

/// What is left of the tolerance after the query: surfaces that conform may have had too many pairs
/// within it.
double found_tolerance(const std::vector<ContactFront>& fronts, double asked) noexcept {
  for (const ContactFront& front : fronts)
    if (front.tolerance >= 0.0) asked = std::min(asked, front.tolerance);
  return asked;
}

/// What was too far is tried again after some time, where more is wanted: a try that fails looks at
/// all that is between. Where nothing is near any more the object may have left what was.
void return_from_crowd(double wanted, double step_time, ContactScratch& scratch) noexcept {
  constexpr double kNear = 20.0, kFree = 200.0;  // of it in a second
  constexpr double kEnough = 2.0;                // of what is wanted
  if (!(scratch.looked_ahead < kEnough * wanted)) return;
  const double rate = scratch.contacts.contacts.empty() ? kFree : kNear;
  scratch.crowded_ahead *= 1.0 + rate * step_time;
}

/// Finest patches as near as the object wants to come until the next model, so that no coarse row
/// presses before it is made; coarse ones beyond.
Resolution levels_far(const ContactWorld& world, double ahead, double wanted) noexcept {
  constexpr double kNext = 0.5;    // of what is wanted until the model after
  constexpr double kMost = 0.5;    // of what is looked ahead
  constexpr double kLeast = 0.25;  // of the least look-ahead
  const ConstraintWorld& constraints = *world.constraints;
  Resolution resolution = world.resolution;
  resolution.metric = {.haptic = world.resolution.metric.haptic};
  resolution.exact_within =
      std::min(std::max(kNext * wanted, kLeast * constraints.least_look_ahead), kMost * ahead);
  resolution.turn = row_reach(constraints, ahead).turn;
  return resolution;
}

/// Contacts for rows: exact, or so where they are near.
void find_near(const ContactWorld& world, const StampedBody& body,
               ContactScratch& scratch) noexcept {
  constexpr double kUsualStep = 1e-3;  // of the first frame, which has none before it [s]
  const bool is_known = scratch.sequence > 0 && body.time > scratch.last_time;
  const double step_time = is_known ? body.time - scratch.last_time : kUsualStep;
  if (is_known) scratch.period = usual_period(step_time, scratch.period);
  scratch.last_time = body.time;
  ContactQuery query;
  // Until the model after the next. Coarse patches under relief are few and the way over it is
  // uneven: twice as far.
  const bool has_relief = !world.textures.is_empty();
  const double models = has_relief ? 4.0 : 2.0;
  const double ahead_time = models * step_time;
  const double wanted = (body.wanted_speed + 0.5 * body.wanted_gain * ahead_time) * ahead_time;
  const ConstraintWorld& constraints = *world.constraints;
  const Pace pace =
      has_relief ? pace_over_relief(constraints) : pace_of(constraints, scratch.period);
  scratch.looked_ahead = look_ahead(constraints, wanted, pace, scratch);
  // Fine surfaces may meet where coarse ones are still apart by their relief.
  const double relief = relief_of(world.textures);
  query.tolerance = scratch.looked_ahead + relief;
  // Coarse surfaces under relief have few, and have to be known beyond the relief.
  query.most_pairs = has_relief ? 0 : kMostPairs;
  query.least_tolerance = crowded_look_ahead(constraints);
  if (has_levels_far(world)) {
    query.resolution = levels_far(world, scratch.looked_ahead, wanted);
    query.most_pairs = kMostPairsFar;
  } else if (!has_relief)  // rows ask contacts which patches are near, no more
    query.resolution.carry = world.resolution.carry;
  query.measures_hulls = query.holds_near = !has_relief;
  query_scene({*world.object, world_from_mesh(world, body.state)}, world.scene, query,
              scratch.fronts, scratch.contacts);
  const double found = found_tolerance(scratch.fronts, query.tolerance);
  if (found < query.tolerance) {
    scratch.looked_ahead = found;  // there is no relief then
    scratch.crowded_ahead = found;
  } else {
    return_from_crowd(wanted, step_time, scratch);
  }
  scratch.separation = scratch.looked_ahead;
  const bool is_far = scratch.contacts.contacts.empty();
  if (has_relief) limit_to_relief(world.textures, scratch.looked_ahead, scratch.contacts);
  if (!is_far) return;
  // Nothing is near: the object may go as far as the traversal has proven.
  scratch.separation = kInfinity;
  for (const ContactFront& front : scratch.fronts)
    scratch.separation = std::min(scratch.separation, unreported_separation(front) - relief);
  scratch.crowded_ahead = std::max(scratch.crowded_ahead, scratch.separation);
}

/// The rows of contacts that touch relief, and all contacts but those.
NearContacts find_relief(const ContactWorld& world, const StampedBody& body,
                         const ContactScratch& scratch, ReliefScratch& relief) noexcept {
  const ReliefReach reach{scratch.separation, scratch.separation / world.constraints->reach,
                          world.constraints->least_look_ahead};
  find_relief_rows({world.textures, world.constraints->relief, world.scene, scratch.contacts,
                    world.max_clusters, scratch.looked_ahead},
                   world_from_mesh(world, body.state), body.state.position, reach, relief);
  return {relief.plain, scratch.separation, relief.rows, relief.travel};
}

/// All contacts, with the rows of those that are coarse.
NearContacts find_coarse(const ContactWorld& world, const StampedBody& body,
                         const ContactScratch& scratch, std::vector<FoundRow>& rows) noexcept {
  rows.clear();
  find_coarse_rows({*world.object, world_from_mesh(world, body.state)}, world.scene,
                   scratch.contacts.contacts, row_reach(*world.constraints, scratch.separation),
                   rows);
  return {scratch.contacts, scratch.separation, rows};
}

/// The way as since the last model, until the model after the next.
LikelyWay likely_way(const BodyState& now, double reach, const ConstraintScratch& last) noexcept {
  constexpr double kModels = 2.0;
  const BodyState& from = last.last_state;
  LikelyWay way{.is_known = true, .center = now.position};
  way.linear = kModels * (now.position - from.position);
  way.turn = kModels * vector_from_rotation(now.orientation * from.orientation.conjugate());
  way.change =
      (way.linear - last.last_way.linear).norm() + reach * (way.turn - last.last_way.turn).norm();
  return way;
}

/// How far the next model is worth looking; where nothing is near there are no rows to have room.
double worth_ahead(const ConstraintWorld& world, const ConstraintStats& stats, double travel,
                   const ContactScratch& last) noexcept {
  constexpr double kMore = 1.5;
  if (last.contacts.contacts.empty()) return kInfinity;
  return worth_asking(stats, std::max(travel, crowded_look_ahead(world)),
                      std::max(last.looked_ahead, last.worth_ahead), kMore);
}

/// Rows instead of clusters.
void make_rows(const ContactWorld& world, const StampedBody& body, ContactScratch& scratch,
               ContactSample& sample) noexcept {
  LinearContactModel& model = sample.model;
  model.state = body.state;
  model.time = body.time;
  model.sequence = ++scratch.sequence;
  model.planes.clear();
  model.depths.clear();
  ConstraintScratch& work = *scratch.constraints;
  const bool has_relief = !world.textures.is_empty();
  NearContacts near = has_relief              ? find_relief(world, body, scratch, work.relief)
                      : has_levels_far(world) ? find_coarse(world, body, scratch, work.coarse)
                                              : NearContacts{scratch.contacts, scratch.separation};
  if (model.sequence > 1)
    near.way = work.last_way = likely_way(body.state, world.constraints->reach, work);
  work.last_state = body.state;
  const ConstraintStats stats =
      build_constraints(*world.constraints, body.state, near, work, model.constraints);
  if (stats.left_out > 0)  // it stops the object, which would ask for as much again
    scratch.crowded_ahead = std::min(scratch.crowded_ahead, 0.5 * scratch.looked_ahead);
  else if (!has_relief)
    scratch.worth_ahead = worth_ahead(*world.constraints, stats, model.constraints.travel, scratch);
  sample.rows = stats.rows;
  sample.travel_halvings = stats.halvings;
  sample.left_out = stats.left_out;
  sample.travel = model.constraints.travel;
  sample.look_ahead = scratch.looked_ahead;
  set_friction(world, model.constraints.rows);
}

}  // namespace

void find_contacts(const ContactWorld& world, const StampedBody& body,
                   ContactScratch& scratch) noexcept {
  if (world.constraints) {
    find_near(world, body, scratch);
    return;
  }
  clear(scratch.contacts);
  if (world.potential) return;  // measures areas instead
  const Pose pose = world_from_mesh(world, body.state);
  if (!world.scene.empty()) {
    ContactQuery query;
    query.tolerance = query_tolerance(world);
    query.keep_directions = true;
    if (world.textures.is_empty() || has_levels(world.textures))
      query.resolution = world.resolution;
    if (scratch.sequence > 0 && body.time > scratch.last_time) {
      query.resolution.step_time = body.time - scratch.last_time;
    }
    scratch.last_time = body.time;
    query_scene({*world.object, pose}, world.scene, query, scratch.fronts, scratch.contacts);
    if (!world.textures.is_empty())
      limit_to_relief(world.textures, world.tolerance, scratch.contacts);
  }
  if (world.source) world.source(pose, world.tolerance, scratch.contacts);
}

namespace {

/// Clusters of the contacts, and the terms they make.
void make_terms(const ContactWorld& world, const StampedBody& body, ContactScratch& scratch,
                ContactSample& sample) noexcept {
  ClusterParams clustering;
  clustering.max_clusters = world.max_clusters;
  clustering.tolerance = query_tolerance(world);
  std::span<const Contact> pressing = scratch.contacts.contacts;
  scratch.spread.clear();
  if (distributes_wide_contacts(world)) {
    distribute_contacts({*world.object, world_from_mesh(world, body.state)}, world.scene, pressing,
                        world.tolerance, scratch.spread);
    pressing = scratch.spread;
  }
  cluster_contacts(pressing, scratch.clusters, clustering, scratch.clustering, scratch.clusters);

  PenaltyParams response = world.response;
  // one d: what the query starts at is what the force starts at
  response.tolerance = world.tolerance;
  ++scratch.sequence;
  const ModelStamp stamp{body.state, body.time, scratch.sequence};
  sample.model = world.textures.is_empty()
                     ? linearize_contacts(scratch.clusters, response, stamp)
                     : linearize_textured({world.textures, world_from_mesh(world, body.state),
                                           world.scene, scratch.contacts.contacts, scratch.clusters,
                                           scratch.clustering.assignment},
                                          response, stamp, *scratch.textures);
  set_friction(world, sample.model.planes);
  set_friction(world, sample.model.depths);
}

/// Springs of the potential law. Returns over how many parts of the surfaces it was summed.
std::int64_t make_springs(const ContactWorld& world, const StampedBody& body,
                          ContactScratch& scratch, ContactSample& sample) noexcept {
  PenaltyParams response = world.response;
  response.tolerance = world.tolerance;
  const PotentialContact contact = measure_potential(
      *world.potential, body.state, world.potential_law, world.tolerance, *scratch.potential);
  sample.model = potential_model(contact, response, world.potential_law,
                                 {body.state, body.time, ++scratch.sequence});
  set_friction(world, sample.model.depths);
  return contact.stats.cells;
}

}  // namespace

void make_model(const ContactWorld& world, const StampedBody& body, ContactScratch& scratch,
                ContactSample& sample) noexcept {
  std::int64_t areas = 0;
  if (world.constraints)
    make_rows(world, body, scratch, sample);
  else if (world.potential)
    areas = make_springs(world, body, scratch, sample);
  else
    make_terms(world, body, scratch, sample);
  sample.time = body.time;
  describe_contacts(world, scratch, sample);
  if (world.potential) sample.contacts = areas;
  sample.level_changes = sample.pressing_changes = 0;
  sample.triangles_below = 0.0;
  if (!world.resolution.is_exact && !world.constraints && !world.potential) {
    const LevelChanges changes =
        count_level_changes(*world.object, world.scene, scratch.contacts.contacts,
                            query_tolerance(world), scratch.levels);
    sample.level_changes = changes.all;
    sample.pressing_changes = changes.pressing;
    sample.triangles_below = triangles_below(scratch.levels);
  }
  sample.model_digest = model_digest(sample.model);
}

void contact_step(const ContactWorld& world, const StampedBody& body, ContactScratch& scratch,
                  ContactSample& sample) noexcept {
  find_contacts(world, body, scratch);
  make_model(world, body, scratch, sample);
}

}  // namespace thigma
