// Models of rows that come late: the object has moved since they were made.

#include <algorithm>
#include <cstdio>

#include "experiments/common/outside_depth.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_asset.h"
#include "thigma/thigma.h"

namespace thigma::test {
namespace {

// Taken as they came, those 8 and 12 ms late let the jaws enter by 1.5 and 1.1 mm.
TEST(LateModels, LetNothingEnter) {
  const Scene scene = load_scene("jaws");
  const experiments::DepthSurface upper =
      experiments::make_depth_surface(scene.object->meshes.front());
  const experiments::DepthSurface lower =
      experiments::make_depth_surface(scene.statics.front()->meshes.front());
  for (const int latency : {1, 8, 12}) {
    SceneSession session = open_session(scene, {.device = "hand:", .duration = 3.0});
    session.config.contact_latency = latency;
    experiments::DepthMemory memory;
    double deepest = 0.0;
    int pressed = 0;
    SessionSinks sinks;
    sinks.haptic = [&](const HapticSample& s) {
      pressed += s.contact.force.norm() > 0.1;
      if (s.frame % 5 != 0) return;
      const Pose body{s.body.position, s.body.orientation};
      deepest = std::max(
          deepest, experiments::outside_depth(upper, body * session.config.contact.body_from_mesh,
                                              lower, memory));
    };
    const SessionSummary summary = run_lockstep(session, sinks);
    EXPECT_EQ(deepest, 0.0) << latency << " ms late";
    EXPECT_GT(pressed, 500);
    EXPECT_NE(summary.end, SessionEnd::fault);
    std::printf("%d ms late: %.1f %% of the frames held back\n", latency,
                100.0 * summary.constraint.held_back_share);
  }
}

}  // namespace
}  // namespace thigma::test
