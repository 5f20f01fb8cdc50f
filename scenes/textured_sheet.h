#pragma once
// Closed textured surfaces from sheets (u, v): coarse cells, and a fine surface as a texture over them.

#include <functional>
#include <span>
#include <vector>

#include "thigma/texture/haptic_texture.h"

namespace thigma::scenes {

/// A closed surface over u, v in [0, 1], u around. Its normal is (along u) x (along v).
struct TexturedSheet {
  std::function<Vec3(double u, double v)> coarse;  // [m]; only its values at corners of cells count
  std::function<Vec3(double u, double v)> fine;    // [m]
  std::function<Vec3(double u, double v)> smooth;  // the fine surface without its relief, for controls; may be empty [m]
  bool is_ring = false;  // v goes around too; otherwise v = 0 and v = 1 are one point each
  int around = 8, along = 8;            // coarse cells
  int fine_around = 64, fine_along = 64;  // cells of the fine surface as triangles
};

/// Triangles of a sheet as coarse and as fine surface.
int coarse_triangles(const TexturedSheet& sheet);
int fine_triangles(const TexturedSheet& sheet);

/// Coarse surface and texture of some sheets, each a component and a chart.
///
/// texels  about how many along the longer side of the map
/// Thread  [offline]
TextureSource make_textured_sheets(std::span<const TexturedSheet> sheets, int texels);

/// The fine surfaces of the sheets as triangles.
TriangleMesh make_fine_sheets(std::span<const TexturedSheet> sheets);

}  // namespace thigma::scenes
