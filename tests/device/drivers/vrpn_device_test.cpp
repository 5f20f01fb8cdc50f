// The driver of VRPN servers against the stand-in of one, a process of its own.
#include "thigma/device/detail/vrpn_device.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include "driver_session.h"
#include "standins/services.h"
#include <gtest/gtest.h>

#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using standin_test::Running;
using standin_test::wait_for;

class VrpnDevice : public testing::Test {
 protected:
  void start(std::vector<std::string> keys = {}) {
    server_ = std::make_unique<Running>("standin_vrpn", "VRPN", std::vector<std::string>{},
                                        std::move(keys));
  }
  std::string address(const std::string& more = "", const char* name = "Haptic0") const {
    return std::string("vrpn:") + name + "@localhost:" + std::to_string(server_->port()) + more;
  }
  std::string refusal(const std::string& place) const {
    try {
      open_device(place);
    } catch (const DeviceUnavailable& error) {
      return error.what();
    } catch (const DeviceAddressError& error) {
      return std::string("address: ") + error.what();
    }
    return "";
  }
  Vec3 felt() const {
    return {server_->get("applied_fx"), server_->get("applied_fy"), server_->get("applied_fz")};
  }
  Running& server() { return *server_; }

  std::unique_ptr<Running> server_;
};

const Mat3& ours_from_theirs() {  // x right, y up, z to the person
  static const Mat3 axes = [] {
    Mat3 m;
    detail::parse_axes("zxy", m);
    return m;
  }();
  return axes;
}

TEST_F(VrpnDevice, the_field_is_the_force_in_si_where_the_handle_is) {
  start();
  server().set("hold", 1);
  const auto device = open_device(address("?max_force=4"));
  const Vec3 asked(1.25, -0.5, 2.0 / 3.0);
  double now = 0.0;
  EXPECT_TRUE(wait_for([&] {
    device->read(now += 1e-3);
    device->write({asked, Vec3(0.1, 0.0, 0.0)});
    return felt().norm() > 1.0;
  }));
  const double off = (ours_from_theirs() * felt() - asked).norm();
  std::printf("asked %.6f %.6f %.6f, off by %.1e N\n", asked.x(), asked.y(), asked.z(), off);
  EXPECT_LT(off, 1e-6);  // of 32-bit numbers
  EXPECT_NEAR(server().get("field_radius"), 0.02, 1e-8);
  const Vec3 at(server().get("field_ox"), server().get("field_oy"), server().get("field_oz"));
  const Vec3 handle = device->read(now).motion.pose.position;
  EXPECT_LT((ours_from_theirs() * at - handle).norm(), 1e-6);
  EXPECT_TRUE(wait_for([&] { return felt().norm() == 0.0; }));  // nothing renews it
}

TEST_F(VrpnDevice, axes_are_those_of_the_engine_in_six_poses) {
  start();
  server().set("hold", 1);
  const auto device = open_device(address("?force=0"));
  const char* const places[3] = {"target_x", "target_y", "target_z"};
  const char* const turns[3] = {"target_rx", "target_ry", "target_rz"};
  double now = 0.0;
  std::printf("pose of the server    position [mm]            rotation vector [rad]\n");
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (int i = 0; i < 3; ++i) {
        server().set(places[i], i == axis ? sign * 0.01 : 0.0);
        server().set(turns[i], i == axis ? sign * 0.3 : 0.0);
      }
      const Vec3 wanted = sign * ours_from_theirs().col(axis);
      Pose pose;
      wait_for(
          [&] {
            pose = device->read(now += 1e-3).motion.pose;
            return (pose.position - 0.01 * wanted).norm() < 1e-5 &&
                   (vector_from_rotation(pose.orientation) - 0.3 * wanted).norm() < 1e-3;
          },
          5.0);
      EXPECT_LT((pose.position - 0.01 * wanted).norm(), 1e-5) << axis;
      EXPECT_LT((vector_from_rotation(pose.orientation) - 0.3 * wanted).norm(), 1e-3) << axis;
      const Vec3 p = 1e3 * pose.position, r = vector_from_rotation(pose.orientation);
      std::printf("%s %c           %7.3f %7.3f %7.3f  %7.4f %7.4f %7.4f\n", places[axis],
                  sign > 0.0 ? '+' : '-', p.x(), p.y(), p.z(), r.x(), r.y(), r.z());
    }
  }
}

TEST_F(VrpnDevice, buttons_and_limits) {
  start();
  server().set("buttons", 5);
  const auto device = open_device(address());
  double now = 0.0;
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).buttons == 5u; }));
  server().set("buttons", 0);
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).buttons == 0u; }));
  EXPECT_TRUE(device->limits().holds_person);
  EXPECT_FALSE(device->limits().actuates_rotation);
  const auto tracker = open_device(address("?force=0&hold=1"));
  EXPECT_FALSE(tracker->limits().holds_person);
  EXPECT_TRUE(wait_for([&] { return tracker->read(now += 1e-3).buttons == kClutchButton; }));
}

