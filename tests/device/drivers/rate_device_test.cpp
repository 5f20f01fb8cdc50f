// SpaceMouse and gamepad: events into deflections, deflections into motion.
#include "thigma/device/detail/rate_device.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <linux/input.h>

#include "thigma/device/detail/gamepad_device.h"
#include "thigma/device/detail/spacenav_device.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

std::string event_of(std::initializer_list<std::int32_t> numbers) {
  std::int32_t data[8] = {};
  std::copy(numbers.begin(), numbers.end(), data);
  return {reinterpret_cast<const char*>(data), sizeof data};
}

TEST(Spacenav, six_pushes_and_six_turns_are_ours) {
  // x right, y up, z away from the person; ours: x to the person, y right, z up
  const Vec3 wanted[3] = {Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX()};
  for (int axis = 0; axis < 6; ++axis) {
    for (const int sign : {1, -1}) {
      std::int32_t data[8] = {0};
      data[axis + 1] = 350 * sign;
      SpacenavState state;
      ASSERT_EQ(take_spacenav_event({reinterpret_cast<const char*>(data), sizeof data}, state), "");
      const Twist d = spacenav_deflection(state);
      const Vec3 way = sign * wanted[axis % 3];
      EXPECT_EQ(d.linear, axis < 3 ? way : Vec3(Vec3::Zero()));
      EXPECT_EQ(d.angular, axis < 3 ? Vec3(Vec3::Zero()) : way);
    }
  }
}

TEST(Spacenav, small_deflections_are_none_and_large_ones_full) {
  SpacenavState state;
  EXPECT_EQ(take_spacenav_event(event_of({0, 10, -9000, 182, 0, 0, 0, 16}), state), "");
  const Twist d = spacenav_deflection(state);
  EXPECT_EQ(d.linear.y(), 0.0);
  EXPECT_EQ(d.linear.z(), -1.0);
  EXPECT_NEAR(d.linear.x(), -0.5, 1e-12);  // 182 is midway between 14 and 350
}

TEST(Spacenav, buttons_are_bits) {
  SpacenavState state;
  EXPECT_EQ(take_spacenav_event(event_of({1, 1, 1}), state), "");
  EXPECT_EQ(state.buttons, 2u);
  EXPECT_EQ(take_spacenav_event(event_of({2, 1, 0}), state), "");
  EXPECT_EQ(take_spacenav_event(event_of({1, 99, 1}), state), "");
  EXPECT_EQ(take_spacenav_event(event_of({1, -1, 1}), state), "");
  EXPECT_EQ(state.buttons, 0u);
}

