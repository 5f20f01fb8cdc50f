// The driver of Force Dimension's devices against the stand-in of their library.
#include "thigma/device/detail/dhd_device.h"

#include <cmath>
#include <cstdio>

#include "driver_session.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using standin_test::Library;

const Library& drd() {
  static const Library library("drd", "libdrd.so.3");
  return library;
}

double sent_force() {
  return std::hypot(drd().get("last_fx"), drd().get("last_fy"), drd().get("last_fz"));
}

class DhdDevice : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(drd().is_open()) << dlerror();
    drd().reset();
    drd().set("velocity_threshold", 0);
    drd().set("watchdog", 0);  // a loaded machine is late
  }
  static std::string refusal(const std::string& address) {
    try {
      open_device(address);
    } catch (const DeviceUnavailable& error) {
      return error.what();
    } catch (const DeviceAddressError& error) {
      return std::string("address: ") + error.what();
    }
    return "";
  }
};

TEST_F(DhdDevice, tells_what_the_type_can_do) {
  const auto sigma = open_device("dhd:0");
  EXPECT_TRUE(sigma->limits().actuates_rotation);
  EXPECT_TRUE(sigma->limits().senses_rotation);
  EXPECT_TRUE(sigma->limits().holds_person);
  EXPECT_EQ(sigma->limits().clock, DeviceClock::engine);
  EXPECT_EQ(sigma->limits().max_force, 12.0);
}

TEST_F(DhdDevice, sends_what_is_asked_for_in_si) {
  const auto device = open_device("dhd:");
  const Wrench asked{{1.25, -0.5, 2.0}, {0.05, -0.02, 0.1}};
  device->write(asked);
  const Vec3 force(drd().get("last_fx"), drd().get("last_fy"), drd().get("last_fz"));
  const Vec3 torque(drd().get("last_tx"), drd().get("last_ty"), drd().get("last_tz"));
  EXPECT_LT((force - asked.force).norm(), 1e-6);
  EXPECT_LT((torque - asked.torque).norm(), 1e-6);
  device->write({{0.0, 0.0, 100.0}, {0.0, 3.0, 0.0}});  // cut by norm
  EXPECT_NEAR(drd().get("last_fz"), 12.0, 1e-9);
  EXPECT_NEAR(drd().get("last_ty"), 0.2, 1e-9);
  device->write({{0.0, 0.0, std::nan("")}, Vec3::Zero()});
  EXPECT_EQ(sent_force(), 0.0);
}

TEST_F(DhdDevice, axes_are_those_of_the_engine_in_six_poses) {
  const auto device = open_device("dhd:");
  drd().set("hold", 1);
  const char* const places[3] = {"target_x", "target_y", "target_z"};
  const char* const turns[3] = {"target_rx", "target_ry", "target_rz"};
  std::printf("pose of the vendor    position [mm]            rotation vector [rad]\n");
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (int i = 0; i < 3; ++i) {
        drd().set(places[i], i == axis ? sign * 0.01 : 0.0);
        drd().set(turns[i], i == axis ? sign * 0.3 : 0.0);
      }
      usleep(20'000);
      const Pose pose = device->read(0.0).motion.pose;
      Vec3 wanted = Vec3::Zero();
      wanted[axis] = sign;
      EXPECT_LT((pose.position - 0.01 * wanted).norm(), 1e-6) << axis;
      EXPECT_LT((vector_from_rotation(pose.orientation) - 0.3 * wanted).norm(), 1e-3) << axis;
      EXPECT_NEAR(pose.orientation.norm(), 1.0, 1e-12);
      const Vec3 p = 1e3 * pose.position, r = vector_from_rotation(pose.orientation);
      std::printf("%s %c             %7.3f %7.3f %7.3f  %7.4f %7.4f %7.4f\n", places[axis],
                  sign > 0.0 ? '+' : '-', p.x(), p.y(), p.z(), r.x(), r.y(), r.z());
    }
  }
}

