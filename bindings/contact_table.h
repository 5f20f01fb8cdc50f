#pragma once
// Contacts at many poses as columns: what languages with arrays take over without a copy.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/pose.h"

namespace thigma::bindings {

/// Contacts of n poses, N in all. Those of pose i are rows start[i] to start[i + 1].
struct ContactTable {
  std::vector<double> distance;            // least, of the contacts; infinity without one (n) [m]
  std::vector<std::int64_t> start{0};      // (n + 1)
  std::vector<double> cpu;                 // CPU time of the query (n) [s]
  std::vector<std::int64_t> front, tests;  // node pairs held, looked at (n)
  std::vector<Vec3> point, scene_point;    // on the object, on the scene (N) [m; world]
  std::vector<Vec3> normal;                // out of the object (N) [world]
  std::vector<double> depth, bound;        // (N) [m]
  std::vector<std::array<std::int32_t, 2>> level;  // of the object, of the scene (N)
};

/// What is asked at every pose.
struct TableQuery {
  ContactQuery contact{};
  bool is_fresh = false;  // forget the pose before, as after clear_front
};

/// Throws InputError for a query that is not one.
void check_query(const ContactQuery& query);

/// Whether contacts were dropped; then there is room for all, and the query is to be made again.
/// pose    for messages
/// throws  InputError for more than can be listed
bool needs_room(ContactSet& set, std::size_t pose);

/// Called now and then; what it throws ends the work.
using Poll = std::function<void()>;

/// Queries the poses in their order, as `thigma contacts` does. Nothing is dropped.
///
/// object   at `poses`: world from body, unit quaternions
/// scene    where it stands
/// poll     may be empty; called about ten times a second
/// Thread   [offline]; throws InputError for a query that is not one, or with more contacts at a
///          pose than can be listed
ContactTable contacts_at_poses(const ClodHierarchy& object, const PlacedHierarchy& scene,
                               std::span<const Pose> poses, const TableQuery& query,
                               const Poll& poll = {});

/// Poses from rows x, y, z, qx, qy, qz, qw (7 n) [m].
/// name    of the argument, for messages
/// Thread  [offline]; throws InputError for a number that is not finite and a quaternion whose
///         length is off 1 by more than 1e-6
std::vector<Pose> poses_from_rows(std::span<const double> rows, const char* name);

}  // namespace thigma::bindings