TEST(Spacenav, what_is_no_event_is_refused) {
  SpacenavState state;
  EXPECT_NE(take_spacenav_event("half an event", state), "");
  EXPECT_NE(take_spacenav_event(std::string(32, 'x'), state), "");
  EXPECT_NE(take_spacenav_event(event_of({0, 2'000'000'000}), state), "");
  EXPECT_NE(take_spacenav_event(event_of({-1}), state), "");
  EXPECT_EQ(take_spacenav_event(event_of({3, 0, 1}), state), "");  // of protocol 1: passed over
  EXPECT_EQ(spacenav_deflection(state).linear, Vec3(Vec3::Zero()));
}

TEST(Gamepad, sticks_triggers_and_bumpers_are_ours) {
  struct Case {
    int code, value;
    Vec3 linear, angular;
  };
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Case cases[] = {{ABS_X, 32767, y, o},   {ABS_X, -32768, -y, o}, {ABS_Y, 32767, x, o},
                        {ABS_Y, -32768, -x, o}, {ABS_RZ, 255, z, o},    {ABS_Z, 255, -z, o},
                        {ABS_RX, 32767, o, -z}, {ABS_RX, -32768, o, z}, {ABS_RY, 32767, o, y},
                        {ABS_RY, -32768, o, -y}};
  for (const Case& c : cases) {
    PadState state = plain_pad();
    EXPECT_LT(pad_deflection(state).linear.norm(), 1e-12);
    take_pad_event(EV_ABS, static_cast<std::uint16_t>(c.code), c.value, state);
    EXPECT_LT((pad_deflection(state).linear - c.linear).norm(), 1e-9) << c.code;
    EXPECT_LT((pad_deflection(state).angular - c.angular).norm(), 1e-9) << c.code;
  }
  PadState state = plain_pad();
  take_pad_event(EV_KEY, BTN_TR, 1, state);
  EXPECT_EQ(pad_deflection(state).angular, -x);
  take_pad_event(EV_KEY, BTN_TR, 0, state);
  take_pad_event(EV_KEY, BTN_TL, 1, state);
  EXPECT_EQ(pad_deflection(state).angular, x);
}

TEST(Gamepad, nonsense_stays_within_the_ranges) {
  PadState state = plain_pad();
  take_pad_event(EV_ABS, ABS_X, 2'000'000'000, state);
  take_pad_event(EV_ABS, ABS_Z, -5, state);
  take_pad_event(EV_ABS, 999, 5, state);
  take_pad_event(EV_KEY, 999, 1, state);
  take_pad_event(99, 0, 1, state);
  EXPECT_EQ(pad_deflection(state).linear, Vec3(Vec3::UnitY()));
  EXPECT_EQ(state.buttons, 0u);
}

/// Publishes one deflection at once.
LinkTalk pushed(const Twist& rate, std::uint32_t buttons) {
  return [rate, buttons](LinkEnds& ends) {
    LinkSample sample;
    sample.count = 1;
    sample.motion.twist = rate;
    sample.buttons = buttons;
    ends.samples.publish(sample);
  };
}

TEST(RateDevice, a_deflection_becomes_a_velocity_without_steps) {
  RateDevice device("pushed", {}, pushed({0.1 * Vec3::UnitX(), 0.5 * Vec3::UnitZ()}, 0));
  for (int i = 0; i < 100 && device.read(0.0).motion.twist.linear.norm() == 0.0; ++i)
    usleep(1000);  // its thread begins
  DeviceState last = device.read(0.0);
  double told = 0.0;
  for (int i = 1; i <= 1000; ++i) {
    const DeviceState state = device.read(1e-3 * i);
    EXPECT_LT((state.motion.twist.linear - last.motion.twist.linear).norm(), 0.1 * 0.06);
    told += 1e-3 * state.motion.twist.linear.x();
    last = state;
  }
  EXPECT_NEAR(last.motion.twist.linear.x(), 0.1, 1e-9);
  EXPECT_NEAR(last.motion.pose.position.x(), told, 1e-12);  // velocities add up to the way
  EXPECT_NEAR(last.motion.pose.position.x(), 0.1 * (1.0 - 0.02), 1e-4);
  EXPECT_EQ(last.buttons, kClutchButton);
  EXPECT_FALSE(device.limits().holds_person);
  EXPECT_FALSE(device.limits().actuates_translation);
}

TEST(RateDevice, its_first_button_lets_go_or_takes_hold) {
  for (const bool is_held : {true, false}) {
    RateParams params;
    params.is_held = is_held;
    RateDevice device("pressed", params, pushed({}, 1));
    for (int i = 0; i < 100; ++i) {
      if ((device.read(0.0).buttons & kClutchButton) == (is_held ? 0u : 1u)) break;
      usleep(1000);
    }
    EXPECT_EQ(device.read(0.0).buttons, is_held ? 0u : 1u);
  }
}

TEST(RateDevice, addresses_are_read_and_refused) {
  const auto refusal = [](const char* address) {
    try {
      open_device(address);
    } catch (const DeviceUnavailable& error) {
      return std::string("unavailable: ") + error.what();
    } catch (const DeviceAddressError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("spacenav:?spede=1"), "spacenav: no parameter 'spede', nearest is 'speed'");
  EXPECT_EQ(refusal("gamepad:?turn=0"), "gamepad: turn = '0', expected above 0, at most 10");
  EXPECT_EQ(refusal("gamepad:x"),
            "gamepad: 'x', expected gamepad:, gamepad:NUMBER or gamepad:/dev/input/eventN");
  EXPECT_NE(refusal("gamepad:99").find("Plug it in"), std::string::npos) << refusal("gamepad:99");
  EXPECT_NE(refusal("spacenav:/nowhere/spnav.sock").find("apt-get install spacenavd"),
            std::string::npos);
  EXPECT_NE(refusal("gamepad:/nowhere/event3").find("/nowhere/event3: No such file"),
            std::string::npos);
}

}  // namespace
}  // namespace thigma::detail
