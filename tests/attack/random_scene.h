#pragma once
// Random scenes: two closed surfaces of any shape and size, materials, response, device and rate,
// all drawn by a number.

#include <cstdint>
#include <string>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

struct RandomScene {
  TriangleMesh object, ground;  // as their files have them
  double scale = 1.0;           // metres per unit of these
  std::string response;         // as scenes name it
  std::string text;             // TOML, naming object.ply and ground.ply
  std::string device;           // address
  double duration = 0.3;        // [s]
  double radius = 0.0;          // of the object, about [m]
};

/// The scene of a number. Surfaces are closed and not flat, but may pass through themselves: what
/// is built of them may be refused.
RandomScene random_scene(std::uint64_t number);

}  // namespace thigma::test
