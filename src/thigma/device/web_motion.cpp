#include "thigma/device/web_motion.h"

#include <algorithm>
#include <cmath>

#include "thigma/device/detail/pose_follower.h"
#include "thigma/math/rotation.h"

namespace thigma {

using namespace detail;

namespace {

/// From a to b, beyond b where u > 1; the shorter way round.
Pose between(const Pose& a, const Pose& b, double u) THIGMA_RT {
  const Vec3 turn = vector_from_rotation(b.orientation * a.orientation.conjugate());
  return {a.position + u * (b.position - a.position),
          (rotation_from_vector(u * turn) * a.orientation).normalized()};
}

}  // namespace

void WebMotion::take_up() THIGMA_RT {
  hold_ = Hold::held;
  has_place_ = false;
  count_ = 0;
  weight_ = 1.0;
}

void WebMotion::begin() THIGMA_RT {
  take_up();
  press(0);
}

void WebMotion::release() THIGMA_RT {
  if (hold_ == Hold::never) return;
  hold_ = Hold::released;
  press(0);
}

void WebMotion::lose() THIGMA_RT {
  if (hold_ == Hold::never) return;
  hold_ = Hold::lost;
}

void WebMotion::place_first(const WebSample& sample) THIGMA_RT {
  page_origin_ = sample.pose;
  place_ = has_pose_ ? motion_.pose : sample.pose;
  motion_ = {place_, Twist{}};
  has_pose_ = true;
  has_place_ = true;
  count_ = 0;
}

void WebMotion::press(std::uint32_t buttons) THIGMA_RT {
  next_buttons_ = buttons;
  const bool is_open = (buttons & kClutchButton) == 0;
  // An open clutch waits for nothing, and lets nothing overtake it.
  if (!is_read_ && !is_open) return;
  is_read_ = is_read_ && buttons == buttons_;
  buttons_ = buttons;
}

double WebMotion::session_from_page() const THIGMA_RT { return std::min(offset_, offset_before_); }

void WebMotion::learn_offset(double offset, double now) THIGMA_RT {
  if (count_ == 0) {
    offset_ = offset_before_ = offset;
    offset_since_ = now;
  } else if (now - offset_since_ > 0.5 * params_.offset_memory) {
    offset_before_ = offset_;
    offset_ = offset;
    offset_since_ = now;
  }
  offset_ = std::min(offset_, offset);
}

void WebMotion::add(const WebSample& sample, double now) THIGMA_RT {
  if (hold_ == Hold::never || hold_ == Hold::released) return;
  if (hold_ == Hold::lost) {
    take_up();  // its clutch as it was: to go on takes a new press
    last_read_ = now;
  }
  if (!has_place_) {
    place_first(sample);
    last_read_ = now;
  }
  last_arrival_ = now;
  press(sample.buttons);
  const bool is_later = count_ == 0 || sample.time > back(0).time;
  if (!is_later && sample.time < back(0).time) return;
  if (is_later) learn_offset(now - sample.time, now);
  WebSample placed = sample;
  placed.pose.position = place_.position + (sample.pose.position - page_origin_.position);
  placed.pose.orientation =
      (sample.pose.orientation * page_origin_.orientation.conjugate() * place_.orientation)
          .normalized();
  if (is_later) newest_ = (newest_ + 1) % kHistory;
  history_[newest_] = placed;
  if (is_later) count_ = std::min(count_ + 1, kHistory);
}

Pose WebMotion::target(double now) const THIGMA_RT {
  const double time = now - session_from_page() - params_.delay;
  const WebSample& last = back(0);
  if (count_ == 1) return last.pose;
  if (time >= last.time) {
    const WebSample& before = back(1);
    // What was guessed goes with the weight: a stale handle is where it was last known to be.
    const double ahead = weight_ * std::min(time - last.time, params_.extrapolation);
    // Samples a moment apart say little about a velocity.
    const double span = std::max(last.time - before.time, params_.extrapolation / 4.0);
    return between(before.pose, last.pose, 1.0 + ahead / span);
  }
  for (std::size_t age = 1; age < count_; ++age) {
    const WebSample& a = back(age);
    const WebSample& b = back(age - 1);
    if (time < a.time) continue;
    return between(a.pose, b.pose, (time - a.time) / (b.time - a.time));
  }
  return back(count_ - 1).pose;
}

void WebMotion::follow(const Pose& target, double elapsed) THIGMA_RT {
  const double h = step_of(elapsed);
  if (h <= 0.0) return;
  follow_position(target.position, params_.stiffness, params_.max_speed, h, motion_);
  follow_orientation(target.orientation, params_.stiffness, params_.max_angular_speed, h, motion_);
}

void WebMotion::weigh(double now, double elapsed) THIGMA_RT {
  const double age = now - session_from_page() - back(0).time;
  const double by_age = (params_.stale_age - age) / (params_.stale_age - params_.full_age);
  const double risen = weight_ + step_of(elapsed) / params_.return_time;
  weight_ = std::clamp(std::min(by_age, risen), 0.0, 1.0);
}

DeviceState WebMotion::read(double now) THIGMA_RT {
  DeviceState state;
  state.time = now;
  const double elapsed = now - last_read_;
  last_read_ = now;
  if (hold_ == Hold::held && has_place_ && now - last_arrival_ > params_.lost_after)
    hold_ = Hold::lost;
  if (!has_pose_) {
    state.status = hold_ == Hold::lost ? DeviceStatus::lost : DeviceStatus::not_ready;
    return state;
  }
  if (hold_ == Hold::held && count_ > 0) {
    weigh(now, elapsed);
    follow(target(now), elapsed);
  } else {
    motion_.twist = Twist{};
  }
  state.motion = motion_;
  state.buttons = buttons_;
  buttons_ = next_buttons_;
  is_read_ = true;
  state.weight = weight_;
  if (hold_ == Hold::lost) state.status = DeviceStatus::lost;
  return state;
}

}  // namespace thigma
