// Force Dimension's library, pretended: opening, initialising, poses, forces, limits, kinds of
// devices.
#include <cmath>
#include <cstring>

#include "client.h"

namespace standin_test {
namespace {

const Library& drd() {
  static const Library library("drd", "libdrd.so");
  return library;
}

class Drd : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(drd().is_open()) << dlerror();
    drd().reset();
    drd().set("watchdog", 0);  // tests of time are in drd_safety_test
  }
  void TearDown() override {
    drd().set("hang", 0);
    drd().set("unplug", 0);
    drd().call("drdClose", kDefault);
  }

  static int last_error() { return drd().call("dhdErrorGetLast"); }
  static int send(double fx, double fy, double fz, double tx = 0, double ty = 0, double tz = 0) {
    return drd().call("dhdSetForceAndTorqueAndGripperForce", fx, fy, fz, tx, ty, tz, 0.0, kDefault);
  }
  static int read(double p[3], double frame[3][3]) {
    return drd().call("dhdGetPositionAndOrientationFrame", p, p + 1, p + 2, frame, kDefault);
  }
};

TEST_F(Drd, version_and_count) {
  int v[4] = {};
  drd().call<void>("dhdGetSDKVersion", v, v + 1, v + 2, v + 3);
  EXPECT_EQ(v[0], 3);
  EXPECT_EQ(v[1], 17);
  EXPECT_EQ(drd().call("dhdGetDeviceCount"), 1);
  drd().set("count", 2);
  EXPECT_EQ(drd().call("dhdGetDeviceCount"), 2);
}

TEST_F(Drd, nothing_plugged_in) {
  drd().set("count", 0);
  EXPECT_EQ(drd().call("drdOpen"), -1);
  EXPECT_EQ(last_error(), 5);
  EXPECT_STREQ(drd().call<const char*>("dhdErrorGetLastStr"), "no device found");
}

TEST_F(Drd, every_error_of_opening_can_be_had) {
  for (int error = 1; error <= 22; ++error) {
    drd().set("fail_open", error);
    EXPECT_EQ(drd().call("drdOpen"), -1);
    EXPECT_EQ(last_error(), error);
    EXPECT_GT(std::strlen(drd().call<const char*>("dhdErrorGetLastStr")), 0u);
  }
}

TEST_F(Drd, opens_initialises_and_leaves_force_mode_on) {
  drd().set("initialized", 0);
  ASSERT_EQ(drd().call("drdOpen"), 0);
  EXPECT_FALSE(drd().call<bool>("drdIsInitialized", kDefault));
  EXPECT_EQ(drd().call("drdStart", kDefault), -1);
  EXPECT_EQ(last_error(), 12);
  EXPECT_EQ(drd().call("drdAutoInit", kDefault), 0);
  EXPECT_TRUE(drd().call<bool>("drdIsInitialized", kDefault));
  EXPECT_TRUE(drd().call<bool>("drdIsRunning", kDefault));
  // While the vendor regulates, forces of the application do nothing.
  EXPECT_EQ(send(1, 0, 0), 0);
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
  EXPECT_EQ(drd().get("set_while_regulated"), 1.0);
  EXPECT_EQ(drd().call("drdStop", true, kDefault), 0);
  EXPECT_EQ(drd().get("mode"), 1.0);
  EXPECT_EQ(send(1, 0, 0), 0);
  EXPECT_EQ(drd().get("applied_fx"), 1.0);
}

TEST_F(Drd, stopping_regulation_without_forces_brakes) {
  ASSERT_EQ(drd().call("drdOpen"), 0);
  ASSERT_EQ(drd().call("drdAutoInit", kDefault), 0);
  EXPECT_EQ(drd().call("drdStop", false, kDefault), 0);
  EXPECT_EQ(drd().get("mode"), 2.0);
}

TEST_F(Drd, initialising_can_fail) {
  ASSERT_EQ(drd().call("drdOpen"), 0);
  drd().set("fail_init", 7);
  EXPECT_EQ(drd().call("drdAutoInit", kDefault), -1);
  EXPECT_EQ(last_error(), 7);
}

TEST_F(Drd, pose_is_metres_and_rows_of_a_frame) {
  drd().set("hold", 1);
  drd().set("target_x", 0.01);
  drd().set("target_z", -0.03);
  drd().set("target_rz", 0.5);
  ASSERT_EQ(drd().call("drdOpen"), 0);
  double p[3], frame[3][3];
  ASSERT_GE(read(p, frame), 0);
  EXPECT_NEAR(p[0], 0.01, 1e-12);
  EXPECT_NEAR(p[1], 0.0, 1e-12);
  EXPECT_NEAR(p[2], -0.03, 1e-12);
  EXPECT_NEAR(frame[0][0], std::cos(0.5), 1e-12);
  EXPECT_NEAR(frame[0][1], -std::sin(0.5), 1e-12);
  EXPECT_NEAR(frame[1][0], std::sin(0.5), 1e-12);
  EXPECT_NEAR(frame[2][2], 1.0, 1e-12);
}

TEST_F(Drd, force_moves_the_handle_and_arrives_as_sent) {
  ASSERT_EQ(drd().call("drdOpen"), 0);
  ASSERT_EQ(drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault), 0);
  EXPECT_TRUE(wait_for([] { return send(2.0, 0, 0) == 0 && drd().get("px") > 0.009; }));
  EXPECT_EQ(drd().get("last_fx"), 2.0);
  EXPECT_EQ(drd().get("applied_fx"), 2.0);
  EXPECT_NEAR(drd().get("py"), 0.0, 1e-9);
}

