// Objects dropped at random on others: they come to rest or leave, none hangs and none falls
// through.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>

#include "support/full.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/import/load_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/models/make_model.h"
#include "thigma/simulation/free_motion.h"
#include "thigma/simulation/simulate.h"

namespace thigma {
namespace {

constexpr double kSceneRadius = 0.1;              // [m]
constexpr double kLongest = 10.0;                 // of a drop [s]
constexpr double kStretch = 0.05;                 // [s]
constexpr std::int64_t kMostQueries = 4'000'000;  // more: it hangs

/// A thing of unit radius about its centre of mass, or of its enclosing ball where it has no
/// volume.
struct Thing {
  std::string name;
  ClodHierarchy hierarchy;
  Mat3 inertia = Mat3::Identity();  // for unit mass
};

Thing make_thing(const std::string& name, TriangleMesh mesh, double radius) {
  const Ball ball = enclosing_ball(mesh.positions);
  MassProperties solid = mass_properties(mesh);
  const bool is_solid = solid.volume > 0.01 * ball.radius * ball.radius * ball.radius;
  const Vec3 center = is_solid ? solid.center_of_mass : ball.center;
  const double scale = radius / ball.radius;
  Thing thing;
  thing.name = name;
  thing.inertia = is_solid ? Mat3(scale * scale / solid.volume * solid.inertia)
                           : Mat3(0.4 * radius * radius * Mat3::Identity());
  for (Vec3& p : mesh.positions) p = scale * (p - center);
  thing.hierarchy = build_exact_hierarchy(mesh);
  return thing;
}

/// Things by name, made when first asked for.
class Things {
 public:
  explicit Things(std::optional<std::filesystem::path> shared) : shared_(std::move(shared)) {}

  const Thing& get(const std::string& name, double radius) {
    const std::pair<std::string, double> key{name, radius};
    auto found = things_.find(key);
    if (found == things_.end()) {
      const bool is_file = name.find(".obj") != std::string::npos;
      TriangleMesh mesh = is_file
                              ? load_usable_mesh((*shared_ / "meshes" / name).string(), 1.0, true)
                              : models::make_model({.name = name, .triangles = 2000});
      found =
          things_.emplace(key, std::make_unique<Thing>(make_thing(name, std::move(mesh), radius)))
              .first;
    }
    return *found->second;
  }

