#pragma once
// The point of a surface that is nearest to a point, and how far one surface is from another.

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma {

/// The point of a triangle nearest to p; segments and points are triangles too.
/// Thread    [offline] by use; neither allocates nor throws.
/// Source    Ericson 2005, Sec. 5.1.5.
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

struct NearestPoint {
  std::int32_t triangle = -1;                                 // -1: none within reach
  double distance = std::numeric_limits<double>::infinity();  // [m]
  Vec3 point = Vec3::Zero();                                  // [m]
};

/// The point of a surface nearest to p.
///
/// tree      of the mesh
/// reach     points at this distance and beyond are not looked for [m]
/// Thread    [offline]; no failure. Of equally near triangles the first in the tree.
NearestPoint nearest_point(const TriangleMesh& mesh, const TriangleTree& tree, const Vec3& p,
                           double reach = std::numeric_limits<double>::infinity());

/// What is known of the largest distance of some triangles from a surface: met <= it <= bound.
struct LargestDistance {
  double met = 0.0;    // of some point [m]
  double bound = 0.0;  // of all points [m]
};

using TrianglePiece = std::array<Vec3, 3>;

/// Largest distance of any point of the pieces from a surface (one side of the Hausdorff distance).
/// Pieces are divided into four until the bound is a twentieth above what was met, or less than
/// `small`; after 64 divisions a piece (and 100,000) the bound is what is known by then.
///
/// small     a distance nobody asks about [m], >= 0
/// Thread    [offline]; deterministic.
LargestDistance largest_distance(std::span<const TrianglePiece> pieces, const TriangleMesh& mesh,
                                 const TriangleTree& tree, double small = 0.0);

}  // namespace thigma
