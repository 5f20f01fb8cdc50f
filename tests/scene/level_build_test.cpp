#include "thigma/scene/level_build.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/device/open_device.h"
#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/recording/replay_session.h"
#include "thigma/scene/record_session.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

/// Jaws whose contacts have levels, by the text's law.
SceneDescription jaws_with_levels() {
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::coupled;
  scene.contact.resolution = {.is_exact = false};
  return scene;
}

/// Levels are built beside the session. folder: where they are kept; "": nowhere
LoadOptions beside(const std::string& folder = "") {
  LoadOptions options;
  options.defers_levels = true;
  options.keeps_levels = !folder.empty();
  options.cache_folder = folder;
  return options;
}

/// The same before and after its levels have come.
struct Both {
  Scene without, with;
  SceneSession session;  // begins without
  Both() : without(load_scene(jaws_with_levels(), beside())) {
    LevelBuild levels(jaws_with_levels(), beside());
    with = levels.take();
    session = open_session(without, {.device = "null:"});
  }
};

/// Built once for all tests.
const Both& jaws_of_both() {
  static const Both jaws;
  return jaws;
}

TEST(LevelBuild, LeavesOutLevelsThatAreNotKeptAndBuildsThemBesideTheSession) {
  const Both& jaws = jaws_of_both();
  EXPECT_TRUE(jaws.without.lacks_levels);
  EXPECT_TRUE(jaws.without.object->hierarchy.level_patches.empty());
  EXPECT_FALSE(jaws.with.lacks_levels);
  EXPECT_FALSE(jaws.with.object->hierarchy.level_patches.empty());
  EXPECT_FALSE(jaws.without.config.contact.resolution.is_exact);  // asks for levels all the same
  EXPECT_EQ(jaws.without.config.haptic.body.mass, jaws.with.config.haptic.body.mass);
  EXPECT_EQ(jaws.without.config.haptic.body.inertia, jaws.with.config.haptic.body.inertia);
}

TEST(LevelBuild, UsesLevelsThatAreKeptAtOnce) {
  const fs::path folder = fs::temp_directory_path() / "thigma_level_build_test";
  fs::remove_all(folder);
  const LoadOptions options = beside(folder.string());
  EXPECT_TRUE(load_scene(jaws_with_levels(), options).lacks_levels);
  EXPECT_FALSE(LevelBuild(jaws_with_levels(), options).take().lacks_levels);
  const Scene again = load_scene(jaws_with_levels(), options);
  EXPECT_FALSE(again.lacks_levels);
  EXPECT_FALSE(again.object->hierarchy.level_patches.empty());
  fs::remove_all(folder);
}

TEST(LevelBuild, IsGivenUpAtOnceAndTellsWhatIsWrong) {
  LevelBuild levels(jaws_with_levels(), beside());
  levels.give_up();
  EXPECT_THROW(levels.take(), std::runtime_error);
  SceneDescription absent = jaws_with_levels();
  absent.object.model.reset();
  absent.object.mesh = "/no/such/mesh.obj";
  EXPECT_THROW(LevelBuild(absent, {}).take(), std::runtime_error);
}

/// Contacts at the finest are the same ones with and without levels.
TEST(LevelBuild, IsGivenUpWhileItWaits) {
  LevelBuild levels(jaws_with_levels(), beside(), 1e4);
  EXPECT_FALSE(levels.is_over());
  levels.give_up();
  EXPECT_THROW(levels.take(), std::runtime_error);  // without the wait
}

TEST(LevelBuild, FinestContactsAreTheSameBitsWithAndWithoutLevels) {
  const Both& jaws = jaws_of_both();
  std::vector<std::vector<Contact>> found;
  for (const Scene* scene : {&jaws.without, &jaws.with}) {
    ContactWorld world = scene->config.contact;
    world.resolution = {};
    world.tolerance = 0.004;
    ContactScratch scratch;
    reserve_query(world, scratch);
    StampedBody at;
    at.state.position = scene->config.world_from_body.position;
    at.state.orientation = scene->config.world_from_body.orientation;
    find_contacts(world, at, scratch);
    found.push_back(scratch.contacts.contacts);
  }
  ASSERT_GT(found[0].size(), 20u);
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    EXPECT_EQ(found[0][i].object_patch, found[1][i].object_patch);
    EXPECT_EQ(found[0][i].scene_patch, found[1][i].scene_patch);
    EXPECT_EQ(found[0][i].depth, found[1][i].depth);
  }
}

