#include <cstdio>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/device/open_device.h"
#include "thigma/mesh/shapes.h"
#include "thigma/runtime/session.h"

using namespace thigma;

int main() {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(0.02, 12));
  const ClodHierarchy plate = build_exact_hierarchy(make_box({0.2, 0.2, 0.01}));
  SessionConfig session{.world_from_body = {{0.0, 0.0, 0.035}}, .duration = 4.0};
  session.haptic.body = make_body(0.010, 1.6e-6 * Mat3::Identity());
  session.haptic.coupling = {.linear_stiffness = 300.0,
                             .linear_damping = 2.4,
                             .angular_stiffness = 0.04,
                             .angular_damping = 3.5e-4};
  session.contact = ContactWorld{.object = &ball,
                                 .scene = {SceneBody{&plate, Pose{}}},
                                 .tolerance = 2e-4,
                                 .response = {.damping = 6.0}};
  const auto hand = open_device("hand:", {.clearance = 0.01, .object_radius = 0.02});
  const SessionSummary felt = run_lockstep(session, *hand);
  std::printf("largest force %.2f N at %.1f contacts, penetration %.3f mm\n", felt.force_max,
              felt.contacts_mean, 1e3 * felt.penetration_max);
}
