#pragma once
// Where a vertex goes when only smoothness counts (Sec. 3.3.4 step 3).

#include <span>

#include "thigma/math/types.h"

namespace thigma {

/// One triangle around a vertex: from ring vertex a to ring vertex b, and what lies beyond.
struct RingTriangle {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  // counter-clockwise around the vertex [m]
  Vec3 beyond = Vec3::Zero();               // apex of the triangle across a b [m]
  Vec3 following = Vec3::Zero();            // the ring vertex after b [m]
  bool has_beyond = false;                  // false on a boundary
  bool has_following = false;
};

/// The position that minimises the sum of squared second-order divided differences over the edges
/// whose two triangles contain the vertex: its spokes and the edges of its ring.
///
/// The difference of an edge is the jump of the gradient across it of a function that is linear on
/// either triangle; its four weights come from the two triangles, with the vertex at `p`, laid into
/// one plane about their common edge. Linear functions have none, so a flat neighbourhood leaves
/// the vertex where it is. Edges whose triangles are too thin to lay flat are left out.
///
/// p       where the vertex is [m]
/// ring    its triangles
/// Thread  [offline]; no failure: p when nothing constrains it.
/// Source  Guskov, Sweldens, Schroeder 1999, Sec. 3 (relaxation operator).
Vec3 relax(const Vec3& p, std::span<const RingTriangle> ring);

}  // namespace thigma
