#pragma once
// Closed textured surfaces from sheets (u, v): coarse cells, and a fine surface as a texture over
// them.

#include <functional>
#include <span>
#include <vector>

#include "thigma/texture/haptic_texture.h"

namespace thigma::models {

/// A closed surface over u, v in [0, 1], u around. Its normal is (along u) x (along v).
struct TexturedSheet {
  std::function<Vec3(double u, double v)> coarse;  // [m]; only its values at corners of cells count
  std::function<Vec3(double u, double v)> fine;    // [m]
  // the fine surface without its relief, for controls; may be empty [m]
  std::function<Vec3(double u, double v)> smooth;
  bool is_ring = false;       // v goes around too; otherwise v = 0 and v = 1 are one point each
  int around = 8, along = 8;  // coarse cells
  int fine_around = 64, fine_along = 64;  // cells of the fine surface as triangles
  /// The fine point of a coarse one has the same (u, v), wherever that lies. Otherwise it is looked
  /// for along the normal of the coarse surface: what is displaced sideways has to be followed by
  /// every depth, and is the larger error.
  bool is_paired = false;
};

/// Triangles of a sheet as coarse and as fine surface.
int coarse_triangles(const TexturedSheet& sheet);
int fine_triangles(const TexturedSheet& sheet);

/// Coarse surface and texture of some sheets, each a component and a chart. The texture is of the
/// triangles that make_fine_sheets gives: from a coarse point along the normals of its triangle's
/// corners, interpolated; where no line meets them near (u, v), the point of the same (u, v).
///
/// texels  squared, about how many in all; of one size in metres
/// Thread  [offline]
TextureSource make_textured_sheets(std::span<const TexturedSheet> sheets, int texels);

/// The fine surfaces of the sheets as triangles.
TriangleMesh make_fine_sheets(std::span<const TexturedSheet> sheets);

}  // namespace thigma::models
