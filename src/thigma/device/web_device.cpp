#include "thigma/device/web_device.h"

namespace thigma {
namespace {

DeviceLimits web_limits() {
  DeviceLimits limits;
  limits.max_force = 8.5;
  limits.max_torque = 0.188;
  limits.max_stiffness = 1000.0;
  limits.max_angular_stiffness = 0.6;
  limits.workspace_radius = 1.0;
  limits.holds_person = false;  // a mouse has no motors, and the page shows what it is told
  constexpr WebMotionParams kMotion;
  limits.delay = kMotion.delay + 2.0 / kMotion.stiffness;
  return limits;
}

class WebDevice final : public HapticDevice {
 public:
  WebDevice(WebDeviceChannel& link, const WebMotionParams& params) : link_(link), motion_(params) {}

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "web"; }
  DeviceState read(double now) THIGMA_RT override {
    link_.take(now, motion_, seen_);
    return motion_.read(now);
  }
  void write(const Wrench&) THIGMA_RT override {}  // the page reads it from the telemetry

 private:
  WebDeviceChannel& link_;
  WebMotion motion_;
  std::uint32_t seen_ = 0;  // state of the link
  DeviceLimits limits_ = web_limits();
};

constexpr std::uint32_t kHoldBits = 2;

}  // namespace

void WebDeviceChannel::set(Hold hold) noexcept {
  hold_ = hold;
  state_.store((turn_ << kHoldBits) | static_cast<std::uint32_t>(hold), std::memory_order_release);
}

void WebDeviceChannel::begin() noexcept {
  ++turn_;
  set(Hold::held);
}

void WebDeviceChannel::release() noexcept {
  if (hold_ == Hold::held) set(Hold::free);
}

void WebDeviceChannel::lose() noexcept {
  if (hold_ == Hold::held) set(Hold::lost);
}

bool WebDeviceChannel::push(const WebSample& sample) noexcept {
  return hold_ == Hold::held && samples_.push({turn_, sample});
}

void WebDeviceChannel::take(double now, WebMotion& motion, std::uint32_t& seen) THIGMA_RT {
  const std::uint32_t state = state_.load(std::memory_order_acquire);
  const std::uint32_t turn = state >> kHoldBits;
  if (turn != seen >> kHoldBits) motion.begin();
  // What is there now, and no more: the server may be adding faster than this takes.
  for (std::size_t left = samples_.capacity(); left > 0; --left) {
    const Tagged* next = samples_.front();
    if (next == nullptr) break;
    if (next->turn == turn) motion.add(next->sample, now);
    samples_.pop();
  }
  if (state != seen) {
    const auto hold = static_cast<Hold>(state & ((1u << kHoldBits) - 1u));
    if (hold == Hold::free) motion.release();
    if (hold == Hold::lost) motion.lose();
  }
  seen = state;
}

std::unique_ptr<HapticDevice> make_web_device(WebDeviceChannel& link,
                                              const WebMotionParams& params) {
  return std::make_unique<WebDevice>(link, params);
}

}  // namespace thigma
