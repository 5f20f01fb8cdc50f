#pragma once
// Depth and gradient of textured contacts, each way beside the scalar one.

#include <vector>

#include "benchmarks/bench_rows.h"

#include "thigma/depth/depth.h"
#include "thigma/math/random.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::bench {

/// On the processor, per contact; and on a graphics processor where there is one, per frame over
/// the number of contacts.
std::vector<Row> texture_rows(bool quick);
std::vector<Row> gpu_texture_rows(bool quick);

/// Per contact with the envelope gradient: contacts of 16 textures in turn, which come from memory,
/// and each contact again and again, which stays in the caches; displaced along the normal, and
/// sideways as well. Maps of heights in 16 bits beside maps of displacements.
std::vector<Row> texture_memory_rows(bool quick);

/// A plate of 20 mm with three random waves of 0.1 mm.
///
/// sideways  what a displacement goes along both axes, by its height [-]
HapticTexture wavy_plate(Random& random, int texels, const Vec2& sideways = Vec2::Zero());
/// Of a plate that lies on another.
DepthContact plate_contact(const TexturedPatch& object, const TexturedPatch& scene);
inline constexpr double kPlateSide = 0.02, kPlateAmplitude = 1e-4;  // each wave's [m]

}  // namespace thigma::bench
