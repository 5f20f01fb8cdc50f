#pragma once
// Worlds of simple bodies for tests, and distances between their surfaces by triangles alone.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "support/triangle_search.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"
#include "thigma/multibody/step_world.h"

namespace thigma::test {

/// A mesh with what a body needs of it. Not moved while a world uses it.
struct BodyMesh {
  TriangleMesh mesh;
  ClodHierarchy hierarchy;
  MassProperties unit;  // for a density of 1
};

inline std::shared_ptr<BodyMesh> body_mesh(const TriangleMesh& mesh) {
  auto made = std::make_shared<BodyMesh>();
  made->mesh = mesh;
  made->hierarchy = build_exact_hierarchy(mesh);
  made->unit = mass_properties(mesh);
  return made;
}

struct WorldBench {
  std::vector<std::shared_ptr<BodyMesh>> meshes;
  std::vector<const BodyMesh*> of;  // by body
  std::vector<WorldBody> bodies;
  World world;
  WorldState state;
  WorldScratchPtr scratch;

  /// Adds a body whose mesh's centre of mass is at a place; density in kg/m^3.
  WorldBody& add(const std::shared_ptr<BodyMesh>& mesh, BodyKind kind, const Vec3& place,
                 const Quat& turn = Quat::Identity(), double density = 1000.0) {
    meshes.push_back(mesh);
    of.push_back(mesh.get());
    WorldBody body;
    body.name = "body " + std::to_string(bodies.size());
    body.kind = kind;
    body.shape.hierarchy = &mesh->hierarchy;
    body.shape.body_from_mesh.position = -mesh->unit.center_of_mass;
    body.mass = density * mesh->unit.volume;
    body.inertia = density * mesh->unit.inertia;
    body.start.position = place;
    body.start.orientation = turn;
    bodies.push_back(body);
    return bodies.back();
  }

  void make(const Vec3& gravity = Vec3(0.0, 0.0, -9.81)) {
    world = make_world(bodies, gravity);
    state = start_state(world);
    scratch = reserve_world(world);
  }

  WorldStep step(double dt = 1e-3, const WorldInputs& inputs = {}) {
    return step_world(world, inputs, dt, state, *scratch);
  }

  Pose world_from_mesh(std::size_t body) const {
    const BodyState& y = state.bodies[body];
    return Pose{y.position, y.orientation} * world.bodies[body].shape.body_from_mesh;
  }

  double energy() const { return mechanical_energy(world, state); }

  /// Least distance of the surfaces of two bodies, 0 where they are through each other [m].
  double distance(std::size_t a, std::size_t b) const {
    return least_triangle_distance(build_triangle_tree(of[a]->mesh, world_from_mesh(a)),
                                   build_triangle_tree(of[b]->mesh, world_from_mesh(b)));
  }
};

/// A floor whose top is z = 0.
inline std::shared_ptr<BodyMesh> floor_mesh(double size = 0.5, double thickness = 0.02) {
  return body_mesh(make_box(Vec3(size, size, thickness)));
}
inline WorldBody& add_floor(WorldBench& bench, double size = 0.5) {
  const double thickness = 0.02;
  return bench.add(floor_mesh(size, thickness), BodyKind::fixed, Vec3(0.0, 0.0, -0.5 * thickness));
}

}  // namespace thigma::test
