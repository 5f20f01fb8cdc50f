// The driver of Haply's devices against the stand-in of their service, a process of its own.
#include "thigma/device/detail/haply_device.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "driver_session.h"
#include "standins/services.h"
#include <gtest/gtest.h>

#include "thigma/device/detail/haply_link.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using standin_test::Running;
using standin_test::wait_for;

class HaplyDevice : public testing::Test {
 protected:
  void start(std::vector<std::string> keys = {}) {
    service_ = std::make_unique<Running>(
        "standin_haply", "HAPLY", std::vector<std::string>{"--events-port", "0"}, std::move(keys));
  }
  std::string address(const std::string& more = "") const {
    return "haply:?port=" + std::to_string(service_->port()) + more;
  }
  std::unique_ptr<HapticDevice> open(const std::string& more = "") const {
    return open_device(address(more));
  }
  std::string refusal(const std::string& more = "") const {
    try {
      open(more);
    } catch (const DeviceUnavailable& error) {
      return error.what();
    }
    return "";
  }
  double sent() const {
    return std::hypot(service_->get("applied_fx"), service_->get("applied_fy"),
                      service_->get("applied_fz"));
  }
  Running& service() { return *service_; }

  std::unique_ptr<Running> service_;
};

/// Reads until `is_so`, at most for some seconds; the last state.
template <class Condition>
DeviceState read_until(HapticDevice& device, Condition is_so) {
  DeviceState state;
  static double now = 0.0;
  wait_for([&] { return is_so(state = device.read(now += 1e-3)); }, 5.0);
  return state;
}

TEST_F(HaplyDevice, sends_what_is_asked_for_in_si_in_both_forms) {
  std::printf("version   asked [N]                    received [N; right, away, up]     off\n");
  for (const char* minor : {"1", "5"}) {
    start({std::string("SDK_MINOR=") + minor});
    const auto device = open();
    const Vec3 asked(1.25, -0.5, 2.0 / 3.0);
    EXPECT_TRUE(wait_for([&] {
      device->write({asked, Vec3(0.1, 0.1, 0.1)});
      return service().get("applied_fx") != 0.0;
    }));
    const Vec3 got(service().get("applied_fx"), service().get("applied_fy"),
                   service().get("applied_fz"));
    const double off = (detail::ours_from_haply(got) - asked).norm();
    EXPECT_LT(off, 1e-6);
    EXPECT_EQ(service().get("wrong_form"), 0.0);
    EXPECT_EQ(service().get("torque_nonzero"), 0.0);
    EXPECT_EQ(service().get("bad_messages"), 0.0);
    std::printf("3.%s      %8.5f %8.5f %8.5f   %8.5f %8.5f %8.5f   %.1e\n", minor, asked.x(),
                asked.y(), asked.z(), got.x(), got.y(), got.z(), off);
    EXPECT_TRUE(wait_for([&] {  // cut by norm
      device->write({{0.0, 0.0, 100.0}, Vec3::Zero()});
      return std::abs(service().get("applied_fz") - 4.0) < 1e-9;
    }));
    EXPECT_TRUE(wait_for([&] {
      device->write({{0.0, std::nan(""), 0.0}, Vec3::Zero()});
      return sent() == 0.0;
    }));
  }
}

TEST_F(HaplyDevice, a_haptic_thread_that_hangs_leaves_no_force) {
  start();
  const auto device = open();
  EXPECT_TRUE(wait_for([&] {
    device->write({{0.0, 0.0, 2.0}, Vec3::Zero()});
    return sent() > 1.9;
  }));
  EXPECT_TRUE(wait_for([&] { return sent() == 0.0; }));  // nothing renews it
}

