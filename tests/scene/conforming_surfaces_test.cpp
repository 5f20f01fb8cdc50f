// Surfaces that fit each other everywhere, in the constrained response: two wavy discs of 100,000
// triangles, of which 85,000 pairs of patches are near at once.

#include <algorithm>
#include <vector>

#include "support/apart.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/constraint/build_constraints.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

struct Pressed {
  Scene scene;
  Pose body_from_mesh, world_from_static;
  std::vector<HapticSample> steps;
  std::vector<ContactSample> queries;
  double slop = 0.0;
};

/// The hand comes down, and presses for the last third of a second.
Pressed press_discs() {
  SceneDescription description = read_scene("conforming");
  description.contact.response = ResponseKind::constrained;
  description.contact.resolution.is_exact = true;
  Pressed pressed;
  pressed.scene = load_scene(std::move(description));
  SceneSession session = open_session(pressed.scene, {.device = "hand:", .duration = 1.2});
  pressed.body_from_mesh = session.config.contact.body_from_mesh;
  pressed.world_from_static = session.config.contact.scene[0].world_from_body;
  pressed.slop = session.config.contact.constraints->slop;
  run_lockstep(session, {[&](const HapticSample& s) { pressed.steps.push_back(s); },
                         [&](const ContactSample& s) { pressed.queries.push_back(s); },
                         {}});
  return pressed;
}

const Pressed& pressed_discs() {
  static const Pressed pressed = press_discs();
  return pressed;
}

// With a look-ahead of less than the gap that is kept no row says where the object stops: it was
// held back in most frames, crept, and never came to rest. And a query that asks for more than it
// can look at in every frame looks at all of it in every frame.
TEST(ConformingSurfaces, ComeToRestAndAreCheapThere) {
  const Pressed& pressed = pressed_discs();
  constexpr std::ptrdiff_t kRest = 150;  // frames
  ASSERT_GT(pressed.steps.size(), 1000u);
  const auto& last = pressed.steps.back();
  EXPECT_GT(last.command.force.norm(), 0.3);
  EXPECT_TRUE(std::none_of(pressed.steps.end() - kRest, pressed.steps.end(),
                           [](const HapticSample& s) { return s.is_held_back; }));
  EXPECT_LE((last.body.position - (pressed.steps.end() - kRest)->body.position).norm(), 1e-6);
  std::vector<std::int64_t> tests;
  double least = 1.0;
  for (auto query = pressed.queries.end() - kRest; query != pressed.queries.end(); ++query) {
    tests.push_back(query->tests);
    least = std::min(least, query->look_ahead);
  }
  EXPECT_GE(least, pressed.slop);
  std::nth_element(tests.begin(), tests.begin() + kRest / 2, tests.end());
  EXPECT_LE(tests[kRest / 2], 2000);
}

// By the triangles of both meshes, without the engine's own contacts.
TEST(ConformingSurfaces, AreKeptApartByHalfOfTheGapAtLeast) {
  const Pressed& pressed = pressed_discs();
  const test::TriangleTree still = test::build_triangle_tree(
      pressed.scene.statics[0]->meshes.front(), pressed.world_from_static);
  double least = 1.0;
  for (std::size_t k = 800; k < pressed.steps.size(); k += 40) {
    const BodyState& body = pressed.steps[k].body;
    const Pose pose = Pose{body.position, body.orientation} * pressed.body_from_mesh;
    const double apart = test::least_triangle_distance(
        test::build_triangle_tree(pressed.scene.object->meshes.front(), pose), still);
    EXPECT_GT(apart, 0.45 * pressed.slop) << k;
    least = std::min(least, apart);
  }
  EXPECT_LT(least, 2.0 * pressed.slop);  // and that near they come
}

}  // namespace
}  // namespace thigma
