#pragma once
// Texture coordinates of a mesh file, beside its surface.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/math/types.h"

namespace thigma {

/// Texture coordinates (vt) of an OBJ, of the triangles parse_mesh gives and in their order.
///
/// bytes     an OBJ that parse_mesh takes
/// name      of the file, for messages
/// returns   (u, v) of the three corners of each triangle, as the file has them (m)
/// Thread    [offline]; throws InputError for a corner without texture coordinates, or with wrong
///           ones; naming the line.
std::vector<std::array<Vec2, 3>> read_texture_coordinates(std::string_view bytes,
                                                          const std::string& name);

}  // namespace thigma
