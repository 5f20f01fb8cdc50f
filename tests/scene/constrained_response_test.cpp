// The constrained response through the whole loop: the hand presses, the object stays outside.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "support/apart.h"
#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/constraint/build_constraints.h"
#include "thigma/core/error.h"
#include "thigma/loop/contact_step.h"
#include "thigma/recording/replay_session.h"
#include "thigma/response/potential_contacts.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/record_session.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

Scene constrained_jaws(double friction = 0.0) {
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::constrained;
  scene.contact.friction = {friction, friction};
  return load_scene(std::move(scene));
}

struct Felt {
  SessionSummary summary;
  double deepest = 0.0, force = 0.0;
  double bound = 0.0;  // of the contacts, at most [m]
  int met = 0;
};

/// Runs a session; every so many frames the triangles of both meshes are looked at.
/// stand_off  of the object's size; 0: the engine's
Felt run(const Scene& scene, int every, int look, double stand_off = 0.0) {
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 2.0});
  session.config.contact_every = every;
  if (stand_off > 0.0) {
    auto world = std::make_shared<ConstraintWorld>(*session.config.contact.constraints);
    session.config.haptic.constraint.slop = world->slop = stand_off * world->reach;
    session.config.contact.constraints = world;
  }
  const test::TriangleTree still = test::build_triangle_tree(
      scene.statics[0]->meshes.front(), session.config.contact.scene[0].world_from_body);
  Felt felt;
  int frame = 0;
  const SessionSinks sinks{
      [&](const HapticSample& s) {
        felt.deepest = std::max(felt.deepest, s.penetration);
        felt.force = std::max(felt.force, s.command.force.norm());
        if (frame++ % look != 0) return;
        const Pose pose =
            Pose{s.body.position, s.body.orientation} * session.config.contact.body_from_mesh;
        felt.met += test::meet(scene.object->meshes.front(), pose, still);
      },
      [&](const ContactSample& s) { felt.bound = std::max(felt.bound, s.bound_max); },
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

// On the way that the jaws go with this stand-off, a list of features that was full counted as one
// that holds, as that of two other patches had been in its place: two edges had no row.
TEST(ConstrainedResponse, NorDoTheyWhereALongListTakesThePlaceOfAnother) {
  EXPECT_EQ(run(constrained_jaws(), 33, 7, 4e-6).met, 0);
}

Scene jaws_that_carry(double carry) {
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::constrained;
  scene.contact.carry = carry;
  return load_scene(std::move(scene));
}

TEST(ConstrainedResponse, CarriesContactsUnlessAskedNotTo) {
  SceneDescription scene = test::small_jaws();
  const auto carried = [&] { return load_scene(scene).config.contact.resolution.carry; };
  scene.contact.response = ResponseKind::constrained;
  EXPECT_EQ(carried(), 0.1);
  scene.contact.carry = 0.0;
  EXPECT_EQ(carried(), 0.0);
  scene.contact.carry.reset();
  scene.contact.resolution.carry = 0.3;
  EXPECT_EQ(carried(), 0.3);
  scene.contact.resolution.carry = 0.0;
  scene.contact.response = ResponseKind::coupled;
  EXPECT_EQ(carried(), 0.0);
}

TEST(ConstrainedResponse, NorDoTheyWhereContactsAreCarried) {
  for (const double carry : {0.1, 1.0}) {
    const Scene scene = jaws_that_carry(carry);
    for (const int every : {1, 10}) {
      const Felt felt = run(scene, every, 41);
      EXPECT_EQ(felt.summary.end, SessionEnd::duration) << every;
      EXPECT_EQ(felt.met, 0) << every;
      EXPECT_LE(felt.deepest, 0.0) << every;
      EXPECT_GT(felt.force, 0.3) << every;
      EXPECT_GT(felt.bound, 0.0) << every << ": nothing was carried";
    }
  }
}

Scene jaws_with_levels(double threshold) {
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::constrained;
  scene.contact.has_levels_far = true;
  scene.contact.resolution.is_exact = false;
  scene.contact.resolution.metric.haptic = threshold;
  return load_scene(std::move(scene), {.keeps_levels = false});
}

TEST(ConstrainedResponse, NorDoTheyWhereFarPairsStayCoarse) {
  for (const double threshold : {0.0025, 0.05}) {
    const Scene scene = jaws_with_levels(threshold);
    ASSERT_FALSE(scene.config.contact.resolution.is_exact);
    for (const int every : {1, 10}) {
      const Felt felt = run(scene, every, 41);
      EXPECT_EQ(felt.summary.end, SessionEnd::duration) << every;
      EXPECT_EQ(felt.met, 0) << every;
      EXPECT_LE(felt.deepest, 0.0) << every;
      EXPECT_GT(felt.force, 0.3) << every;
      EXPECT_GT(felt.summary.constraint.coarse_max, 0) << every;
      EXPECT_EQ(felt.summary.state_hash, run(scene, every, 41).summary.state_hash) << every;
    }
  }
}

TEST(ConstrainedResponse, FarPairsStayCoarseOnlyWhereAskedFor) {
  const auto response = [](const std::string& keys) {
    return parse_scene(
        "[object]\nmesh = \"procedural:ball\"\n[[static]]\nmesh = \"procedural:ball\"\n"
        "[contact]\n" +
            keys,
        "S.toml", "");
  };
  EXPECT_TRUE(response("response = \"constraint\"\nthreshold = 0.01\n").contact.has_levels_far);
  EXPECT_FALSE(response("response = \"constraint\"\n").contact.has_levels_far);
  EXPECT_FALSE(response("threshold = 0.01\n").contact.has_levels_far);
  EXPECT_FALSE(response("response = \"constraint\"\nthreshold = 0.01\nexact = true\n")
                   .contact.has_levels_far);
  EXPECT_FALSE(response("response = \"penalty\"\nthreshold = 0.01\n").contact.has_levels_far);
}

TEST(ConstrainedResponse, ThePenaltyLetsThemIn) {
  // What the test above looks at is there to be seen.
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::coupled;
  const Felt felt = run(load_scene(std::move(scene)), 10, 41);
  EXPECT_GT(felt.met, 0);
}

/// What was felt of a recorded session, which replays bit for bit.
SessionSummary felt_and_replayed(const Scene& scene, const std::string& name) {
  const std::string path = (fs::temp_directory_path() / name).string();
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.2, .seed = 7});
  const SessionSummary felt = record_lockstep(session, path);
  const ReplayReport replay = replay_recording(path);
  EXPECT_EQ(replay.state_hash, felt.state_hash);
  EXPECT_GT(felt.force_max, 0.3);
  fs::remove(path);
  return felt;
}

