#include "experiments/common/spoon_drop.h"

#include <algorithm>

#include "thigma/mesh/measure.h"

namespace thigma::experiments {
namespace {

constexpr double kMass = 0.010;       // [kg]
constexpr double kOverTheRim = 0.02;  // [m]
constexpr double kRim = 0.11;         // height of the cup [m]
constexpr double kLean = 0.25;        // of the handle from the vertical [rad]

}  // namespace

SpoonDrop spoon_drop(Assets& assets, int triangles, double gravity) {
  const std::string spoon = model_uri("spoon", triangles), cup = model_uri("cup", triangles);
  SpoonDrop drop;
  SimulationWorld& world = drop.world;
  world.object = &levels_of(assets, spoon);
  world.scene.push_back({&levels_of(assets, cup), Pose{}});
  drop.radius = std::min(world.object->radius, world.scene.front().hierarchy->radius);
  world.tolerance = 1e-3 * drop.radius;
  world.law = {0.4, 0.2};
  const MassProperties solid = mass_properties(make_mesh(spoon));
  world.body = make_body(kMass, kMass / solid.volume * solid.inertia, Vec3(0, 0, -gravity));
  world.body_from_mesh.position = -solid.center_of_mass;
  // The spoon lies along x, the tip of its bowl at 0: upright, leaning towards the handle of the
  // cup.
  BodyState& body = drop.start.body;
  body.orientation = Quat(Eigen::AngleAxisd(-0.5 * 3.14159265358979 + kLean, Vec3::UnitY()));
  const Vec3 tip = body.orientation * (world.body_from_mesh.position);
  body.position = Vec3(-0.012, 0.004, kRim + kOverTheRim) - tip;
  return drop;
}

}  // namespace thigma::experiments
