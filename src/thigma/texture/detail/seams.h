#pragma once
// Edges of the coarse surface at which two charts of a texture meet.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/math/types.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::detail {

/// An edge whose two triangles have it at different places of the map. Ends and sides correspond.
struct Seam {
  struct Side {
    std::int32_t triangle = -1;
    std::array<int, 2> corner{};  // of the triangle, at either end
  };
  std::array<Side, 2> sides;
};

/// corners   texture coordinates of every triangle [texels]
/// Returns   in the order of edges; open edges and those of more than two triangles are none
std::vector<Seam> find_seams(const TriangleMesh& coarse,
                             std::span<const std::array<Vec2, 3>> corners);

/// A point of a seam: weights of the corners of one side's triangle; share 0 is the first end, 1
/// the second.
Vec3 seam_weights(const Seam::Side& side, double share) noexcept;

/// Displacements of a map, to be changed.
struct StitchedMap {
  int width = 0, height = 0;  // at least 2
  std::vector<Vec3> texels;   // (width x height) [m]
  std::vector<double> ease;   // how far each gives way, compared with the others; above 0
};

/// Moves texels on both sides of every seam, by little, until the displacements interpolated on
/// either side agree along it but for what the texels cannot hold. Texels more than one row and one
/// column away from every seam stay as they are.
///
/// corners   of every triangle, within the map [texels]
/// Thread    [offline]; deterministic.
/// Source    the text says nothing of seams; projection onto one equation after the other (Kaczmarz
///           1937)
void stitch_seams(std::span<const Seam> seams, std::span<const std::array<Vec2, 3>> corners,
                  StitchedMap& map);

}  // namespace thigma::detail
