#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/device/web_device.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"
#include "thigma/simulation/simulate.h"

namespace thigma {
namespace {

TEST(OpenSession, PlacesAHandApartAndFeelsTheScene) {
  const Scene scene = load_scene(test::small_jaws());
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 2.0});
  EXPECT_TRUE(session.start.has_scene);
  const SessionSummary felt = run_lockstep(session);
  EXPECT_GT(felt.force_max, 0.1);
  EXPECT_EQ(felt.end, SessionEnd::duration);
}

TEST(OpenSession, GivesTheSameBitsTwice) {
  const Scene scene = load_scene(test::small_jaws());
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    SceneSession session = open_session(scene, {.device = "hand:", .duration = 0.5});
    hash = run_lockstep(session).state_hash;
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(OpenSession, LeavesTheSceneAsItIs) {
  const Scene scene = load_scene(test::small_jaws());
  const Pose before = scene.config.world_from_body;
  const SceneSession session = open_session(scene, {.device = "hand:", .rate = 500.0});
  EXPECT_EQ(session.config.rate, 500.0);
  EXPECT_EQ(scene.config.rate, 1000.0);
  EXPECT_EQ(scene.config.world_from_body.position, before.position);
}

TEST(OpenSession, StartsOthersWhereTheSceneSays) {
  const Scene scene = load_scene(test::small_jaws());
  const SceneSession session = open_session(scene, {.device = "null:"});
  EXPECT_EQ(session.config.world_from_body.position, scene.config.world_from_body.position);
}

TEST(OpenSession, RefusesThePagesDeviceWithoutAPage) {
  const Scene scene = load_scene(test::small_jaws());
  EXPECT_THROW(open_session(scene, {.device = "web:"}), DeviceUnavailable);
}

TEST(OpenSession, PollsForNoHandOfAPage) {
  Scene scene = load_scene(test::small_jaws());
  WebDeviceChannel page;
  const SessionOptions of_page{.device = "web:", .web_channel = &page};
  EXPECT_EQ(open_session(scene, of_page).config.spin, 0.0);
  EXPECT_LT(open_session(scene, {.device = "hand:"}).config.spin, 0.0);
  scene.config.spin = 1e-4;  // asked for
  EXPECT_EQ(open_session(scene, of_page).config.spin, 1e-4);
}

TEST(OpenSession, RefusesASceneWithNothingToTouchByWhatIsMissing) {
  SceneDescription alone = test::small_jaws();
  alone.statics.clear();
  for (const ResponseKind response : {ResponseKind::constrained, ResponseKind::potential}) {
    alone.contact.response = response;
    const Scene scene = load_scene(alone);
    try {
      open_session(scene, {.device = "null:"});
      ADD_FAILURE() << "opened";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("[[static]]"), std::string::npos) << error.what();
    }
  }
}

TEST(OpenSession, RefusesAHandForASimulation) {
  SceneDescription description = read_scene("spoon_in_cup");
  description.object.model->triangles = 3000;
  description.object.mesh = "procedural:spoon?triangles=3000";
  description.statics[0].model->triangles = 3000;
  description.statics[0].mesh = "procedural:cup?triangles=3000";
  description.contact.resolution.is_exact = true;
  const Scene scene = load_scene(std::move(description));
  EXPECT_THROW(open_session(scene, {.device = "hand:"}), DeviceAddressError);
  SceneSession session = open_session(scene, {.device = "null:", .duration = 0.02});
  ASSERT_NE(session.simulation, nullptr);
  EXPECT_EQ(run_lockstep(session).frames, 20u);
}

}  // namespace
}  // namespace thigma
