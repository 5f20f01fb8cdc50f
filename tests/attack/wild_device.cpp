#include "attack/wild_device.h"

#include <limits>

#include "thigma/math/elementary.h"

namespace thigma::test {

WildDevice::WildDevice(const HandParams& hand, Random& random, std::uint64_t frames) : hand_(hand) {
  // None in one of four; else a few, mostly short, and late enough to find contacts.
  const std::uint64_t count = random.below(4) == 0 ? 0 : 1 + random.below(5);
  for (std::uint64_t i = 0; i < count; ++i) {
    Span span;
    const std::uint64_t calm = random.below(4) == 0 ? 0 : frames / 2;
    span.first = calm + random.below(frames - calm + 1);
    span.end = span.first + 1 + random.below(random.below(3) == 0 ? frames : 5);
    span.kind = static_cast<Mischief>(random.below(kMischiefs));
    span.size = random.uniform();
    span.along = random.direction();
    spans_.push_back(span);
  }
}

void WildDevice::spoil(const Span& span, const DeviceState& before, DeviceState& state) THIGMA_RT {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Pose& pose = state.motion.pose;
  Twist& twist = state.motion.twist;
  switch (span.kind) {
    case Mischief::nan_position:
      pose.position.y() = kNan;
      break;
    case Mischief::infinite_velocity:
      twist.linear.x() = std::numeric_limits<double>::infinity();
      break;
    case Mischief::nan_orientation:
      pose.orientation.w() = kNan;
      break;
    case Mischief::no_orientation:
      pose.orientation.coeffs().setZero();
      break;
    case Mischief::jump:
      pose.position += 0.05 * span.size * span.along;
      break;
    case Mischief::turn: {
      const double half = 1.5 * span.size;
      const Vec3 axis = sine(half) * span.along;
      pose.orientation = pose.orientation * Quat(cosine(half), axis.x(), axis.y(), axis.z());
      break;
    }
    case Mischief::too_fast:
      twist.linear = 5.0 * span.size * span.along;
      break;
    case Mischief::spinning:
      twist.angular = 80.0 * span.size * span.along;
      break;
    case Mischief::lost:
      state.status = DeviceStatus::lost;
      break;
    case Mischief::not_ready:
      state = before;
      state.status = DeviceStatus::not_ready;
      break;
    case Mischief::silent:
      state = before;
      break;
    case Mischief::backwards:
      state.time -= 0.1 * span.size;
      break;
    case Mischief::buttons:
      state.buttons = ~state.buttons;
      break;
    case Mischief::light:
      state.weight = span.size;
      break;
  }
}

DeviceState WildDevice::read(double now) THIGMA_RT {
  DeviceState state = hand_.read(now);
  for (const Span& span : spans_)
    if (frame_ >= span.first && frame_ < span.end) spoil(span, last_, state);
  ++frame_;
  last_ = state;
  return state;
}

void WildDevice::write(const Wrench& wrench) THIGMA_RT {
  written_ = wrench;
  hand_.write(wrench);
}

}  // namespace thigma::test
