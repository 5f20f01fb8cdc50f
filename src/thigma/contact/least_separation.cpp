#include "thigma/contact/least_separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "thigma/contact/contact_node.h"
#include "thigma/contact/detail/node_gap.h"
#include "thigma/contact/detail/patch_pair.h"
#include "thigma/contact/surface_crossing.h"
#include "thigma/core/index.h"

// Contacts with levels of detail say within what bounds the original triangles below them lie, and
// those bounds are as wide as the nodes are large. Of most of them that does not matter: only what
// may be nearer than the nearest pair known has to be divided. Best first, so nothing is divided
// that the answer does not need, whatever the order of the contacts.

namespace thigma {
namespace {

using namespace detail;

// Contacts below which a near pair of finest patches is looked for before anything is divided: the
// nearer it is, the more bounds are settled by a sphere or an axis.
constexpr std::size_t kProbes = 3;
// Of the size of two hulls: a search for their distance ends there where any distance is enough.
// Smaller, and it goes on for no use.
constexpr double kApart = 1e-6;
// Of the width asked for, so that no interval is wider by the rounding of its own ends.
constexpr double kOfWidth = 1.0 - 1e-9;
// Rounding of the distance of two hulls, times their size.
constexpr double kHullRounding = 1e-11;

struct Descent {
  const ClodHierarchy &object, &scene;
  RelativePose pose;
  const SeparationQuery& query;
  double width;  // [m]
  SegmentProbe probe;
  SeparationScratch& scratch;
  double rest = kInfinity;  // least bound of what is not in the heap any more [m]
  bool is_full = false;
  SeparationInterval out{};
};

const ClodNode& node_a(const Descent& d, std::int32_t i) noexcept { return d.object.nodes[at(i)]; }
const ClodNode& node_b(const Descent& d, std::int32_t i) noexcept { return d.scene.nodes[at(i)]; }

bool is_leaf_pair(const Descent& d, std::int32_t a, std::int32_t b) noexcept {
  return node_a(d, a).child_count == 0 && node_b(d, b).child_count == 0;
}

// What a bound has to reach for its pair to be settled.
double wanted(const Descent& d) noexcept {
  return std::min(d.out.high - d.width, d.query.tolerance);
}

bool is_higher(const SeparationPair& x, const SeparationPair& y) noexcept {
  if (x.low != y.low) return x.low > y.low;
  return x.a != y.a ? x.a > y.a : x.b > y.b;
}

// No two finest patches below are nearer; cheapest test first, no farther than is wanted. Keeps the
// axis that was found, for the children.
double lower_bound(Descent& d, SeparationPair& p, double want) noexcept {
  const auto pair = place(hull_view(d.object, p.a), hull_view(d.scene, p.b), d.pose);
  const double outside = node_a(d, p.a).hausdorff + node_b(d, p.b).hausdorff;
  const double size = pair.a.radius + pair.b.radius;
  double low = sphere_gap(pair) - outside;
  if (low >= want) return low;
  if (p.axis[0] != 0.0f || p.axis[1] != 0.0f || p.axis[2] != 0.0f) {
    low = std::max(low, axis_gap(pair, d.pose, p.axis) - outside);
    if (low >= want) return low;
  }
  ++d.out.pair_queries;
  if (p.gjk.count == 0) start_along(pair, d.pose, p.axis, p.gjk);
  const double stop = std::max(want + outside, kApart * size);
  const Separation s = closest_points(pair.a, pair.b, d.pose, stop, p.gjk);
  if (s.status == GjkStatus::overlapping || !(s.distance > 0.0)) return low;
  const Vec3 way = s.witness_b - s.witness_a;
  const double length = std::sqrt(way.squaredNorm());
  for (int i = 0; i < 3; ++i) p.axis[i] = static_cast<float>(way[i] / length);
  const double gap = s.status == GjkStatus::gave_up
                         ? axis_gap(pair, d.pose, p.axis)
                         : s.distance - pair.rounding - kHullRounding * size;
  return std::max(low, gap - outside);
}

// Minus the depth of two finest patches, or `limit` where they are farther apart [m].
double measure_finest(const Descent& d, std::int32_t a, std::int32_t b, double limit) noexcept {
  FrontNode memory;
  QueryStats counts;
  const PatchPair pair = measure_patches(hull_view(d.object, a), hull_view(d.scene, b), d.pose,
                                         limit, false, d.probe, memory, counts);
  return pair.status == PairContactStatus::apart ? limit : -pair.depth;
}

bool splits_object(const Descent& d, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode &na = node_a(d, a), &nb = node_b(d, b);
  if (na.child_count == 0 || nb.child_count == 0) return na.child_count > 0;
  return na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
}

// Two finest patches that were measured, up to the tolerance.
void settle(Descent& d, double separation) noexcept {
  d.rest = std::min(d.rest, separation);
  if (separation < d.query.tolerance) d.out.high = std::min(d.out.high, separation);
}

// Settles a pair, or leaves it to be divided.
void add(Descent& d, SeparationPair p) noexcept {
  if (is_leaf_pair(d, p.a, p.b)) return settle(d, measure_finest(d, p.a, p.b, d.query.tolerance));
  const double want = wanted(d);
  if (p.low < want) p.low = std::max(p.low, lower_bound(d, p, want));
  std::vector<SeparationPair>& pairs = d.scratch.pairs;
  if (p.low >= want || pairs.size() == pairs.capacity()) {
    d.is_full = d.is_full || p.low < want;
    d.rest = std::min(d.rest, p.low);
    return;
  }
  pairs.push_back(p);
  std::push_heap(pairs.begin(), pairs.end(), is_higher);
}

void divide(Descent& d, const SeparationPair& p) noexcept {
  ++d.out.expansions;
  const bool of_a = splits_object(d, p.a, p.b);
  const ClodNode& parent = of_a ? node_a(d, p.a) : node_b(d, p.b);
  for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
    SeparationPair child{.low = p.low, .a = of_a ? c : p.a, .b = of_a ? p.b : c};
    std::copy(p.axis, p.axis + 3, child.axis);
    add(d, child);
  }
}

// Two finest patches that are likely near: down to the child whose ball reaches farthest towards
// the other's centre.
void probe_below(Descent& d, std::int32_t a, std::int32_t b) noexcept {
  while (!is_leaf_pair(d, a, b)) {
    const ClodNode &na = node_a(d, a), &nb = node_b(d, b);
    const bool of_a = splits_object(d, a, b);
    const Vec3 other = of_a ? Vec3(d.pose.rotation * nb.center + d.pose.translation)
                            : Vec3(d.pose.rotation.transpose() * (na.center - d.pose.translation));
    const ClodNode& parent = of_a ? na : nb;
    const std::vector<ClodNode>& nodes = of_a ? d.object.nodes : d.scene.nodes;
    double least = kInfinity;
    std::int32_t next = parent.first_child;
    for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
      const ClodNode& child = nodes[at(c)];
      const double gap = std::sqrt((child.center - other).squaredNorm()) - child.radius;
      if (!(gap < least)) continue;
      least = gap;
      next = c;
    }
    (of_a ? a : b) = next;
  }
  d.out.high = std::min(d.out.high, measure_finest(d, a, b, kInfinity));
}

