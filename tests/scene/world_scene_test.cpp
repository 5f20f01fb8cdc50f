#include "thigma/scene/world_scene.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/scene/scene_file.h"

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
  EXPECT_EQ(world.config.held, -1);
  EXPECT_EQ(world.config.world.shapes.size(), 2u);
  EXPECT_EQ(world.config.world.bodies[2].friction.kinetic, 0.4);
  EXPECT_EQ(world.config.world.bodies[2].restitution, 0.5);
  EXPECT_EQ(world.config.start.bodies[2].linear_momentum, Vec3(0.5, 1.0, 1.5));
}

TEST(WorldScene, RefusesByName) {
  const struct {
    const char* more;
    const char* says;
  } cases[] = {
      {"", "no mass, line"},
      {"mass = 0.0\n", "body.mass"},
      {"mass = 1.0\ndensity = 1.0\n", "density stands beside mass"},
      {"mass = 1.0\nkind = \"held\"\n", "expected the held body as [object]"},
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
  const WorldSummary run = run_world(world.config, nullptr, [&](const WorldFrame& frame) {
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
  const auto device = open_world_device(world, "", 1);
  ASSERT_NE(device, nullptr);
  double way = 0.0;
  const WorldSummary run = run_world(world.config, device.get(), [&](const WorldFrame& frame) {
    way = (frame.bodies.back().position - world.config.start.bodies.back().position).norm();
  });
  EXPECT_GT(way, 1e-3);  // the last of ten
  EXPECT_EQ(run.largest_island, 11);
  EXPECT_GE(run.port_energy_min, -1e-6);
}

}  // namespace
}  // namespace thigma
