#include "thigma/session/fault_injection.h"

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

TEST(FaultInjection, ReadsWhatTheProgramTakes) {
  const std::vector<FaultEvent> events = parse_faults("unplug@2,stall=0.05@3,nan@4.5,hang=0.03@5");
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].kind, InjectedFault::unplug);
  EXPECT_EQ(events[0].time, 2.0);
  EXPECT_EQ(events[1].kind, InjectedFault::stall);
  EXPECT_EQ(events[1].duration, 0.05);
  EXPECT_EQ(events[1].time, 3.0);
  EXPECT_EQ(events[2].kind, InjectedFault::nan);
  EXPECT_EQ(events[3].kind, InjectedFault::hang);
  EXPECT_TRUE(parse_faults("").empty());
}

TEST(FaultInjection, RefusesTheRestWithItsText) {
  for (const char* text :
       {"unplug", "unplug@", "unplug@x", "unplug@-1", "unplug@nan", "stall@3", "stall=@3",
        "stall=1@", "unplug=1@2", "boom@1", "nan@1,", ",nan@1", "nan@1s", "nan@inf"}) {
    try {
      parse_faults(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("expected unplug@T"), std::string::npos) << text;
    }
  }
}

TEST(FaultInjection, SpansEndAndOthersDoNot) {
  const auto events = parse_faults("stall=0.5@1,unplug@2");
  EXPECT_EQ(active_fault(events, InjectedFault::stall, 0.99), nullptr);
  EXPECT_NE(active_fault(events, InjectedFault::stall, 1.0), nullptr);
  EXPECT_EQ(active_fault(events, InjectedFault::stall, 1.5), nullptr);
  EXPECT_EQ(active_fault(events, InjectedFault::unplug, 1.9), nullptr);
  EXPECT_NE(active_fault(events, InjectedFault::unplug, 99.0), nullptr);
  EXPECT_EQ(active_fault(events, InjectedFault::nan, 99.0), nullptr);
}

TEST(FaultInjection, ActsOnTheDeviceAndPassesTheRestThrough) {
  test::HeldDevice inner;
  inner.state.motion.pose.position = {1.0, 2.0, 3.0};
  const auto device = make_faulty_device(inner, parse_faults("nan@1,unplug@2"));
  EXPECT_EQ(device->read(0.5).motion.pose.position, Vec3(1.0, 2.0, 3.0));
  EXPECT_FALSE(device->read(1.0).motion.pose.position.allFinite());
  EXPECT_TRUE(device->read(1.001).motion.pose.position.allFinite());  // once
  EXPECT_EQ(device->read(2.0).status, DeviceStatus::lost);
  device->write({Vec3(0.0, 1.0, 0.0), Vec3::Zero()});
  EXPECT_EQ(inner.written.force.y(), 1.0);
  EXPECT_EQ(device->name(), "held");
}

}  // namespace
}  // namespace thigma
