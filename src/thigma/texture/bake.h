#pragma once
// Haptic textures from fine surfaces and from height maps.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/texture/height_image.h"
#include "thigma/texture/texture_file.h"

namespace thigma {

struct BakeParams {
  int texels = 1024;       // along each side of the map, 16..kMaxTextureSide
  int samples = 20000;     // of each side of the fit error
  std::uint64_t seed = 1;  // of the samples
};

/// The fine surface as a texture over charts of a coarse one.
///
/// From a point of the coarse surface the fine one is where the line along the interpolated vertex
/// normal meets it from within, on either side, nearest; where no such line meets it, its nearest
/// point. That belongs to the point of the surface, not to the chart: two charts hold the same at
/// their common edge, and texels beyond the edge of a chart hold what lies there on the neighbour.
/// Between texels and at edges what is left is measured:
///
/// figures   distortion_max: see ChartMap. fit_error: distances from samples of the textured
///           surface to the fine one, and from samples of the fine one to the textured surface, the
///           latter from above. crack_max: largest gap between both sides of a common edge over at
///           least 10,000 samples of those where charts meet; 0 without any
/// fine      usable [m]
/// coarse    usable, every triangle with an area [m]
/// name      of the file, for messages
/// Thread    [offline]; deterministic; throws InputError: a fine surface that lies farther off than
///           the coarse one's radius, and as make_charts and make_texture.
/// Source    Sec. 4.2.2.
TextureAsset bake_surface(const TriangleMesh& fine, const TriangleMesh& coarse,
                          const BakeParams& params, const std::string& name);

/// The same for each of several levels, where the fine surface is looked for through the finer
/// levels, one after the other, each along its own normals.
///
/// levels    surfaces, from the finest; each triangle with an area [m]
/// progress  called with the share of the levels done, 0..1; may be empty
/// returns   one a level; none for the first where that is the fine surface
/// Thread    [offline]; deterministic; throws InputError as bake_surface.
/// Source    Sec. 4.2.2. Deviates: D84.
std::vector<std::optional<TextureAsset>> bake_levels(
    const TriangleMesh& fine, std::span<const TriangleMesh> levels, const BakeParams& params,
    const std::string& name, const std::function<void(double)>& progress = {});

/// A height map over texture coordinates: white lies `amplitude` outside, black as much inside the
/// coarse surface, along its normals, which are averaged over edges of less than 40 degrees.
///
/// coordinates  (u, v) of every triangle's corners, 0..1, (0, 0) the lower left corner of the
///              picture (m)
/// amplitude    half the range [m]; > 0
/// name         of the coarse surface, for messages
/// Thread       [offline]; throws InputError as make_texture, and for an amplitude that is not
///              positive and finite.
TextureAsset bake_heights(TriangleMesh coarse, const std::vector<std::array<Vec2, 3>>& coordinates,
                          const HeightImage& image, double amplitude, const std::string& name);

}  // namespace thigma
