#pragma once
// The steps of find_rows: vertices first, nearest first, then the edges that no plane guards.

#include <cstdint>
#include <vector>

#include "thigma/constraint/feature_rows.h"
#include "thigma/core/static_vector.h"

namespace thigma::detail {

/// Features may be through each other by this times the travel: an error of steps, no more.
inline constexpr double kError = 2e-3;

/// Corners of a patch: it has at most half as many vertices.
inline constexpr std::size_t kMostNear = 64;

/// How far the object may go along a normal at most, by what is nearest there.
struct KnownLimit {
  Vec3 normal = Vec3::Zero();  // unit, out of the object, into the scene [scene's mesh frame]
  double gap = 0.0;            // [m]
};
inline constexpr std::size_t kMostKnown = 8;  // each a comparison for every plane there might be

/// One call of find_rows.
struct RowSearch {
  PlacedFeatures object, scene;
  std::int32_t body = 0;
  RowReach reach;
  Pose scene_from_object{}, object_from_scene{};                   // mesh frames
  Mat3 to_scene = Mat3::Identity(), to_object = Mat3::Identity();  // rotations of these
  LikelyWay way{};          // of the reach, in the scene's mesh frame
  double rounding = 0.0;    // lengths below it are none [m]
  double cone_slack = 0.0;  // sine by which turning may widen a cone of normals
  StaticVector<KnownLimit, kMostKnown> known{};
  double least_gap = 0.0;  // of those; infinite without [m]
  std::int64_t left_out = 0;
};

/// How far any point of the object goes by the likely way, at most [m].
double length_of_way(const RowReach& reach) noexcept;

RowSearch make_search(const BodyPair& pair, const RowReach& reach) noexcept;

/// The slab of a contact along its normal, for so much travel [m].
Slab find_slab(const RowSearch& search, const Contact& contact, double travel) noexcept;

/// Corners of a patch at least so far along an axis; at most kMostNear.
void keep_near(const SurfaceFeatures& features, std::int32_t patch, const Vec3& axis, double least,
               std::vector<std::int32_t>& near) noexcept;

/// Adds vertices of either patch within reach of triangles of the other that they may touch.
/// returns  the slab of the contact; of no axis where a list of what may touch made it needless
Slab gather_vertices(RowSearch& search, const Contact& contact, RowScratch& scratch) noexcept;

/// Rows of all that was gathered.
void search_vertices(RowSearch& search, RowScratch& scratch, std::vector<FoundRow>& rows) noexcept;

/// Rows of convex edges of two patches that no plane keeps apart.
/// slab  as gathering vertices gave it
void search_edges(RowSearch& search, const Contact& contact, const Slab& slab, RowScratch& scratch,
                  std::vector<FoundRow>& rows) noexcept;

/// Appends where there is room, else counts.
void add_row(RowSearch& search, std::vector<FoundRow>& rows, const FoundRow& row) noexcept;

/// Which of the two has the vertices; the other has the planes.
enum class PointsOf : std::uint8_t { object, scene };

/// Row of a vertex in front of a plane.
FoundRow plane_row(const RowSearch& search, PointsOf side, std::int32_t vertex,
                   const GuardPlane& plane) noexcept;

/// Number of a pair of features, the same in every frame.
std::uint64_t id_of(const RowSearch& search, RowKind kind, std::int32_t object_feature,
                    std::int32_t scene_feature) noexcept;

/// Whether a vertex has a row with a plane.
bool is_member(const VertexSide& side, std::int32_t vertex, std::int32_t plane) noexcept;

/// Gives a vertex a row with a plane.
void add_member(RowSearch& search, PointsOf points, std::int32_t vertex, std::int32_t plane,
                VertexSide& side, std::vector<FoundRow>& rows) noexcept;

}  // namespace thigma::detail
