// The driver of Touch and Phantom against the stand-in of OpenHaptics' library.
#include "thigma/device/detail/openhaptics_device.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "driver_session.h"
#include <gtest/gtest.h>

#include "thigma/device/detail/device_profile.h"
#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using standin_test::Library;

const Library& hd() {
  static const Library library("hd", "libHD.so");
  return library;
}

double sent_force() {
  return std::hypot(hd().get("last_fx"), hd().get("last_fy"), hd().get("last_fz"));
}

/// At the motors: what was sent, or nothing while they are switched off [N].
double motor_force() { return hd().get("force_output") == 0.0 ? 0.0 : sent_force(); }

/// Ticks that write one wrench and keep what they read.
struct Ticker {
  HapticDevice* device = nullptr;
  Wrench wrench{};
  DeviceState state{};
  std::atomic<int> ticks{0};
  static void tick(void* context) noexcept {
    Ticker& t = *static_cast<Ticker*>(context);
    t.state = t.device->read(1e-3 * t.ticks);
    t.device->write(t.wrench);
    ++t.ticks;
  }
  void run(int most = 60) {
    const int from = ticks;
    device->start_ticks(1000.0, {tick, this});
    for (int i = 0; i < 3000 && ticks < from + most; ++i) usleep(1000);
  }
};

/// As the stand-in's device tells it.
std::string serial() { return std::to_string(static_cast<int>(hd().get("serial"))); }

class OpenHapticsDevice : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(hd().is_open()) << dlerror();
    hd().reset();
    folder_ = testing::TempDir() + "thigma_openhaptics_config";
    std::filesystem::remove_all(folder_);
    setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  static std::string refusal(const std::string& address) {
    try {
      open_device(address);
    } catch (const DeviceUnavailable& error) {
      return error.what();
    }
    return "";
  }
  /// A person who holds the button until the torque is `felt` [N m], and answers as it was.
  static void calibrate(double felt) {
    std::atomic<bool> is_over{false}, has_felt{false};
    hd().set("buttons", 1);
    std::thread finger([&] {
      while (!is_over) {
        const double torque =
            std::hypot(hd().get("applied_tx"), hd().get("applied_ty"), hd().get("applied_tz"));
        if (torque > felt) {
          has_felt = true;
          hd().set("buttons", 0);
        }
        usleep(1000);
      }
    });
    calibrate_device("openhaptics:", {[](const std::string&) {},
                                      [&has_felt](const std::string& question) {
                                        return question.find("at all?") == std::string::npos ||
                                               !has_felt;
                                      }});
    is_over = true;
    finger.join();
    hd().set("buttons", 0);
  }
  std::string folder_;
};

TEST_F(OpenHapticsDevice, axes_are_turned_into_the_engines_in_six_poses) {
  const auto device = open_device("openhaptics:Default Device");
  EXPECT_EQ(device->limits().clock, DeviceClock::device);
  EXPECT_TRUE(device->limits().holds_person);
  Ticker ticker{device.get()};
  hd().set("hold", 1);
  ticker.run();
  const char* const places[3] = {"target_x", "target_y", "target_z"};
  const char* const turns[3] = {"target_rx", "target_ry", "target_rz"};
  const int ours[3] = {1, 2, 0};  // the vendor's x, y, z are our y, z, x
  std::printf("pose of the vendor    position [mm]            rotation vector [rad]\n");
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      for (int i = 0; i < 3; ++i) {
        hd().set(places[i], i == axis ? sign * 0.01 : 0.0);
        hd().set(turns[i], i == axis ? sign * 0.3 : 0.0);
      }
      usleep(50'000);
      const Pose pose = ticker.state.motion.pose;
      Vec3 wanted = Vec3::Zero();
      wanted[ours[axis]] = sign;
      EXPECT_LT((pose.position - 0.01 * wanted).norm(), 1e-6) << axis;
      EXPECT_LT((vector_from_rotation(pose.orientation) - 0.3 * wanted).norm(), 1e-3) << axis;
      EXPECT_NEAR(pose.orientation.norm(), 1.0, 1e-12);
      const Vec3 p = 1e3 * pose.position, r = vector_from_rotation(pose.orientation);
      std::printf("%s %c             %7.3f %7.3f %7.3f  %7.4f %7.4f %7.4f\n", places[axis],
                  sign > 0.0 ? '+' : '-', p.x(), p.y(), p.z(), r.x(), r.y(), r.z());
    }
  }
  device->stop_ticks();
}

TEST_F(OpenHapticsDevice, sends_force_in_si_and_ends_in_order) {
  {
    const auto device = open_device("openhaptics:");
    Ticker ticker{device.get(), {{0.3, -0.5, 0.7}, {0.0, 0.01, 0.0}}};
    ticker.run(300);
    EXPECT_NEAR(hd().get("last_fx"), -0.5, 1e-6);  // the vendor's x is our y
    EXPECT_NEAR(hd().get("last_fy"), 0.7, 1e-6);
    EXPECT_NEAR(hd().get("last_fz"), 0.3, 1e-6);
    EXPECT_EQ(hd().get("torque_sets"), 0.0);  // not confirmed: none is sent
    device->stop_ticks();
    EXPECT_EQ(sent_force(), 0.0);
    EXPECT_EQ(hd().get("force_output"), 0.0);
  }
  EXPECT_EQ(hd().get("outside_frame"), 0.0);
  EXPECT_EQ(hd().get("after_close"), 0.0);
  EXPECT_EQ(hd().get("opened"), 0.0);
}

