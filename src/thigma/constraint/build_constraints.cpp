#include "thigma/constraint/build_constraints.h"

#include <algorithm>
#include <map>

#include "thigma/core/index.h"

namespace thigma {
namespace {

// Of the separation: nothing comes as near as that.
constexpr double kShare = 0.95;
// A travel that is free in all but name, times the reach.
constexpr double kFar = 10.0;

std::int64_t find_all(const ConstraintWorld& world, const Pose& world_from_object,
                      std::span<const Contact> contacts, const RowReach& reach,
                      ConstraintScratch& scratch) noexcept {
  std::int64_t left_out = 0;
  scratch.found.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const BodyPair pair{{&world.object, world_from_object},
                        {world.scene[i].get(), world.bodies[i].world_from_body},
                        static_cast<std::int32_t>(i)};
    left_out += find_rows(pair, contacts, reach, scratch.rows, scratch.found);
    if (reach.most_rows > 0 && left_out > 0) break;  // they are looked for again
  }
  return left_out;
}

/// The same for a travel that is halved until all fits and is not too much; both are counted.
void find_for_travel(const ConstraintWorld& world, const Pose& world_from_object,
                     const NearContacts& near, ConstraintScratch& scratch, double& travel,
                     ConstraintStats& stats) noexcept {
  constexpr int kHalvings = 8;
  // Of so many rows far too many are needed: to find the others first would be in vain.
  constexpr std::size_t kMostFound = 8 * kMaxRows;
  constexpr int kBounded = 4;  // halvings; smooth surfaces have a fourth of the rows each time
  for (;; ++stats.halvings) {
    RowReach reach = row_reach(world, travel);
    reach.way = near.way;
    if (stats.halvings < kBounded) reach.most_rows = kMostFound;
    stats.left_out = find_all(world, world_from_object, near.contacts.contacts, reach, scratch);
    if (stats.left_out == 0 || stats.halvings == kHalvings) return;
    travel *= 0.5;
  }
}

/// Points and directions of the object in the frame of its body.
void move_into_body(const ConstraintWorld& world, ContactRow& row) noexcept {
  const Pose& body_from_mesh = world.body_from_mesh;
  row.object_point = transform_point(body_from_mesh, row.object_point);
  if (row.kind != RowKind::relief)
    row.object_direction = body_from_mesh.orientation._transformVector(row.object_direction);
}

}  // namespace

ConstraintWorld make_constraint_world(const ClodHierarchy& object, const Pose& body_from_mesh,
                                      std::span<const SceneBody> bodies) {
  ConstraintWorld world;
  world.object = find_features(object);
  world.body_from_mesh = body_from_mesh;
  world.bodies.assign(bodies.begin(), bodies.end());
  for (const Vec3& v : world.object.vertices)
    world.reach = std::max(world.reach, transform_point(body_from_mesh, v).norm());
  constexpr double kSlop = 3e-6;  // of the reach: 60 nm of an object of 4 cm
  world.slop = kSlop * world.reach;
  constexpr double kLeast = 2.5e-3, kMost = 0.3;  // of the reach: what a query may cost
  world.least_look_ahead = kLeast * world.reach;
  world.most_look_ahead = kMost * world.reach;
  std::map<const ClodHierarchy*, std::shared_ptr<const SurfaceFeatures>> known;
  for (const SceneBody& body : bodies) {
    auto& features = known[body.hierarchy];
    if (!features)
      features = std::make_shared<const SurfaceFeatures>(find_features(*body.hierarchy));
    world.scene.push_back(features);
  }
  return world;
}

void widen(ConstraintWorld& world) noexcept {
  constexpr double kSlop = 5e-5;  // of the reach
  world.slop = kSlop * world.reach;
}

void reserve_constraints(const ConstraintWorld& world, std::size_t capacity,
                         ConstraintScratch& scratch) {
  for (const auto& features : world.scene)
    reserve_rows(scratch.rows, world.object, *features, capacity);
  scratch.found.reserve(capacity);
  reserve_implied(scratch.implied, capacity);
}

RowReach row_reach(const ConstraintWorld& world, double travel) noexcept {
  constexpr double kChord = 1.1;  // of an angle of less than a right one over its chord
  return {travel, kChord * travel / world.reach};
}

std::int32_t take_needed_rows(std::span<const FoundRow> found, double slop, ImpliedScratch& scratch,
                              ConstraintModel& model) noexcept {
  constexpr double kKept = 0.5;  // of the gap that is kept: what a step may leave of it
  constexpr double kCut = 0.7071067811865476;  // two make a half
  constexpr int kCuts = 12;
  model.rows.clear();
  std::span<const std::int32_t> needed;
  std::int32_t cuts = 0;
  for (; cuts <= kCuts; ++cuts) {
    const RowBounds bounds{model.travel, model.reach, kKept * slop};
    needed = cuts == 0 ? needed_rows(found, model.state, bounds, kMaxRows, scratch)
                       : needed_again(bounds, kMaxRows, scratch);
    if (needed.size() <= kMaxRows) break;
    model.travel *= kCut;
  }
  // Too many even so: nearest first, none of the others is met before the first of them.
  if (needed.size() > kMaxRows)
    model.travel = std::min(model.travel, std::max(found[idx(needed.back())].gap, 0.0));
  for (const std::int32_t row : needed) {
    if (model.rows.size() == kMaxRows) break;
    model.rows.push_back(found[idx(row)].row);
  }
  return (cuts + 1) / 2;
}

ConstraintStats build_constraints(const ConstraintWorld& world, const BodyState& state,
                                  const NearContacts& near, ConstraintScratch& scratch,
                                  ConstraintModel& model) noexcept {
  ConstraintStats stats;
  const Pose world_from_object = Pose{state.position, state.orientation} * world.body_from_mesh;
  model.state = state;
  model.reach = world.reach;
  model.travel = kShare * std::min(near.separation, kFar * world.reach);
  model.travel = std::min(model.travel, near.relief_travel);
  find_for_travel(world, world_from_object, near, scratch, model.travel, stats);
  stats.left_out += near.contacts.dropped;
  const std::size_t room = scratch.found.capacity() - scratch.found.size();
  const auto relief = near.relief.first(std::min(near.relief.size(), room));
  scratch.found.insert(scratch.found.end(), relief.begin(), relief.end());
  stats.left_out += static_cast<std::int64_t>(near.relief.size() - relief.size());
  stats.rows = static_cast<std::int64_t>(scratch.found.size());
  for (FoundRow& found : scratch.found) move_into_body(world, found.row);
  stats.halvings += take_needed_rows(scratch.found, world.slop, scratch.implied, model);
  if (stats.left_out > 0) model.travel = 0.0;
  return stats;
}

}  // namespace thigma
