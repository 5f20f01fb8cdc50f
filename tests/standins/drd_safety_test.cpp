// Force Dimension's library, pretended: time, watchdog, brakes, faults, and calls in the wrong
// state.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

#include "client.h"

namespace standin_test {
namespace {

const Library& drd() {
  static const Library library("drd", "libdrd.so");
  return library;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class DrdSafety : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(drd().is_open()) << dlerror();
    drd().reset();
    drd().set("watchdog", 0);
    ASSERT_EQ(drd().call("drdOpen"), 0);
    ASSERT_EQ(drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault), 0);
  }
  void TearDown() override {
    drd().set("hang", 0);
    drd().set("unplug", 0);
    drd().call("drdClose", kDefault);
  }

  static int last_error() { return drd().call("dhdErrorGetLast"); }
  static int send(double fx) {
    return drd().call("dhdSetForceAndTorqueAndGripperForce", fx, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
                      kDefault);
  }
  static int read(double p[3]) {
    double frame[3][3];
    return drd().call("dhdGetPositionAndOrientationFrame", p, p + 1, p + 2, frame, kDefault);
  }
  static int cause() {
    int status[64] = {};
    drd().call("dhdGetStatus", status, kDefault);
    return status[14];
  }
};

TEST_F(DrdSafety, calls_block_on_the_loop_of_the_device) {
  drd().set("loop_us", 2000);
  drd().set("timeguard_us", 0);
  double p[3];
  const double start = seconds();
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(read(p), 0);
  }
  EXPECT_GT(seconds() - start, 0.016);  // ten loops of 2 ms, the first one cut
}

TEST_F(DrdSafety, timeguard_gives_the_last_pose_again) {
  drd().set("timeguard_us", 1e6);
  double p[3], again[3];
  EXPECT_EQ(read(p), 0);
  drd().set("jump_x", 0.1);
  EXPECT_EQ(read(again), 1);
  EXPECT_EQ(p[0], again[0]);
  EXPECT_EQ(drd().get("timeguards"), 1.0);
}

TEST_F(DrdSafety, velocity_needs_two_reads_within_its_window) {
  drd().set("timeguard_us", 0);
  double v[3];
  EXPECT_EQ(drd().call("dhdGetLinearVelocity", v, v + 1, v + 2, kDefault), -1);
  EXPECT_EQ(last_error(), 7);
  drd().call("dhdConfigLinearVelocity", 1000, 0, kDefault);
  drd().set("hold", 1);
  double p[3];
  EXPECT_GE(read(p), 0);
  drd().set("target_x", 0.05);
  usleep(20000);
  EXPECT_EQ(drd().call("dhdGetLinearVelocity", v, v + 1, v + 2, kDefault), 0);
  EXPECT_GT(v[0], 0.0);
  EXPECT_LT(v[0], 0.05 / 0.019);
}

TEST_F(DrdSafety, watchdog_cuts_force_when_nothing_comes) {
  EXPECT_EQ(send(2.0), 0);
  EXPECT_EQ(drd().get("applied_fx"), 2.0);
  drd().set("watchdog", 40);  // 5 ms
  EXPECT_TRUE(wait_for([] { return drd().get("mode") != 1.0; }));
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
  EXPECT_EQ(drd().get("mode"), 2.0);
  EXPECT_EQ(cause(), 3);
  EXPECT_GE(drd().get("force_off_time") - drd().get("last_set_time"), 0.005);
  EXPECT_EQ(drd().get("watchdog_trips"), 1.0);
  EXPECT_EQ(send(2.0), 0);  // does not come back by itself
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
}

TEST_F(DrdSafety, speed_brakes) {
  EXPECT_EQ(send(1.0), 0);
  drd().set("velocity_threshold", 0.01);
  drd().set("push_y", 20);
  EXPECT_TRUE(wait_for([] { return drd().get("mode") == 2.0; }));
  EXPECT_EQ(cause(), 2);
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
}

TEST_F(DrdSafety, the_button_and_the_dead_man_cut_force) {
  for (const int why : {1, 6}) {
    drd().set("cut", 0);
    drd().call("dhdEnableForce", static_cast<unsigned char>(1), kDefault);
    EXPECT_EQ(send(1.0), 0);
    drd().set("cut", why);
    EXPECT_TRUE(wait_for([] { return drd().get("applied_fx") == 0.0; }));
    EXPECT_EQ(cause(), why);
  }
}

TEST_F(DrdSafety, stop_and_brakes) {
  EXPECT_EQ(send(1.0), 0);
  EXPECT_EQ(drd().call("dhdStop", kDefault), 0);
  EXPECT_EQ(drd().get("mode"), 2.0);
  EXPECT_EQ(drd().get("applied_fx"), 0.0);
  EXPECT_EQ(cause(), 4);
  EXPECT_EQ(drd().call("dhdSetBrakes", 0, kDefault), 0);
  EXPECT_EQ(drd().get("mode"), 0.0);
  EXPECT_EQ(drd().call("dhdSetBrakes", 1, kDefault), 0);
  EXPECT_EQ(drd().get("mode"), 2.0);
}

