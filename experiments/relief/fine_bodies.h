#pragma once
// The fine surfaces of the textured scenes as triangles, made without the engine's textures where
// the model is given by its triangles, else of the texels alone.

#include "experiments/common/outside_depth.h"

#include "thigma/scene/scene_description.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::experiments::relief {

/// The closed fine surface of an object of a scene, in its mesh frame.
///
/// texture  of the object; of one texel for a plain one
/// step     slabs: texels from one vertex to the next
/// Thread   [offline]
DepthSurface fine_surface(const SceneObject& object, const HapticTexture& texture, int step);

/// The largest depth of a vertex of one surface inside the other, 0 where there is none [m]. `b`
/// is where world_from_b has it.
double vertex_depth(const DepthSurface& a, const Pose& world_from_a, const DepthSurface& b,
                    const Pose& world_from_b);

}  // namespace thigma::experiments::relief
