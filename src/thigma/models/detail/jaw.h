#pragma once
// Lower and upper jaw as dental models: a horseshoe of gum on a flat base with fourteen teeth.

#include <cstdint>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/models/make_model.h"

namespace thigma::models {

/// Jaws of one seed fit each other: both in one frame, occlusal plane z = 0, lips towards +y, they
/// stand apart by the clearance of occlusal_gap where they meet. Closed, genus 0, [m].
TriangleMesh make_lower_jaw(int triangles, std::uint64_t seed);
TriangleMesh make_upper_jaw(int triangles, std::uint64_t seed);

}  // namespace thigma::models