TEST_F(DrdSafety, status_has_seventeen_numbers_or_as_many_as_an_old_library) {
  int status[64];
  std::fill(status, status + 64, -7);
  EXPECT_EQ(drd().call("dhdGetStatus", status, kDefault), 0);
  EXPECT_EQ(status[5], 1);
  EXPECT_NE(status[16], -7);
  EXPECT_EQ(status[17], -7);
  drd().set("status_count", 16);
  std::fill(status, status + 64, -7);
  EXPECT_EQ(drd().call("dhdGetStatus", status, kDefault), 0);
  EXPECT_EQ(status[16], -7);
}

TEST_F(DrdSafety, unplugged_in_the_middle) {
  EXPECT_EQ(send(1.0), 0);
  drd().set("unplug", 1);
  double p[3];
  EXPECT_EQ(read(p), -1);
  EXPECT_EQ(last_error(), 2);
  EXPECT_EQ(send(1.0), -1);
  EXPECT_TRUE(wait_for([] { return drd().get("applied_fx") == 0.0; }));
  EXPECT_EQ(drd().get("force_off_cause"), 5.0);
  EXPECT_EQ(drd().call("dhdGetDeviceCount"), 0);
  drd().set("unplug", 0);  // plugged in again it must be opened again
  EXPECT_EQ(send(1.0), -1);
}

TEST_F(DrdSafety, errors_of_reading_and_sending) {
  double p[3];
  drd().set("fail_read", 8);
  EXPECT_EQ(read(p), -1);
  EXPECT_EQ(last_error(), 8);
  drd().set("fail_read", 0);
  drd().set("fail_set", 6);
  EXPECT_EQ(send(1.0), -1);
  EXPECT_EQ(last_error(), 6);
}

TEST_F(DrdSafety, poses_that_are_no_poses) {
  drd().set("timeguard_us", 0);
  double p[3];
  drd().set("hold", 1);
  drd().set("jump_x", 0.2);
  EXPECT_GE(read(p), 0);
  EXPECT_NEAR(p[0], 0.2, 1e-9);
  drd().set("nan_pose", 1);
  EXPECT_GE(read(p), 0);
  EXPECT_TRUE(std::isnan(p[0]));
}

TEST_F(DrdSafety, a_call_that_hangs_comes_back_only_when_told) {
  drd().set("hang", 1);
  std::atomic<bool> back{false};
  std::thread caller([&] {
    send(1.0);
    back = true;
  });
  usleep(50000);
  EXPECT_FALSE(back);
  drd().set("hang", 0);
  caller.join();
  EXPECT_TRUE(back);
}

TEST_F(DrdSafety, calls_after_closing_are_counted) {
  EXPECT_EQ(drd().call("drdClose", kDefault), 0);
  EXPECT_EQ(send(1.0), -1);
  EXPECT_EQ(last_error(), 5);
  EXPECT_EQ(drd().get("after_close"), 1.0);
  EXPECT_EQ(drd().get("mode"), 0.0);
}

TEST_F(DrdSafety, expert_calls_need_expert_mode) {
  EXPECT_EQ(drd().call("dhdSetWatchdog", static_cast<unsigned char>(0), kDefault), -1);
  EXPECT_EQ(last_error(), 9);
  EXPECT_EQ(drd().call("dhdEnableExpertMode"), 0);
  EXPECT_EQ(drd().get("expert"), 1.0);
  EXPECT_EQ(drd().call("dhdSetWatchdog", static_cast<unsigned char>(80), kDefault), 0);
  EXPECT_EQ(drd().get("watchdog"), 80.0);
  EXPECT_EQ(drd().call("dhdDisableExpertMode"), 0);
  EXPECT_EQ(drd().get("expert_calls"), 2.0);
}

TEST_F(DrdSafety, the_record_names_calls_in_their_order) {
  send(1.5);
  drd().call("dhdStop", kDefault);
  drd().call("drdClose", kDefault);
  const std::string path = ::testing::TempDir() + "standin_drd_log.csv";
  ASSERT_EQ(drd().call("standin_log", path.c_str()), 0);
  std::ifstream file(path);
  std::string line, order;
  while (std::getline(file, line)) {
    for (const char* name :
         {",drdOpen,", ",dhdEnableForce,", ",dhdSetForceAndTorqueAndGripperForce,0,1.5,",
          ",dhdStop,", ",drdClose,"}) {
      if (line.find(name) != std::string::npos) {
        order += name;
      }
    }
  }
  EXPECT_EQ(
      order,
      ",drdOpen,,dhdEnableForce,,dhdSetForceAndTorqueAndGripperForce,0,1.5,,dhdStop,,drdClose,");
  std::remove(path.c_str());
}

}  // namespace
}  // namespace standin_test
