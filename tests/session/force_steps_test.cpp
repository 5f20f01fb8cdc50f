#include "thigma/session/force_steps.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

ContactSample model(std::uint64_t sequence, std::int32_t changes) {
  ContactSample s;
  s.model.sequence = sequence;
  s.pressing_changes = changes;
  return s;
}

HapticSample frame(std::uint64_t sequence, double contact, double sent, bool is_armed = true) {
  HapticSample s;
  s.model_sequence = sequence;
  s.contact.force = {0.0, 0.0, contact};
  s.command.force = {0.0, sent, 0.0};
  s.is_grasped = true;
  s.is_armed = is_armed;
  return s;
}

TEST(ForceSteps, ASteppingForceIsPutDownToTheModelThatCameWithIt) {
  ForceSteps steps;
  steps.observe(model(1, 0));
  steps.observe(frame(1, 0.0, 0.0));
  steps.observe(frame(1, 0.5, 0.1));  // same model: the hand moved
  EXPECT_DOUBLE_EQ(steps.contact.other, 0.5);
  EXPECT_DOUBLE_EQ(steps.device.other, 0.1);
  steps.observe(model(2, 3));
  steps.observe(frame(2, 0.8, 0.3));
  EXPECT_NEAR(steps.contact.level_change, 0.3, 1e-15);
  EXPECT_NEAR(steps.device.level_change, 0.2, 1e-15);
  steps.observe(frame(2, 2.8, 0.3));  // a frame later it is no longer the level's doing
  EXPECT_NEAR(steps.contact.level_change, 0.3, 1e-15);
  EXPECT_NEAR(steps.contact.other, 2.0, 1e-15);
  EXPECT_EQ(steps.level_change_frames, 1u);
}

TEST(ForceSteps, ModelsThatNoFrameUsedCountWithTheNext) {
  ForceSteps steps;
  steps.observe(model(1, 0));
  steps.observe(frame(1, 0.0, 0.0));
  steps.observe(model(2, 1));
  steps.observe(model(3, 0));
  steps.observe(frame(3, 1.0, 0.0));
  EXPECT_EQ(steps.level_change_frames, 1u);
  EXPECT_EQ(steps.contact.other, 0.0);
}

TEST(ForceSteps, FramesWithoutForcesDoNotCount) {
  ForceSteps steps;
  steps.observe(model(1, 5));
  steps.observe(frame(1, 0.0, 0.0, false));
  steps.observe(frame(1, 9.0, 9.0, false));
  steps.observe(frame(1, 1.0, 1.0));  // the first armed frame has none before it
  steps.observe(frame(1, 1.5, 1.0));
  EXPECT_NEAR(steps.contact.other, 0.5, 1e-15);
  EXPECT_EQ(steps.contact.level_change, 0.0);
}

}  // namespace
}  // namespace thigma
