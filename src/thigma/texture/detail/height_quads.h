#pragma once
// Heights in 16 bits, four texels in one place.

#include "thigma/texture/haptic_texture.h"

namespace thigma::detail {

/// Fills the quads of a texture that has its texels: along one direction where all displacements
/// lie along it, otherwise along the normals of the coarse triangles. Cells under triangles of
/// normals so different that their heights are apart by more than an eighth of a step are mixed.
///
/// Heights are off by no more than 1/65,536 of the range of those that are held.
/// Thread  [offline]; no failure.
void fill_height_quads(HapticTexture& texture);

}  // namespace thigma::detail
