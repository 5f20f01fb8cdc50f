#include "experiments/level-choice/shells.h"

#include <algorithm>

#include "benchmarks/probe.h"

namespace thigma::experiments::level_choice {
namespace {

constexpr double kBandOfScene = 0.03;   // of the smaller radius, as the bench has it
constexpr double kBandOfObject = 0.02;  // of the radius of the object itself
// of the tolerance: apart as far as it, and through as far again
constexpr double kBandOfQuery = 2.0;

TriangleMesh mesh_of(const SceneObject& object, int triangles) {
  if (!object.model) return load_object(object).mesh;
  return make_mesh(
      model_uri(object.model->name, triangles > 0 ? triangles : object.model->triangles));
}

}  // namespace

ShellPair build_shells(const SceneDescription& description, int triangles,
                       const SessionPair& session) {
  const ContactWorld& world = session.config.contact;
  const ClodHierarchy &object = *world.object, &scene = *world.scene.front().hierarchy;
  const double least = std::max(kBandOfScene * std::min(object.radius, scene.radius),
                                kBandOfQuery * world.tolerance);
  const auto params = [&](const ClodHierarchy& h) {
    return bench::ShellParams{.field = {.band = std::max(least, kBandOfObject * h.radius)}};
  };
  const TriangleMesh object_mesh = mesh_of(description.object, triangles);
  const TriangleMesh scene_mesh = mesh_of(description.statics.front(), triangles);
  const double start = bench::thread_cpu();
  ShellPair shells{bench::build_point_shell(object_mesh, params(object)),
                   bench::build_point_shell(scene_mesh, params(scene))};
  shells.build = bench::thread_cpu() - start;
  shells.bytes =
      static_cast<double>(bench::shell_bytes(shells.object) + bench::shell_bytes(shells.scene));
  return shells;
}

}  // namespace thigma::experiments::level_choice
