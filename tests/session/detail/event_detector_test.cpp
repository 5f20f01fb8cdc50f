#include "thigma/session/detail/event_detector.h"

#include <string>

#include "support/row_samples.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::grasped;
using test::with_rows;

struct Told {
  std::vector<SessionEvent> events;
  detail::EventDetector detector{
      [this](const SessionEvent& e) {
        if (e.kind == EventKind::held_back || e.kind == EventKind::squeezed) events.push_back(e);
      },
      detail::DeepContactLimits{1.0, 1.0}};
};

TEST(WaitingEvents, AreToldOnceAndOnlyWhenTheyLast) {
  Told told;
  std::uint64_t frame = 0;
  const auto frames = [&](int count, int every) {
    for (int i = 0; i < count; ++i) {
      HapticSample s = grasped(frame++);
      s.is_held_back = every > 0 && i % every == 0;
      s.wanted_speed = 0.5;
      told.detector.observe(s, 0.0);
    }
  };
  ContactSample c = with_rows(4);
  told.detector.observe(c);
  c.time = 0.01;
  c.travel = 1.5e-3;
  told.detector.observe(c);
  frames(1000, 3);  // a third of the frames: it gets on
  frames(98, 1);
  EXPECT_TRUE(told.events.empty());
  frames(5, 1);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_EQ(told.events[0].kind, EventKind::held_back);
  EXPECT_EQ(told.events[0].detail, "contacts_too_slow");
  EXPECT_NE(told.events[0].text.find("0.5 m/s"), std::string::npos) << told.events[0].text;
  EXPECT_NE(told.events[0].text.find("10.0 ms"), std::string::npos) << told.events[0].text;
  EXPECT_NE(told.events[0].text.find("1.5 mm"), std::string::npos) << told.events[0].text;
  frames(500, 0);
  frames(500, 1);
  EXPECT_EQ(told.events.size(), 1u);
}

TEST(WaitingEvents, NameWhatHadNoRoom) {
  for (const bool is_cut : {true, false}) {
    Told told;
    ContactSample c = with_rows(256);
    c.travel_halvings = is_cut ? 3 : 0;
    c.left_out = is_cut ? 0 : 12;
    told.detector.observe(c);
    for (std::uint64_t i = 0; i < 200; ++i) {
      HapticSample s = grasped(i);
      s.is_held_back = true;
      told.detector.observe(s, 0.0);
    }
    ASSERT_EQ(told.events.size(), 1u);
    EXPECT_EQ(told.events[0].detail, is_cut ? "too_many_rows" : "contacts_left_out");
  }
}

TEST(WaitingEvents, TellOfASqueezeAndNotOfAnObjectThatNobodyHolds) {
  Told told;
  for (std::uint64_t i = 0; i < 300; ++i) {
    HapticSample s = grasped(i);
    s.is_grasped = false;
    s.is_squeezed = s.is_held_back = true;
    told.detector.observe(s, 0.0);
  }
  EXPECT_TRUE(told.events.empty());
  for (std::uint64_t i = 300; i < 600; ++i) {
    HapticSample s = grasped(i);
    s.is_squeezed = true;
    told.detector.observe(s, 0.0);
  }
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_EQ(told.events[0].kind, EventKind::squeezed);
  EXPECT_NE(told.events[0].text.find("move it back"), std::string::npos);
}

}  // namespace
}  // namespace thigma
