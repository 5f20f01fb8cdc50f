#pragma once
// How well a texture stands for the fine surface it was made of.

#include "thigma/texture/detail/surface_search.h"
#include "thigma/texture/texture_file.h"

namespace thigma::detail {

struct FitParams {
  int samples = 20000;  // of each side
  std::uint64_t seed = 1;
};

/// Fine point over a point of the coarse surface, as the texture has it.
Vec3 textured_point(const HapticTexture& texture, std::int32_t triangle, const Vec3& weights);

/// Fit error and cracks of a texture; charts and distortion are left alone. on_fine, on_coarse: of
/// `fine` and of texture.coarse. See bake_surface.
BakeFigures measure_fit(const TriangleMesh& fine, const SurfaceSearch& on_fine,
                        const SurfaceSearch& on_coarse, const HapticTexture& texture,
                        const FitParams& params);

}  // namespace thigma::detail
