#pragma once
// Where a session starts: apart from the scene, knowing which way and how far it is to the first
// touch.

#include <cstdint>
#include <optional>

#include "thigma/device/open_device.h"
#include "thigma/session/session.h"

namespace thigma {

struct StartPlacement {
  Pose world_from_body;            // of the centre of mass; nothing touches there
  double given_gap = 0.0;          // as given, of the closest points; < 0: they overlap [m]
  Vec3 approach = -Vec3::UnitZ();  // unit, from the object towards the scene [world]
  double clearance = 0.0;  // travel along approach to the first contact within the tolerance [m]
  bool is_moved = false;   // the objects overlapped, or touched within twice the tolerance
  bool has_scene = false;  // false: nothing was found near; approach and clearance are guesses
};

/// Places the grasped object for a hand that comes to it.
///
/// Objects that are farther apart than twice the tolerance stay as given. Those that overlap or
/// touch are moved apart by `gap` along the direction of the closest (or deepest) points, because
/// forces are never switched on inside a contact. The clearance is found by advancing back along
/// that direction by the distance at hand, so it cannot miss a surface. Orientation is kept.
///
/// world            tolerance > 0
/// world_from_body  as given
/// gap              wanted where the objects have to be moved, > 0 [m]; 0: a tenth of the object's
///                  radius; at least three times the tolerance
/// way_out          null, or the direction to move out along, any length > 0 [world]
/// Thread           [offline]; allocates its own scratch. Throws InputError when the objects
///                  cannot be told apart within four times their size.
StartPlacement find_start(const ContactWorld& world, const Pose& world_from_body, double gap = 0.0,
                          const Vec3* way_out = nullptr);

/// find_start for a session that is set up but for its start.
///
/// approach  from the object towards the scene, any length > 0 [world]; nothing: along the closest
///           points
/// config    world_from_body is as given before, the start afterwards
StartPlacement place_at_start(const std::optional<Vec3>& approach, SessionConfig& config);

/// What a simulated hand is told of the scene, in the device's frame and lengths.
///
/// approach       from the object towards the scene, any length > 0 [world]
/// clearance      until they meet along it [m; virtual]
/// object_radius  [m; virtual]
DeviceContext device_context(const Workspace& workspace, const Vec3& approach, double clearance,
                             double object_radius, std::uint64_t seed);
DeviceContext device_context(const SessionConfig& config, const StartPlacement& start,
                             double object_radius, std::uint64_t seed = 1);

}  // namespace thigma
