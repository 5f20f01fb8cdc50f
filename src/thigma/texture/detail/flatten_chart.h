#pragma once
// One chart from the surface into the plane.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::detail {

/// A chart in the plane, of the area it has on the surface.
struct FlatChart {
  bool is_usable = false;               // one sheet: nothing folds, nothing overlaps
  std::vector<std::array<Vec2, 3>> at;  // corners of each triangle [m]
  double stretch = 1.0;  // by how much a length is longer or shorter than on the surface, at most
};

/// Least-squares conformal map of connected triangles: of all maps that hold two far vertices the
/// one that changes angles least, by the squared area.
/// Thread    [offline]; deterministic.
FlatChart flatten_chart(const TriangleMesh& mesh, std::span<const std::int32_t> triangles);

}  // namespace thigma::detail