TEST_F(Drd, forces_before_force_mode_do_nothing) {
  ASSERT_EQ(drd().call("drdOpen"), 0);
  EXPECT_EQ(send(1, 0, 0), 0);
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
  EXPECT_EQ(drd().get("set_while_off"), 1.0);
  EXPECT_EQ(drd().get("sets"), 1.0);
}

TEST_F(Drd, limits_and_saturation) {
  ASSERT_EQ(drd().call("drdOpen"), 0);
  drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault);
  EXPECT_EQ(send(30, 40, 0), 2);  // above 12 N: success, and the direction stays
  EXPECT_NEAR(drd().get("applied_fx"), 12.0 * 0.6, 1e-9);
  EXPECT_NEAR(drd().get("applied_fy"), 12.0 * 0.8, 1e-9);
  EXPECT_EQ(drd().get("last_fx"), 30.0);
  EXPECT_EQ(drd().call("dhdSetMaxForce", 1.0, kDefault), 0);
  EXPECT_EQ(drd().call("dhdSetMaxTorque", 0.05, kDefault), 0);
  EXPECT_EQ(send(3, 4, 0, 0, 0, 0.1), 0);
  EXPECT_NEAR(drd().get("applied_fx"), 0.6, 1e-9);
  EXPECT_NEAR(drd().get("applied_tz"), 0.05, 1e-9);
  EXPECT_NEAR(drd().get("torque_max"), 0.1, 1e-12);
}

TEST_F(Drd, not_a_number_is_counted_and_not_applied) {
  ASSERT_EQ(drd().call("drdOpen"), 0);
  drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault);
  EXPECT_EQ(send(std::nan(""), 0, 0), -1);
  EXPECT_EQ(last_error(), 21);
  EXPECT_EQ(drd().get("non_finite"), 1.0);
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
}

TEST_F(Drd, gravity_is_held_only_by_calls) {
  drd().set("weight", 1.0);
  ASSERT_EQ(drd().call("drdOpen"), 0);
  drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault);
  EXPECT_EQ(send(0, 0, 0), 0);
  EXPECT_EQ(drd().get("applied_fz"), 1.0);
  EXPECT_EQ(drd().get("last_fz"), 0.0);
  EXPECT_EQ(drd().call("dhdSetGravityCompensation", 0, kDefault), 0);
  EXPECT_EQ(send(0, 0, 0), 0);
  EXPECT_EQ(drd().get("applied_fz"), 0.0);
}

TEST_F(Drd, kinds_of_devices) {
  struct Kind {
    int type;
    const char* name;
    bool wrist, active, left;
  };
  for (const Kind& kind : {Kind{104, "sigma.7", true, true, false},
                           {34, "omega.6", true, false, false},
                           {36, "omega.6", true, false, true},
                           {108, "lambda.7", true, true, false},
                           {63, "delta.3", false, false, false},
                           {60, "Falcon", false, false, false}}) {
    drd().reset();
    drd().set("watchdog", 0);
    drd().set("type", kind.type);
    drd().set("hold", 1);
    drd().set("target_rx", 0.3);
    ASSERT_EQ(drd().call("drdOpen"), 0);
    EXPECT_EQ(drd().call("dhdGetSystemType", kDefault), kind.type);
    EXPECT_STREQ(drd().call<const char*>("dhdGetSystemName", kDefault), kind.name);
    EXPECT_EQ(drd().call<bool>("dhdHasWrist", kDefault), kind.wrist);
    EXPECT_EQ(drd().call<bool>("dhdHasActiveWrist", kDefault), kind.active);
    EXPECT_EQ(drd().call<bool>("dhdIsLeftHanded", kDefault), kind.left);
    double p[3], frame[3][3];
    EXPECT_GE(read(p, frame), 0);
    EXPECT_NEAR(frame[1][1], kind.wrist ? std::cos(0.3) : 1.0, 1e-12);
    drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault);
    EXPECT_EQ(send(0, 0, 0, 0, 0, 0.01), 0);
    EXPECT_EQ(drd().get("applied_tz"), kind.active ? 0.01 : 0.0);
    EXPECT_EQ(drd().get("torque_ignored"), kind.active ? 0.0 : 1.0);
    EXPECT_EQ(drd().call("drdClose", kDefault), 0);
  }
}

TEST_F(Drd, two_devices_have_keys_and_records_of_their_own) {
  drd().set("count", 2);
  drd().set("1.buttons", 5);
  ASSERT_EQ(drd().call("drdOpenID", static_cast<signed char>(0)), 0);
  ASSERT_EQ(drd().call("drdOpenID", static_cast<signed char>(1)), 1);
  EXPECT_EQ(drd().call<unsigned>("dhdGetButtonMask", static_cast<signed char>(1)), 5u);
  EXPECT_EQ(drd().call<unsigned>("dhdGetButtonMask", static_cast<signed char>(0)), 0u);
  EXPECT_EQ(drd().call("dhdSetForce", 1.0, 0.0, 0.0, static_cast<signed char>(1)), 0);
  EXPECT_EQ(drd().get("1.last_fx"), 1.0);
  EXPECT_EQ(drd().get("0.sets"), 0.0);
  EXPECT_EQ(drd().call("drdClose", static_cast<signed char>(1)), 0);
  EXPECT_EQ(drd().call("drdClose", static_cast<signed char>(0)), 0);
}

TEST_F(Drd, missing_symbol_variant_lacks_one) {
  const Library missing("drd_missing", "libdrd.so");
  ASSERT_TRUE(missing.is_open());
  EXPECT_FALSE(missing.has("dhdSetForceAndTorqueAndGripperForce"));
  EXPECT_TRUE(missing.has("dhdSetForce"));
}

}  // namespace
}  // namespace standin_test
