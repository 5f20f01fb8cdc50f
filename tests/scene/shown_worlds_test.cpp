// The shipped worlds whose parts hold each other by contact alone.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/core/index.h"
#include "thigma/multibody/joint.h"
#include "thigma/scene/world_scene.h"

namespace thigma {
namespace {

/// A shipped world, run with the devices it names.
struct ShownWorld {
  LoadedWorld world;
  WorldSummary run;
  std::vector<std::vector<Vec3>> places;         // by frame and body: centre of mass [m]
  std::vector<std::vector<double>> coordinates;  // by frame and joint

  ShownWorld(const std::string& name, double seconds, std::uint64_t seed = 1)
      : world(load_world(
            read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/" + name + ".toml"))) {
    world.config.duration = seconds;
    const WorldDevices devices = open_world_devices(world, {}, seed);
    run = run_world(world.config, devices.list, [this](const WorldFrame& frame) {
      std::vector<Vec3>& all = places.emplace_back();
      for (const BodyState& body : frame.bodies) all.push_back(body.position);
      std::vector<double>& angles = coordinates.emplace_back();
      for (const JointReading& joint : frame.joints) angles.push_back(joint.coordinate);
    });
    EXPECT_FALSE(run.has_fault());
    EXPECT_EQ(run.waited, 0.0);
    EXPECT_EQ(run.not_whole, 0u);
    EXPECT_LE(run.energy_made, 1e-6);
    EXPECT_GT(run.gap_min, 0.0);
  }
  std::size_t body(const std::string& name) const {
    for (std::size_t i = 0; i < world.config.world.bodies.size(); ++i)
      if (world.config.world.bodies[i].name == name) return i;
    ADD_FAILURE() << "no body " << name;
    return 0;
  }
  /// How far it is from where it was at first [m].
  double way(const std::string& name) const {
    const std::size_t i = body(name);
    return (places.back()[i] - places.front()[i]).norm();
  }
};

// 20 teeth each: what one turns the other turns back, but for the play between teeth, in which it
// coasts. A tooth that is skipped is a whole pitch.
TEST(ShownWorlds, TeethTurnTheOtherGear) {
  const ShownWorld gears("gears", 3.0);
  const double pitch = 2.0 * 3.14159265358979 / 20.0;
  double most = 0.0, off = 0.0;
  for (const std::vector<double>& angle : gears.coordinates) {
    most = std::max(most, std::fabs(angle[1]));
    off = std::max(off, std::fabs(angle[0] + angle[1]));
  }
  EXPECT_GT(most, 1.0);  // rad: more than three teeth
  EXPECT_LT(off, 0.5 * pitch);
  EXPECT_GT(gears.run.pressing_max, 0);
}

// Linked, two rings cannot be farther apart than their holes let them.
TEST(ShownWorlds, RingsHoldEachOther) {
  const ShownWorld rings("rings", 2.0);
  const double thick = 0.4 * 0.012, across = 0.4 * 0.092;
  const double most = across - 2.0 * thick;
  const std::vector<std::string> order = {"ring 0",      "odd ring 1", "even ring 1", "odd ring 2",
                                          "even ring 2", "odd ring 3", "even ring 3"};
  double farthest = 0.0;
  for (const std::vector<Vec3>& places : rings.places) {
    for (std::size_t k = 1; k < order.size(); ++k) {
      const Vec3 apart = places[rings.body(order[k])] - places[rings.body(order[k - 1])];
      farthest = std::max(farthest, apart.norm());
    }
  }
  EXPECT_LT(farthest, most);
  EXPECT_GT(farthest, 0.98 * most);  // they hang in each other
  EXPECT_EQ(rings.run.largest_island, 7);
}

TEST(ShownWorlds, ThingsInTraysAreMovedAndStayThere) {
  const ShownWorld tray("tray", 6.0), instruments("instruments", 6.0);
  EXPECT_GT(tray.way("peg 2"), 0.002);
  EXPECT_GT(instruments.way("probe in the tray"), 0.002);
  EXPECT_EQ(tray.run.awake, 1);  // the ball in the hand
  for (const ShownWorld* shown : {&tray, &instruments}) {
    EXPECT_GE(shown->run.port_energy_min, -2e-5);  // the weight in the hand, let down
    for (std::size_t i = 0; i < shown->places.back().size(); ++i) {
      if (shown->world.config.world.bodies[i].kind == BodyKind::fixed) continue;
      const Vec3& place = shown->places.back()[i];
      EXPECT_GT(place.z(), 0.0);
      EXPECT_LT(std::fabs(place.x()), 0.071) << i;  // between the walls
      EXPECT_LT(std::fabs(place.y()), 0.051) << i;
    }
  }
}

// Thirty bodies of 5,000 triangles, balls that roll among them: no step is divided for long.
TEST(ShownWorlds, ACrowdIsStirredWithoutWaiting) {
  const ShownWorld crowd("crowd", 2.0);
  EXPECT_EQ(crowd.world.config.world.bodies.size(), 36u);
  EXPECT_LE(crowd.run.parts_max, 2);
  EXPECT_GT(crowd.run.force_max, 0.1);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < crowd.places.back().size(); ++i) {
    if (crowd.world.config.world.bodies[i].kind != BodyKind::moving) continue;
    const Vec3& place = crowd.places.back()[i];
    moved += (place - crowd.places.front()[i]).norm() > 0.005;
    EXPECT_GT(place.z(), 0.0) << i;
    EXPECT_LT(std::fabs(place.x()), 0.14) << i;  // between the walls
    EXPECT_LT(std::fabs(place.y()), 0.11) << i;
  }
  EXPECT_GE(moved, 3u);
}

TEST(ShownWorlds, HaveTheSameBitsTwice) {
  for (const char* name : {"gears", "rings", "tray", "instruments", "crowd"}) {
    const ShownWorld first(name, 0.5), second(name, 0.5);
    EXPECT_EQ(first.run.state_hash, second.run.state_hash) << name;
  }
}

}  // namespace
}  // namespace thigma
