// OpenHaptics' library, pretended: devices, frames, parameters, the scheduler.
#include <atomic>
#include <cmath>

#include "hd_client.h"

namespace standin_test {
namespace {

class Hd : public HdTest {};

TEST_F(Hd, names_of_the_default_device) {
  EXPECT_EQ(hd().call<unsigned>("hdInitDevice", nobody()), 0u);
  EXPECT_EQ(hd().call<unsigned>("hdInitDevice", nobody()), kNoHandle);
  EXPECT_EQ(error(), 0x0301u);
  hd().call<void>("hdDisableDevice", 0u);
  hd().set("names", 6);  // some installations fail without a name
  EXPECT_EQ(hd().call<unsigned>("hdInitDevice", nobody()), kNoHandle);
  EXPECT_EQ(error(), 0x0300u);
  EXPECT_EQ(hd().call<unsigned>("hdInitDevice", "Default Device"), 0u);
  hd().call<void>("hdDisableDevice", 0u);
  hd().set("names", 4);
  EXPECT_EQ(hd().call<unsigned>("hdInitDevice", "Default Device"), kNoHandle);
  EXPECT_EQ(hd().call<unsigned>("hdInitDevice", "Default PHANToM"), 0u);
}

TEST_F(Hd, every_documented_error_comes_by_value_latest_first) {
  for (const int code :
       {0x0100, 0x0101, 0x0102, 0x0103, 0x0104, 0x0200, 0x0201, 0x0202, 0x0203, 0x0204, 0x0300,
        0x0301, 0x0302, 0x0303, 0x0304, 0x0400, 0x0401, 0x0402, 0x0500, 0x0501, 0x0600}) {
    hd().set("fail_open", code);
    EXPECT_EQ(hd().call<unsigned>("hdInitDevice", nobody()), kNoHandle);
    const ErrorInfo info = hd().call<ErrorInfo>("hdGetError");
    EXPECT_EQ(info.error, static_cast<unsigned>(code));
    EXPECT_EQ(info.device, 0u);
    EXPECT_STRNE(hd().call<const char*>("hdGetErrorString", info.error), "unknown error");
  }
  hd().set("fail_open", 0x0300);
  hd().call<unsigned>("hdInitDevice", nobody());
  hd().set("fail_open", 0x0302);
  hd().call<unsigned>("hdInitDevice", nobody());
  EXPECT_EQ(error(), 0x0302u);
  EXPECT_EQ(error(), 0x0300u);
  EXPECT_EQ(error(), 0u);
}

TEST_F(Hd, transform_is_column_major_in_millimetres_and_not_quite_orthonormal) {
  hd().set("hold", 1);
  hd().set("target_x", 0.01);
  hd().set("target_y", 0.02);
  hd().set("target_z", -0.03);
  hd().set("target_ry", 0.5);
  open();
  double m[16];
  begin();
  hd().call<void>("hdGetDoublev", 0x2052u, m);
  end();
  EXPECT_NEAR(m[12], 10.0, 1e-9);
  EXPECT_NEAR(m[13], 20.0, 1e-9);
  EXPECT_NEAR(m[14], -30.0, 1e-9);
  EXPECT_NEAR(m[0], std::cos(0.5), 1e-3);  // first column: the x axis, turned to -z
  EXPECT_NEAR(m[2], -std::sin(0.5), 1e-3);
  const double xy = m[0] * m[4] + m[1] * m[5] + m[2] * m[6];
  EXPECT_GT(std::fabs(xy), 1e-6);
  EXPECT_LT(std::fabs(xy), 1e-2);
}

TEST_F(Hd, state_outside_a_frame_is_an_error) {
  open();
  double p[3];
  int buttons = 0;
  hd().call<void>("hdGetDoublev", 0x2050u, p);
  EXPECT_EQ(error(), 0x0402u);
  const double force[3] = {1, 0, 0};
  hd().call<void>("hdSetDoublev", 0x2700u, force);
  EXPECT_EQ(error(), 0x0402u);
  EXPECT_EQ(hd().get("outside_frame"), 2.0);
  EXPECT_EQ(hd().get("sets"), 0.0);
  hd().set("strict_frames", 0);
  hd().call<void>("hdGetIntegerv", 0x2000u, &buttons);
  EXPECT_EQ(error(), 0u);
  EXPECT_EQ(hd().get("outside_frame"), 3.0);
  double most = 0.0;  // what the device is may be asked at any time
  hd().call<void>("hdGetDoublev", 0x2603u, &most);
  EXPECT_EQ(most, 3.3);
  EXPECT_EQ(error(), 0u);
}

TEST_F(Hd, frames_must_pair) {
  open();
  end();
  EXPECT_EQ(error(), 0x0401u);
  hd().call<void>("hdBeginFrame", 7u);
  EXPECT_EQ(error(), 0x0104u);
}

TEST_F(Hd, a_tick_has_one_frame) {
  open();
  run_once([] {
    begin();
    end();
    begin();
  });
  EXPECT_EQ(error(), 0x0400u);
}

TEST_F(Hd, types_and_names_of_parameters) {
  open();
  double number = 0.0;
  int whole = 0;
  hd().call<void>("hdGetDoublev", 0x1234u, &number);
  EXPECT_EQ(error(), 0x0100u);
  begin();
  hd().call<void>("hdGetDoublev", 0x2000u, &number);
  EXPECT_EQ(error(), 0x0103u);
  hd().set("buttons", 2);
  hd().call<void>("hdGetIntegerv", 0x2000u, &whole);
  EXPECT_EQ(whole, 0);  // as at the beginning of the frame
  end();
  begin();
  hd().call<void>("hdGetIntegerv", 0x2000u, &whole);
  end();
  EXPECT_EQ(whole, 2);
  EXPECT_STREQ(hd().call<const char*>("hdGetString", 0x2501u), "Touch");
  double box[6];
  hd().call<void>("hdGetDoublev", 0x2551u, box);
  EXPECT_LT(box[0], -10.0);
  EXPECT_GT(box[3], 10.0);
}

TEST_F(Hd, scheduler_calls_at_its_rate_by_priority) {
  static std::atomic<int> calls, order_wrong, last;
  calls = order_wrong = last = 0;
  open();
  const auto low = +[](void*) -> unsigned {
    order_wrong += last != 1 && calls < 400 ? 1 : 0;  // alone after the other is done
    last = 0;
    return 1;
  };
  const auto high = +[](void*) -> unsigned {
    last = 1;
    return ++calls < 400 ? 1 : 0;
  };
  const unsigned long a =
      hd().call<unsigned long>("hdScheduleAsynchronous", low, nobody(), kLowest);
  const unsigned long b =
      hd().call<unsigned long>("hdScheduleAsynchronous", high, nobody(), kHighest);
  hd().call<void>("hdSetSchedulerRate", 1000ul);
  hd().call<void>("hdStartScheduler");
  EXPECT_EQ(hd().call<unsigned char>("hdWaitForCompletion", b, 1u), 1);
  hd().call<void>("hdUnschedule", a);
  EXPECT_EQ(calls, 400);  // 0: done, it is not called again
  EXPECT_EQ(order_wrong, 0);
  EXPECT_GE(hd().get("ticks"), 400.0);
  EXPECT_EQ(error(), 0u);
  hd().call<void>("hdUnschedule", a);
  EXPECT_EQ(error(), 0x0102u);
  EXPECT_EQ(hd().call<unsigned char>("hdWaitForCompletion", b, 0u), 0);
}

TEST_F(Hd, rates_slots_and_a_timer_that_fails) {
  hd().call<void>("hdSetSchedulerRate", 777ul);
  EXPECT_EQ(error(), 0x0101u);
  hd().call<void>("hdSetSchedulerRate", 500ul);
  EXPECT_EQ(error(), 0u);
  EXPECT_EQ(hd().get("rate"), 500.0);
  hd().set("scheduler_slots", 0);
  const auto nothing = +[](void*) -> unsigned { return 0; };
  hd().call<unsigned long>("hdScheduleAsynchronous", nothing, nobody(), kLowest);
  EXPECT_EQ(error(), 0x0501u);
  hd().set("fail_scheduler", 0x0304);
  hd().call<void>("hdStartScheduler");
  EXPECT_EQ(error(), 0x0304u);
}

TEST_F(Hd, synchronous_calls_run_in_the_servo_thread) {
  open();
  begin();
  end();
  EXPECT_EQ(hd().get("off_scheduler"), 1.0);
  run_once([] {
    begin();
    end();
  });
  EXPECT_EQ(hd().get("off_scheduler"), 1.0);
  EXPECT_EQ(hd().get("frames"), 2.0);
}

TEST_F(Hd, calibration) {
  hd().set("calibration", 0x5002);
  hd().set("hold", 1);
  open();
  EXPECT_EQ(hd().call<unsigned>("hdCheckCalibration"), 0x5002u);
  EXPECT_EQ(hd().call<unsigned>("hdCheckCalibrationStyle"), 4u);
  double p[3];
  begin();
  hd().call<void>("hdGetDoublev", 0x2050u, p);
  end();
  EXPECT_NEAR(p[1], 20.0, 1e-9);  // off by what was not calibrated
  hd().call<void>("hdUpdateCalibration", 1u);
  EXPECT_EQ(error(), 0x0300u);
  hd().call<void>("hdUpdateCalibration", 4u);
  EXPECT_EQ(hd().call<unsigned>("hdCheckCalibration"), 0x5002u);
  hd().set("inkwell", 1);
  hd().call<void>("hdUpdateCalibration", 4u);
  EXPECT_EQ(hd().call<unsigned>("hdCheckCalibration"), 0x5000u);
}

TEST_F(Hd, missing_symbol_variant_lacks_one) {
  const Library missing("hd_missing", "libHD.so");
  ASSERT_TRUE(missing.is_open());
  EXPECT_FALSE(missing.has("hdSetDoublev"));
  EXPECT_TRUE(missing.has("hdGetDoublev"));
}

}  // namespace
}  // namespace standin_test