// The nearest contacts by what they report, nearest first; the others null.
std::array<const Contact*, kProbes> nearest(const ContactSet& set, std::int32_t body) noexcept {
  std::array<const Contact*, kProbes> best{};
  for (const Contact& c : set.contacts) {
    const Contact* next = c.body == body ? &c : nullptr;
    for (const Contact*& place : best) {
      if (next == nullptr) break;
      if (place == nullptr || next->depth > place->depth) std::swap(next, place);
    }
  }
  return best;
}

// A contact of coarse patches that overlap says how deep what is below them is along a normal, not
// that any of it meets: it has no upper end.
void add_contact(Descent& d, const Contact& c, const Mat3& object_from_world) noexcept {
  SeparationPair p{.low = -c.depth - c.bound,
                   .a = contact_node(d.object, c.object_patch),
                   .b = contact_node(d.scene, c.scene_patch)};
  if (p.a < 0 || p.b < 0) return;
  if (is_leaf_pair(d, p.a, p.b)) return settle(d, -c.depth);
  const Vec3 axis = object_from_world * c.normal;
  for (int i = 0; i < 3; ++i) p.axis[i] = static_cast<float>(axis[i]);
  add(d, p);
}

void start(Descent& d, const ContactSet& set, const Mat3& object_from_world) noexcept {
  if (set.dropped > 0) return add(d, {});
  for (const Contact* c : nearest(set, d.query.body)) {
    if (c == nullptr) break;
    const std::int32_t a = contact_node(d.object, c->object_patch);
    const std::int32_t b = contact_node(d.scene, c->scene_patch);
    if (a >= 0 && b >= 0) probe_below(d, a, b);
  }
  for (const Contact& c : set.contacts) {
    if (c.body == d.query.body) add_contact(d, c, object_from_world);
  }
}

bool has_memory(SeparationScratch& scratch, const ClodHierarchy& object,
                const ClodHierarchy& scene) noexcept {
  if (scratch.object == &object && scratch.scene == &scene && scratch.pairs.capacity() > 0)
    return true;
  try {
    reserve_separation(scratch, object, scene);
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

}  // namespace

void reserve_separation(SeparationScratch& scratch, const ClodHierarchy& object,
                        const ClodHierarchy& scene, std::size_t capacity) {
  scratch.pairs = {};
  scratch.pairs.reserve(std::max<std::size_t>(capacity, 1));
  scratch.object_closed = is_closed(object);
  scratch.scene_closed = is_closed(scene);
  scratch.object = &object;
  scratch.scene = &scene;
}

SeparationInterval least_separation(const ClodHierarchy& object, const Pose& world_from_object,
                                    const ClodHierarchy& scene, const Pose& world_from_scene,
                                    const ContactSet& contacts, const SeparationQuery& query,
                                    SeparationScratch& scratch) noexcept {
  const RelativePose pose = relative_pose(world_from_object, world_from_scene);
  const bool is_answerable = !object.nodes.empty() && !scene.nodes.empty() &&
                             pose.rotation.allFinite() && pose.translation.allFinite();
  if (!is_answerable || !has_memory(scratch, object, scene)) return {};
  const CrossingContext crossing{&object, &scene, pose, scratch.object_closed,
                                 scratch.scene_closed};
  const double smaller = std::min(object.radius, scene.radius);
  const double width = kOfWidth * std::max(query.width, 0.0) * smaller;
  Descent d{object, scene, pose, query, width, crossing_probe(crossing), scratch};
  std::vector<SeparationPair>& pairs = scratch.pairs;
  pairs.clear();
  start(d, contacts, world_from_object.orientation.toRotationMatrix().transpose());
  while (!pairs.empty() && pairs.front().low < wanted(d) && d.out.expansions < query.budget) {
    std::pop_heap(pairs.begin(), pairs.end(), is_higher);
    const SeparationPair lowest = pairs.back();
    pairs.pop_back();
    divide(d, lowest);
  }
  d.out.low = std::min({d.rest, query.tolerance, d.out.high});
  if (!pairs.empty()) d.out.low = std::min(d.out.low, pairs.front().low);
  d.out.is_narrow = !(d.out.low < wanted(d));
  return d.out;
}

}  // namespace thigma