 private:
  std::optional<std::filesystem::path> shared_;
  std::map<std::pair<std::string, double>, std::unique_ptr<Thing>> things_;
};

enum class Ending { rests, leaves, moves, hangs };

struct Drop {
  Ending ending = Ending::moves;
  double seconds = 0.0, deepest = 0.0, growth = 0.0;  // [s, tolerances, of the energy at the start]
  SimulationCounts counts;
};

Drop drop(const Thing& object, const Thing& below, Random& random) {
  SimulationWorld world;
  world.body = make_body(0.05, 0.05 * object.inertia, Vec3(0, 0, -9.81));
  world.object = &object.hierarchy;
  const double lie = below.name == "cup" ? 0.0 : random.uniform(-0.2, 0.2);  // tilted a little
  world.scene.push_back(
      {&below.hierarchy, {Vec3::Zero(), Quat(Eigen::AngleAxisd(lie, Vec3::UnitX()))}});
  world.tolerance = 1e-3 * std::min(object.hierarchy.radius, below.hierarchy.radius);
  // Without rolling friction what rolls or rocks would do so for long.
  world.law = {random.uniform(0.0, 0.6), random.uniform(0.05, 0.6), 0.01 * object.hierarchy.radius};
  SimulationState state;
  state.body.orientation = random.orientation();
  const Vec3 beside = 0.4 * below.hierarchy.radius * random.in_cube(1.0);
  state.body.position =
      below.hierarchy.center +
      Vec3(beside.x(), beside.y(), 1.1 * below.hierarchy.radius + 2.1 * object.hierarchy.radius);
  const Mat3 R = state.body.orientation.toRotationMatrix();
  state.body.angular_momentum =
      R * (world.body.inertia * (R.transpose() * (10.0 * random.direction())));
  SimulationScratch scratch = reserve_simulation(world);
  const double floor =
      below.hierarchy.center.z() - 3.0 * (below.hierarchy.radius + object.hierarchy.radius);
  const double start = world.body.mass * 9.81 * (state.body.position.z() - floor);
  Drop result;
  double energy = mechanical_energy(world.body, state.body);
  SimulationPorts ports;
  ports.query = [&](const SimulationState& s, const ContactSet&) {
    const double now = mechanical_energy(world.body, s.body);
    result.growth = std::max(result.growth, (now - energy) / start);
    energy = now;
  };
  for (double t = 0.0; t < kLongest; t += kStretch) {
    const SimulationCounts counts = simulate(world, kStretch, state, scratch, ports);
    result.counts.steps += counts.steps;
    result.counts.unresolved += counts.unresolved;
    result.deepest = std::max(result.deepest, counts.deepest / world.tolerance);
    result.seconds = state.time;
    result.ending = state.is_resting                     ? Ending::rests
                    : !(state.body.position.z() > floor) ? Ending::leaves
                    : result.counts.steps > kMostQueries ? Ending::hangs
                                                         : Ending::moves;
    if (result.ending != Ending::moves) break;
  }
  return result;
}

int drops_wanted() {
  if (const char* count = std::getenv("THIGMA_DROPS")) return std::atoi(count);
  return test::is_full() ? 1000 : 10;
}

void expect_drops(Things& things, const std::vector<std::string>& objects,
                  const std::vector<std::string>& scenes, int count, std::uint64_t seed) {
  int endings[4] = {};
  double deepest = 0.0;
  for (int i = 0; i < count; ++i) {
    Random random(seed + static_cast<std::uint64_t>(i));
    const auto pick = [&](const std::vector<std::string>& names) {
      return names[static_cast<std::size_t>(random.uniform() * static_cast<double>(names.size()))];
    };
    const std::string object = pick(objects), scene = pick(scenes);
    const double size = random.uniform() < 0.5 ? 0.02 : 0.05;
    const Drop d = drop(things.get(object, size), things.get(scene, kSceneRadius), random);
    ++endings[static_cast<int>(d.ending)];
    deepest = std::max(deepest, d.deepest);
    const std::string which = std::to_string(i) + ": " + object + " of " + std::to_string(size) +
                              " m on " + scene + " after " + std::to_string(d.seconds) + " s";
    EXPECT_NE(d.ending, Ending::hangs) << which;
    if (d.ending == Ending::moves) std::printf("moves on: %s\n", which.c_str());
    EXPECT_LE(d.deepest, 1.0) << which;
    EXPECT_LE(d.growth, 1e-6) << which;
  }
  std::printf("%d drops: %d rest, %d leave, %d move on, %d hang; deepest %.3f tolerances\n", count,
              endings[0], endings[1], endings[2], endings[3], deepest);
  EXPECT_EQ(endings[static_cast<int>(Ending::moves)], 0);
}

TEST(RandomDrops, OfProceduralObjects) {
  Things things(std::nullopt);
  expect_drops(things, {"spoon", "box", "gear", "hole", "ellipsoid", "cylinder", "torus"},
               {"plate", "cup", "hole", "box"}, drops_wanted(), 100);
}

TEST(RandomDrops, OfRealObjects) {
  THIGMA_NEEDS_SHARED(shared);
  Things things(shared);
  const std::vector<std::string> scenes = {"plate", "cup", "a12_mug_ycb.obj",
                                           "a10_round_socket_tray_16mm.obj"};
  expect_drops(things,
               {"a07_bolt_m16_loose.obj", "a08_nut_m16_loose.obj", "a09_round_peg_16mm.obj",
                "a11_spoon_ycb.obj"},
               scenes, std::max(drops_wanted() / 5, 3), 5000);
}

}  // namespace
}  // namespace thigma
