#pragma once
// How far two objects are from each other, and poses at a distance that is asked for
// (docs/sources.md, E1).

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/pose.h"

namespace thigma::experiments {

/// Least distance of the original surfaces, 0 where they intersect [m]. Best first over the
/// hierarchies, without memory of the last call.
/// Thread   [offline].
double least_distance(const ClodHierarchy& object, const Pose& world_from_object,
                      const ClodHierarchy& scene, const Pose& world_from_scene);

/// Moves the object along a direction from far away until the distance is `wanted`, without passing
/// a surface: by the distance that is missing, again and again.
///
/// start      apart by more than `wanted`; orientation is kept
/// direction  unit, towards the scene
/// wanted     >= 0 [m]; `tolerance` of it is met [m]
/// returns    the pose, or `start` with is_met false where the object passes by
struct Placed {
  Pose pose;
  bool is_met = false;
};
Placed place_at_distance(const ClodHierarchy& object, const Pose& start, const Vec3& direction,
                         const ClodHierarchy& scene, double wanted, double tolerance);

}  // namespace thigma::experiments
