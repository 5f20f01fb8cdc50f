#pragma once
// The tree of node pairs in a front, and how long its decisions hold: travel, timers, nodes.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>

#include "thigma/contact/detail/carry_contacts.h"
#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

inline constexpr float kNever = std::numeric_limits<float>::infinity();

// How far any point within `radius` of `center` in the frame of b moved in the frame of a, at most.
inline double motion_bound(const RelativePose& from, const RelativePose& to, const Vec3& center,
                           double radius) noexcept {
  const Mat3 turn = to.rotation - from.rotation;
  // A difference of rotations stretches by its Frobenius norm over sqrt(2): two equal singular
  // values and a zero.
  const double stretch = std::sqrt(0.5 * turn.squaredNorm());
  const Vec3 shift = turn * center + (to.translation - from.translation);
  const double rounding = 1e-14 * (center.lpNorm<1>() + to.translation.lpNorm<1>() + radius);
  return (std::sqrt(shift.squaredNorm()) + stretch * radius) * (1.0 + 1e-9) + rounding;
}

inline RelativePose inverse(const RelativePose& pose) noexcept {
  RelativePose back;
  back.rotation = pose.rotation.transpose();
  back.translation = -(back.rotation * pose.translation);
  return back;
}

// Distances between nodes change by no more than points of either body move in the frame of the
// other.
inline double relative_motion(const QueryFrame& frame) noexcept {
  const RelativePose& last = frame.front.last;
  const double scene_moves =
      motion_bound(last, frame.pose, frame.scene.center, 1.02 * frame.scene.radius);
  const double object_moves = motion_bound(inverse(last), inverse(frame.pose), frame.object.center,
                                           1.02 * frame.object.radius);
  return std::min(scene_moves, object_moves);
}

// The largest float that is no larger than x, where x is not negative; a float that is not
// positive, where it is: times that have passed are all the same. Without a branch or a call, as a
// tolerance that changes asks it of every node.
inline float round_down(double x) noexcept {
  const auto nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits - static_cast<std::int32_t>(static_cast<double>(nearest) > x));
}

// The smallest float that is no smaller than x, which is not negative.
inline float round_up(double x) noexcept {
  const auto nearest = static_cast<float>(x);
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits + static_cast<std::int32_t>(static_cast<double>(nearest) < x));
}

inline void set_timer(ContactFront& front, std::int32_t i, double slack) noexcept {
  front.expires[i] = round_down(front.travel + slack);
}

// The scale of travel starts again before single precision costs slack.
inline void rebase(ContactFront& front) noexcept {
  for (std::int32_t i = 0; i < front.used; ++i) {
    front.expires[i] = round_down(static_cast<double>(front.expires[i]) - front.travel);
  }
  front.travel = 0.0;
  forget_carried(front);
}

inline std::int32_t take_node(ContactFront& front) noexcept {
  std::int32_t i = front.free_head;
  if (i >= 0) {
    front.free_head = front.nodes[i].next_sibling;
  } else {
    if (front.used == front.capacity) return -1;
    i = front.used++;
  }
  front.nodes[i] = FrontNode{};
  front.expires[i] = kNever;
  ++front.alive;
  return i;
}

inline void free_node(ContactFront& front, std::int32_t i) noexcept {
  drop_carried(front.carried, i);
  front.nodes[i].next_sibling = front.free_head;
  front.nodes[i].a = -1;
  front.expires[i] = kNever;
  front.free_head = i;
  --front.alive;
}

// Gives a pair its children; false, and nothing changes, when there is no room for all.
inline bool split(QueryFrame& frame, std::int32_t i, bool of_a) noexcept {
  ContactFront& front = frame.front;
  const ClodNode& parent = of_a ? node_a(frame, front.nodes[i].a) : node_b(frame, front.nodes[i].b);
  if (front.capacity - front.alive < parent.child_count) return false;
  std::int32_t previous = -1;
  for (std::int32_t c = 0; c < parent.child_count; ++c) {
    const std::int32_t child = take_node(front);
    FrontNode& node = front.nodes[child];
    const FrontNode& up = front.nodes[i];
    node.a = of_a ? parent.first_child + c : up.a;
    node.b = of_a ? up.b : parent.first_child + c;
    node.parent = i;
    for (int k = 0; k < 3; ++k) node.axis[k] = up.axis[k];
    if (previous < 0)
      front.nodes[i].first_child = child;
    else
      front.nodes[previous].next_sibling = child;
    previous = child;
  }
  ++front.split;
  return true;
}

// What a frame starts from.
enum class FrontState : std::uint8_t { kept, empty, no_memory };

// Timers for another tolerance. What was culled by s is culled by less where the tolerance is
// larger, and the other way round. With levels the same is so of what was open; in an exact query
// that is a split pair, and when it may rise is only a question of cost: all timers move alike, so
// that none of the nodes has to be read.
inline void retarget(ContactFront& front, double tolerance) noexcept {
  const double change = tolerance - front.tolerance;
  if (front.has_levels) {
    for (std::int32_t i = 0; i < front.used; ++i) {
      const FrontNode& node = front.nodes[i];
      if (node.a < 0 || front.expires[i] == kNever) continue;
      const bool is_open = node.decision == FrontNode::Decision::open;
      if (!is_open && node.first_child >= 0) continue;
      const double by = is_open ? change : -change;
      front.expires[i] = round_down(static_cast<double>(front.expires[i]) + by);
    }
  } else {
    for (std::int32_t i = 0; i < front.used; ++i)
      front.expires[i] = round_down(static_cast<double>(front.expires[i]) - change);
  }
  front.tolerance = tolerance;
  forget_depths(front);
}

// Whether the tolerance of a query with too many pairs may be halved again, after so many times.
inline bool may_halve(const ContactQuery& query, int halvings) noexcept {
  constexpr int kMost = 6;
  return query.most_pairs > 0 && halvings < kMost && 0.5 * query.tolerance >= query.least_tolerance;
}

// Brings travel up to this pose, or forgets everything: other bodies, another kind of query, or a
// jump, after which descending from the root is cheaper than looking at everything.
inline FrontState advance_front(QueryFrame& frame, bool has_levels) noexcept {
  ContactFront& front = frame.front;
  const bool is_new =
      front.object != &frame.object || front.scene != &frame.scene || front.capacity == 0;
  const bool lacks_carried = frame.query.resolution.carry > 0.0 && front.carried.place == nullptr;
  if (is_new || lacks_carried) {
    try {
      if (is_new) reserve_front(front, frame.object, frame.scene);
      if (frame.query.resolution.carry > 0.0) reserve_carried(front);
    } catch (const std::bad_alloc&) {
      return FrontState::no_memory;
    }
  }
  const double smaller = std::min(frame.object.radius, frame.scene.radius);
  if (front.tolerance >= 0.0 && front.has_levels == has_levels &&
      front.tolerance != frame.query.tolerance)
    retarget(front, frame.query.tolerance);
  const bool is_known = front.tolerance == frame.query.tolerance && front.has_levels == has_levels;
  if (is_known) {
    front.last_step = relative_motion(frame);
    front.travel += front.last_step;
    if (front.travel > 1000.0 * (front.tolerance + 1e-3 * smaller)) rebase(front);
  }
  if (is_known && front.last_step < 0.5 * smaller) return FrontState::kept;
  clear_front(front);
  front.tolerance = frame.query.tolerance;
  front.has_levels = has_levels;
  return FrontState::empty;
}

}  // namespace thigma::detail
