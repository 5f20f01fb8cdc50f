#pragma once
// Procedural surfaces with relief: a few coarse triangles and a texture of any number of texels.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/models/model_request.h"
#include "thigma/models/ridge_profile.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::models {

struct TexturedInfo {
  const char* name;
  int texels;        // default
  const char* text;  // one line for listings
};

/// Every model, in the order of listings.
const std::vector<TexturedInfo>& textured_models();

/// Makes a model: its coarse surface closed, in metres. Same request, same bytes, on every machine.
/// Thread    [offline]; InputError for an unknown name or a count out of range.
HapticTexture make_textured_model(const TexturedRequest& request);

/// "procedural:NAME" or "procedural:NAME?texels=N".
///
/// where   prefix of the message
/// Thread  [offline]; InputError names what is wrong and the nearest right name or key.
TexturedRequest parse_textured_uri(std::string_view uri, const std::string& where);

/// A box of 16 triangles, its top and bottom as fans around their middles, centred at the origin,
/// with relief on top.
///
/// size     [m]
/// texels   along each side of the top, 16 to 8192
/// height   of the fine surface over a point of the top [m, m -> m]
struct TexturedSlab {
  Vec3 size = Vec3::Ones();
  int texels = 512;
  std::function<double(double x, double y)> height;
};
TextureSource make_textured_slab(const TexturedSlab& slab);

/// The block of Fig. 4.11, 80 x 60 x 20 mm, with ridges of a profile across x, 2 mm high and 10 mm
/// apart. Thread [offline].
HapticTexture make_block(const RidgeProfile& ridges, int texels, const std::string& name);

}  // namespace thigma::models