TEST(ConstrainedResponse, ReplaysBitForBit) {
  felt_and_replayed(constrained_jaws(0.3), "thigma_constrained.mcap");
}

TEST(ConstrainedResponse, ReplaysBitForBitWhereContactsAreCarried) {
  felt_and_replayed(jaws_that_carry(0.1), "thigma_constrained_carry.mcap");
}

TEST(ConstrainedResponse, ReplaysBitForBitWhereFarPairsStayCoarse) {
  const SessionSummary felt =
      felt_and_replayed(jaws_with_levels(0.025), "thigma_constrained_levels.mcap");
  EXPECT_GT(felt.constraint.coarse_max, 0);
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
  EXPECT_EQ(scene.contact.friction, (Friction{0.4, 0.4}));
}

TEST(ConstrainedResponse, IsTheDefaultOfSmoothScenesInAHand) {
  EXPECT_EQ(load_scene(test::small_jaws()).config.haptic.response, ResponseKind::constrained);
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::direct;
  EXPECT_EQ(load_scene(scene).config.haptic.response, ResponseKind::direct);
  const SceneDescription relief = read_scene("plate"), dropped = read_scene("spoon_in_cup");
  EXPECT_EQ(default_response(relief, true), ResponseKind::coupled);
  EXPECT_EQ(default_response(relief, false), ResponseKind::constrained);
  EXPECT_EQ(default_response(dropped, true), ResponseKind::coupled);
}

TEST(PotentialResponse, IsOpenedByNameAndRefusesWhatTheLawHasNot) {
  SceneDescription scene = test::small_jaws();
  scene.contact.response = ResponseKind::potential;
  scene.contact.exponent = 2;
  const Scene jaws = load_scene(scene);
  const SceneSession session = open_session(jaws, {.device = "null:", .duration = 0.01});
  EXPECT_EQ(session.config.haptic.response, ResponseKind::potential);
  EXPECT_TRUE(session.config.contact.potential != nullptr);
  EXPECT_EQ(session.config.contact.potential_law.exponent, 2);
  const double radius = jaws.object->hierarchy.radius;
  EXPECT_DOUBLE_EQ(session.config.contact.potential_law.area, 0.0625 * radius * radius);

  // What only code can say is refused in one line with its place, too.
  scene.contact.area = -1.0;
  const Scene wrong = load_scene(scene);
  try {
    open_session(wrong, {.device = "null:"});
    FAIL() << "an area below 0";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("potential response: area -1"), std::string::npos)
        << error.what();
  }
}