TEST_F(HaplyDevice, axes_are_those_of_the_engine_in_six_poses) {
  start();
  const auto device = open();
  service().set("hold", 1);
  const char* const places[3] = {"target_x", "target_y", "target_z"};
  const Vec3 ours[3] = {Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ()};  // right, away, up
  const double start_at[3] = {service().get(places[0]), service().get(places[1]),
                              service().get(places[2])};
  const auto settle = [&] {
    usleep(50'000);
    Vec3 place = Vec3::Zero();
    for (int i = 0; i < 100; ++i) {
      place = read_until(*device, [](const DeviceState&) { return true; }).motion.pose.position;
      usleep(500);
    }
    return place;
  };
  const Vec3 middle = settle();
  std::printf("pose of the vendor    moved [mm; ours]\n");
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (double way = 0.001; way < 0.0101; way += 0.001) {  // a jump is a fault
        service().set(places[axis], start_at[axis] + sign * way);
        usleep(3000);
      }
      const Vec3 moved = settle() - middle;
      EXPECT_LT((moved - sign * 0.01 * ours[axis]).norm(), 1e-5) << axis;
      std::printf("%s %c           %7.3f %7.3f %7.3f\n", places[axis], sign > 0.0 ? '+' : '-',
                  1e3 * moved.x(), 1e3 * moved.y(), 1e3 * moved.z());
      for (double way = 0.009; way > -0.0001; way -= 0.001) {
        service().set(places[axis], start_at[axis] + sign * way);
        usleep(3000);
      }
      settle();
    }
  }
  EXPECT_STREQ(device->trouble(), "");
}

TEST_F(HaplyDevice, a_grip_turns_the_object_and_takes_hold) {
  start();
  const auto device = open();
  EXPECT_TRUE(device->limits().senses_rotation);
  EXPECT_FALSE(device->limits().actuates_rotation);
  service().set("hold", 1);
  service().set("buttons", 1);
  EXPECT_EQ(read_until(*device, [](const DeviceState& s) { return s.buttons == 1; }).buttons, 1u);
  const char* const turns[3] = {"target_rx", "target_ry", "target_rz"};
  const Vec3 ours[3] = {Vec3::UnitY(), -Vec3::UnitX(), Vec3::UnitZ()};
  const Quat start_at =
      read_until(*device, [](const DeviceState&) { return true; }).motion.pose.orientation;
  for (int axis = 0; axis < 3; ++axis) {
    for (double angle = 0.02; angle < 0.3001; angle += 0.02) {
      service().set(turns[axis], angle);
      usleep(4000);
    }
    // Waited for, as what was set comes late on a busy machine; then it has to stay.
    Vec3 turned = Vec3::Zero();
    const auto turn_to = [&](const Vec3& wanted) {
      const auto is_there = [&](const DeviceState& s) {
        turned = vector_from_rotation(s.motion.pose.orientation * start_at.conjugate());
        return (turned - wanted).norm() < 2e-3;
      };
      read_until(*device, is_there);
      for (int i = 0; i < 400; ++i) {
        is_there(read_until(*device, [](const DeviceState&) { return true; }));
        usleep(500);
      }
    };
    turn_to(0.3 * ours[axis]);
    EXPECT_LT((turned - 0.3 * ours[axis]).norm(), 2e-3) << turned.transpose();
    for (double angle = 0.28; angle > -0.0001; angle -= 0.02) {
      service().set(turns[axis], angle);
      usleep(4000);
    }
    turn_to(Vec3::Zero());
  }
  EXPECT_STREQ(device->trouble(), "");
}

TEST_F(HaplyDevice, without_a_grip_the_hand_always_holds) {
  start();
  const auto device = open("&grip=none");
  EXPECT_FALSE(device->limits().senses_rotation);
  const DeviceState state =
      read_until(*device, [](const DeviceState& s) { return s.status == DeviceStatus::ok; });
  EXPECT_EQ(state.buttons, kClutchButton);
}

