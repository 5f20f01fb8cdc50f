#pragma once
// From exact contacts to rows: inequalities that keep two surfaces apart wherever the object goes
// within a reach, and forbid as little else as can be.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/constraint/surface_features.h"
#include "thigma/contact/contact.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/math/pose.h"

namespace thigma {

/// One body's surface where it is.
struct PlacedFeatures {
  const SurfaceFeatures* features = nullptr;
  Pose world_from_mesh;
};

/// The object and one body of the scene, apart or touching, where the query was made.
struct BodyPair {
  PlacedFeatures object, scene;
  std::int32_t body = 0;  // the scene's, as contacts name it
};

/// The motion that the object is likely to make while the rows hold: it says which rows disturb
/// least, never which are needed.
struct LikelyWay {
  bool is_known = false;
  Vec3 linear = Vec3::Zero(), turn = Vec3::Zero();  // [m, rad; world]
  Vec3 center = Vec3::Zero();                       // turned about [m; world]
  double change = 0.0;  // of the way of any point since the model before, at most [m]
};

/// What the rows are asked for.
struct RowReach {
  double travel = 0.0;  // no point of the object moves farther [m]
  double turn = 0.0;    // nor does it turn by more [rad]
  LikelyWay way{};      // longer than the travel it counts as far as that
  // so many rows are enough: with more those of edges are looked for no further, and count as left
  // out; 0: all
  std::size_t most_rows = 0;
};

/// A row with what finding it has learned.
struct FoundRow {
  // object_point and object_direction in the object's mesh frame; without friction
  ContactRow row = make_row(RowKind::scene_plane);
  double gap = 0.0;  // at the pose of the query [m]
};

/// A plane that a surface lies behind, as far as it matters, and that vertices of the other surface
/// are kept in front of.
struct GuardPlane {
  Vec3 normal = Vec3::Zero();  // out of the surface behind it [its mesh frame]
  double offset = 0.0;         // [m]
  std::int32_t feature = -1;   // what it is the plane of: a triangle, or ~edge

  double height(const Vec3& point) const noexcept { return normal.dot(point) - offset; }
};

/// What lies within reach between two patches: of the object from object_least on along
/// object_axis, of the scene up to scene_most along scene_axis [each mesh frame].
struct Slab {
  Vec3 object_axis = Vec3::Zero();
  double object_least = 0.0;
  Vec3 scene_axis = Vec3::Zero();
  double scene_most = 0.0;
};

/// Vertices of one surface against planes of the other.
struct VertexSide {
  struct Candidate {  // a vertex and a triangle of the other surface
    double distance = 0.0;
    std::int32_t vertex = -1, triangle = -1;
    Vec3 nearest = Vec3::Zero();  // on the triangle
  };
  struct Member {  // a vertex has a row with this plane
    std::int32_t plane = -1, next = -1;
  };
  std::vector<Candidate> candidates;
  std::vector<GuardPlane> planes;
  std::vector<Member> members;
  std::vector<std::int32_t> first_member;  // by vertex, -1: none
  std::vector<std::int32_t> touched;       // vertices with members
};

/// Working memory of find_rows: grows while warming up, never after.
struct RowScratch {
  struct EdgePair {
    std::int32_t object = -1, scene = -1;
    friend auto operator<=>(const EdgePair&, const EdgePair&) = default;
  };
  struct NearEdge {              // of the scene
    Vec3 middle = Vec3::Zero();  // [m; scene's mesh frame]
    double half = 0.0;           // of its length [m]
    double least = 0.0;          // along the slab's axis [m; scene's mesh frame]
  };
  struct EdgeCone {  // of a near edge, as of ConvexEdge [object's mesh frame]
    std::int32_t edge = -1;
    Vec3 direction = Vec3::Zero(), into_left = Vec3::Zero(), into_right = Vec3::Zero();
  };
  struct FeaturePair {  // of two patches: a vertex and a triangle, or two edges
    std::int32_t of_object = -1, of_scene = -1;
  };
  // What may touch of two patches, as of where they were then: it holds until they have moved.
  struct PairList {
    const SurfaceFeatures *object = nullptr, *scene = nullptr;
    std::int32_t body = -1, object_patch = -1, scene_patch = -1;
    std::array<std::uint8_t, 3> ends{};  // in `pairs`, of each FeatureKind
    bool is_full = false;                // there were too many: none are listed
    std::int64_t checked = -1;           // call that has found it to hold
    Vec3 center = Vec3::Zero();          // of the object's patch [m; scene's mesh frame]
    Quat scene_from_object = Quat::Identity();
    double travel = 0.0, slack = 0.0;  // of the pairs listed [m, sine]
    std::array<FeaturePair, 32> pairs{};
  };
  VertexSide object, scene;                           // vertices of the object, and of the scene
  std::vector<Slab> slabs;                            // of the contacts, in their order
  std::vector<EdgePair> met;                          // pairs with a row of their own, sorted
  std::vector<std::int32_t> near_object, near_scene;  // vertices of a pair of patches
  std::vector<NearEdge> near_edges;                   // of the scene's
  std::vector<EdgeCone> near_cones;                   // of the same
  std::vector<std::int32_t> planes;  // that the scene's patch of a pair lies behind
  std::vector<FeaturePair> listed;   // of a pair of patches without a list
  std::vector<PairList> lists;       // by a hash of the patches, 2^n of them; none: none are kept
  std::int64_t calls = 0, lists_used = 0, lists_made = 0, most_made = 0;
};

/// Room for vertices of either surface and so many candidates.
/// Thread [offline]; throws std::bad_alloc.
void reserve_rows(RowScratch& scratch, const SurfaceFeatures& object, const SurfaceFeatures& scene,
                  std::size_t capacity);

/// Room for lists of what may touch, so that pairs of patches that have hardly moved are not
/// searched anew. The rows are the same, bit for bit. For one object among bodies with indices of
/// their own; more than these lists only takes longer.
/// Thread [offline]; throws std::bad_alloc.
void reserve_pair_lists(RowScratch& scratch);

/// Rows between the object and one body of the scene, appended to `rows`.
///
/// pair            the two bodies
/// contacts        of the exact query, all pairs of patches nearer than reach.travel; those with
///                 other bodies are passed over
/// reach           how far the rows have to hold
/// scratch, rows   capacity is never grown; what does not fit is counted
/// returns         candidates and rows that did not fit: the rows do not say all then
/// Thread          [contact]; no failure
/// Source          The first touch of two surfaces is a vertex on a face or an edge on an edge,
///                 both locally convex towards each other. Each such pair within reach is either
///                 kept apart by a row of its own or lies behind a plane that a row keeps its
///                 partner in front of: coplanar and convex neighbours of a face add no row.
///                 Of several planes that would do the vertex keeps one that leaves it at least
///                 half its distance.
std::int64_t find_rows(const BodyPair& pair, std::span<const Contact> contacts,
                       const RowReach& reach, RowScratch& scratch,
                       std::vector<FoundRow>& rows) noexcept;

}  // namespace thigma
