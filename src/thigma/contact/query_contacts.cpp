#include "thigma/contact/query_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <emmintrin.h>

#include "thigma/contact/detail/level_query.h"
#include "thigma/contact/detail/traversal.h"
#include "thigma/contact/surface_crossing.h"

// Sec. 3.4.1-3.4.2 with generalized front tracking (Ehmann and Lin 2001). Each decision of the
// traversal (this pair is farther apart than d_ab, that one is not) is kept with the motion it
// survives: a pair that misses its tolerance by s has to be looked at again only when the bodies
// may have moved by s against each other. A frame is then one pass over an array of numbers, tests
// of the few pairs whose time has come, and the contacts themselves, which are measured every frame
// and from nothing but the pose.

namespace thigma {
namespace {

using namespace detail;

// The larger of the two is split; the rule sees the pair only, so every pair is reached in one way.
bool splits_a(const Traversal& t, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode& na = node_a(t, a);
  const ClodNode& nb = node_b(t, b);
  if (na.child_count == 0) return false;
  if (nb.child_count == 0) return true;
  return na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
}

// ---- contacts
// ------------------------------------------------------------

// Measures a leaf pair, reports it when it is a contact, returns its slack (<= 0 for a contact).
double measure_leaf(Traversal& t, FrontNode& n) noexcept {
  ++t.set.stats.tests;
  const PatchPair pair =
      measure_patches(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose, t.query.tolerance,
                      t.query.keep_directions, t.probe, n, t.set.stats);
  if (pair.status == PairContactStatus::apart) return -pair.depth - t.query.tolerance;
  report(t, make_contact(t, n, pair));
  return 0.0;
}

// ---- traversal without memory
// ------------------------------------------------------------

std::int64_t packed(std::int32_t a, std::int32_t b) noexcept {
  return (static_cast<std::int64_t>(a) << 32) | static_cast<std::uint32_t>(b);
}

// Everything below a pair that the front has no room for. The stack was reserved for the depth of
// both trees.
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

// ---- descending and rising
// ------------------------------------------------------------

void activate(Traversal& t, std::int32_t i) noexcept {
  ContactFront& f = t.front;
  f.nodes[i].is_active = true;
  f.expires[i] = kNever;
  f.incoming.push_back(i);
}

// Looks at pair i of the front and everything below it that has to be. f.work above `base` is the
// stack.
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
    } else if (split(t, k, splits_a(t, n.a, n.b))) {
      // It can only rise again once the bodies moved by what it lacks; a quarter of the tolerance
      // keeps it from going back and forth.
      set_timer(f, k, -slack + 0.25 * t.query.tolerance);
      for (std::int32_t c = f.nodes[k].first_child; c >= 0; c = f.nodes[c].next_sibling)
        f.work.push_back(c);
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
    if (f.nodes[i].first_child >= 0)
      try_to_rise(t, i);
    else
      descend(t, i);
  }
}

// ---- leaf pairs
// ------------------------------------------------------------

std::int64_t key_of(const Traversal& t, std::int32_t i) noexcept {
  const FrontNode& n = t.front.nodes[i];
  return packed(node_a(t, n.a).patch, node_b(t, n.b).patch);
}

// Measures the active leaf pairs in the order of their patches; those that left the tolerance fall
// asleep.
void measure_active(Traversal& t) noexcept {
  ContactFront& f = t.front;
  std::sort(f.incoming.begin(), f.incoming.end(),
            [&](std::int32_t x, std::int32_t y) { return key_of(t, x) < key_of(t, y); });
  f.next_active.clear();
  std::size_t old = 0, fresh = 0;
  while (old < f.active.size() || fresh < f.incoming.size()) {
    const bool take_old =
        fresh == f.incoming.size() ||
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

// ---- frames
// ------------------------------------------------------------

bool start_frame(Traversal& t) noexcept {
  ContactFront& f = t.front;
  const FrontState state = advance_front(t, false);
  if (state == FrontState::no_memory) return false;
  if (state == FrontState::empty) {
    descend(t, take_node(f));
  } else {
    update_front(t);
  }
  f.last = t.pose;
  return true;
}

bool is_answerable(const ClodHierarchy& object, const ClodHierarchy& scene,
                   const ContactQuery& query, const RelativePose& pose) noexcept {
  return !object.nodes.empty() && !scene.nodes.empty() && query.tolerance >= 0.0 &&
         pose.rotation.allFinite() && pose.translation.allFinite();
}

}  // namespace

void query_contacts(const ClodHierarchy& object, const Pose& world_from_object,
                    const ClodHierarchy& scene, const Pose& world_from_scene,
                    const ContactQuery& query, ContactFront& front, ContactSet& contacts) noexcept {
  const RelativePose pose = relative_pose(world_from_object, world_from_scene);
  if (!is_answerable(object, scene, query, pose)) return;
  CrossingContext crossing{&object, &scene, pose};
  Traversal t{object,
              scene,
              query,
              pose,
              world_from_object.orientation.toRotationMatrix(),
              world_from_object.position,
              front,
              contacts,
              contacts.contacts.size(),
              crossing_probe(crossing)};
  if (!query.resolution.is_exact) {
    query_levels(t);
    return;
  }
  if (!start_frame(t)) return;
  crossing.object_closed = front.object_closed;
  crossing.scene_closed = front.scene_closed;
  measure_active(t);
  traverse_saturated(t);
  const auto begin = contacts.contacts.begin() + static_cast<std::ptrdiff_t>(t.first);
  if (t.full || t.unordered) std::sort(begin, contacts.contacts.end(), is_before);
  contacts.stats.front += front.alive - front.split;
}

QueryStats track_front(const ClodHierarchy& object, const Pose& world_from_object,
                       const ClodHierarchy& scene, const Pose& world_from_scene,
                       const ContactQuery& query, ContactFront& front) noexcept {
  ContactSet none;
  const RelativePose pose = relative_pose(world_from_object, world_from_scene);
  if (!is_answerable(object, scene, query, pose)) return none.stats;
  Traversal t{object, scene, query, pose, Mat3::Identity(), Vec3::Zero(), front, none, 0, {}};
  if (!query.resolution.is_exact) {
    query_levels(t);
    return none.stats;
  }
  if (!start_frame(t)) return none.stats;
  none.stats.front = front.alive - front.split;
  return none.stats;
}

void query_scene(const ClodHierarchy& object, const Pose& world_from_object,
                 std::span<const SceneBody> bodies, const ContactQuery& query,
                 std::span<ContactFront> fronts, ContactSet& contacts) noexcept {
  clear(contacts);
  ContactQuery one = query;
  const std::size_t count = std::min(bodies.size(), fronts.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (bodies[i].hierarchy == nullptr) continue;
    one.body = static_cast<std::int32_t>(i);
    query_contacts(object, world_from_object, *bodies[i].hierarchy, bodies[i].world_from_body, one,
                   fronts[i], contacts);
  }
}

double least_distance(const ContactSet& contacts) noexcept {
  double least = kInfinity;
  for (const Contact& c : contacts.contacts) least = std::min(least, -c.depth);
  return least;
}

}  // namespace thigma