TEST_F(HaplyDevice, says_what_to_do_where_it_does_not_open) {
  struct Case {
    std::vector<std::string> keys;
    const char *more, *says;
  };
  const Case cases[] = {{{"CALIBRATED=0"}, "", "not calibrated. Put the grip onto its inkwell"},
                        {{"READY=0"}, "", "not ready. Switch it on"},
                        {{"COUNT=0"}, "", "has no device. Plug it in"},
                        {{"SDK_MINOR=0"}, "", "version 3.0, expected 3.1 to 3.x"},
                        {{"SDK_MAJOR=4"}, "", "version 4.5, expected 3.1 to 3.x"},
                        {{"NO_VERSION=1"}, "", "does not say its version"},
                        {{}, "&grip=none&rate=1000", ""},
                        {{}, "&grip=nobody", "no VerseGrip 'nobody'. Switch it on"}};
  for (const Case& c : cases) {
    start(c.keys);
    const std::string said = refusal(c.more);
    std::printf("%s\n", said.c_str());
    EXPECT_EQ(said.empty(), *c.says == '\0') << said;
    EXPECT_NE(said.find(c.says), std::string::npos) << said;
  }
  start({"COUNT=2", "SERIAL=7"});
  try {
    open_device("haply:0007?port=" + std::to_string(service_->port()));
    ADD_FAILURE();
  } catch (const DeviceUnavailable& error) {
    EXPECT_NE(std::string(error.what()).find("two devices '0007'. Unplug one"), std::string::npos)
        << error.what();
  }
  start();
  const std::string named = "haply:0000?port=" + std::to_string(service().port());
  try {
    open_device(named);
    ADD_FAILURE();
  } catch (const DeviceUnavailable& error) {
    EXPECT_NE(std::string(error.what()).find("no device '0000', the Inverse Service has '049D'"),
              std::string::npos)
        << error.what();
  }
}

struct FaultCase {
  const char* name;
  const char* key;
  double value;
  bool is_deaf;  // the service takes nothing any more: the device stops by itself
};

TEST_F(HaplyDevice, faults_in_contact_end_in_zero_force) {
  const FaultCase cases[] = {
      {"unplugged", "unplug", 1, false},  {"no calibration", "calibrated", 0, false},
      {"silent", "silent", 1, false},     {"not a number", "nan_pose", 1, false},
      {"null", "null_pose", 1, false},    {"jump", "jump_x", 0.03, false},
      {"no JSON", "garbage", 1, false},   {"no frame", "garbage", 2, false},
      {"half a frame", "half", 1, false}, {"half and closed", "half", 2, false},
      {"closed", "drop", 1, false},       {"service killed", "die", 1, true}};
  test::print_fault_heads();
  for (const FaultCase& c : cases) {
    double height = 0.0;
    const test::PressedSession s = test::press_and_fail(
        [&] {
          start();
          service().set("buttons", 1);
          height = service().get("target_z");
          return open();
        },
        [&](double depth) { service().set("target_z", height - depth); }, [&] { return sent(); },
        [&] {
          service().set(c.key, c.value);
          if (c.is_deaf) wait_for([&] { return service().has_ended(); });
        });
    test::expect_fault(c.name, s, *s.device, c.is_deaf ? "with it" : test::zero_text(s));
    EXPECT_STRNE(s.device->trouble(), "") << c.name;
    if (!c.is_deaf) {
      EXPECT_GE(s.zero_after, 0.0) << c.name;
      EXPECT_EQ(sent(), 0.0) << c.name;
    }
  }
}

TEST_F(HaplyDevice, a_killed_program_leaves_no_force) {
  start({"COMM_TIMEOUT_MS=0"});
  const std::string place = address();
  const pid_t child = standin_test::run_child([&place] {
    HapticDevice* device = open_device(place).release();
    for (;;) {
      device->write({{0.0, 0.0, 2.0}, Vec3::Zero()});
      usleep(1000);
    }
  });
  EXPECT_TRUE(wait_for([&] { return sent() > 1.9; }));
  const std::int64_t begin = detail::driver_time_ns();
  standin_test::kill_child(child);
  EXPECT_TRUE(wait_for([&] { return sent() == 0.0; }));
  std::printf("our process killed: zero after %.1f ms\n",
              1e-6 * static_cast<double>(detail::driver_time_ns() - begin));
}

