#include "thigma/scene/load_scene.h"

#include <filesystem>
#include <fstream>

#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

TEST(LoadScene, HasEverySurfaceAndNumberOfTheDescription) {
  const Scene scene = load_scene(test::small_jaws());
  ASSERT_EQ(scene.statics.size(), 1u);
  EXPECT_EQ(scene.config.contact.object, &scene.object->hierarchy);
  ASSERT_EQ(scene.config.contact.scene.size(), 1u);
  EXPECT_EQ(scene.config.contact.scene[0].hierarchy, &scene.statics[0]->hierarchy);
  EXPECT_GT(scene.config.contact.response.stiffness, 0.0);
  EXPECT_GT(scene.config.haptic.body.mass, 0.0);
  EXPECT_TRUE(scene.config.contact.textures.is_empty());
}

TEST(LoadScene, StaysValidWhenMoved) {
  Scene first = load_scene(test::small_jaws());
  const ClodHierarchy* object = first.config.contact.object;
  const Scene second = std::move(first);
  EXPECT_EQ(second.config.contact.object, object);
  EXPECT_EQ(&second.object->hierarchy, object);
}

TEST(LoadScene, TakesTwoMeshFiles) {
  const fs::path folder = fs::temp_directory_path() / "thigma_load_scene_test";
  fs::create_directories(folder);
  write_mesh(make_ball(10.0, 4), (folder / "ball.obj").string());
  write_mesh(make_box({200.0, 200.0, 10.0}), (folder / "plate.obj").string());
  SceneDescription pair = scene_from_pair(
      (folder / "ball.obj").string(), (folder / "plate.obj").string(), 0.001, {{0.0, 0.0, 0.04}});
  pair.contact.resolution.is_exact = true;
  const Scene scene = load_scene(std::move(pair));
  EXPECT_NEAR(scene.object->hierarchy.radius, 0.010, 1e-4);
  fs::remove_all(folder);
}

TEST(LoadScene, SaysWhatIsBuiltAndHowFar) {
  SceneDescription description = test::small_jaws();
  description.contact.resolution.is_exact = false;
  description.contact.response = ResponseKind::coupled;
  LoadOptions options;
  options.keeps_levels = false;
  int lines = 0;
  double last = 0.0;
  options.log = [&](const std::string&) { ++lines; };
  options.progress = [&](const std::string& what, double share, double triangles) {
    EXPECT_NE(what.find("building levels of"), std::string::npos);
    EXPECT_GT(triangles, 1000.0);
    last = share;
  };
  const Scene scene = load_scene(std::move(description), options);
  EXPECT_GT(scene.object->hierarchy.levels.size(), 1u);
  EXPECT_GE(lines, 2);
  EXPECT_EQ(last, 1.0);
}

TEST(LoadScene, GivesUpWhereItIsToldTo) {
  SceneDescription description = test::small_jaws();
  description.contact.resolution.is_exact = false;
  description.contact.response = ResponseKind::coupled;
  LoadOptions options;
  options.keeps_levels = false;
  options.progress = [](const std::string&, double, double) {
    throw std::runtime_error("told to stop");
  };
  EXPECT_THROW(load_scene(std::move(description), options), std::runtime_error);
}

TEST(LoadScene, NamesTheSceneThatIsNotThere) {
  try {
    load_scene("no_such_scene");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_scene"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("jaws"), std::string::npos);
  }
}

}  // namespace
}  // namespace thigma
