#pragma once
// Turning the edge between two triangles into the other diagonal of their quadrilateral.

#include <array>
#include <cstdint>

#include "thigma/mesh/halfedge_mesh.h"

namespace thigma {

/// The quadrilateral around an edge: triangles a b c and b a d become a d c and b c d.
struct FlipQuad {
  std::array<std::int32_t, 2> triangle{-1, -1};  // that of the half-edge, and that of its twin
  std::int32_t a = -1, b = -1;                   // the edge
  std::int32_t c = -1, d = -1;                   // across it, and the edge afterwards
};

/// halfedge  one with a twin
FlipQuad quad_of(const HalfedgeMesh& mesh, std::int32_t halfedge);

/// Whether flipping leaves the same surface and every corner its value: none of the four vertices
/// locked, the new edge not there yet, no seam along the old one.
/// Thread    [offline].
bool can_flip(const HalfedgeMesh& mesh, std::int32_t halfedge);

/// Writes the corners of the two triangles as they will be, or again as they were; neighbours stay
/// as they are, so that a position can be tried before flip_edge, which wants them as they were.
void set_flipped_corners(HalfedgeMesh& mesh, std::int32_t halfedge, const FlipQuad& quad,
                         bool is_flipped);

/// Flips an edge for which can_flip holds. The half-edge becomes a d, its twin b c; positions stay.
void flip_edge(HalfedgeMesh& mesh, std::int32_t halfedge);

}  // namespace thigma
