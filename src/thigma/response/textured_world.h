#pragma once
// The relief of the surfaces of a contact world, and how it is looked for.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "thigma/depth/gradient_kind.h"
#include "thigma/depth/triangle_ring.h"

namespace thigma {

struct ClodHierarchy;
struct HapticTexture;

enum class DepthSearch : std::uint8_t {
  grid,    // samples, then the climb to the maximum near the best
  branch,  // every texel, by branch and bound
  gpu,     // the grid, on a graphics processor; on this one where there is none, with a warning
};

struct TextureParams {
  DepthSearch search = DepthSearch::grid;
  int resolution = 50;    // of the grid
  int max_nodes = 20000;  // of the search over texels
  GradientKind gradient = GradientKind::smoothed_envelope;
  // of the summed amplitudes: depths this near the maximum count, see depth_request
  double smoothing = 0.1;
};

/// A body whose surface textures may refine. Immutable; outlives the session.
struct TexturedBody {
  // over the surface of level 0, 1, ..; of one texel where there is no relief
  std::vector<const HapticTexture*> textures;
  // of each texture's coarse surface; empty where it has no relief
  std::vector<VertexTriangles> at_vertex;
  const ClodHierarchy* hierarchy = nullptr;  // its patches of level k are of textures[k]->coarse
  // of each node, -1 of the root; empty with one texture
  std::vector<std::int32_t> parent;
  bool has_relief = false;  // false: a plain body
  double relief = 0.0;      // by how much the fine surface lies off level 0, at most [m]
  double amplitude = 0.0;   // of the texture that has least of it, of those with relief [m]
};

/// Everything textured of a contact world. Empty: nothing is.
struct TexturedWorld {
  TexturedBody object;
  std::vector<TexturedBody> scene;  // one a static body
  TextureParams params;
  /// Told why depths are not computed on a graphics processor, or that it is none in hardware: by
  /// the thread that reserves scratch, later by the one that samples. May be empty.
  std::function<void(const std::string& why)> warn{};
  bool is_empty() const noexcept { return object.hierarchy == nullptr; }
};

}  // namespace thigma