TEST_F(VrpnDevice, a_slow_server_is_an_old_handle) {
  start();
  server().set("rate", 1000);
  const double fast = open_device(address())->limits().delay;
  server().set("rate", 100);
  const double slow = open_device(address())->limits().delay;
  std::printf("delay %.1f ms at 1000 Hz, %.1f ms at 100 Hz\n", 1e3 * fast, 1e3 * slow);
  EXPECT_GT(slow, 0.015);
  EXPECT_GT(slow, 1.5 * fast);
}

TEST_F(VrpnDevice, says_what_to_do_where_it_does_not_open) {
  start();
  EXPECT_NE(refusal(address("", "Phantom9")).find("the server has no 'Phantom9'. It has Haptic0"),
            std::string::npos)
      << refusal(address("", "Phantom9"));
  EXPECT_NE(refusal(address("?sensor=7")).find("tells no pose of sensor 7"), std::string::npos);
  start({"WRONG_COOKIE=1"});
  const std::string cookie = refusal(address());
  std::printf("%s\n", cookie.c_str());
  EXPECT_NE(cookie.find("vrpn_server of version 07"), std::string::npos) << cookie;
  start({"SDK_MAJOR=6"});
  EXPECT_NE(refusal(address()).find("expected 07"), std::string::npos) << refusal(address());
  EXPECT_NE(refusal("vrpn:Haptic0@localhost:1").find("Start vrpn_server there"), std::string::npos);
  EXPECT_NE(refusal("vrpn:Haptic0@two\nlines").find("'two?lines', expected the name or address of"),
            std::string::npos);
  EXPECT_NE(refusal("vrpn:Haptic0@no.such.host.invalid").find("no server answers"),
            std::string::npos);
  EXPECT_EQ(refusal("vrpn:Haptic0"),
            "address: vrpn: 'Haptic0', expected vrpn:NAME@HOST or vrpn:NAME@HOST:PORT");
  EXPECT_EQ(refusal("vrpn:H@h?axes=yxz"),
            "address: vrpn: axes = 'yxz' mirror, turn one of them round");
}

struct FaultCase {
  const char* name;
  const char* key;
  double value;
  bool is_deaf;
};

TEST_F(VrpnDevice, faults_in_contact_end_in_zero_force) {
  const FaultCase cases[] = {
      {"unplugged", "unplug", 1, false},          {"silent", "silent", 1, false},
      {"not a number", "nan_pose", 1, false},     {"jump", "jump_x", 0.03, false},
      {"no message", "garbage", 1, false},        {"half a message", "half", 1, false},
      {"a wrong length", "lie_length", 1, false}, {"closed", "drop", 1, false},
      {"server killed", "die", 1, true}};
  test::print_fault_heads();
  for (const FaultCase& c : cases) {
    const test::PressedSession s = test::press_and_fail(
        [&] {
          start();
          server().set("buttons", 1);
          return open_device(address("?max_force=6"));
        },
        [&](double depth) { server().set("target_y", -depth); },  // y is up there
        [&] { return felt().norm(); },
        [&] {
          server().set(c.key, c.value);
          if (c.is_deaf) wait_for([&] { return server().has_ended(); });
        });
    test::expect_fault(c.name, s, *s.device, c.is_deaf ? "with it" : test::zero_text(s));
    EXPECT_STRNE(s.device->trouble(), "") << c.name;
    if (!c.is_deaf) {
      EXPECT_GE(s.zero_after, 0.0) << c.name;
      EXPECT_EQ(felt().norm(), 0.0) << c.name;
    }
  }
}

TEST_F(VrpnDevice, a_complaint_of_the_server_is_a_loss_with_its_word) {
  start({"MAX_FORCE=1"});
  const auto device = open_device(address());
  double now = 0.0;
  EXPECT_TRUE(wait_for([&] {
    device->write({{0.0, 0.0, 3.0}, Vec3::Zero()});
    return device->read(now += 1e-3).status == DeviceStatus::lost;
  }));
  EXPECT_NE(std::string(device->trouble()).find("largest force is exceeded"), std::string::npos);
  EXPECT_TRUE(wait_for([&] { return felt().norm() == 0.0; }));
}

TEST_F(VrpnDevice, the_end_stops_the_field) {
  start();
  {
    const auto device = open_device(address());
    EXPECT_TRUE(wait_for([&] {
      device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
      return felt().norm() > 0.9;
    }));
  }
  EXPECT_TRUE(wait_for([&] { return felt().norm() == 0.0; }));
}

}  // namespace
}  // namespace thigma
