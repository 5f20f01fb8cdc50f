#pragma once
// What every traversal of a pair of hierarchies is made of: motion, nodes of the front, tests,
// reports.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>

#include "thigma/contact/detail/node_gap.h"
#include "thigma/contact/detail/patch_pair.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/infinity.h"

namespace thigma::detail {

inline constexpr float kNever = std::numeric_limits<float>::infinity();

struct Traversal {
  const ClodHierarchy& object;
  const ClodHierarchy& scene;
  const ContactQuery& query;
  RelativePose pose;    // object_from_scene
  Mat3 world_rotation;  // of the object
  Vec3 world_position;
  ContactFront& front;
  ContactSet& set;
  std::size_t first;  // contact of this query in the set
  SegmentProbe probe;
  bool full = false;       // contacts are a heap by now
  bool unordered = false;  // some came from a traversal without memory
};

inline const ClodNode& node_a(const Traversal& t, std::int32_t i) noexcept {
  return t.object.nodes[static_cast<std::size_t>(i)];
}
inline const ClodNode& node_b(const Traversal& t, std::int32_t i) noexcept {
  return t.scene.nodes[static_cast<std::size_t>(i)];
}

// ---- travel
// ------------------------------------------------------------

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

inline RelativePose inverse(const RelativePose& p) noexcept {
  RelativePose q;
  q.rotation = p.rotation.transpose();
  q.translation = -(q.rotation * p.translation);
  return q;
}

// Distances between nodes change by no more than points of either body move in the frame of the
// other.
inline double relative_motion(const Traversal& t) noexcept {
  const RelativePose& last = t.front.last;
  const double scene_moves = motion_bound(last, t.pose, t.scene.center, 1.02 * t.scene.radius);
  const double object_moves =
      motion_bound(inverse(last), inverse(t.pose), t.object.center, 1.02 * t.object.radius);
  return std::min(scene_moves, object_moves);
}

inline float round_down(double x) noexcept {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafterf(f, -kNever) : f;
}

inline void set_timer(ContactFront& f, std::int32_t i, double slack) noexcept {
  f.expires[i] = round_down(f.travel + slack);
}

// The scale of travel starts again before single precision costs slack.
inline void rebase(ContactFront& f) noexcept {
  for (std::int32_t i = 0; i < f.used; ++i) {
    f.expires[i] = round_down(static_cast<double>(f.expires[i]) - f.travel);
  }
  f.travel = 0.0;
}

// ---- nodes
// ------------------------------------------------------------

inline std::int32_t take_node(ContactFront& f) noexcept {
  std::int32_t i = f.free_head;
  if (i >= 0) {
    f.free_head = f.nodes[i].next_sibling;
  } else {
    if (f.used == f.capacity) return -1;
    i = f.used++;
  }
  f.nodes[i] = FrontNode{};
  f.expires[i] = kNever;
  ++f.alive;
  return i;
}

inline void free_node(ContactFront& f, std::int32_t i) noexcept {
  f.nodes[i].next_sibling = f.free_head;
  f.nodes[i].a = -1;
  f.expires[i] = kNever;
  f.free_head = i;
  --f.alive;
}

// Gives a pair its children; false, and nothing changes, when there is no room for all.
inline bool split(Traversal& t, std::int32_t i, bool of_a) noexcept {
  ContactFront& f = t.front;
  const ClodNode& parent = of_a ? node_a(t, f.nodes[i].a) : node_b(t, f.nodes[i].b);
  if (f.capacity - f.alive < parent.child_count) return false;
  std::int32_t previous = -1;
  for (std::int32_t c = 0; c < parent.child_count; ++c) {
    const std::int32_t child = take_node(f);
    FrontNode& n = f.nodes[child];
    const FrontNode& up = f.nodes[i];
    n.a = of_a ? parent.first_child + c : up.a;
    n.b = of_a ? up.b : parent.first_child + c;
    n.parent = i;
    for (int k = 0; k < 3; ++k) n.axis[k] = up.axis[k];
    if (previous < 0)
      f.nodes[i].first_child = child;
    else
      f.nodes[previous].next_sibling = child;
    previous = child;
  }
  ++f.split;
  return true;
}

// What a frame starts from.
enum class FrontState : std::uint8_t { kept, empty, no_memory };

// Brings travel up to this pose, or forgets everything: other bodies, another tolerance, another
// kind of query, or a jump, after which descending from the root is cheaper than looking at
// everything.
inline FrontState advance_front(Traversal& t, bool has_levels) noexcept {
  ContactFront& f = t.front;
  if (f.object != &t.object || f.scene != &t.scene || f.capacity == 0) {
    try {
      reserve_front(f, t.object, t.scene);
    } catch (const std::bad_alloc&) {
      return FrontState::no_memory;
    }
  }
  const double smaller = std::min(t.object.radius, t.scene.radius);
  const bool is_known = f.tolerance == t.query.tolerance && f.has_levels == has_levels;
  if (is_known) {
    f.last_step = relative_motion(t);
    f.travel += f.last_step;
    if (f.travel > 1000.0 * (f.tolerance + 1e-3 * smaller)) rebase(f);
  }
  if (is_known && f.last_step < 0.5 * smaller) return FrontState::kept;
  clear_front(f);
  f.tolerance = t.query.tolerance;
  f.has_levels = has_levels;
  return FrontState::empty;
}

inline bool is_leaf_pair(const Traversal& t, std::int32_t a, std::int32_t b) noexcept {
  return node_a(t, a).child_count == 0 && node_b(t, b).child_count == 0;
}

// ---- tests
// ------------------------------------------------------------

// By how much a pair misses d_ab = d + h(a) + h(b) (Eq. 3.5), at least; <= 0: not culled. Stops at
// the first bound that outlives the next frame.
inline double slack_of(Traversal& t, FrontNode& n) noexcept {
  ++t.set.stats.tests;
  const double reach = t.query.tolerance + node_a(t, n.a).hausdorff + node_b(t, n.b).hausdorff;
  const NodePair pair = place(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose);
  double slack = sphere_gap(pair) - reach;
  const double enough = t.front.last_step;
  if (slack > enough) return slack;
  if (n.axis[0] != 0.0f || n.axis[1] != 0.0f || n.axis[2] != 0.0f) {
    slack = std::max(slack, axis_gap(pair, t.pose, n.axis) - reach);
    if (slack > enough) return slack;
  }
  ++t.set.stats.pair_queries;
  if (n.gjk.count == 0) start_along(pair, t.pose, n.axis, n.gjk);
  const Separation s = closest_points(pair.a, pair.b, t.pose, kInfinity, n.gjk);
  if (s.status == GjkStatus::overlapping || !(s.distance > 0.0)) return std::max(slack, -reach);
  const Vec3 axis = (s.witness_b - s.witness_a) / s.distance;
  if (!n.has_normal) {
    for (int i = 0; i < 3; ++i) n.axis[i] = static_cast<float>(axis[i]);
  }
  const double rounding = pair.rounding + 1e-11 * (pair.a.radius + pair.b.radius);
  if (s.status == GjkStatus::gave_up) {
    return std::max(slack, axis_gap(pair, t.pose, n.axis) - reach);
  }
  return std::max(slack, s.distance - rounding - reach);
}

// ---- contacts
// ------------------------------------------------------------

inline bool is_before(const Contact& x, const Contact& y) noexcept {
  return x.object_patch != y.object_patch ? x.object_patch < y.object_patch
                                          : x.scene_patch < y.scene_patch;
}

// Heap order of a full set: the least worth keeping on top.
inline bool is_deeper(const Contact& x, const Contact& y) noexcept {
  return x.depth != y.depth ? x.depth > y.depth : is_before(x, y);
}

inline ContactStatus status_of(PairContactStatus status) noexcept {
  switch (status) {
    case PairContactStatus::apart:
    case PairContactStatus::separated:
      return ContactStatus::separated;
    case PairContactStatus::penetrating:
      return ContactStatus::penetrating;
    case PairContactStatus::deep:
      return ContactStatus::deep;
    case PairContactStatus::beside:
      return ContactStatus::beside;
  }
  return ContactStatus::separated;
}

inline std::int32_t patch_id(const ClodHierarchy& h, const ClodNode& node) noexcept {
  return node.patch >= 0 ? node.patch : static_cast<std::int32_t>(h.patches.size()) + node.contact;
}

inline Contact make_contact(const Traversal& t, const FrontNode& n,
                            const PatchPair& pair) noexcept {
  Contact c;
  c.point = t.world_rotation * pair.witness_a + t.world_position;
  c.scene_point = t.world_rotation * pair.witness_b + t.world_position;
  c.normal = t.world_rotation * pair.normal;
  c.depth = pair.depth;
  c.body = t.query.body;
  c.object_patch = patch_id(t.object, node_a(t, n.a));
  c.scene_patch = patch_id(t.scene, node_b(t, n.b));
  c.object_level = node_a(t, n.a).level;
  c.scene_level = node_b(t, n.b).level;
  c.status = status_of(pair.status);
  return c;
}

// Keeps the deepest of more contacts than fit.
inline void report(Traversal& t, const Contact& c) noexcept {
  std::vector<Contact>& all = t.set.contacts;
  if (all.size() < all.capacity()) {
    all.push_back(c);
    return;
  }
  ++t.set.dropped;
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(t.first);
  if (begin == all.end()) return;
  if (!t.full) std::make_heap(begin, all.end(), is_deeper);
  t.full = true;
  if (!is_deeper(c, *begin)) return;
  std::pop_heap(begin, all.end(), is_deeper);
  all.back() = c;
  std::push_heap(begin, all.end(), is_deeper);
}

}  // namespace thigma::detail
