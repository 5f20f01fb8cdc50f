#include "thigma/scene/world_scene.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/infinity.h"
#include "thigma/scene/asset_cache.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/world_change.h"

namespace thigma {
namespace {

const std::string kTable = R"(
[[static]]
name = "table"
mesh = "procedural:box?triangles=12"
unit_scale = 10.0
position = [0.0, 0.0, -0.2]
)";

std::string block(const std::string& more) {
  return "[[body]]\nmesh = \"procedural:box?triangles=12\"\n" + more;
}

std::string refusal(const std::string& text) {
  try {
    load_world(parse_world_scene(text, "w.toml", ""));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WorldScene, ReadsBodiesAndCopies) {
  const WorldSceneDescription scene = parse_world_scene(
      "title = \"t\"\ngravity = [0.0, 0.0, -9.81]\n" + kTable +
          block("name = \"b\"\nposition = [0.0, 0.0, 0.0201]\ncopies = 3\n"
                "spacing = [0.0, 0.0, 0.041]\nmass = 0.5\nvelocity = [1.0, 2.0, 3.0]\n"
                "material = {friction = 0.4, restitution = 0.5}\n"),
      "w.toml", "");
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(scene.bodies[0].kind, BodyKind::fixed);
  EXPECT_EQ(scene.bodies[3].object.name, "b 3");
  EXPECT_NEAR(scene.bodies[3].object.world_from_mesh.position.z(), 0.1021, 1e-15);
  const LoadedWorld world = load_world(scene);
  EXPECT_TRUE(world.config.hands.empty());
  EXPECT_EQ(world.config.world.shapes.size(), 2u);
  EXPECT_EQ(world.config.world.bodies[2].friction.kinetic, 0.4);
  EXPECT_EQ(world.config.world.bodies[2].restitution, 0.5);
  EXPECT_EQ(world.config.start.bodies[2].linear_momentum, Vec3(0.5, 1.0, 1.5));
}

// Refused at the table that goes beyond, not after every table has made its thousand.
TEST(WorldScene, RefusesMoreBodiesThanAWorldHolds) {
  const std::string thousand =
      block("mass = 1.0\ncopies = 1000\nspacing = [0.0, 0.0, 1.0]\nname = \"b\"\n");
  const std::string line = refusal(thousand + block("mass = 1.0\nname = \"c\"\n") + thousand);
  EXPECT_NE(line.find("1001 bodies"), std::string::npos) << line;
  EXPECT_NE(line.find("expected at most 1000"), std::string::npos) << line;
}

TEST(WorldScene, AThresholdAsksForLevelsThatAreKept) {
  const std::string home = ::testing::TempDir() + "world_levels";
  ::setenv("XDG_CACHE_HOME", home.c_str(), 1);
  const std::string ring =
      "[[body]]\nmesh = \"procedural:torus?triangles=600\"\nmass = 0.1\n"
      "position = [0.0, 0.0, 0.3]\n";
  const LoadedWorld exact = load_world(parse_world_scene(kTable + ring, "w.toml", ""));
  EXPECT_EQ(exact.config.world.threshold, 0.0);
  EXPECT_TRUE(exact.hierarchies[1]->level_patches.empty());
  const std::string asked = kTable + ring + "[contact]\nthreshold = 0.05\n";
  const LoadedWorld world = load_world(parse_world_scene(asked, "w.toml", ""));
  EXPECT_EQ(world.config.world.threshold, 0.05);
  EXPECT_FALSE(world.hierarchies[1]->level_patches.empty());
  EXPECT_EQ(world.meshes[1]->triangles.size(), exact.meshes[1]->triangles.size());
  EXPECT_NEAR(world.config.world.bodies[1].mass, 0.1, 1e-15);
  EXPECT_FALSE(list_cache(home + "/thigma").empty());
  ::unsetenv("XDG_CACHE_HOME");
  const WorldChange change = with_another(world, 1, Vec3(0.3, 0.0, 0.3), world.config.start);
  EXPECT_EQ(change.world.config.world.threshold, 0.05);
  EXPECT_NE(refusal(kTable + ring + "[contact]\nthreshold = 0.0\n").find("threshold"),
            std::string::npos);
  EXPECT_NE(refusal(kTable + ring + "[contact]\nbudget_us = 5.0\n").find("budget_us"),
            std::string::npos);
}

TEST(WorldScene, RefusesByName) {
  const struct {
    const char* more;
    const char* says;
  } cases[] = {
      {"", "no mass, line"},
      {"mass = 0.0\n", "body.mass"},
      {"mass = 1.0\ndensity = 1.0\n", "density stands beside mass"},
      {"mass = 1.0\nkind = \"held\"\nposition = [0.0, 0.0, 1.0]\nname = \"b\"\n"
       "[[device]]\nholds = \"c\"\n",
       "holds 'c', expected 'b'?"},
      {"mass = 1.0\nkind = \"held\"\nposition = [0.0, 0.0, 1.0]\nname = \"b\"\n"
       "[[device]]\nuri = \"null:\"\n",
       "no holds"},
      {"mass = 1.0\nkind = \"held\"\nposition = [0.0, 0.0, 1.0]\nname = \"b\"\ncopies = 2\n"
       "spacing = [0.5, 0.0, 0.0]\n[[device]]\nholds = \"b 1\"\n",
       "body 'b 2': held by no device"},
      {"mass = 1.0\nkind = \"flying\"\n", "kind"},
      {"mass = 1.0\ncopies = 2\n", "expected spacing"},
      {"mass = 1.0\nname = \"a/b\"\n", "cannot be used"},
      {"mass = 1.0\nfriktion = 1.0\n", "friktion"},
      {"mass = 1.0\nname = \"table\"\nposition = [0.0, 0.0, 1.0]\n", "name given twice"},
      {"mass = 1.0\nname = \"low\"\n", "body 'low': starts"},
  };
  for (const auto& c : cases) {
    const std::string line = refusal(kTable + block(c.more));
    EXPECT_NE(line.find(c.says), std::string::npos) << c.says << " | " << line;
    EXPECT_EQ(line.find("w.toml: "), 0u) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

std::string joint(const std::string& more) {
  return "\n[[joint]]\nname = \"j\"\nbody = \"b\"\nposition = [0.0, 0.0, 1.0]\n" + more;
}

TEST(WorldScene, ReadsJoints) {
  const std::string bodies = block(
      "name = \"b\"\nposition = [0.0, 0.0, 1.0]\ncopies = 3\n"
      "spacing = [0.2, 0.0, 0.0]\nmass = 0.5\n");
  const std::string joints = R"(
[[joint]]
name = "arm"
kind = "hinge"
body = "b 1"
to = "table"
position = [0.0, 0.1, 1.0]
axis = [0.0, 2.0, 0.0]
lower = -1.0
upper = 2.0
motor = {target = 0.5, most = 3.0, stiffness = 10.0, damping = 1.0}

[[joint]]
name = "rope"
kind = "spring"
body = "b 3"
position = [0.4, 0.0, 1.0]
to_position = [0.4, 0.0, 1.5]
stiffness = 5.0

[[joint]]
name = "eye"
kind = "ball"
body = "b #"
to = "b #-1"
position = [-0.1, 0.0, 1.0]
copies = 3
spacing = [0.2, 0.0, 0.0]
)";
  const std::string first = "name = \"b 0\"\nposition = [-0.2, 0.0, 1.0]\nmass = 1.0\n";
  const LoadedWorld loaded =
      load_world(parse_world_scene(kTable + bodies + block(first) + joints, "w.toml", ""));
  const World& world = loaded.config.world;
  ASSERT_EQ(world.joints.size(), 5u);
  const WorldJoint &arm = world.joints[0], &rope = world.joints[1], &eye = world.joints[4];
  EXPECT_EQ(arm.kind, JointKind::hinge);
  EXPECT_EQ(world.bodies[static_cast<std::size_t>(arm.b)].name, "table");
  EXPECT_EQ(arm.upper, 2.0);
  EXPECT_TRUE(arm.motor.is_on && arm.motor.is_servo);
  EXPECT_LT((arm.b_from_joint.orientation * Vec3::UnitZ() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(rope.b, -1);
  EXPECT_NEAR(rope.rest, 0.5, 1e-15);
  EXPECT_EQ(eye.name, "eye 3");
  EXPECT_EQ(world.bodies[static_cast<std::size_t>(eye.a)].name, "b 3");
  EXPECT_EQ(world.bodies[static_cast<std::size_t>(eye.b)].name, "b 2");
  EXPECT_TRUE(never_touch(world, eye.a, eye.b));
}

TEST(WorldScene, RefusesJointsByName) {
  const std::string bodies =
      kTable + block("name = \"b\"\nposition = [0.0, 0.0, 1.0]\nmass = 0.5\n");
  const struct {
    const char* more;
    const char* says;
  } cases[] = {
      {"", "no kind"},
      {"kind = \"screw\"\n", "kind"},
      {"kind = \"hinge\"\n", "no axis"},
      {"kind = \"ball\"\naxis = [0.0, 0.0, 1.0]\n", "axis is not for this kind"},
      {"kind = \"hinge\"\naxis = [0.0, 0.0, 0.0]\n", "axis has no direction"},
      {"kind = \"ball\"\nto = \"tabel\"\n", "joint 'j': no body 'tabel', expected 'table'"},
      {"kind = \"ball\"\nto = \"b\"\n", "joint 'j': the same body twice"},
      {"kind = \"ball\"\nupper = 1.0\n", "joint 'j': limits or a motor"},
      {"kind = \"ball\"\nto_position = [0.0, 0.0, 0.0]\n", "to_position is not for this kind"},
      {"kind = \"spring\"\n", "joint 'j': a spring without"},
      {"kind = \"ball\"\nstiffness = nan\n", "stiffness"},
      {"kind = \"hinge\"\naxis = [0.0, 1.0, 0.0]\nstiffness = 1e300\n", "numbers to 1e100"},
      {"kind = \"hinge\"\naxis = [0.0, 1.0, 0.0]\nmotor = {speed = 1.0, most = 1e308}\n",
       "numbers to 1e100"},
      {"kind = \"slider\"\naxis = [1.0, 0.0, 0.0]\nlower = 0.1\n",
       "joint 'j': starts at 0, expected within its limits 0.1 to inf"},
      {"kind = \"slider\"\naxis = [1.0, 0.0, 0.0]\nmotor = {speed = 1.0}\n", "no most"},
      {"kind = \"slider\"\naxis = [1.0, 0.0, 0.0]\nmotor = {most = 1.0}\n", "no speed or target"},
      {"kind = \"slider\"\naxis = [1.0, 0.0, 0.0]\nmotor = {target = 1.0, most = 1.0}\n",
       "a target without stiffness"},
      {"kind = \"ball\"\ncopies = 2\n", "copies stands without spacing"},
      {"kind = \"ball\"\nstifness = 1.0\n", "stifness"},
      {"kind = \"ball\"\n[[joint]]\nname = \"a/b\"\nkind = \"ball\"\nbody = \"b\"\n"
       "position = [0.0, 0.0, 1.0]\n",
       "joint.name = 'a/b' cannot be used"},
  };
  const std::string far = refusal(
      bodies + "[[joint]]\nname = \"j\"\nbody = \"b\"\nkind = \"ball\"\nposition = [1e12, 0, 0]\n");
  EXPECT_NE(far.find("m from a body's centre, expected at most"), std::string::npos) << far;
  for (const auto& c : cases) {
    const std::string line = refusal(bodies + joint(c.more));
    EXPECT_NE(line.find(c.says), std::string::npos) << c.says << " | " << line;
    EXPECT_EQ(line.find("w.toml: "), 0u) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

TEST(WorldScene, AMotorTurnsByARadianAFrameAtMost) {
  const std::string bodies =
      kTable + block("name = \"b\"\nposition = [0.0, 0.0, 1.0]\nmass = 0.5\n");
  const std::string fast =
      "kind = \"hinge\"\naxis = [0.0, 1e200, 0.0]\nmotor = {speed = 1e6, most = 1.0}\n";
  const LoadedWorld world = load_world(parse_world_scene(bodies + joint(fast), "w.toml", ""));
  try {
    run_world(world.config, {});
    FAIL() << "a motor of a million radians a second";
  } catch (const InputError& error) {
    EXPECT_NE(
        std::string(error.what()).find("joint 'j': motor of 1e+06 rad/s at 1000 Hz, expected"),
        std::string::npos)
        << error.what();
  }
}

TEST(WorldScene, DevicesThatMayHoldAPersonAreRefusedUnopened) {
  const LoadedWorld world =
      load_world(read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/two_hands.toml"));
  for (const char* uri : {"haply:?host=nowhere.invalid", "vrpn:T@nowhere.invalid", "dhd:0",
                          "web:", "hand:?camera=vrpn:T@nowhere.invalid"}) {
    try {
      open_world_devices(world, {uri, "null:"}, 1);
      FAIL() << uri;
    } catch (const DeviceUnavailable& error) {
      EXPECT_NE(std::string(error.what()).find("not in lockstep"), std::string::npos) << uri;
    }
  }
}

TEST(WorldScene, HandsOfPeopleHoldByTheirClutch) {
  LoadedWorld world =
      load_world(read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/two_hands.toml"));
  use_clutches({"dhd:0", ""}, world);
  EXPECT_TRUE(world.config.hands[0].has_clutch);
  EXPECT_FALSE(world.config.hands[1].has_clutch);  // the scene's hand:
  use_clutches({"script:way.csv", "spacenav:"}, world);
  EXPECT_FALSE(world.config.hands[0].has_clutch);
  EXPECT_TRUE(world.config.hands[1].has_clutch);
}

TEST(WorldScene, SafetyIsOfAllHandsAndADevicesOwnNumbersAreItsOwn) {
  const std::string bodies = kTable + R"(
[[body]]
kind = "held"
name = "a"
mesh = "procedural:box?triangles=12"
position = [0.0, 0.0, 0.5]
density = 100.0
[[body]]
kind = "held"
name = "b"
mesh = "procedural:box?triangles=12"
position = [0.2, 0.0, 0.5]
density = 100.0
[[device]]
holds = "a"
motion_scale = 2.0
position = [0.0, 0.0, 0.1]
[[device]]
holds = "b"
max_force = 3.0
motion_scale = 2.0
force_scale = 2.0
)";
  const LoadedWorld world = load_world(parse_world_scene(
      bodies + "[safety]\nwatchdog = 0.1\nmax_force = 5.0\nstart_ramp = 2.0\n", "s.toml", ""));
  ASSERT_EQ(world.config.hands.size(), 2u);
  const WorldHand &a = world.config.hands[0], &b = world.config.hands[1];
  EXPECT_EQ(a.limits.max_force, 5.0);
  EXPECT_EQ(b.limits.max_force, 3.0);
  EXPECT_EQ(b.limits.watchdog, 0.1);
  EXPECT_EQ(b.limits.start_ramp, 2.0);
  EXPECT_EQ(free_hand(world).limits.watchdog, 0.1);
  EXPECT_EQ(a.workspace.motion_scale, 2.0);
  EXPECT_EQ(a.workspace.force_scale, 0.5);
  EXPECT_EQ(a.workspace.world_from_device.position.z(), 0.1);
  EXPECT_EQ(b.workspace.force_scale, 2.0);
  const std::string line = refusal(bodies + "[safety]\nwatchdogs = 1.0\n");
  EXPECT_NE(line.find("watchdogs"), std::string::npos) << line;
}

TEST(WorldScene, IsToldFromAScene) {
  const std::string folder = std::string(THIGMA_SOURCE_DIR) + "/scenes/";
  EXPECT_TRUE(is_world_scene(folder + "tower.toml"));
  EXPECT_FALSE(is_world_scene(folder + "jaws.toml"));
  EXPECT_FALSE(is_world_scene("nothing.toml"));
  try {
    read_scene(folder + "tower.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("moves by itself"), std::string::npos);
  }
}

TEST(WorldScene, ShippedTowerStands) {
  LoadedWorld world =
      load_world(read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/tower.toml"));
  ASSERT_EQ(world.config.world.bodies.size(), 31u);
  world.config.duration = 0.8;
  double most = 0.0;
  const WorldSummary run = run_world(world.config, {}, [&](const WorldFrame& frame) {
    for (std::size_t i = 0; i < frame.bodies.size(); ++i)
      most =
          std::max(most, (frame.bodies[i].position - world.config.start.bodies[i].position).norm());
  });
  EXPECT_LE(most, 30 * 2e-6);  // to the stand-off of each
  EXPECT_EQ(run.awake, 0);
}

TEST(WorldScene, ShippedRowIsPushed) {
  LoadedWorld world =
      load_world(read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/row_of_blocks.toml"));
  world.config.duration = 1.5;
  const WorldDevices devices = open_world_devices(world, {}, 1);
  ASSERT_EQ(devices.list.size(), 1u);
  double way = 0.0;
  const WorldSummary run = run_world(world.config, devices.list, [&](const WorldFrame& frame) {
    way = (frame.bodies.back().position - world.config.start.bodies.back().position).norm();
  });
  EXPECT_GT(way, 1e-3);  // the last of ten
  EXPECT_EQ(run.largest_island, 11);
  EXPECT_GE(run.port_energy_min, -1e-6);
}

/// A shipped scene with the device it names.
struct Shipped {
  LoadedWorld world;
  WorldSummary run;
  std::vector<double> most;  // by joint: largest coordinate
  std::vector<BodyState> end;

  Shipped(const std::string& name, double seconds)
      : world(load_world(
            read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/" + name + ".toml"))) {
    world.config.duration = seconds;
    most.assign(world.config.world.joints.size(), -kInfinity);
    const WorldDevices devices = open_world_devices(world, {}, 1);
    run = run_world(world.config, devices.list, [&](const WorldFrame& frame) {
      end.assign(frame.bodies.begin(), frame.bodies.end());
      for (std::size_t i = 0; i < most.size(); ++i)
        most[i] = std::max(most[i], frame.joints[i].coordinate);
    });
    EXPECT_EQ(run.waited, 0.0);
    EXPECT_EQ(run.not_whole, 0u);
    EXPECT_LE(run.joint_error, 1e-8);
    EXPECT_LE(run.energy_made, 1e-6);
  }
};

TEST(WorldScene, ShippedDrawerIsOpenedUpToItsStop) {
  const Shipped drawer("drawer", 4.0);
  EXPECT_NEAR(drawer.most[1], 0.03, 1e-9);
  EXPECT_GE(drawer.run.port_energy_min, -1e-6);
}

TEST(WorldScene, ShippedLidIsLifted) {
  const Shipped lid("lid", 3.0);
  EXPECT_GT(lid.most[0], 0.05);
  EXPECT_GE(lid.run.port_energy_min, -1e-6);
}

TEST(WorldScene, ShippedHandsPutThePegIn) {
  const Shipped hands("two_hands", 3.0), again("two_hands", 0.5), once_more("two_hands", 0.5);
  ASSERT_EQ(hands.run.hands.size(), 2u);
  EXPECT_GT(hands.run.pressing_max, 4);
  EXPECT_FALSE(hands.run.has_fault());
  EXPECT_EQ(again.run.state_hash, once_more.run.state_hash);
}

TEST(WorldScene, ShippedCastingsArePutTogether) {
  const Shipped castings("castings", 3.0);
  const std::vector<WorldBody>& bodies = castings.world.config.world.bodies;
  // Where the planes of the faces meet their axes.
  std::array<Vec3, 2> face = {Vec3::Zero(), Vec3::Zero()};
  int found = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const bool is_spigot = bodies[i].name == "flange with spigot";
    if (!is_spigot && bodies[i].name != "flange with socket") continue;
    const BodyState& y = castings.end[i];
    const Pose mesh = Pose{y.position, y.orientation} * bodies[i].shape.body_from_mesh;
    face[is_spigot ? 1 : 0] = mesh.position;
    ++found;
  }
  ASSERT_EQ(found, 2);
  const Vec3 apart = face[1] - face[0];
  EXPECT_GT(apart.z(), 0.0);
  EXPECT_LE(apart.z(), 10e-6);  // face on face, 42.5 mm from where it began
  EXPECT_LE(std::hypot(apart.x(), apart.y()), 0.31e-3);  // within the play
  EXPECT_GE(castings.run.pressing_max, 3);
  EXPECT_FALSE(castings.run.has_fault());
}

TEST(WorldScene, ShippedLinksHangTogether) {
  const Shipped links("links", 2.0);
  EXPECT_EQ(links.world.config.world.joints.size(), 9u);
  EXPECT_EQ(links.run.largest_island, 10);
}

}  // namespace
}  // namespace thigma
