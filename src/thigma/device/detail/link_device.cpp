#include "thigma/device/detail/link_device.h"

#include <algorithm>

#include <pthread.h>
#include <sched.h>

#include "thigma/device/detail/pose_follower.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/detail/vendor_frames.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

constexpr double kPeriod = 1e-3;       // what comes as often needs no smoothing [s]
constexpr double kQuick = 1.5;         // over the excess of an interval is its frequency [rad]
constexpr double kMostSpeed = 1.2;     // of a smoothed handle: below what safety takes for a fault
constexpr double kMostTurning = 12.0;  // [rad/s]

void ask_for_real_time() noexcept {
  sched_param wanted{};
  wanted.sched_priority = 70;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
}

/// What an interval is longer than a haptic period; below 0.01 ms as good as nothing [s].
double excess_of(double interval) THIGMA_RT {
  const double excess = interval - kPeriod;
  return excess > 1e-5 ? excess : 0.0;
}

/// Is where the sample is, or follows it where samples come seldom: with the velocity that was told
/// for as long as the next is due, and to rest after that.
///
/// age   of the sample [s]
/// h     since the last call, above 0 [s]
void follow(const LinkSample& sample, double age, double h, Motion& handle) THIGMA_RT {
  const Motion& target = sample.motion;
  if (const double excess = excess_of(sample.interval); excess == 0.0) {
    handle.pose.position = target.pose.position;
    handle.twist.linear = target.twist.linear;
  } else {
    const double ahead = std::min(age, 2.0 * excess);
    const Vec3 v = age <= ahead ? target.twist.linear : Vec3::Zero();
    handle.pose.position += h * v;  // seen from what moves with the target
    handle.twist.linear -= v;
    const Vec3 place = target.pose.position + ahead * target.twist.linear;
    follow_position(place, kQuick / excess, kMostSpeed, h, handle);
    handle.twist.linear += v;
  }
  if (const double excess = excess_of(sample.turn_interval); excess == 0.0) {
    handle.pose.orientation = target.pose.orientation;
    handle.twist.angular = target.twist.angular;
  } else {
    follow_orientation(target.pose.orientation, kQuick / excess, kMostTurning, h, handle);
  }
}

}  // namespace

const LinkCommand& LinkForce::newest(LinkEnds& ends, std::int64_t now) {
  if (ends.commands.fetch()) {
    command_ = ends.commands.value();
    renewed_ = now;
  }
  const bool is_off = ends.is_over.load(std::memory_order_acquire) || ends.trouble.is_lost();
  if (is_off || now - renewed_ > kOld) command_.force.setZero();
  return command_;
}

bool is_jump(const Vec3& from, const Vec3& to, double seconds) {
  return !((to - from).norm() <= 0.005 + 1.5 * seconds);
}

bool is_jump(const Quat& from, const Quat& to, double seconds) {
  return !(vector_from_rotation(to * from.conjugate()).norm() <= 0.1 + 25.0 * seconds);
}

LinkThread::LinkThread(LinkTalk talk, bool is_urgent) : ends_(std::make_unique<LinkEnds>()) {
  thread_ = std::thread([talk = std::move(talk), is_urgent, ends = ends_.get()] {
    if (is_urgent) ask_for_real_time();
    try {
      talk(*ends);
    } catch (const std::exception& error) {
      ends->trouble.lose("the driver has failed", error.what());
    }
  });
}

LinkThread::~LinkThread() {
  ends_->is_over.store(true, std::memory_order_release);
  thread_.join();
}

LinkDevice::LinkDevice(std::string name, const DeviceLimits& limits, bool stays, LinkTalk talk)
    : name_(std::move(name)), limits_(limits), stays_(stays), link_(std::move(talk), true) {
  last_.status = DeviceStatus::not_ready;
}

DeviceState LinkDevice::read(double now) THIGMA_RT {
  const double elapsed = now - last_read_;
  last_read_ = now;
  LinkEnds& ends = link_.ends();
  ends.samples.fetch();
  const LinkSample& sample = ends.samples.value();
  if (sample.count == 0) {
    last_.time = now;  // a service that says nothing at first is told of by its thread
  } else {
    const bool is_first = seen_ == 0;
    const bool is_new = sample.count != seen_;
    seen_ = sample.count;
    if (is_new || stays_) last_.time = now;
    const double h = step_of(elapsed);
    if (is_new) arrival_ = now;
    if (is_first) last_.motion = sample.motion;
    if (!is_first && h > 0.0) follow(sample, now - arrival_, h, last_.motion);
    last_.buttons = sample.buttons;
    last_.status = DeviceStatus::ok;
  }
  if (ends.trouble.is_lost()) last_.status = DeviceStatus::lost;
  return last_;
}

void LinkDevice::write(const Wrench& wrench) THIGMA_RT {
  LinkEnds& ends = link_.ends();
  LinkCommand& next = ends.commands.draft();
  next.count = ++sent_;
  next.force = sendable(wrench, limits_).force;
  next.at = last_.motion.pose.position;
  ends.commands.publish();
}

}  // namespace thigma::detail
