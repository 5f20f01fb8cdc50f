// What the haptic step does in the thread of a device that owns the clock.
#include <functional>
#include <memory>
#include <thread>

#include "support/audit.h"
#include "support/plane_session.h"
#include "support/ticking_hand.h"
#include <gtest/gtest.h>
#include <sys/syscall.h>

#include "thigma/device/detail/link_device.h"
#include "thigma/device/detail/rate_device.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"
#include "thigma/session/session.h"

namespace thigma {
namespace {

/// Adds up what ticks do.
struct TickAudit {
  test::AuditCounts counts;
  int ticks = 0;
  void make(DeviceTick tick) {
    const test::AuditScope scope;
    tick.call(tick.context);
    const test::AuditCounts now = scope.counts();
    counts.allocations += now.allocations;
    counts.frees += now.frees;
    counts.locks += now.locks;
    counts.system_calls += now.system_calls;
    ++ticks;
  }
  std::string text() const {
    return std::to_string(ticks) + " ticks, " + std::to_string(counts.allocations) +
           " allocations, " + std::to_string(counts.locks) + " locks, " +
           std::to_string(counts.system_calls) + " system calls, last " +
           std::to_string(counts.last_system_call);
  }
};

SessionConfig patient_session() {
  SessionConfig config = test::plane_session();
  config.duration = 1.0;
  config.haptic.safety.watchdog = 5.0;
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  config.haptic.safety.pose_jump = 1.0;
  return config;
}

/// A device whose ticks are watched.
class AuditedDevice final : public HapticDevice {
 public:
  AuditedDevice(HapticDevice& inner, TickAudit& audit) : inner_(inner), audit_(audit) {}
  const DeviceLimits& limits() const override { return inner_.limits(); }
  std::string name() const override { return inner_.name(); }
  const char* trouble() const THIGMA_RT override { return inner_.trouble(); }
  DeviceState read(double now) THIGMA_RT override { return inner_.read(now); }
  void write(const Wrench& wrench) THIGMA_RT override { inner_.write(wrench); }
  void start_ticks(double rate, DeviceTick tick) override {
    tick_ = tick;
    inner_.start_ticks(rate, {[](void* self) noexcept {
                                auto& device = *static_cast<AuditedDevice*>(self);
                                device.audit_.make(device.tick_);
                              },
                              this});
  }
  void stop_ticks() noexcept override { inner_.stop_ticks(); }

 private:
  HapticDevice& inner_;
  TickAudit& audit_;
  DeviceTick tick_;
};

TEST(DeviceAudit, a_tick_neither_allocates_nor_locks_nor_calls_the_system) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  test::TickingHand device(test::plane_hand(HandPath::press, 0.005));
  TickAudit audit;
  bool is_seen = false;
  device.begins = [&] { is_seen = test::forbid_system_calls(); };
  device.around = [&](DeviceTick tick) { audit.make(tick); };
  Session session(patient_session(), device);
  session.start();
  session.finish();
  EXPECT_TRUE(is_seen);
  EXPECT_GT(audit.ticks, 100);
  EXPECT_GT(device.most_force, 0.0);
  EXPECT_EQ(audit.counts.total(), 0) << audit.text();
}

TEST(DeviceAudit, nor_does_the_step_in_the_callback_of_openhaptics) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const auto device = open_device("openhaptics:");
  TickAudit audit;
  AuditedDevice audited(*device, audit);
  Session session(patient_session(), audited);
  session.start();
  EXPECT_EQ(session.finish().end, SessionEnd::duration) << device->trouble();
  EXPECT_GT(audit.ticks, 100);
  EXPECT_EQ(audit.counts.total(), 0) << audit.text();
}

TEST(DeviceAudit, nor_does_the_driver_of_force_dimension_in_a_session_of_its_thread) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  setenv("STANDIN_DRD_BLOCKING", "0", 1);  // else the library waits for the device, in our thread
  setenv("STANDIN_DRD_WATCHDOG", "0", 1);  // a loaded machine is late
  setenv("STANDIN_DRD_VELOCITY_THRESHOLD", "0", 1);
  const auto device = open_device("dhd:0");
  test::AuditCounts counts;
  int reads = 0;
  bool is_seen = false;
  std::thread haptic([&] {
    // The stand-in keeps errors by thread; the loader allocates room for them at the first call.
    device->read(0.0);
    device->write(Wrench{});
    is_seen = test::forbid_system_calls();
    const test::AuditScope scope;
    for (int i = 0; i < 20'000; ++i) {
      const DeviceState state = device->read(1e-3 * i);
      device->write({{0.0, 0.0, 1e-4 * (i % 100)}, Vec3(0.0, 1e-4, 0.0)});
      reads += state.status == DeviceStatus::ok ? 1 : 0;
    }
    counts = scope.counts();
  });
  haptic.join();
  EXPECT_TRUE(is_seen);
  EXPECT_EQ(reads, 20'000) << device->trouble();
  if (counts.last_system_call == SYS_sched_yield) counts.system_calls = 0;  // the stand-in's lock
  EXPECT_EQ(counts.total(), 0) << counts.allocations << ' ' << counts.locks << ' '
                               << counts.last_system_call;
}

/// The service of a link: tells a moving handle twice a millisecond, takes forces.
void pretend_service(detail::LinkEnds& ends) {
  detail::LinkSample sample;
  detail::LinkForce force;
  while (!ends.is_over) {
    ++sample.count;
    sample.motion.pose.position.x() = 1e-5 * static_cast<double>(sample.count % 100);
    sample.interval = sample.count % 200 < 100 ? 0.5e-3 : 8e-3;  // seldom as well
    ends.samples.publish(sample);
    force.newest(ends, detail::driver_time_ns());
    if (sample.count == 2000) ends.trouble.lose("the service", "has gone");
    usleep(500);
  }
}

TEST(DeviceAudit, nor_do_drivers_over_a_link_however_they_are_wrapped) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  std::unique_ptr<HapticDevice> devices[] = {
      std::make_unique<detail::LinkDevice>("link", DeviceLimits{}, false, pretend_service),
      std::make_unique<detail::RateDevice>("rate", detail::RateParams{}, pretend_service),
      open_device("hand:?dof=3&bubble=0.005&rotation=null:&camera=null:")};
  test::AuditCounts counts;
  bool is_seen = false;
  std::thread haptic([&] {
    is_seen = test::forbid_system_calls();
    const test::AuditScope scope;
    for (int i = 0; i < 200'000; ++i) {
      for (const auto& device : devices) {
        const DeviceState state = device->read(1e-5 * i);
        device->write({state.motion.pose.position, Vec3::UnitX()});
      }
    }
    counts = scope.counts();
  });
  haptic.join();
  EXPECT_TRUE(is_seen);
  EXPECT_EQ(counts.total(), 0) << counts.allocations << ' ' << counts.locks << ' '
                               << counts.last_system_call;
}

}  // namespace
}  // namespace thigma
