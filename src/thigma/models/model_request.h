#pragma once
// Procedural models by name.

#include <cstdint>
#include <string>

namespace thigma::models {

/// A procedural mesh.
struct ModelRequest {
  std::string name;   // one of model_names()
  int triangles = 0;  // wished count; 0 = the model's own default
  // of the models that vary: jaws, joint, golf club, conforming discs; others ignore it
  std::uint64_t seed = 1;
};

/// A procedural surface with relief.
struct TexturedRequest {
  std::string name;  // one of textured_models()
  // along a side of the map, of sheets the root of all texels; 0 = the model's own default
  int texels = 0;
};

}  // namespace thigma::models
