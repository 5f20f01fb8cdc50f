#pragma once
// Everything around an edge that a collapse changes.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/simplify/patched_surface.h"
#include "thigma/simplify/relaxation.h"

namespace thigma::detail {

/// A triangle that keeps its place around the collapsed vertex.
struct StarTriangle {
  std::int32_t triangle = -1;
  std::int32_t a = -1, b = -1;  // the other two vertices, counter-clockwise
  std::int32_t patch = -1;
  std::int32_t beyond = -1;     // triangle across a b, -1 on a boundary
  std::int32_t following = -1;  // place in the star of the triangle that begins at b
};

/// The triangles around an edge, and the patches they are in.
struct EdgeStar {
  std::int32_t halfedge = -1, tail = -1, head = -1;
  std::vector<StarTriangle> triangles;          // without those along the edge
  std::array<std::int32_t, 2> removed{-1, -1};  // those along it
  std::vector<std::int32_t> patches;            // of both
  bool is_tail_on_boundary = false, is_head_on_boundary = false;
};

/// Fills the star of an edge that can be collapsed.
void gather_star(const PatchedSurface& surface, std::int32_t halfedge, EdgeStar& star);

/// Of the triangles across its rim [m].
void list_rim_boxes(const PatchedSurface& surface, const EdgeStar& star,
                    std::vector<TreeBox>& boxes);

/// Its ring as the relaxation wants it.
void list_ring(const PatchedSurface& surface, const EdgeStar& star,
               std::vector<RingTriangle>& ring);

/// Vertices of a patch after the collapse, the tail standing for the new vertex; empty when the
/// patch goes with the edge.
void list_patch_vertices(const PatchedSurface& surface, const EdgeStar& star, std::int32_t patch,
                         std::vector<std::int32_t>& vertices);

}  // namespace thigma::detail
