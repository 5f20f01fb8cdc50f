#pragma once
// Stand-ins for the textured models of Table 4.1, of about its numbers of triangles: gear, hammer, CAD part, file and
// helicoidal torus.

#include <string_view>
#include <vector>

#include "scenes/textured_sheet.h"

namespace thigma::scenes {

/// The sheets of a model: "gear", "hammer", "cad_part", "file" or "helicoidal_torus"; empty for another name.
/// Same name, same bits, on every machine.
/// Thread [offline].
std::vector<TexturedSheet> textured_part(std::string_view name);

}  // namespace thigma::scenes
