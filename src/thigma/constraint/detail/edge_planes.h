#pragma once
// Planes that keep two edges apart: the one lies behind, both ends of the other are kept in front.

#include <span>
#include <vector>

#include "thigma/constraint/detail/row_search.h"
#include "thigma/math/infinity.h"

namespace thigma::detail {

/// An edge's ends, kept in front of planes, and the other edge, all in the frame of the planes.
struct EdgeEnds {
  PointsOf points_of = PointsOf::object;
  std::int32_t tail = -1, head = -1;  // vertices
  Vec3 at_tail, at_head, other_tail, other_head;
  Vec3 nearest, other_nearest;        // points of the two segments
  const ConvexEdge* other = nullptr;  // in the frame of its mesh, which is that of the planes
  std::int32_t other_index = -1;
};

/// The plane that forbids least of those looked at.
struct EdgeGuard {
  double forbids = kInfinity;  // [m]
  GuardPlane plane;
  std::int32_t index = -1;  // of the side's planes; -1: not yet one
  const EdgeEnds* ends = nullptr;
};

/// Whether a vertex needs no row with a plane: it has one, or is higher over it than it may come.
bool is_kept(const VertexSide& side, std::int32_t vertex, std::int32_t plane, double height,
             double reach) noexcept;

/// Whether one plane that the whole other patch lies behind keeps both ends of an edge.
///
/// planes      of the side, that the patch lies behind
/// tail, head  of the edge, where they are [frame of the planes; m]
bool is_guarded_from_patch(const RowSearch& search, const VertexSide& side,
                           std::span<const std::int32_t> planes, const ConvexEdge& edge,
                           const Vec3& tail, const Vec3& head) noexcept;

/// Whether a plane that there is keeps the edges apart: both ends have a row with it or do not
/// reach it. Ends that are high over a plane of others take it as theirs (least_shared).
///
/// distance  of the edges [m]
/// rows      of ends that take a plane are added
/// Thread    [contact]; no failure
bool is_kept_apart(RowSearch& search, const EdgeEnds& ends, double distance, VertexSide& side,
                   std::vector<FoundRow>& rows) noexcept;

/// Compares the planes that either end has rows with, the planes of the other edge's faces, the
/// one between them, and the one square to the line between the nearest points, with `best`.
///
/// distance  of the two edges [m]
/// Thread    [contact]; no failure
void choose_plane(const RowSearch& search, const EdgeEnds& ends, double distance,
                  const VertexSide& side, EdgeGuard& best) noexcept;

/// Whether the plane chosen is the one square to the line between the nearest points.
bool is_between(const EdgeGuard& guard) noexcept;

/// Gives both ends rows with the plane chosen. Thread [contact]; what does not fit is counted.
void keep_ends(RowSearch& search, const EdgeGuard& guard, VertexSide& side,
               std::vector<FoundRow>& rows) noexcept;

}  // namespace thigma::detail