TEST_F(OpenHapticsDevice, torque_is_sent_in_newton_metres_once_its_unit_is_confirmed) {
  // At the speed of a person 6 s in N m, 25 s in mN m: that one in long runs.
  const bool is_long = std::getenv("THIGMA_FULL") != nullptr;
  std::printf("unit    before    asked         sent [vendor's]   received\n");
  for (const double unit : {1.0, 1e-3}) {
    if (unit != 1.0 && !is_long) continue;
    hd().reset();
    std::filesystem::remove_all(folder_);
    hd().set("model", 2);
    hd().set("hold", 1);
    hd().set("torque_unit", unit);
    {
      const auto device = open_device("openhaptics:");
      EXPECT_FALSE(device->limits().actuates_rotation);
      Ticker ticker{device.get(), {Vec3::Zero(), {0.0, 0.02, 0.0}}};
      ticker.run(100);
      device->stop_ticks();
      EXPECT_EQ(hd().get("torque_nonzero"), 0.0);
    }
    const double before = hd().get("torque_sets");
    calibrate(0.015);
    const auto device = open_device("openhaptics:");
    ASSERT_TRUE(device->limits().actuates_rotation);
    Ticker ticker{device.get(), {Vec3::Zero(), {0.0, 0.02, 0.0}}};
    ticker.run(300);
    std::printf("%-7s %.0f sent    0.02000 N m   %8.3f          %.5f N m\n",
                unit == 1.0 ? "N m" : "mN m", before, hd().get("last_tx"), hd().get("applied_tx"));
    EXPECT_NEAR(hd().get("applied_tx"), 0.02, 0.0002);
    device->stop_ticks();
  }
}

TEST_F(OpenHapticsDevice, a_kept_unit_is_that_of_its_device) {
  hd().set("model", 2);
  hd().set("torque_unit", 1e-3);
  detail::write_device_profile(
      detail::device_profile_file("openhaptics-PHANToM Premium 1.5 6DOF-" + serial()), {1000.0});
  const auto device = open_device("openhaptics:");
  ASSERT_TRUE(device->limits().actuates_rotation) << device->name() << ' ' << serial();
  Ticker ticker{device.get(), {Vec3::Zero(), {0.0, 0.02, 0.0}}};
  ticker.run(300);
  EXPECT_NEAR(hd().get("applied_tx"), 0.02, 0.0002);
  device->stop_ticks();
}

TEST_F(OpenHapticsDevice, a_torque_that_is_stopped_is_off_and_its_unit_not_kept) {
  hd().set("model", 2);
  hd().set("hold", 1);  // the stylus does not turn
  hd().set("buttons", 1);
  calibrate_device("openhaptics:",
                   {[](const std::string&) {}, [](const std::string&) { return true; },
                    [] { return hd().get("torque_nonzero") > 100.0; }});
  EXPECT_GT(hd().get("torque_nonzero"), 0.0);
  EXPECT_EQ(hd().get("last_tx"), 0.0);
  EXPECT_EQ(hd().get("force_output"), 0.0);
  EXPECT_EQ(hd().get("opened"), 0.0);
  EXPECT_FALSE(open_device("openhaptics:")->limits().actuates_rotation);
}

TEST_F(OpenHapticsDevice, warm_motors_are_told_of_until_they_have_cooled) {
  const auto device = open_device("openhaptics:");
  Ticker ticker{device.get()};
  ticker.run(50);
  hd().set("motor_temperature", 1.0);
  EXPECT_TRUE(standin_test::wait_for(
      [&] { return std::string(device->trouble()).find("warm") != std::string::npos; }));
  hd().set("motor_temperature", 0.2);
  EXPECT_TRUE(standin_test::wait_for([&] { return *device->trouble() == '\0'; }));
  EXPECT_EQ(ticker.state.status, DeviceStatus::ok);
  device->stop_ticks();
}

TEST_F(OpenHapticsDevice, says_what_to_do_where_it_does_not_open) {
  hd().set("calibration", 0x5002);
  EXPECT_NE(refusal("openhaptics:").find("put the stylus into its inkwell, then run"),
            std::string::npos)
      << refusal("openhaptics:");
  hd().reset();
  hd().set("count", 0);
  EXPECT_NE(refusal("openhaptics:").find("no device answers"), std::string::npos);
  hd().reset();
  hd().set("fail_open", 0x0302);
  EXPECT_NE(refusal("openhaptics:").find("Plug it in"), std::string::npos)
      << refusal("openhaptics:");
}

TEST_F(OpenHapticsDevice, one_usual_name_is_enough) {
  for (const double names : {1.0, 2.0, 4.0}) {
    hd().reset();
    hd().set("names", names);
    EXPECT_EQ(refusal("openhaptics:"), "") << names;
  }
}

struct FaultCase {
  const char* name;
  const char* key;
  double value;
};

TEST_F(OpenHapticsDevice, faults_in_contact_end_in_zero_force) {
  const FaultCase cases[] = {{"unplugged", "unplug", 1},
                             {"error returned", "fail_read", 0x0302},
                             {"silent", "silent", 1},
                             {"NaN", "nan_pose", 1},
                             {"jump", "jump_x", 0.06}};
  test::print_fault_heads();
  for (const FaultCase& c : cases) {
    const auto open = [] {
      hd().reset();
      hd().set("buttons", 1);
      hd().set("velocity_check", 0);
      return open_device("openhaptics:");
    };
    const test::PressedSession s = test::press_and_fail(
        open, [](double depth) { hd().set("target_y", -depth); }, motor_force,
        [&c] { hd().set(c.key, c.value); });
    test::expect_fault(c.name, s, *s.device, test::zero_text(s));
    std::printf("%-20s force output %s\n", "", hd().get("force_output") != 0.0 ? "on" : "off");
    EXPECT_TRUE(sent_force() == 0.0 || hd().get("force_output") == 0.0) << c.name;
  }
}

}  // namespace
}  // namespace thigma