TEST_F(DhdDevice, gives_buttons_and_the_vendors_velocity) {
  const auto device = open_device("dhd:");
  drd().set("buttons", 5);
  usleep(20'000);
  EXPECT_EQ(device->read(0.0).buttons, 5u);
}

TEST_F(DhdDevice, three_axes_without_rotation) {
  drd().set("type", 33);
  const auto omega = open_device("dhd:");
  EXPECT_FALSE(omega->limits().senses_rotation);
  EXPECT_FALSE(omega->limits().actuates_rotation);
  omega->write({{0.0, 0.0, 1.0}, {0.0, 0.1, 0.0}});
  EXPECT_EQ(drd().get("last_ty"), 0.0);
  EXPECT_NEAR(drd().get("last_fz"), 1.0, 1e-9);
  EXPECT_EQ(omega->read(0.0).motion.pose.orientation.coeffs(), Quat::Identity().coeffs());
}

TEST_F(DhdDevice, its_watchdog_that_cuts_the_forces_is_a_loss_with_a_reason) {
  const auto device = open_device("dhd:");
  drd().set("watchdog", 255);
  device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
  usleep(200'000);
  for (int i = 0; i < 40; ++i) device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
  EXPECT_EQ(device->read(0.3).status, DeviceStatus::lost);
  EXPECT_NE(std::string(device->trouble()).find("watchdog"), std::string::npos);
  EXPECT_EQ(sent_force(), 0.0);
}

TEST_F(DhdDevice, forces_that_a_button_brings_back_grow) {
  const auto device = open_device("dhd:");
  double now = 0.0;
  const auto frames = [&](int count) {
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(device->read(now += 1e-3).status, DeviceStatus::ok);
      device->write({{0.0, 0.0, 4.0}, Vec3::Zero()});
    }
  };
  frames(40);
  EXPECT_NEAR(sent_force(), 4.0, 1e-9);
  drd().set("cut", 1);
  usleep(50'000);
  frames(40);
  EXPECT_EQ(sent_force(), 0.0);
  EXPECT_NE(std::string(device->trouble()).find("button"), std::string::npos);
  drd().set("cut", 0);
  usleep(50'000);
  EXPECT_EQ(drd().call<int>("dhdEnableForce", static_cast<unsigned char>(1), '\0'), 0);
  frames(120);
  EXPECT_STREQ(device->trouble(), "");  // it is over
  EXPECT_GT(sent_force(), 0.3);
  EXPECT_LT(sent_force(), 1.2);
  frames(500);
  EXPECT_NEAR(sent_force(), 4.0, 1e-9);
}

TEST_F(DhdDevice, timeguard_and_saturation_are_successes) {
  const auto device = open_device("dhd:");
  drd().set("saturate", 1);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(device->read(0.001 * i).status, DeviceStatus::ok);
    device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
  }
  EXPECT_STREQ(device->trouble(), "");
}

TEST_F(DhdDevice, says_what_to_do_where_it_does_not_open) {
  drd().set("count", 0);
  EXPECT_NE(refusal("dhd:").find("no device is plugged in. Plug it in"), std::string::npos);
  drd().reset();
  drd().set("fail_open", 20);
  EXPECT_NE(refusal("dhd:").find("does not open"), std::string::npos) << refusal("dhd:");
  drd().reset();
  drd().set("initialized", 0);
  EXPECT_NE(refusal("dhd:").find("devices calibrate dhd:"), std::string::npos);
  drd().reset();
  EXPECT_NE(refusal("dhd:77777").find("serial number 77777"), std::string::npos);
  EXPECT_EQ(refusal("dhd:x"), "address: dhd: 'x', expected dhd:, dhd:NUMBER or dhd:SERIAL");
  EXPECT_EQ(refusal("dhd:1001"), "");  // its serial number
}

TEST_F(DhdDevice, calibrates_after_a_word_of_the_person) {
  drd().set("initialized", 0);
  int questions = 0;
  const auto talk = [&](bool answer) {
    return CalibrationTalk{[](const std::string&) {},
                           [&questions, answer](const std::string&) {
                             ++questions;
                             return answer;
                           }};
  };
  calibrate_device("dhd:", talk(false));
  EXPECT_EQ(drd().get("initialized"), 0.0);
  calibrate_device("dhd:", talk(true));
  EXPECT_EQ(drd().get("initialized"), 1.0);
  EXPECT_EQ(questions, 2);
}

TEST_F(DhdDevice, what_moves_by_itself_stops_when_told_to) {
  drd().set("initialized", 0);
  drd().set("init_ms", 400);
  std::string said;
  int looks = 0;
  calibrate_device("dhd:",
                   {[&said](const std::string& text) { said = text; },
                    [](const std::string&) { return true; }, [&looks] { return ++looks > 2; }});
  EXPECT_NE(said.find("stopped"), std::string::npos) << said;
  EXPECT_GT(looks, 2);
  EXPECT_NE(drd().get("mode"), 1.0);
  EXPECT_EQ(drd().get("opened"), 0.0);
  EXPECT_EQ(drd().get("after_close"), 0.0);
}

TEST_F(DhdDevice, factory_safety_is_kept_and_the_end_is_in_order) {
  {
    const auto device = open_device("dhd:");
    for (int i = 0; i < 50; ++i) device->write({{0.0, 0.0, 1.0}, Vec3::Zero()});
    EXPECT_EQ(drd().get("mode"), 1.0);
  }
  EXPECT_EQ(drd().get("expert"), 0.0);
  EXPECT_EQ(drd().get("expert_calls"), 0.0);
  EXPECT_EQ(drd().get("watchdog"), 0.0);  // as it was found
  EXPECT_EQ(sent_force(), 0.0);
  EXPECT_NE(drd().get("mode"), 1.0);
  EXPECT_EQ(drd().get("opened"), 0.0);
  EXPECT_EQ(drd().get("after_close"), 0.0);
}

struct FaultCase {
  const char* name;
  const char* key;
  double value;
};

TEST_F(DhdDevice, faults_in_contact_end_in_zero_force) {
  const FaultCase cases[] = {{"unplugged", "unplug", 1},
                             {"error returned", "fail_read", 2},
                             {"error of a force", "fail_set", 2},
                             {"NaN", "nan_pose", 1},
                             {"NaN of a velocity", "nan_velocity", 1},
                             {"jump", "jump_x", 0.06},
                             {"dead man's switch", "cut", 6}};
  test::print_fault_heads();
  for (const FaultCase& c : cases) {
    const auto open = [] {
      drd().reset();
      drd().set("velocity_threshold", 0);
      drd().set("watchdog", 0);  // a loaded machine is late
      drd().set("buttons", 1);
      return open_device("dhd:");
    };
    const test::PressedSession s = test::press_and_fail(
        open, [](double depth) { drd().set("target_z", -depth); }, sent_force,
        [&c] { drd().set(c.key, c.value); });
    test::expect_fault(c.name, s, *s.device, test::zero_text(s));
    const bool is_deaf = std::string(c.key) == "unplug" || std::string(c.key) == "fail_set";
    if (!is_deaf) {
      EXPECT_GE(s.zero_after, 0.0) << c.name;
      EXPECT_EQ(sent_force(), 0.0) << c.name;
    }
  }
}

}  // namespace
}  // namespace thigma