TEST_F(HaplyDevice, a_late_service_is_told_of_and_goes_on) {
  start();
  const auto device = open();
  read_until(*device, [](const DeviceState& s) { return s.status == DeviceStatus::ok; });
  service().set("delay_ms", 60);
  EXPECT_TRUE(
      wait_for([&] { return std::string(device->trouble()).find("late") != std::string::npos; }));
  service().set("delay_ms", 0);
  EXPECT_TRUE(wait_for([&] {
    device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
    return service().get("applied_fz") == 1.0;
  }));
  EXPECT_EQ(device->read(1.0).status, DeviceStatus::ok);
  EXPECT_TRUE(wait_for([&] { return *device->trouble() == '\0'; }));  // it is over
}

TEST_F(HaplyDevice, what_is_amiss_is_told_until_it_is_mended) {
  start();
  const auto device = open();
  service().set("powered", 0);
  EXPECT_TRUE(wait_for(
      [&] { return std::string(device->trouble()).find("no power") != std::string::npos; }));
  service().set("powered", 1);
  EXPECT_TRUE(wait_for([&] { return *device->trouble() == '\0'; }));
  service().set("verse_grip", 0);
  EXPECT_TRUE(wait_for([&] {
    return std::string(device->trouble()).find("VerseGrip is gone") != std::string::npos;
  }));
  service().set("verse_grip", 2);
  EXPECT_TRUE(wait_for([&] { return *device->trouble() == '\0'; }));
  EXPECT_EQ(device->read(1.0).status, DeviceStatus::ok);
}

/// Of the loop that sends a force and waits for the state [s]; sorted.
std::vector<double> round_trips(const detail::HaplyAddress& address, int count) {
  detail::HaplyLink link(address);
  const std::string id = link.frame().arms.at(0).id;
  std::vector<double> trips;
  for (int i = 0; i < count; ++i) {
    const std::int64_t begin = detail::driver_time_ns();
    link.send(id, Vec3(0.0, 0.0, 1e-3 * (i % 100)));
    if (!link.wait(1.0)) break;
    trips.push_back(1e-9 * static_cast<double>(detail::driver_time_ns() - begin));
  }
  link.close();
  std::sort(trips.begin(), trips.end());
  return trips;
}

TEST_F(HaplyDevice, round_trips_of_both_forms_calibrated_and_not) {
  constexpr int kTrips = 4000;
  std::printf("form                calibrated   round trips   p50       p99       max\n");
  for (const char* minor : {"1", "5"}) {
    for (const char* calibrated : {"1", "0"}) {
      start({std::string("SDK_MINOR=") + minor, std::string("CALIBRATED=") + calibrated});
      detail::HaplyAddress address;
      address.port = static_cast<std::uint16_t>(service().port());
      const std::vector<double> trips = round_trips(address, kTrips);
      ASSERT_EQ(trips.size(), std::size_t{kTrips});
      EXPECT_EQ(service().get("wrong_form"), 0.0);
      EXPECT_EQ(service().get("bad_messages"), 0.0);
      std::printf("3.%s, %-12s  %-10s  %11zu   %6.3f ms %6.3f ms %6.3f ms\n", minor,
                  minor[0] == '1' ? "\"values\"" : "\"vector\"",
                  calibrated[0] == '1' ? "yes" : "no", trips.size(), 1e3 * trips[kTrips / 2],
                  1e3 * trips[kTrips * 99 / 100], 1e3 * trips.back());
    }
  }
}

TEST_F(HaplyDevice, one_answer_a_message_and_zero_at_the_end) {
  start();
  {
    const auto device = open();
    EXPECT_TRUE(wait_for([&] {
      device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
      return service().get("messages") > 500.0;
    }));
    const double messages = service().get("messages"),
                 begin = 1e-9 * static_cast<double>(detail::driver_time_ns());
    usleep(500'000);
    std::printf("%.0f round trips a second, at most 2000 asked for\n",
                (service().get("messages") - messages) /
                    (1e-9 * static_cast<double>(detail::driver_time_ns()) - begin));
  }
  EXPECT_EQ(sent(), 0.0);
  EXPECT_TRUE(service().reaches("clients", 0.0));
  EXPECT_EQ(service().get("bad_messages"), 0.0);
}

}  // namespace
}  // namespace thigma
