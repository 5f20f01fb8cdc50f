// The constrained response through the whole loop: the hand presses, the object stays outside.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/apart.h"
#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/recording/replay_session.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/record_session.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

Scene constrained_jaws(double friction = 0.0) {
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::constrained;
  scene.contact.friction = friction;
  return load_scene(std::move(scene));
}

struct Felt {
  SessionSummary summary;
  double deepest = 0.0, force = 0.0;
  int met = 0;
};

/// Runs a session; every so many frames the triangles of both meshes are looked at.
Felt run(const Scene& scene, int every, int look) {
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 2.0});
  session.config.contact_every = every;
  const test::TriangleTree still = test::build_triangle_tree(
      scene.statics[0]->meshes.front(), session.config.contact.scene[0].world_from_body);
  Felt felt;
  int frame = 0;
  const SessionSinks sinks{[&](const HapticSample& s) {
                             felt.deepest = std::max(felt.deepest, s.penetration);
                             felt.force = std::max(felt.force, s.command.force.norm());
                             if (frame++ % look != 0) return;
                             const Pose pose = Pose{s.body.position, s.body.orientation} *
                                               session.config.contact.body_from_mesh;
                             felt.met += test::meet(scene.object->meshes.front(), pose, still);
                           },
                           {},
                           {}};
  felt.summary = run_lockstep(session, sinks);
  return felt;
}

TEST(ConstrainedResponse, PressedByAHandTheJawsDoNotEnterEachOther) {
  const Scene scene = constrained_jaws();
  for (const int every : {1, 10, 33}) {
    const Felt felt = run(scene, every, 41);
    EXPECT_EQ(felt.summary.end, SessionEnd::duration) << every;
    EXPECT_EQ(felt.met, 0) << every;
    EXPECT_LE(felt.deepest, 0.0) << every;
    EXPECT_GT(felt.force, 0.3) << every;  // and the hand feels them
  }
}

TEST(ConstrainedResponse, ThePenaltyLetsThemIn) {
  // What the test above looks at is there to be seen.
  const Felt felt = run(load_scene(test::small_jaws()), 10, 41);
  EXPECT_GT(felt.met, 0);
}

TEST(ConstrainedResponse, ReplaysBitForBit) {
  const std::string path = (fs::temp_directory_path() / "thigma_constrained.mcap").string();
  const Scene scene = constrained_jaws(0.3);
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.2, .seed = 7});
  const SessionSummary felt = record_lockstep(session, path);
  const ReplayReport replay = replay_recording(path);
  EXPECT_EQ(replay.state_hash, felt.state_hash);
  EXPECT_GT(felt.force_max, 0.3);
  fs::remove(path);
}

TEST(ConstrainedResponse, IsReadFromAScene) {
  const std::string text = R"(
[object]
mesh = "procedural:ball?triangles=320"
[[static]]
mesh = "procedural:ball?triangles=320"
[contact]
response = "constraint"
friction = 0.4
)";
  const SceneDescription scene = parse_scene(text, "S.toml", "");
  EXPECT_EQ(scene.contact.response, ResponseKind::constrained);
  EXPECT_EQ(scene.contact.friction, 0.4);
}

TEST(ConstrainedResponse, RefusesNegativeFriction) {
  const std::string text =
      "[object]\nmesh = \"procedural:ball\"\n[[static]]\nmesh = \"procedural:ball\"\n"
      "[contact]\nfriction = -0.1\n";
  EXPECT_THROW(parse_scene(text, "S.toml", ""), InputError);
}

}  // namespace
}  // namespace thigma
