#pragma once
// Models with their levels of detail, made once for all experiments of a run.

#include <functional>
#include <map>
#include <string>

#include "thigma/clod/hierarchy.h"
#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/scene/scene_description.h"

namespace thigma::experiments {

/// What has been made so far; grows, references stay valid.
struct Assets {
  std::map<std::string, ClodHierarchy> levels{};  // by procedural address
  std::map<std::string, double> seconds{};        // CPU time of building those that were timed [s]
  // Levels of an address that somebody keeps from run to run; empty: they are built.
  std::function<ClodHierarchy(const std::string& uri)> kept{};
};

/// "procedural:NAME?triangles=N", or the model's own count for 0.
std::string model_uri(const std::string& name, int triangles = 0);
TriangleMesh make_mesh(const std::string& uri);

/// Levels of a procedural model.
/// Thread   [offline]; InputError for an address that is none.
const ClodHierarchy& levels_of(Assets& assets, const std::string& uri);

/// The same, built here, with its time in assets.seconds: CPU time of the process, of all its
/// threads.
const ClodHierarchy& timed_levels_of(Assets& assets, const std::string& uri);

/// An object over a scene of one body at rest.
struct Pair {
  std::string name;
  const ClodHierarchy* object = nullptr;
  const ClodHierarchy* scene = nullptr;
  double radius = 0.0;  // the smaller of the two [m]
  Pose start;           // of the object, apart from the scene
  Pose world_from_scene;
  Vec3 approach = -Vec3::UnitZ();  // unit
  double clearance = 0.0;          // from start along approach to the first touch [m]
};

/// A built-in scene as a pair.
/// triangles  0 as the scene says, otherwise of both
/// is_timed   levels are built here and timed
/// Thread     [offline].
Pair scene_pair(Assets& assets, const std::string& scene, int triangles = 0, bool is_timed = false);

/// The same of any scene. The object and the first static one are procedural or mesh files; levels
/// of files are built and kept in assets for the run.
Pair scene_pair(Assets& assets, const SceneDescription& scene, int triangles = 0,
                bool is_timed = false);

/// Start and clearance of a pair whose object stands somewhere near: moved apart where it touches.
void place_apart(Pair& pair, const Vec3& approach);

}  // namespace thigma::experiments
