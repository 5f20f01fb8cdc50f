#include "viewer/server/world_feed.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "viewer/server/detail/wire.h"
#include "viewer/server/protocol.h"

namespace thigma::live {
namespace {

Pose pose_of(const BodyState& y) { return {y.position, y.orientation}; }

/// What the device of a hand was sent.
const Wrench& sent_to(const WorldFrame& frame, std::size_t hand) {
  return frame.haptic.ticks > 0 ? frame.haptic.sent[hand] : frame.commands[hand];
}

ViewedHand viewed_hand(const WorldView& view, const WorldFrame& frame, std::size_t i) {
  const WorldGrip& grip = frame.grips[i];
  ViewedHand hand;
  hand.handle = frame.handles[i].pose;
  hand.grasp_point = hand.handle.position;
  hand.body = grip.body;
  hand.is_page = static_cast<std::int32_t>(i) == view.page_hand;
  hand.force = view.workspaces[i].world_from_device.orientation * sent_to(frame, i).force;
  if (grip.body < 0) return hand;
  const auto body = static_cast<std::size_t>(grip.body);
  hand.grasp_point = transform_point(pose_of(frame.bodies[body]), grip.body_from_grasp.position);
  hand.ghost = hand.handle * inverse(grip.body_from_grasp) * view.body_from_mesh[body];
  return hand;
}

/// The page's hand while it holds something, else the first that does, else the page's.
std::int32_t hand_to_show(const WorldView& view, const std::vector<ViewedHand>& hands) {
  const auto holds = [&](std::int32_t i) { return hands[static_cast<std::size_t>(i)].body >= 0; };
  if (view.page_hand >= 0 && holds(view.page_hand)) return view.page_hand;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(hands.size()); ++i)
    if (holds(i)) return i;
  return view.page_hand;
}

}  // namespace

void WorldFeed::begin_session(const WorldView& view) {
  view_ = view;
  last_ = -1;
  rows_.clear();
  rows_near_ = 0;
  const std::lock_guard lock(mutex_);
  has_next_ = false;
}

void WorldFeed::observe(std::span<const WorldRow> rows, std::size_t near) {
  rows_.assign(rows.begin(), rows.end());
  rows_near_ = near;
}

HapticSample WorldFeed::observe(const WorldFrame& frame) {
  draft_.time = frame.time;
  draft_.frame = frame.frame;
  draft_.bodies.resize(frame.bodies.size());
  for (std::size_t i = 0; i < frame.bodies.size(); ++i)
    draft_.bodies[i] = pose_of(frame.bodies[i]) * view_.body_from_mesh[i];
  draft_.is_asleep.assign(frame.is_asleep.begin(), frame.is_asleep.end());
  draft_.hands.clear();
  for (std::size_t i = 0; i < frame.grips.size(); ++i)
    draft_.hands.push_back(viewed_hand(view_, frame, i));
  draft_.shown_hand = hand_to_show(view_, draft_.hands);
  draft_.haptic_ticks = frame.haptic.ticks;
  draft_.haptic_missed = frame.haptic.missed;
  draft_.step_cpu = frame.step_cpu;
  draft_.rows = rows_;
  draft_.rows_near = rows_near_;

  HapticSample sample;
  sample.frame = frame.frame;
  sample.time = frame.time;
  sample.elapsed = 1.0 / view_.rate;
  sample.model_age = std::numeric_limits<double>::infinity();
  sample.model_weight = 1.0;
  sample.penetration = -std::numeric_limits<double>::infinity();
  const bool is_apart = frame.haptic.ticks > 0;
  sample.step_cpu = static_cast<float>(is_apart ? frame.haptic.step_cpu : frame.step_cpu);
  sample.wake_late = static_cast<float>(static_cast<double>(frame.lost) / view_.rate);
  if (draft_.shown_hand >= 0) {
    const auto k = static_cast<std::size_t>(draft_.shown_hand);
    const ViewedHand& hand = draft_.hands[k];
    if (hand.body >= 0) last_ = hand.body;
    sample.device = frame.grips[k].device;
    sample.handle = frame.handles[k];
    sample.feedback = sample.command = sent_to(frame, k);
    sample.is_grasped = sample.is_armed = hand.body >= 0;
    sample.stretch = (hand.handle.position - hand.grasp_point).norm();
    sample.energy = frame.grips[k].energy;
  }
  if (last_ >= 0) sample.body = frame.bodies[static_cast<std::size_t>(last_)];
  draft_.shown_body = last_;
  if (const std::unique_lock lock(mutex_, std::try_to_lock); lock.owns_lock()) {
    std::swap(draft_, next_);
    has_next_ = true;
  }
  return sample;
}

const WorldNow* WorldFeed::newest() {
  {
    const std::lock_guard lock(mutex_);
    if (has_next_) {
      std::swap(next_, now_);
      has_next_ = false;
      has_now_ = true;
    }
  }
  return has_now_ ? &now_ : nullptr;
}

void WorldFeed::forget() {
  const std::lock_guard lock(mutex_);
  has_next_ = has_now_ = false;
}

void WorldFeed::carry(std::vector<Pose> bodies, std::span<const std::int32_t> was) {
  if (newest() == nullptr) return;
  const auto renumber = [&](std::int32_t& body) {
    const auto found = std::find(was.begin(), was.end(), body);
    body = body < 0 || found == was.end() ? -1 : static_cast<std::int32_t>(found - was.begin());
  };
  now_.bodies = std::move(bodies);
  now_.is_asleep.assign(now_.bodies.size(), 0);
  now_.rows.clear();
  now_.rows_near = 0;
  for (ViewedHand& hand : now_.hands) renumber(hand.body);
  renumber(now_.shown_body);
}

std::string encode_bodies(const WorldNow& now) {
  using namespace detail;
  std::string out;
  put_header(out, MessageKind::bodies, 0, now.bodies.size(), now.time);
  put(out, static_cast<double>(now.frame));
  put(out, static_cast<std::uint32_t>(now.hands.size()));
  put(out, std::uint32_t{0});
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    put_pose(out, now.bodies[i]);
    put(out, static_cast<std::uint32_t>(now.is_asleep[i] != 0 ? 1 : 0));
  }
  for (const ViewedHand& hand : now.hands) {
    put_pose(out, hand.handle);
    put_vector(out, hand.grasp_point);
    put_vector(out, hand.force);
    put(out, hand.body);
    put(out, static_cast<std::uint32_t>(hand.is_page ? 1 : 0));
    put(out, std::uint32_t{0});
  }
  return out;
}

}  // namespace thigma::live
