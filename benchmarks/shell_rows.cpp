#include "benchmarks/shell_rows.h"

#include <algorithm>

namespace thigma::bench {
namespace {

constexpr double kShare = 0.95, kFar = 10.0;  // of the separation: as build_constraints has them

FoundRow row_of(const ShellContact& contact, const Pose& body_from_world,
                const Friction& friction) {
  const Vec3 other =
      contact.point + (contact.is_of_object ? -1.0 : 1.0) * contact.depth * contact.normal;
  FoundRow found;
  ContactRow& row = found.row;
  row = make_row(contact.is_of_object ? RowKind::scene_plane : RowKind::object_plane);
  const Vec3& of_object = contact.is_of_object ? contact.point : other;
  row.object_point = transform_point(body_from_world, of_object);
  row.scene_point = contact.is_of_object ? other : contact.point;
  if (contact.is_of_object)
    row.scene_direction = contact.normal;
  else
    row.object_direction = body_from_world.orientation._transformVector(contact.normal);
  row.id = 2 * static_cast<std::uint64_t>(contact.index) + (contact.is_of_object ? 1 : 0) + 1;
  row.friction = friction;
  found.gap = -contact.depth;
  return found;
}

}  // namespace

void make_shell_rows(const ConstraintWorld& world, const BodyState& state,
                     std::span<const ShellContact> contacts, double separation,
                     const Friction& friction, ShellRowScratch& scratch, ConstraintModel& model) {
  const Pose body_from_world = inverse(Pose{state.position, state.orientation});
  scratch.found.clear();
  for (const ShellContact& contact : contacts)
    scratch.found.push_back(row_of(contact, body_from_world, friction));
  reserve_implied(scratch.implied, scratch.found.size());
  model.state = state;
  model.reach = world.reach;
  model.travel = kShare * std::min(separation, kFar * world.reach);
  take_needed_rows(scratch.found, world.slop, scratch.implied, model);
}

}  // namespace thigma::bench
