// The potential response through the whole loop.

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/mesh_session.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/loop/contact_step.h"
#include "thigma/math/rotation.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

SessionConfig potential_session(const test::MeshSession& scene) {
  SessionConfig config = scene.config;
  config.contact.potential_law.area = 2e-5;
  use_potential(config);
  return config;
}

/// What use_potential says of a configuration.
std::string refusal(SessionConfig config) {
  try {
    use_potential(config);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PotentialSession, RefusesWhatTheLawHasNot) {
  const test::MeshSession scene;
  SessionConfig good = scene.config;
  good.contact.potential_law.area = 2e-5;
  EXPECT_EQ(refusal(good), "");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {0.0, -1.0, nan, infinity}) {
    SessionConfig config = good;
    config.contact.response.stiffness = wrong;
    EXPECT_NE(refusal(config).find("potential response: stiffness"), std::string::npos) << wrong;
    config = good;
    config.contact.potential_law.area = wrong;
    EXPECT_NE(refusal(config).find("potential response: area"), std::string::npos) << wrong;
  }
  SessionConfig config = good;
  config.contact.potential_law.exponent = 3;
  EXPECT_NE(refusal(config).find("exponent 3, expected 2 or 4"), std::string::npos);
  EXPECT_NE(refusal(test::plane_session()).find("no surfaces"), std::string::npos);
}

TEST(PotentialSession, AHandFeelsIt) {
  const test::MeshSession scene;
  SessionConfig config = potential_session(scene);
  config.duration = 2.0;
  HandDevice hand(scene.hand(HandPath::slide));
  double deepest = 0.0;
  int touching = 0;
  const SessionSummary felt = run_lockstep(config, hand,
                                           {[&](const HapticSample& s) {
                                              deepest = std::max(deepest, s.penetration);
                                              touching += s.touching > 0;
                                            },
                                            {},
                                            {}});
  EXPECT_EQ(felt.end, SessionEnd::duration);
  EXPECT_GT(felt.force_max, 0.2);
  EXPECT_GT(touching, 500);
  EXPECT_LT(deepest, 5e-3);
  EXPECT_GT(felt.energy_min, -1e-5);
}

TEST(PotentialSession, TheModelTellsTheDeepestPlace) {
  const test::MeshSession scene(300.0, make_ball(0.015, 8));
  const SessionConfig config = potential_session(scene);
  ContactScratch scratch;
  reserve_contact_scratch(config.contact, scratch);
  BodyState state;
  state.position = {0.0, 0.0, 0.0145};
  ContactSample sample;
  contact_step(config.contact, {state, 0.0, 0}, scratch, sample);
  EXPECT_GT(sample.contacts, 10);
  EXPECT_GT(sample.model.depths.size(), 1u);
  EXPECT_NEAR(sample.depth_max, 5e-4, 3e-4);
  // In the air there is no model to feel.
  state.position.z() = 0.03;
  contact_step(config.contact, {state, 0.001, 1}, scratch, sample);
  EXPECT_EQ(sample.contacts, 0);
  EXPECT_TRUE(sample.model.depths.empty());
}

}  // namespace
}  // namespace thigma
