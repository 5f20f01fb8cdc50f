#pragma once
// Texture coordinates for surfaces that have none: charts of little distortion, packed into one
// map.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct ChartParams {
  int texels = 1024;  // along each side of the map, 16..kMaxTextureSide
  // cosine between a triangle's normal and the mean of its chart, at least
  double widest_cone = 0.5;
  double most_stretch = 1.5;  // charts that stretch or squeeze any length by more are divided
  int gutter = 3;             // texels around a chart that belong to no other
};

/// A map of a surface.
struct ChartMap {
  std::vector<std::array<Vec2, 3>> corners;  // [texels], of each triangle (m)
  std::vector<std::int32_t> chart;           // of each triangle (m)
  std::int32_t count = 0;                    // charts
  double texels_per_metre = 0.0;             // mean; the same of every chart
  double distortion_max =
      // by how much a length in the map is longer or shorter than the mean says, at most: 1 =
      // nowhere
      1.0;
};

/// Charts of a surface: neighbouring triangles that look about the same way, flattened with the
/// least change of angles, divided until they neither fold, overlap themselves nor stretch too
/// much.
///
/// mesh      every triangle has an area; any connectivity
/// name      of the file, for messages
/// Thread    [offline]; deterministic; throws InputError: a triangle without area, more charts than
///           the map has room for.
/// Source    Sec. 4.2.2 names the need; least-squares conformal maps after Levy, Petitjean, Ray,
///           Maillot 2002.
ChartMap make_charts(const TriangleMesh& mesh, const ChartParams& params, const std::string& name);

}  // namespace thigma
