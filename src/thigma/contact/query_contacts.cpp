#include "thigma/contact/query_contacts.h"

#include <emmintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "thigma/contact/detail/node_gap.h"
#include "thigma/contact/detail/patch_pair.h"
#include "thigma/contact/surface_crossing.h"

// Sec. 3.4.1-3.4.2 with generalized front tracking (Ehmann and Lin 2001). Each decision of the traversal (this pair is
// farther apart than d_ab, that one is not) is kept with the motion it survives: a pair that misses its tolerance by s
// has to be looked at again only when the bodies may have moved by s against each other. A frame is then one pass
// over an array of numbers, tests of the few pairs whose time has come, and the contacts themselves, which are
// measured every frame and from nothing but the pose.

namespace thigma {
namespace {

using detail::NodePair;
using detail::PatchPair;

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Traversal {
  const ClodHierarchy& object;
  const ClodHierarchy& scene;
  const ContactQuery& query;
  RelativePose pose;     // object_from_scene
  Mat3 world_rotation;   // of the object
  Vec3 world_position;
  ContactFront& front;
  ContactSet& set;
  std::size_t first;     // contact of this query in the set
  SegmentProbe probe;
  bool full = false;     // contacts are a heap by now
  bool unordered = false;  // some came from a traversal without memory
};

const ClodNode& node_a(const Traversal& t, std::int32_t i) noexcept { return t.object.nodes[static_cast<std::size_t>(i)]; }
const ClodNode& node_b(const Traversal& t, std::int32_t i) noexcept { return t.scene.nodes[static_cast<std::size_t>(i)]; }

// ---- travel -----------------------------------------------------------------------------------------------------

// How far any point within `radius` of `center` in the frame of b moved in the frame of a, at most.
double motion_bound(const RelativePose& from, const RelativePose& to, const Vec3& center, double radius) noexcept {
  const Mat3 turn = to.rotation - from.rotation;
  // A difference of rotations stretches by its Frobenius norm over sqrt(2): two equal singular values and a zero.
  const double stretch = std::sqrt(0.5 * turn.squaredNorm());
  const Vec3 shift = turn * center + (to.translation - from.translation);
  const double rounding = 1e-14 * (center.lpNorm<1>() + to.translation.lpNorm<1>() + radius);
  return (std::sqrt(shift.squaredNorm()) + stretch * radius) * (1.0 + 1e-9) + rounding;
}

RelativePose inverse(const RelativePose& p) noexcept {
  RelativePose q;
  q.rotation = p.rotation.transpose();
  q.translation = -(q.rotation * p.translation);
  return q;
}

// Distances between nodes change by no more than points of either body move in the frame of the other.
double relative_motion(const Traversal& t) noexcept {
  const RelativePose& last = t.front.last;
  const double scene_moves = motion_bound(last, t.pose, t.scene.center, 1.02 * t.scene.radius);
  const double object_moves = motion_bound(inverse(last), inverse(t.pose), t.object.center, 1.02 * t.object.radius);
  return std::min(scene_moves, object_moves);
}

float round_down(double x) noexcept {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafterf(f, -kNever) : f;
}

void set_timer(ContactFront& f, std::int32_t i, double slack) noexcept { f.expires[i] = round_down(f.travel + slack); }

// The scale of travel starts again before single precision costs slack.
void rebase(ContactFront& f) noexcept {
  for (std::int32_t i = 0; i < f.used; ++i) {
    f.expires[i] = round_down(static_cast<double>(f.expires[i]) - f.travel);
  }
  f.travel = 0.0;
}

// ---- nodes ------------------------------------------------------------------------------------------------------

std::int32_t take_node(ContactFront& f) noexcept {
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

void free_node(ContactFront& f, std::int32_t i) noexcept {
  f.nodes[i].next_sibling = f.free_head;
  f.nodes[i].a = -1;
  f.expires[i] = kNever;
  f.free_head = i;
  --f.alive;
}

bool is_leaf_pair(const Traversal& t, std::int32_t a, std::int32_t b) noexcept {
  return node_a(t, a).child_count == 0 && node_b(t, b).child_count == 0;
}

// The larger of the two is split; the rule sees the pair only, so every pair is reached in one way.
bool splits_a(const Traversal& t, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode& na = node_a(t, a);
  const ClodNode& nb = node_b(t, b);
  if (na.child_count == 0) return false;
  if (nb.child_count == 0) return true;
  return na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
}

// ---- tests ------------------------------------------------------------------------------------------------------

// By how much a pair misses d_ab = d + h(a) + h(b) (Eq. 3.5), at least; <= 0: not culled. Stops at the first bound
// that outlives the next frame.
double slack_of(Traversal& t, FrontNode& n) noexcept {
  ++t.set.stats.tests;
  const double reach = t.query.tolerance + node_a(t, n.a).hausdorff + node_b(t, n.b).hausdorff;
  const NodePair pair = detail::place(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose);
  double slack = detail::sphere_gap(pair) - reach;
  const double enough = t.front.last_step;
  if (slack > enough) return slack;
  if (n.axis[0] != 0.0f || n.axis[1] != 0.0f || n.axis[2] != 0.0f) {
    slack = std::max(slack, detail::axis_gap(pair, t.pose, n.axis) - reach);
    if (slack > enough) return slack;
  }
  ++t.set.stats.pair_queries;
  const Separation s = closest_points(pair.a, pair.b, t.pose, kInfinity, n.gjk);
  if (s.status == PairStatus::overlapping || !(s.distance > 0.0)) return std::max(slack, -reach);
  const Vec3 axis = (s.witness_b - s.witness_a) / s.distance;
  if (!n.has_normal) {
    for (int i = 0; i < 3; ++i) n.axis[i] = static_cast<float>(axis[i]);
  }
  const double rounding = pair.rounding + 1e-11 * (pair.a.radius + pair.b.radius);
  if (s.status == PairStatus::gave_up) {
    return std::max(slack, detail::axis_gap(pair, t.pose, n.axis) - reach);
  }
  return std::max(slack, s.distance - rounding - reach);
}

// ---- contacts ---------------------------------------------------------------------------------------------------

bool is_before(const Contact& x, const Contact& y) noexcept {
  return x.object_patch != y.object_patch ? x.object_patch < y.object_patch : x.scene_patch < y.scene_patch;
}

// Heap order of a full set: the least worth keeping on top.
bool is_deeper(const Contact& x, const Contact& y) noexcept {
  return x.depth != y.depth ? x.depth > y.depth : is_before(x, y);
}

ContactStatus status_of(PairContactStatus status) noexcept {
  switch (status) {
    case PairContactStatus::apart:
    case PairContactStatus::separated: return ContactStatus::separated;
    case PairContactStatus::penetrating: return ContactStatus::penetrating;
    case PairContactStatus::deep: return ContactStatus::deep;
    case PairContactStatus::beside: return ContactStatus::beside;
  }
  return ContactStatus::separated;
}

void report(Traversal& t, const FrontNode& n, const PatchPair& pair) noexcept {
  Contact c;
  c.point = t.world_rotation * pair.witness_a + t.world_position;
  c.scene_point = t.world_rotation * pair.witness_b + t.world_position;
  c.normal = t.world_rotation * pair.normal;
  c.depth = pair.depth;
  c.body = t.query.body;
  c.object_patch = node_a(t, n.a).patch;
  c.scene_patch = node_b(t, n.b).patch;
  c.object_level = node_a(t, n.a).level;
  c.scene_level = node_b(t, n.b).level;
  c.status = status_of(pair.status);
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

// Measures a leaf pair, reports it when it is a contact, returns its slack (<= 0 for a contact).
double measure_leaf(Traversal& t, FrontNode& n) noexcept {
  ++t.set.stats.tests;
  const PatchPair pair = detail::measure_patches(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose,
                                                 t.query.tolerance, t.query.keep_directions, t.probe, n, t.set.stats);
  if (pair.status == PairContactStatus::apart) return -pair.depth - t.query.tolerance;
  report(t, n, pair);
  return 0.0;
}

// ---- traversal without memory -----------------------------------------------------------------------------------

std::int64_t packed(std::int32_t a, std::int32_t b) noexcept {
  return (static_cast<std::int64_t>(a) << 32) | static_cast<std::uint32_t>(b);
}

// Everything below a pair that the front has no room for. The stack was reserved for the depth of both trees.
void traverse_below(Traversal& t, std::int32_t a, std::int32_t b) noexcept {
  std::vector<std::int64_t>& stack = t.front.stack;
  stack.clear();
  stack.push_back(packed(a, b));
  while (!stack.empty()) {
    FrontNode n;
    n.a = static_cast<std::int32_t>(stack.back() >> 32);
    n.b = static_cast<std::int32_t>(stack.back() & 0xffffffff);
    stack.pop_back();
    if (is_leaf_pair(t, n.a, n.b)) {
      measure_leaf(t, n);
      continue;
    }
    if (slack_of(t, n) > 0.0) continue;
    const bool of_a = splits_a(t, n.a, n.b);
    const ClodNode& parent = of_a ? node_a(t, n.a) : node_b(t, n.b);
    for (std::int32_t c = 0; c < parent.child_count; ++c) {
      const std::int32_t child = parent.first_child + c;
      stack.push_back(of_a ? packed(child, n.b) : packed(n.a, child));
    }
  }
}

// ---- descending and rising --------------------------------------------------------------------------------------

void activate(Traversal& t, std::int32_t i) noexcept {
  ContactFront& f = t.front;
  f.nodes[i].is_active = true;
  f.expires[i] = kNever;
  f.incoming.push_back(i);
}

// Gives a pair its children; false, and nothing changes, when there is no room for all.
bool split(Traversal& t, std::int32_t i) noexcept {
  ContactFront& f = t.front;
  const bool of_a = splits_a(t, f.nodes[i].a, f.nodes[i].b);
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
    if (previous < 0) f.nodes[i].first_child = child;
    else f.nodes[previous].next_sibling = child;
    previous = child;
  }
  ++f.split;
  return true;
}

// Looks at pair i of the front and everything below it that has to be. f.work above `base` is the stack.
void descend(Traversal& t, std::int32_t i) noexcept {
  ContactFront& f = t.front;
  const std::size_t base = f.work.size();
  f.work.push_back(i);
  while (f.work.size() > base) {
    const std::int32_t k = f.work.back();
    f.work.pop_back();
    FrontNode& n = f.nodes[k];
    const double slack = slack_of(t, n);
    if (slack > 0.0) {
      set_timer(f, k, slack);
    } else if (is_leaf_pair(t, n.a, n.b)) {
      activate(t, k);
    } else if (split(t, k)) {
      // It can only rise again once the bodies moved by what it lacks; a quarter of the tolerance keeps it from
      // going back and forth.
      set_timer(f, k, -slack + 0.25 * t.query.tolerance);
      for (std::int32_t c = f.nodes[k].first_child; c >= 0; c = f.nodes[c].next_sibling) f.work.push_back(c);
    } else {
      f.nodes[k].is_saturated = true;
      f.expires[k] = kNever;
      f.saturated.push_back(k);
    }
  }
}

// A split pair rises when all its children are culled and it is itself.
void try_to_rise(Traversal& t, std::int32_t i) noexcept {
  ContactFront& f = t.front;
  FrontNode& n = f.nodes[i];
  bool all_culled = true;
  for (std::int32_t c = n.first_child; c >= 0 && all_culled; c = f.nodes[c].next_sibling) {
    const FrontNode& child = f.nodes[c];
    all_culled = child.first_child < 0 && !child.is_active && !child.is_saturated;
  }
  const double slack = all_culled ? slack_of(t, n) : 0.0;
  if (slack <= 0.0) {
    set_timer(f, i, std::max({-slack, 0.25 * t.query.tolerance, 8.0 * f.last_step}));
    return;
  }
  for (std::int32_t c = n.first_child; c >= 0;) {
    const std::int32_t next = f.nodes[c].next_sibling;
    free_node(f, c);
    c = next;
  }
  n.first_child = -1;
  --f.split;
  set_timer(f, i, slack);
}

// Nodes whose time has come, into f.work.
void collect_expired(ContactFront& f) noexcept {
  const auto now = static_cast<float>(f.travel * (1.0 + 1e-6));
  const __m128 limit = _mm_set1_ps(now);
  std::int32_t i = 0;
  for (; i + 4 <= f.used; i += 4) {
    int mask = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(f.expires.get() + i), limit));
    for (int k = 0; mask != 0; ++k, mask >>= 1) {
      if (mask & 1) f.work.push_back(i + k);
    }
  }
  for (; i < f.used; ++i) {
    if (f.expires[i] <= now) f.work.push_back(i);
  }
}

void update_front(Traversal& t) noexcept {
  ContactFront& f = t.front;
  f.work.clear();
  collect_expired(f);
  // From the back: children mostly follow their parents, so a parent sees what became of them.
  while (!f.work.empty()) {
    const std::int32_t i = f.work.back();
    f.work.pop_back();
    if (f.nodes[i].a < 0 || f.expires[i] == kNever) continue;  // freed meanwhile
    if (f.nodes[i].first_child >= 0) try_to_rise(t, i);
    else descend(t, i);
  }
}

// ---- leaf pairs -------------------------------------------------------------------------------------------------

std::int64_t key_of(const Traversal& t, std::int32_t i) noexcept {
  const FrontNode& n = t.front.nodes[i];
  return packed(node_a(t, n.a).patch, node_b(t, n.b).patch);
}

// Measures the active leaf pairs in the order of their patches; those that left the tolerance fall asleep.
void measure_active(Traversal& t) noexcept {
  ContactFront& f = t.front;
  std::sort(f.incoming.begin(), f.incoming.end(),
            [&](std::int32_t x, std::int32_t y) { return key_of(t, x) < key_of(t, y); });
  f.next_active.clear();
  std::size_t old = 0, fresh = 0;
  while (old < f.active.size() || fresh < f.incoming.size()) {
    const bool take_old = fresh == f.incoming.size() ||
                          (old < f.active.size() && key_of(t, f.active[old]) < key_of(t, f.incoming[fresh]));
    const std::int32_t i = take_old ? f.active[old++] : f.incoming[fresh++];
    const double slack = measure_leaf(t, f.nodes[i]);
    if (slack > 0.0) {
      f.nodes[i].is_active = false;
      set_timer(f, i, slack);
    } else {
      f.next_active.push_back(i);
    }
  }
  f.active.swap(f.next_active);
  f.incoming.clear();
}

void traverse_saturated(Traversal& t) noexcept {
  ContactFront& f = t.front;
  std::size_t kept = 0;
  for (const std::int32_t i : f.saturated) {
    FrontNode& n = f.nodes[i];
    const double slack = slack_of(t, n);
    if (slack > 0.0) {
      n.is_saturated = false;
      set_timer(f, i, slack);
      continue;
    }
    traverse_below(t, n.a, n.b);
    t.unordered = true;
    if (f.alive < f.capacity / 2) {  // room again: split it next frame
      n.is_saturated = false;
      set_timer(f, i, 0.0);
    } else {
      f.saturated[kept++] = i;
    }
  }
  f.saturated.resize(kept);
}

// ---- frames -----------------------------------------------------------------------------------------------------

bool start_frame(Traversal& t) noexcept {
  ContactFront& f = t.front;
  if (f.object != &t.object || f.scene != &t.scene || f.capacity == 0) {
    try {
      reserve_front(f, t.object, t.scene);
    } catch (const std::bad_alloc&) {
      return false;
    }
  }
  const double smaller = std::min(t.object.radius, t.scene.radius);
  if (f.tolerance == t.query.tolerance) {
    f.last_step = relative_motion(t);
    f.travel += f.last_step;
    if (f.travel > 1000.0 * (f.tolerance + 1e-3 * smaller)) rebase(f);
  }
  // A jump: descending from the root is cheaper than looking at everything.
  if (f.tolerance != t.query.tolerance || !(f.last_step < 0.5 * smaller)) {
    clear_front(f);
    f.tolerance = t.query.tolerance;
    descend(t, take_node(f));
  } else {
    update_front(t);
  }
  f.last = t.pose;
  return true;
}

bool is_answerable(const ClodHierarchy& object, const ClodHierarchy& scene, const ContactQuery& query,
                   const RelativePose& pose) noexcept {
  return !object.nodes.empty() && !scene.nodes.empty() && query.tolerance >= 0.0 && pose.rotation.allFinite() &&
         pose.translation.allFinite();
}

}  // namespace

