#pragma once
// Stand-ins for the textured models of Table 4.1, of about its numbers of triangles: gear, hammer,
// CAD part, file and helicoidal torus.

#include <string_view>
#include <vector>

#include "thigma/models/ridge_profile.h"
#include "thigma/models/textured_sheet.h"

namespace thigma::models {

/// The sheets of a model: "gear", "hammer", "cad_part", "file" or "helicoidal_torus"; empty for
/// another name. Same name, same bits, on every machine.
/// Thread [offline].
std::vector<TexturedSheet> textured_part(std::string_view name);

/// The gear with teeth of a profile: wheel of 80 mm, 24 mm wide, 25 teeth as far apart and as high
/// as the ridges of the block, bevelled at their ends. They are relief alone: the coarse wheel is
/// convex, as the text's. Thread [offline].
TexturedSheet make_gear_sheet(const RidgeProfile& teeth);

}  // namespace thigma::models