constexpr double kFrame = 0.002;            // [s]
constexpr int kFrames = 2400, kSwap = 600;  // levels have faded in at 1600

/// An object that is pressed on and slid about, and the force on it frame by frame.
std::vector<double> force_steps(const Both& jaws, bool has_fade) {
  const SessionConfig& config = jaws.session.config;
  ContactWorld world = config.contact;
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  // Down to where the surfaces are half a tolerance apart.
  SessionConfig placed = config;
  const StartPlacement start = place_at_start(Vec3(-Vec3::UnitZ()), placed);
  const double down = start.clearance + 0.5 * world.tolerance;
  std::unique_ptr<ContactReplacement> next;
  std::vector<double> steps;
  Vec3 last = Vec3::Zero();
  ContactSample sample;
  for (int i = 0; i < kFrames; ++i) {
    StampedBody body;
    body.frame = static_cast<std::uint64_t>(i);
    body.time = kFrame * i;
    body.state.orientation = placed.world_from_body.orientation;
    body.state.position = placed.world_from_body.position - down * Vec3::UnitZ();
    body.state.position.x() += 5e-4 * std::sin(2.0 * body.time);
    if (i == kSwap) {
      next = replace_contacts(config, jaws.with, body.state);
      exchange_contacts(*next, world, scratch);
    }
    if (i >= kSwap && has_fade)
      world.resolution =
          faded_in(jaws.with.config.contact.resolution, (i - kSwap) * kFrame / kLevelsFadeIn);
    contact_step(world, body, scratch, sample);
    EXPECT_EQ(sample.model.sequence, static_cast<std::uint64_t>(i + 1));  // none is missed
    const Vec3 force = contact_wrench(sample.model, config.haptic.body, body.state).force;
    steps.push_back(i == 0 ? 0.0 : (force - last).norm());
    last = force;
  }
  return steps;
}

double largest(const std::vector<double>& steps, int from, int to) {
  return *std::max_element(steps.begin() + from, steps.begin() + to);
}

TEST(LevelBuild, LevelsComeWithoutAJumpOfTheForce) {
  const Both& jaws = jaws_of_both();
  const std::vector<double> steps = force_steps(jaws, true), hard = force_steps(jaws, false);
  const int faded = kSwap + static_cast<int>(kLevelsFadeIn / kFrame);
  const double elsewhere = std::max(largest(steps, 1, kSwap), largest(steps, faded + 1, kFrames));
  std::printf(
      "force steps: %.4f N at the exchange, %.4f N while levels fade in, %.4f N elsewhere; "
      "%.4f N at the exchange without fading\n",
      steps[kSwap], largest(steps, kSwap, faded), elsewhere, hard[kSwap]);
  EXPECT_GT(elsewhere, 0.0);
  EXPECT_LE(largest(steps, kSwap, faded + 1), 2.0 * elsewhere);
  EXPECT_LE(steps[kSwap], elsewhere);
}

TEST(LevelBuild, AThreadedSessionGoesOnWithLevelsAndReplaysToTheSameBits) {
  const Both& jaws = jaws_of_both();
  SceneSession session =
      open_session(jaws.without, {.device = "hand:", .duration = 1.5, .seed = 7});
  SessionConfig config = session.config;
  config.haptic.safety.watchdog = 5.0;  // the machine's other work decides nothing here
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  LivePorts ports;
  config.live = &ports;
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  bool is_given = false;
  const auto next = replace_contacts(config, jaws.with,
                                     initial_state(config.haptic, config.world_from_body).body);
  Session running(config, *session.device,
                  {[&](const HapticSample& s) {
                     samples.push_back(s);
                     if (is_given || s.time < 0.4) return;
                     is_given = true;
                     ports.replacement.store(next.get(), std::memory_order_release);
                   },
                   [&](const ContactSample& s) { models.push_back(s); },
                   {}});
  running.start();
  const SessionSummary felt = running.finish();
  EXPECT_EQ(ports.replacement.load(), nullptr);
  EXPECT_EQ(next->world.object, jaws.without.config.contact.object);  // exchanged
  for (std::size_t i = 0; i < models.size(); ++i) ASSERT_EQ(models[i].model.sequence, i + 1);
  HapticParams params = config.haptic;
  use_device_limits(session.device->limits(), params);
  const ReplayReport again = replay_session(params, config.world_from_body, samples, models);
  EXPECT_TRUE(again.identical) << again.reason;
  EXPECT_EQ(again.state_hash, felt.state_hash);
}

}  // namespace
}  // namespace thigma