TEST(PotentialResponse, FeelsRelief) {
  SceneDescription scene = read_scene("plate");
  scene.contact.response = ResponseKind::potential;
  const Scene plate = load_scene(scene);
  SceneSession session = open_session(plate, {.device = "hand:", .duration = 2.0});
  session.config.contact_every = 4;
  int touching = 0;
  const SessionSummary felt =
      run_lockstep(session, {[&](const HapticSample& s) { touching += s.touching > 0; }, {}, {}});
  EXPECT_EQ(felt.end, SessionEnd::duration);
  EXPECT_GT(touching, 100);
  // The surfaces are the fine ones.
  EXPECT_GT(session.config.contact.potential->scene[0]->mesh.triangles.size() +
                session.config.contact.potential->object.mesh.triangles.size(),
            100'000u);
}

/// A ball of 10 mm at a height over one like it, in the hand of nobody.
void start_ball(double height, std::string& said, SessionConfig& config) {
  SceneDescription scene =
      scene_from_pair("procedural:ball?triangles=320", "procedural:ball?triangles=320");
  const Scene loaded = load_scene(scene);
  SessionOptions options{.device = "null:", .duration = 0.05};
  options.world_from_body = Pose{{0.0, 0.0, height}, Quat::Identity()};
  options.log = [&](const std::string& line) { said += line; };
  SceneSession session = open_session(loaded, options);
  config = session.config;
}

TEST(ConstrainedResponse, AnObjectThatStartsInsideIsLedOut) {
  const double radius =
      load_scene(scene_from_pair("procedural:ball?triangles=320", "procedural:ball?triangles=320"))
          .object->hierarchy.radius;
  std::string said;
  SessionConfig config;
  start_ball(1.5 * radius, said, config);
  EXPECT_NE(said.find("moved apart"), std::string::npos) << said;
  EXPECT_GT(config.world_from_body.position.norm(), 2.0 * radius);
  said.clear();
  start_ball(2.001 * radius, said, config);  // near, but apart: as given
  EXPECT_EQ(said, "");
  EXPECT_DOUBLE_EQ(config.world_from_body.position.z(), 2.001 * radius);
}

TEST(ConstrainedResponse, TheHandKnowsHowFarTheSceneIs) {
  const Scene scene = load_scene(test::small_jaws());
  const SceneSession session = open_session(scene, {.device = "hand:", .duration = 0.1});
  EXPECT_TRUE(session.start.has_scene);
}

TEST(ConstrainedResponse, NeedsNoLevels) {
  SceneDescription scene = test::small_jaws();
  scene.contact.resolution.is_exact = false;
  const Scene loaded = load_scene(std::move(scene), {.keeps_levels = false});
  EXPECT_TRUE(loaded.config.contact.resolution.is_exact);
  ASSERT_GT(loaded.object->hierarchy.levels.size(), 1u);
  EXPECT_TRUE(loaded.object->hierarchy.levels[1].is_free);
}

TEST(ConstrainedResponse, EveryPairOfBodiesHasItsOwnFriction) {
  const std::string text = R"(
[object]
mesh = "procedural:box"
position = [0, 0, 0.041]
[object.material]
friction = 0.2
static_friction = 0.32
[[static]]
mesh = "procedural:box"
[static.material]
friction = 0.8
static_friction = 1.28
[[static]]
mesh = "procedural:box"
position = [0, 0, 0.082]
[contact]
response = "constraint"
exact = true
friction = 0.05
)";
  const Scene scene = load_scene(parse_scene(text, "S.toml", ""));
  const SceneSession session = open_session(scene, {.device = "null:"});
  const std::vector<Friction>& pairs = session.config.contact.friction;
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_NEAR(pairs[0].kinetic, 0.4, 1e-15);
  EXPECT_NEAR(pairs[0].at_rest, 0.64, 1e-15);
  EXPECT_NEAR(pairs[1].kinetic, 0.1, 1e-15);
  // The rows of a model and the terms of the penalty have them, each of its body.
  for (const bool is_constrained : {true, false}) {
    ContactWorld world = session.config.contact;
    if (!is_constrained) world.constraints = nullptr;
    const double reach = scene.object->hierarchy.radius;
    world.tolerance = world.response.tolerance = 0.5 * reach;
    ContactScratch scratch;
    reserve_contact_scratch(world, scratch);
    StampedBody body;
    body.state.position = session.config.world_from_body.position;
    body.wanted_speed = 1e3 * reach;
    auto sample = std::make_unique<ContactSample>();
    for (int k = 0; k < 8; ++k) {  // looks farther ahead each time
      body.time += 1e-3;
      contact_step(world, body, scratch, *sample);
    }
    std::array<int, 2> found{};
    const auto look = [&](const auto& terms) {
      for (const auto& term : terms) {
        const auto b = static_cast<std::size_t>(term.body);
        ASSERT_LT(b, 2u);
        ++found[b];
        EXPECT_EQ(term.friction, pairs[b]);
      }
    };
    look(sample->model.constraints.rows);
    look(sample->model.planes);
    EXPECT_GT(found[0], 0) << is_constrained;
    EXPECT_GT(found[1], 0) << is_constrained;
  }
}

TEST(ConstrainedResponse, RefusesNegativeFriction) {
  const std::string text =
      "[object]\nmesh = \"procedural:ball\"\n[[static]]\nmesh = \"procedural:ball\"\n"
      "[contact]\nfriction = -0.1\n";
  EXPECT_THROW(parse_scene(text, "S.toml", ""), InputError);
}

}  // namespace
}  // namespace thigma
