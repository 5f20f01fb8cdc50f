#include "thigma/scene/packed_world.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

class PackedWorld : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    for (const char* name : {"a", "b", "out"}) fs::create_directories(folder_ / name);
    write_file(path("a/part.obj"), "# one\n");
    write_file(path("b/part.obj"), "# another\n");
    write_file(path("world.toml"),
               "[object]\nname = \"held\"\nmesh = \"a/part.obj\"\nunit_scale = 1e-3\nmass = "
               "0.1\nposition = [0.1, 0.3, 1e-17]\n[[body]]\nmesh = \"b/part.obj\"\nunit_scale = "
               "1e-3\nmass = 0.3\nname = \"b\"\ncopies = 2\nspacing = [0.1, 0, 0]\n[[body]]\nname "
               "= \"c\"\nmesh = \"a/part.obj\"\nunit_scale = 2e-3\nmass = 1\n[device]\nuri = "
               "\"script:x.csv\"\nclearance = 0.007\n");
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string refusal_of(const std::string& toml, const std::string& asset) {
    {
      McapWriter writer(path("hostile.mcap"));
      writer.attach({"scene.toml", "application/toml", toml});
      writer.attach({asset, "application/octet-stream", "bytes"});
      writer.close();
    }
    try {
      read_packed_world(path("hostile.mcap"), path("out"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(PackedWorld, IsWholeInAnEmptyFolder) {
  write_packed_world(path("world.mcap"), read_world_scene(path("world.toml")));
  fs::remove_all(folder_ / "a");
  fs::remove_all(folder_ / "b");
  EXPECT_TRUE(has_packed_world(path("world.mcap")));
  const WorldSceneDescription scene = read_packed_world(path("world.mcap"), path("out"));
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(read_file(scene.bodies[0].object.mesh), "# one\n");
  EXPECT_EQ(read_file(scene.bodies[2].object.mesh), "# another\n");
  EXPECT_EQ(scene.bodies[3].object.mesh, scene.bodies[0].object.mesh) << "each file once";
  EXPECT_EQ(scene.bodies[0].object.world_from_mesh.position, Vec3(0.1, 0.3, 1e-17));
  ASSERT_EQ(scene.devices.size(), 1u);
  EXPECT_EQ(scene.devices[0].uri, "hand:") << "it brings no device";
  EXPECT_EQ(scene.devices[0].clearance, 0.007);
}

TEST_F(PackedWorld, NamesNothingButWhatItBrings) {
  const std::string start = "[[body]]\nname = \"b\"\nmass = 1\nunit_scale = 1\nmesh = ";
  EXPECT_EQ(refusal_of(start + "\"assets/part.obj\"\n", "assets/part.obj"), "");
  EXPECT_NE(refusal_of(start + "\"" + path("a/part.obj") + "\"\n", "assets/part.obj")
                .find("expected one that it brings"),
            std::string::npos);
  EXPECT_NE(refusal_of(start + "\"assets/part.obj\"\n", "../part.obj").find("an attachment"),
            std::string::npos);
}

TEST_F(PackedWorld, IsToldFromOtherFiles) {
  EXPECT_FALSE(has_packed_world(path("world.toml")));
  EXPECT_FALSE(has_packed_world(path("absent.mcap")));
  EXPECT_THROW(read_packed_world(path("absent.mcap"), path("out")), InputError);
}

}  // namespace
}  // namespace thigma
