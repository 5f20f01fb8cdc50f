#pragma once
// Planes that keep two edges apart: the one lies behind, both ends of the other are kept in front.

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

/// Whether a vertex needs no row with a plane: it has one, or is too far.
bool is_kept(const RowSearch& search, const VertexSide& side, std::int32_t vertex,
             std::int32_t plane, double height) noexcept;

/// Whether a plane that an end already has a row with keeps the edges apart as it is.
/// Thread    [contact]; no failure
bool is_kept_apart(const RowSearch& search, const EdgeEnds& ends, const VertexSide& side) noexcept;

/// Compares the planes that either end has rows with, the planes of the other edge's faces, the
/// one between them, and the one square to the line between the nearest points, with `best`.
///
/// distance  of the two edges [m]
/// Thread    [contact]; no failure
void choose_plane(const RowSearch& search, const EdgeEnds& ends, double distance,
                  const VertexSide& side, EdgeGuard& best) noexcept;

/// Gives both ends rows with the plane chosen. Thread [contact]; what does not fit is counted.
void keep_ends(RowSearch& search, const EdgeGuard& guard, VertexSide& side,
               std::vector<FoundRow>& rows) noexcept;

}  // namespace thigma::detail
