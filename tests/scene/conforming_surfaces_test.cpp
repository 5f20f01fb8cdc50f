// Surfaces that fit each other everywhere, in the constrained response: two wavy discs of 100,000
// triangles, of which 85,000 pairs of patches are near at once.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/constraint/build_constraints.h"
#include "thigma/scene/load_scene.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

struct Pressed {
  std::vector<HapticSample> steps;
  std::vector<ContactSample> queries;
  double slop = 0.0;
};

/// The hand comes down, and presses for the last third of a second.
Pressed press_discs() {
  SceneDescription description = read_scene("conforming");
  description.contact.response = ResponseKind::constrained;
  description.contact.resolution.is_exact = true;
  const Scene scene = load_scene(std::move(description));
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.2});
  Pressed pressed;
  pressed.slop = session.config.contact.constraints->slop;
  run_lockstep(session, {[&](const HapticSample& s) { pressed.steps.push_back(s); },
                         [&](const ContactSample& s) { pressed.queries.push_back(s); },
                         {}});
  return pressed;
}

// With a look-ahead of less than the gap that is kept no row says where the object stops: it was
// held back in most frames, crept, and never came to rest. And a query that asks for more than it
// can look at in every frame looks at all of it in every frame.
TEST(ConformingSurfaces, ComeToRestAndAreCheapThere) {
  const Pressed pressed = press_discs();
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

TEST(ConformingSurfaces, AreKeptApartByHalfOfTheGapAtLeast) {
  const Pressed pressed = press_discs();
  double deepest = -1.0;
  for (const HapticSample& s : pressed.steps) deepest = std::max(deepest, s.penetration);
  EXPECT_LE(deepest, -0.45 * pressed.slop);
}

}  // namespace
}  // namespace thigma