void query_contacts(const ClodHierarchy& object, const Pose& world_from_object, const ClodHierarchy& scene,
                    const Pose& world_from_scene, const ContactQuery& query, ContactFront& front,
                    ContactSet& contacts) noexcept {
  const RelativePose pose = relative_pose(world_from_object, world_from_scene);
  if (!is_answerable(object, scene, query, pose)) return;
  CrossingContext crossing{&object, &scene, pose};
  Traversal t{object, scene, query, pose, world_from_object.orientation.toRotationMatrix(),
              world_from_object.position, front, contacts, contacts.contacts.size(), crossing_probe(crossing)};
  if (!start_frame(t)) return;
  crossing.object_closed = front.object_closed;
  crossing.scene_closed = front.scene_closed;
  measure_active(t);
  traverse_saturated(t);
  const auto begin = contacts.contacts.begin() + static_cast<std::ptrdiff_t>(t.first);
  if (t.full || t.unordered) std::sort(begin, contacts.contacts.end(), is_before);
  contacts.stats.front += front.alive - front.split;
}

QueryStats track_front(const ClodHierarchy& object, const Pose& world_from_object, const ClodHierarchy& scene,
                       const Pose& world_from_scene, const ContactQuery& query, ContactFront& front) noexcept {
  ContactSet none;
  const RelativePose pose = relative_pose(world_from_object, world_from_scene);
  if (!is_answerable(object, scene, query, pose)) return none.stats;
  Traversal t{object, scene, query, pose, Mat3::Identity(), Vec3::Zero(), front, none, 0, {}};
  if (!start_frame(t)) return none.stats;
  none.stats.front = front.alive - front.split;
  return none.stats;
}

void query_scene(const ClodHierarchy& object, const Pose& world_from_object, std::span<const SceneBody> bodies,
                 const ContactQuery& query, std::span<ContactFront> fronts, ContactSet& contacts) noexcept {
  clear(contacts);
  ContactQuery one = query;
  const std::size_t count = std::min(bodies.size(), fronts.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (bodies[i].hierarchy == nullptr) continue;
    one.body = static_cast<std::int32_t>(i);
    query_contacts(object, world_from_object, *bodies[i].hierarchy, bodies[i].world_from_body, one, fronts[i],
                   contacts);
  }
}

double least_distance(const ContactSet& contacts) noexcept {
  double least = kInfinity;
  for (const Contact& c : contacts.contacts) least = std::min(least, -c.depth);
  return least;
}

}  // namespace thigma
