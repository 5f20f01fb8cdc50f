#pragma once
// The six analytic scenes of E2 (docs/sources.md): meshes, a path, and the force it should give.

#include <functional>
#include <string>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::experiments {

/// One scene. The scene's object stands at the identity.
struct QualityScene {
  std::string name;
  TriangleMesh object{}, scene{};
  double tolerance = 0.0;    // d of the response [m]
  std::vector<Pose> path{};  // world_from_object, a millisecond apart
  // Ideal wrench on the object about its mesh frame's origin, for stiffness 1: per metre, so a
  // force is in [m] and a torque in [m^2]; scaled afterwards by one factor.
  std::function<Wrench(const Pose&)> ideal{};
  bool has_torque = false;  // the ideal torque is more than zero
  double length = 0.0;      // torque over force that counts as large as the force itself [m]
};

/// a to f of docs/sources.md, E2. `frames` along each path.
std::vector<QualityScene> quality_scenes(int frames);

/// e with a face of this many segments an edge: 12 segments^2 triangles.
QualityScene tilted_cube(int segments, int frames);

}  // namespace thigma::experiments
