// OpenHaptics' library, pretended: forces, torques, checks of the library, faults.
#include <atomic>
#include <cmath>

#include "hd_client.h"

namespace standin_test {
namespace {

class HdSafety : public HdTest {
 protected:
  static void set_torque(unsigned name, double x) {
    const double torque[3] = {x, 0, 0};
    begin();
    hd().call<void>("hdSetDoublev", name, static_cast<const double*>(torque));
    end();
  }
};

TEST_F(HdSafety, force_arrives_in_newtons_and_moves_the_handle) {
  open_with_force();
  hd().set("impulse_limit", 100);
  EXPECT_TRUE(wait_for([] {
    set_force(0, 1.0, 0);
    return hd().get("py") > 0.0045;
  }));
  EXPECT_EQ(hd().get("applied_fy"), 1.0);
  EXPECT_EQ(hd().get("last_fy"), 1.0);
  EXPECT_EQ(error(), 0u);
}

TEST_F(HdSafety, no_force_before_output_and_scheduler_are_on) {
  open();
  set_force(0.5, 0, 0);
  EXPECT_EQ(hd().get("applied_fx"), 0.0);
  EXPECT_EQ(hd().get("set_while_off"), 0.0 + 1.0);
  hd().call<void>("hdEnable", 0x4000u);
  EXPECT_EQ(hd().get("mode"), 0.0);
  hd().call<void>("hdStartScheduler");
  EXPECT_EQ(hd().get("mode"), 1.0);
  hd().call<void>("hdDisable", 0x4000u);
  EXPECT_EQ(hd().get("mode"), 0.0);
}

TEST_F(HdSafety, too_much_force_is_an_error_or_clamped) {
  open_with_force();
  hd().set("impulse_limit", 100);
  set_force(5.0, 0, 0);
  EXPECT_EQ(error(), 0x0201u);
  EXPECT_EQ(hd().get("applied_fx"), 0.0);
  hd().call<void>("hdEnable", 0x4001u);
  set_force(5.0, 0, 0);
  EXPECT_EQ(error(), 0u);
  EXPECT_NEAR(hd().get("applied_fx"), 3.3, 1e-9);
  EXPECT_EQ(hd().get("last_fx"), 5.0);
  EXPECT_EQ(hd().get("force_max"), 5.0);
}

TEST_F(HdSafety, a_kick_is_an_error) {
  open_with_force();
  hd().set("impulse_limit", 1e-6);
  set_force(3.0, 0, 0);
  EXPECT_EQ(error(), 0x0202u);
  EXPECT_EQ(hd().get("applied_fx"), 0.0);
  set_force(0, 0, 0);  // letting go never is one
  EXPECT_EQ(error(), 0u);
}

TEST_F(HdSafety, speed_is_an_error) {
  open_with_force();
  hd().set("velocity_limit", 0.001);
  hd().set("push_x", 10);
  usleep(20000);
  EXPECT_TRUE(wait_for([] {
    set_force(0.01, 0, 0);
    return error() == 0x0203u;
  }));
  EXPECT_EQ(hd().get("applied_fx"), 0.0);
}

TEST_F(HdSafety, warm_motors) {
  open_with_force();
  hd().set("motor_temperature", 1.0);
  set_force(0.1, 0, 0);
  EXPECT_EQ(error(), 0x0200u);
  double heat[6] = {};
  hd().call<void>("hdGetDoublev", 0x2605u, heat);
  EXPECT_EQ(heat[0], 1.0);
}

TEST_F(HdSafety, forces_grow_on_a_ramp_after_the_start) {
  open();
  hd().call<void>("hdEnable", 0x4000u);
  hd().set("ramp_rate", 0.001);
  hd().call<void>("hdStartScheduler");
  set_force(0.5, 0, 0);
  EXPECT_LT(hd().get("applied_fx"), 0.1);
  EXPECT_EQ(hd().get("last_fx"), 0.5);
}

TEST_F(HdSafety, torque_is_recorded_as_the_number_that_came) {
  hd().set("model", 2);  // Premium 1.5 with six actuated degrees of freedom
  open_with_force();
  set_torque(0x2701u, 100.0);
  EXPECT_EQ(hd().get("torque_pname"), 0x2701);
  set_torque(0x2704u, 100.0);
  EXPECT_EQ(hd().get("torque_pname"), 0x2704);
  EXPECT_EQ(hd().get("last_tx"), 100.0);
  EXPECT_EQ(hd().get("torque_max"), 100.0);
  EXPECT_NEAR(hd().get("applied_tx"), 0.1, 1e-12);  // mN m, by default
  hd().set("torque_unit", 1.0);
  set_torque(0x2704u, 0.1);
  EXPECT_NEAR(hd().get("applied_tx"), 0.1, 1e-12);
  EXPECT_EQ(hd().get("torque_sets"), 3.0);
}

TEST_F(HdSafety, a_touch_has_no_torque) {
  open_with_force();
  set_torque(0x2704u, 1.0);
  EXPECT_EQ(hd().get("torque_ignored"), 1.0);
  EXPECT_EQ(hd().get("torque_nonzero"), 1.0);
  EXPECT_EQ(hd().get("applied_tx"), 0.0);
}

TEST_F(HdSafety, not_a_number_is_counted_and_not_applied) {
  open_with_force();
  set_force(std::nan(""), 0, 0);
  EXPECT_EQ(error(), 0x0204u);
  EXPECT_EQ(hd().get("non_finite"), 1.0);
  EXPECT_EQ(hd().get("applied_fx"), 0.0);
}

TEST_F(HdSafety, unplugged_in_the_middle) {
  open_with_force();
  hd().set("impulse_limit", 100);
  set_force(1.0, 0, 0);
  EXPECT_EQ(hd().get("applied_fx"), 1.0);
  hd().set("unplug", 1);
  set_force(1.0, 0, 0);
  EXPECT_EQ(error(), 0x0302u);
  EXPECT_TRUE(wait_for([] { return hd().get("applied_fx") == 0.0; }));
  hd().call<unsigned>("hdCheckCalibration");
  EXPECT_EQ(error(), 0x0300u);
}

TEST_F(HdSafety, silent_scheduler_calls_nobody_and_force_stays) {
  open_with_force();
  hd().set("impulse_limit", 100);
  static std::atomic<int> calls;
  const auto count = +[](void*) -> unsigned {
    ++calls;
    return 1;
  };
  hd().call<unsigned long>("hdScheduleAsynchronous", count, nobody(), kHighest);
  EXPECT_TRUE(wait_for([] { return calls > 3; }));
  set_force(1.0, 0, 0);
  hd().set("silent", 1);
  usleep(20000);
  const int before = calls;
  usleep(50000);
  EXPECT_EQ(calls, before);
  EXPECT_EQ(hd().get("applied_fx"), 1.0);  // nothing documented would take it away
  hd().call<void>("hdStopScheduler");
  EXPECT_EQ(hd().get("applied_fx"), 0.0);
  hd().set("silent", 0);
}

TEST_F(HdSafety, poses_that_are_no_poses) {
  hd().set("hold", 1);
  open();
  hd().set("jump_x", 0.1);
  double p[3];
  begin();
  hd().call<void>("hdGetDoublev", 0x2050u, p);
  end();
  EXPECT_NEAR(p[0], 100.0, 1e-9);
  hd().set("nan_pose", 1);
  begin();
  hd().call<void>("hdGetDoublev", 0x2050u, p);
  end();
  EXPECT_TRUE(std::isnan(p[0]));
}

TEST_F(HdSafety, calls_after_disabling_are_counted) {
  open();
  hd().call<void>("hdDisableDevice", 0u);
  begin();
  EXPECT_EQ(error(), 0x0104u);
  EXPECT_EQ(hd().get("after_close"), 1.0);
  open();
}

}  // namespace
}  // namespace standin_test
