// The textured scenes under constraints, in lockstep and on threads.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "thigma/recording/replay_session.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/record_session.h"
#include "thigma/scene/scene_file.h"
#include "thigma/session/session.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

Scene constrained(const char* name) {
  SceneDescription scene = read_scene(name);
  scene.contact.response = ResponseKind::constrained;
  return load_scene(std::move(scene));
}

struct Felt {
  SessionSummary summary;
  double force = 0.0, inside = 0.0;
  int frames = 0, touching = 0, depths = 0, folds = 0, waits = 0;
  struct Model {
    BodyState state;
    double travel = 0.0, reach = 0.0;
  };
  std::map<std::uint64_t, Model> models;
};

SessionSinks sinks_of(Felt& felt) {
  return {[&felt](const HapticSample& s) {
            ++felt.frames;
            felt.force = std::max(felt.force, s.command.force.norm());
            felt.touching += s.touching > 0 ? 1 : 0;
            const auto used = felt.models.find(s.model_sequence);
            if (used != felt.models.end()) {
              const Felt::Model& m = used->second;
              felt.waits += travel_between(m.state, s.body, m.reach) > 0.99 * m.travel ? 1 : 0;
            }
            if (s.touching > 0) felt.inside = std::max(felt.inside, s.penetration);
          },
          [&felt](const ContactSample& s) {
            felt.depths += s.texture_depths;
            felt.folds += s.texture_folds;
            const ConstraintModel& model = s.model.constraints;
            felt.models[s.model.sequence] = {model.state, model.travel, model.reach};
          },
          {}};
}

void print(const char* how, const Felt& felt) {
  std::printf(
      "%s: %d frames, touching %d, waits %d, force %.2f N, inside %.2f um, depths %d, folds %d\n",
      how, felt.frames, felt.touching, felt.waits, felt.force, 1e6 * felt.inside, felt.depths,
      felt.folds);
}

class ReliefScenes : public testing::TestWithParam<const char*> {};

TEST_P(ReliefScenes, AHandFeelsThem) {
  const Scene scene = constrained(GetParam());
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.0});
  Felt felt;
  felt.summary = run_lockstep(session, sinks_of(felt));
  print("lockstep", felt);
  EXPECT_EQ(felt.summary.end, SessionEnd::duration);
  EXPECT_GT(felt.depths, 0);
  EXPECT_GT(felt.touching, 100);
  EXPECT_GT(felt.force, 0.2);
  const TexturedWorld& textures = session.config.contact.textures;
  const double amplitude = textures.object.amplitude + textures.scene[0].amplitude;
  EXPECT_LE(felt.summary.penetration_max, 0.02 * amplitude);
  EXPECT_EQ(felt.summary.constraint.left_out_models, 0);
}

TEST_P(ReliefScenes, RunOnThreads) {
  const Scene scene = constrained(GetParam());
  SceneSession opened = open_session(scene, {.device = "hand:", .duration = 1.0});
  Felt felt;
  Session session(opened.config, *opened.device, sinks_of(felt));
  session.start();
  felt.summary = session.finish();
  print("threads", felt);
  std::printf("  contact steps: p50 %.0f us, p99 %.0f us; %llu models\n",
              1e6 * felt.summary.contact_step_cpu.p50, 1e6 * felt.summary.contact_step_cpu.p99,
              static_cast<unsigned long long>(felt.models.size()));
  EXPECT_EQ(felt.summary.end, SessionEnd::duration);
}

TEST_P(ReliefScenes, ReplayBitForBit) {
  const std::string path =
      (fs::temp_directory_path() / (std::string("thigma_relief_") + GetParam() + ".mcap")).string();
  const Scene scene = constrained(GetParam());
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 0.9, .seed = 7});
  const SessionSummary felt = record_lockstep(session, path);
  const ReplayReport replay = replay_recording(path);
  EXPECT_EQ(replay.state_hash, felt.state_hash);
  EXPECT_GT(felt.force_max, 0.1);
  fs::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ReliefScenes,
                         testing::Values("blocks", "file_on_cad", "block_on_gear",
                                         "hammer_on_torus"));

}  // namespace
}  // namespace thigma
