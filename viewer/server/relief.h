#pragma once
// The relief of a texture as a surface that a page can draw.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::live {

/// The coarse triangles of a texture, each divided into the same number and displaced.
struct ReliefSurface {
  TriangleMesh mesh;  // [m; body frame]
  int divisions = 1;  // of each edge
};

/// Divides so finely that no edge is longer than a texel, or as far as `most` triangles allow.
///
/// texture  with relief
/// most     triangles, at least those of the coarse surface are made
/// returns  triangles in the order of the coarse ones, divisions^2 of each
/// Thread   [offline]; throws std::bad_alloc.
ReliefSurface make_relief_surface(const HapticTexture& texture, std::size_t most);

/// `relief` of the mesh of that number: what level 0 of it is felt as.
///
/// texture    over the surface of level 0 of the hierarchy
/// Thread     [offline]; throws std::bad_alloc.
std::string encode_relief(std::uint32_t mesh_number, const HapticTexture& texture,
                          const ClodHierarchy& hierarchy);

}  // namespace thigma::live
