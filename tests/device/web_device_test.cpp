#include "thigma/device/web_device.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/recording/replay_session.h"

namespace thigma {
namespace {

using test::plane_session;

WebSample sample(double time, const Vec3& position, std::uint32_t buttons) {
  return {time, {position, Quat::Identity()}, buttons};
}

/// A page scripted frame by frame: called before each frame of a lockstep session.
class PagedDevice final : public HapticDevice {
 public:
  using Page = std::function<void(double now, WebDeviceChannel& link)>;
  PagedDevice(WebDeviceChannel& link, Page page)
      : link_(link), inner_(make_web_device(link)), page_(std::move(page)) {}
  const DeviceLimits& limits() const override { return inner_->limits(); }
  std::string name() const override { return inner_->name(); }
  DeviceState read(double now) THIGMA_RT override {
    page_(now, link_);
    return inner_->read(now);
  }
  void write(const Wrench& wrench) THIGMA_RT override { inner_->write(wrench); }

 private:
  WebDeviceChannel& link_;
  std::unique_ptr<HapticDevice> inner_;
  Page page_;
};

struct Told {
  std::vector<HapticSample> samples;
  std::vector<SessionEvent> events;
  SessionSummary summary;
};

Told run(double duration, const PagedDevice::Page& page) {
  SessionConfig config = plane_session(0.01);
  config.haptic.resumes_lost_device = true;
  config.haptic.safety.start_ramp = 0.0;
  config.duration = duration;
  WebDeviceChannel link;
  PagedDevice device(link, page);
  Told told;
  told.summary = run_lockstep(config, device,
                              {[&](const HapticSample& s) { told.samples.push_back(s); },
                               {},
                               [&](const SessionEvent& e) { told.events.push_back(e); }});
  return told;
}

/// Presses at 0.1 s, pushes down 2 cm, 1 cm more than there is room for, within 0.4 s.
WebSample pushing(double now, bool is_pressed = true) {
  const double down = 0.02 * std::clamp((now - 0.1) / 0.4, 0.0, 1.0);
  return sample(500.0 + now, {0.0, 0.0, -down}, now > 0.1 && is_pressed ? kClutchButton : 0u);
}

bool is_page_frame(double now) { return static_cast<int>(now * 1000.0 + 0.5) % 16 == 0; }

TEST(WebDevice, DragMovesTheObjectUntilContactAndTheForceGrowsWithTheDistance) {
  const Told told = run(1.0, [](double now, WebDeviceChannel& link) {
    if (now == 0.0) link.begin();
    if (is_page_frame(now)) link.push(pushing(now));
  });
  const HapticSample& end = told.samples.back();
  EXPECT_EQ(told.summary.end, SessionEnd::duration);
  EXPECT_TRUE(end.is_armed);
  EXPECT_LT(end.body.position.z(), test::kCubeHalf + 0.001);  // it came down ...
  EXPECT_GT(end.body.position.z(), test::kCubeHalf - 0.002);  // ... and stopped at the surface
  EXPECT_LT(end.handle.pose.position.z(), test::kCubeHalf - 0.008);  // the hand did not
  EXPECT_GT(end.command.force.z(), 1.0);
  EXPECT_TRUE(told.summary.safety_events.empty());
}

TEST(WebDevice, WithoutAPageTheSessionRunsWithoutAFault) {
  const Told told = run(0.5, [](double, WebDeviceChannel&) {});
  EXPECT_EQ(told.summary.end, SessionEnd::duration);
  EXPECT_TRUE(told.summary.safety_events.empty());
  EXPECT_EQ(told.samples.back().device.status, DeviceStatus::not_ready);
}

TEST(WebDevice, LosingThePageIsZeroForceAndANewPressOfTheClutchGoesOn) {
  for (const bool is_closed : {false, true}) {
    const double back = is_closed ? 2.0 : 1.5 + WebMotionParams{}.lost_after;
    const Told told = run(back + 1.0, [is_closed, back](double now, WebDeviceChannel& link) {
      if (now == 0.0) link.begin();
      if (is_closed && now == 1.0) link.lose();
      if (is_closed && now == back) link.begin();
      if (!is_page_frame(now)) return;
      if (now < 1.0) link.push(pushing(now));
      if (now >= back) {  // from elsewhere, first without the clutch; then it pulls up
        const double up = now > back + 0.1 ? 0.05 * (now - back - 0.1) : 0.0;
        link.push(sample(500.0 + now, {1.0, 1.0, up}, now > back + 0.1 ? kClutchButton : 0u));
      }
    });
    const auto at = [&](double t) { return told.samples[static_cast<std::size_t>(t * 1000.0)]; };
    EXPECT_GT(at(0.9).command.force.norm(), 1.0);
    // Told at once when the connection closes, found out by silence otherwise.
    const double latest = is_closed ? 1.002 : 1.05 + WebMotionParams{}.lost_after;
    EXPECT_EQ(at(latest).fault, Fault::device_lost);
    for (double t = latest; t < back + 0.05; t += 0.01) {
      ASSERT_EQ(at(t).command.force, Vec3::Zero()) << t;
      ASSERT_EQ(at(t).command.torque, Vec3::Zero()) << t;
    }
    EXPECT_EQ(at(back + 0.2).fault, Fault::none);
    EXPECT_TRUE(at(back + 0.2).is_grasped);
    EXPECT_GT(at(back + 0.9).body.position.z(), at(back).body.position.z() + 0.01);
    EXPECT_EQ(told.summary.end, SessionEnd::duration);
    ASSERT_EQ(told.summary.safety_events.size(), 1u);
    EXPECT_EQ(told.summary.safety_events[0].detail, "device_lost");
    int resumed = 0;
    for (const SessionEvent& e : told.events) resumed += e.kind == EventKind::resumed;
    EXPECT_EQ(resumed, 1);
  }
}

/// A drag onto the surface by a page that stands still from 1 s to 3 s, silent or saying its last
/// sample again.
Told run_late_page(bool repeats) {
  return run(5.0, [repeats](double now, WebDeviceChannel& link) {
    if (now == 0.0) link.begin();
    if (!is_page_frame(now)) return;
    const bool is_late = now > 1.0 && now < 3.0;
    if (!is_late) link.push(pushing(now));
    if (is_late && repeats) link.push(pushing(0.992));
  });
}

TEST(WebDevice, ALatePageFadesToNothingAndComesBackWhileTheButtonIsDown) {
  for (const bool repeats : {false, true}) {
    const Told told = run_late_page(repeats);
    const auto at = [&](double t) { return told.samples[static_cast<std::size_t>(t * 1000.0)]; };
    EXPECT_TRUE(told.summary.safety_events.empty());
    for (const HapticSample& s : told.samples) {
      if (s.time > 0.2) {
        ASSERT_TRUE(s.is_grasped && s.is_armed) << s.time;
      }
    }
    const double pressed = at(0.99).command.force.norm();
    EXPECT_GT(pressed, 1.0);
    EXPECT_NEAR(at(1.25).command.force.norm(), pressed, 0.01 * pressed);  // not yet late
    EXPECT_EQ(at(2.1).command.force, Vec3::Zero());
    EXPECT_EQ(at(2.9).command.torque, Vec3::Zero());
    // The object rests where the surface has let it go: nothing pulls, nothing throws it.
    EXPECT_LT((at(2.9).body.position - at(0.99).body.position).norm(), 0.002);
    EXPECT_LT((at(2.9).body.position - at(2.4).body.position).norm(), 1e-5);
    EXPECT_NEAR(at(4.9).command.force.norm(), pressed, 0.01 * pressed);  // and is pressed again
  }
}

TEST(WebDevice, NothingLeapsWhileALatePageFadesAndComesBack) {
  SafetyLimits limits;
  const Told told = run_late_page(true);
  for (std::size_t k = 1001; k < told.samples.size(); ++k) {
    const HapticSample& a = told.samples[k - 1];
    const HapticSample& b = told.samples[k];
    ASSERT_LE((b.command.force - a.command.force).norm(), 1.001e-3 * limits.force_slew) << k;
    ASSERT_LE((b.body.position - a.body.position).norm(), 1e-3 * WebMotionParams{}.max_speed) << k;
  }
}

TEST(WebDevice, ASessionOfALatePageIsReplayedBitForBit) {
  SessionConfig config = plane_session(0.01);
  config.haptic.resumes_lost_device = true;
  config.haptic.safety.start_ramp = 0.0;
  config.duration = 4.0;
  WebDeviceChannel link;
  PagedDevice device(link, [](double now, WebDeviceChannel& to) {
    if (now == 0.0) to.begin();
    if (is_page_frame(now) && !(now > 1.0 && now < 2.5)) to.push(pushing(now));
  });
  config.haptic.device = device.limits();
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  run_lockstep(config, device,
               {[&](const HapticSample& s) { samples.push_back(s); },
                [&](const ContactSample& s) { models.push_back(s); },
                {}});
  EXPECT_LT(samples[2200].device.weight, 1.0);
  const ReplayReport report =
      replay_session(config.haptic, config.world_from_body, samples, models);
  EXPECT_TRUE(report.identical) << report.reason;
}

TEST(WebDevice, LettingGoInOrderIsNoFault) {
  const Told told = run(1.5, [](double now, WebDeviceChannel& link) {
    if (now == 0.0) link.begin();
    if (now == 0.5) link.release();
    if (is_page_frame(now)) link.push(pushing(now));
  });
  EXPECT_TRUE(told.summary.safety_events.empty());
  EXPECT_FALSE(told.samples.back().is_grasped);
}

TEST(WebDevice, SamplesOfAPageThatHasLostTheDeviceAreNotTaken) {
  WebDeviceChannel link;
  EXPECT_FALSE(link.push(sample(0.0, Vec3::Zero(), 0)));
  link.begin();
  EXPECT_TRUE(link.push(sample(0.0, {9.0, 0.0, 0.0}, 0)));
  link.lose();
  EXPECT_FALSE(link.push(sample(0.1, Vec3::Zero(), 0)));
  link.begin();
  EXPECT_TRUE(link.push(sample(0.2, {1.0, 0.0, 0.0}, 0)));
  WebMotion motion;
  std::uint32_t seen = 0;
  link.take(0.0, motion, seen);
  EXPECT_EQ(motion.read(0.0).motion.pose.position.x(), 1.0);  // the first turn's sample is gone
}

TEST(WebDevice, AFullRingNeitherBlocksNorHidesTheLoss) {
  WebDeviceChannel link;
  link.begin();
  int taken = 0;
  for (int i = 0; i < 5000; ++i) taken += link.push(sample(1e-3 * i, Vec3::Zero(), 0));
  EXPECT_LT(taken, 1000);
  link.lose();
  const auto device = make_web_device(link);
  EXPECT_EQ(device->read(0.0).status, DeviceStatus::lost);
}

}  // namespace
}  // namespace thigma
