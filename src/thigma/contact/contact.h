#pragma once
// Contacts: the one place where their sign and frame are defined.

#include <cstdint>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/math/types.h"

namespace thigma {

struct ClodHierarchy;

enum class ContactStatus : std::uint8_t {
  separated,    // depth <= 0 is minus the distance of the original triangles
  penetrating,  // depth >= 0 along normal, at most half the patch thickness
  deep,         // depth > 0 beyond that: the direction is kept, or a thicker ancestor's
  // through each other, but still mostly side by side: depth <= 0, above minus the distance of the
  // original triangles and below their overlap, turning from one to the other (see pair_contact)
  grazing,
};

/// What decided how fine a contact is: of the criteria that are on the one nearest to its limit,
/// unless a budget ended refinement before they were met, or there is nothing finer.
enum class LevelDecision : std::uint8_t { haptic, velocity, view, cap, budget, finest };
inline constexpr std::size_t kLevelDecisions = 6;

/// A contact between one surface patch of the grasped object and one of a scene object (Sec.
/// 5.4.1). depth = normal . (point - scene_point): positive when penetrating, negative when
/// separated.
struct Contact {
  Vec3 point = Vec3::Zero();        // p, on the grasped object [m; world]
  Vec3 scene_point = Vec3::Zero();  // p_0, on the scene object [m; world]
  Vec3 normal = Vec3::UnitZ();      // unit, out of the grasped object, into the scene [world]
  double depth = 0.0;               // [m]
  // |depth - d0| <= bound, where d0 is minus the separation (penetrating: the depth along normal)
  // of the original triangles below both patches [m]; 0 = exact
  double bound = 0.0;
  // 0..1: of a pair blended with its children, else 1 (Sec. 3.4.4)
  double weight = 1.0;
  std::int32_t body = 0;  // static object of the scene, 0..
  // Where it comes from: a finest patch p as p, a contact patch c of a simplified level as
  // patches.size() + c.
  std::int32_t object_patch = -1, scene_patch = -1;
  std::int32_t object_level = 0, scene_level = 0;  // of detail: 0 finest
  ContactStatus status = ContactStatus::separated;
  LevelDecision decided_by = LevelDecision::finest;
};

/// Counts of one query.
struct QueryStats {
  std::int64_t front = 0;         // node pairs held after the query
  std::int64_t tests = 0;         // node pairs looked at
  std::int64_t pair_queries = 0;  // convex pairs solved
  std::int64_t triangle_pairs = 0;
  // of tests: those no budget can leave out (free levels, validity of the front)
  std::int64_t mandatory_tests = 0;
  std::int64_t unrefined = 0;  // contacts left coarser than asked for want of budget
};

/// Contacts of one frame. The caller reserves capacity; a query never grows it, what does not fit
/// is counted.
struct ContactSet {
  std::vector<Contact> contacts;
  std::int64_t dropped = 0;
  QueryStats stats;
};

/// A static object of the scene.
struct SceneBody {
  const ClodHierarchy* hierarchy = nullptr;
  Pose world_from_body;
};

/// A hierarchy where it is in the world: one side of a query.
struct PlacedHierarchy {
  const ClodHierarchy& hierarchy;
  Pose world_from_body{};  // |orientation| = 1 to 1e-9
};

}  // namespace thigma
