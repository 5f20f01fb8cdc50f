#pragma once
// The pairs of models every method is measured on, with one path of poses for all of them.

#include <string>
#include <vector>

#include "benchmarks/baselines/point_shell.h"
#include "benchmarks/clod_build_bench.h"

#include "thigma/clod/hierarchy.h"
#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bench {

/// How the object moves: it turns and slides about its pose in the scene, and its height over the
/// scene follows a least separation that swings between touch and apart.
struct PathShape {
  double turn = 0.0;      // amplitude about each axis [rad]
  double slide = 0.0;     // amplitude across the approach, by the smaller radius
  double swing = 0.01;    // amplitude of the least separation, by the smaller radius
  double height = 0.0;    // its mean, by the smaller radius
  bool is_solved = true;  // false: the pose of the scene is the mean height; for very large models
};

/// What to measure on: a built-in scene, with other models or counts.
struct PairRequest {
  std::string name;                               // of the rows
  std::string scene;                              // of scenes/
  std::string object_model{}, scene_model{};      // instead of the scene's own; empty: those
  int object_triangles = 0, scene_triangles = 0;  // 0: the models' own
  double scene_scale = 1.0;                       // of the scene object, when its model is replaced
  PathShape path;
  double tolerance = 0.01;  // d of the queries to come, by the smaller radius
};

/// The pairs that levels of detail are measured on, but for those of a million triangles.
std::vector<PairRequest> level_pairs();

/// A pair ready to be measured.
struct BenchPair {
  PairRequest request;
  TriangleMesh object_mesh, scene_mesh;  // [m]; the scene object stands at the identity
  ClodHierarchy object, scene;
  double radius = 0.0;     // the smaller of the two [m]
  double tolerance = 0.0;  // d [m]
  PointShell object_shell, scene_shell;
  ClodBuildCost object_cost, scene_cost;
  double shell_seconds = 0.0;  // CPU time of building both
  Pose start;                  // of the object, as the scene has it, in the scene object's frame
  Vec3 approach = -Vec3::UnitZ();  // towards the scene, in the same frame
};

/// Makes models, levels of detail and shells. Thread [offline]; throws InputError for unknown
/// names.
BenchPair make_pair(const PairRequest& request);

/// Poses of the object, the scene object at the identity, one a millisecond. The height is solved
/// with the shells on every eighth pose and runs straight between; so it is the same path for all.
std::vector<Pose> make_path(const BenchPair& pair, int frames);

}  // namespace thigma::bench
