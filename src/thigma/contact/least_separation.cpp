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

struct Search {
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

const ClodNode& node_a(const Search& search, std::int32_t i) noexcept {
  return search.object.nodes[idx(i)];
}
const ClodNode& node_b(const Search& search, std::int32_t i) noexcept {
  return search.scene.nodes[idx(i)];
}

bool is_leaf_pair(const Search& search, std::int32_t a, std::int32_t b) noexcept {
  return node_a(search, a).child_count == 0 && node_b(search, b).child_count == 0;
}

// What a bound has to reach for its pair to be settled.
double wanted(const Search& search) noexcept {
  return std::min(search.out.high - search.width, search.query.tolerance);
}

bool is_higher(const SeparationPair& x, const SeparationPair& y) noexcept {
  if (x.low != y.low) return x.low > y.low;
  return x.a != y.a ? x.a > y.a : x.b > y.b;
}

// No two finest patches below are nearer; cheapest test first, no farther than is wanted. Keeps the
// axis that was found, for the children.
double lower_bound(Search& search, SeparationPair& p, double want) noexcept {
  const ClodNode &a = node_a(search, p.a), &b = node_b(search, p.b);
  const HullView hull_a = bare_hull(search.object, a), hull_b = bare_hull(search.scene, b);
  const PlacedHulls pair = place(hull_a, hull_b, search.pose);
  const double outside = a.hausdorff + b.hausdorff;
  const double size = pair.a.radius + pair.b.radius;
  double low = sphere_gap(pair) - outside;
  if (low >= want) return low;
  if (p.axis[0] != 0.0f || p.axis[1] != 0.0f || p.axis[2] != 0.0f) {
    low = std::max(low, axis_gap(pair, search.pose, p.axis) - outside);
    if (low >= want) return low;
  }
  ++search.out.pair_queries;
  if (p.gjk.count == 0) start_along(pair, search.pose, p.axis, p.gjk);
  const double stop = std::max(want + outside, kApart * size);
  const Separation s = closest_points(pair.a, pair.b, search.pose, stop, p.gjk);
  if (s.status == GjkStatus::overlapping || !(s.distance > 0.0)) return low;
  const Vec3 between = s.witness_b - s.witness_a;
  const double length = std::sqrt(between.squaredNorm());
  for (int i = 0; i < 3; ++i) p.axis[i] = static_cast<float>(between[i] / length);
  const double gap = s.status == GjkStatus::gave_up
                         ? axis_gap(pair, search.pose, p.axis)
                         : s.distance - pair.rounding - kHullRounding * size;
  return std::max(low, gap - outside);
}

// Minus the depth of two finest patches, or `limit` where they are farther apart [m].
double measure_finest(const Search& search, std::int32_t a, std::int32_t b, double limit) noexcept {
  FrontNode memory;
  QueryStats counts;
  const PatchPair pair = measure_patches({.a = hull_view(search.object, a),
                                          .b = hull_view(search.scene, b),
                                          .a_from_b = search.pose,
                                          .tolerance = limit,
                                          .probe = search.probe},
                                         memory, counts);
  return pair.status == PairContactStatus::apart ? limit : -pair.depth;
}

bool splits_object(const Search& search, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode &na = node_a(search, a), &nb = node_b(search, b);
  if (na.child_count == 0 || nb.child_count == 0) return na.child_count > 0;
  return na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
}

// Two finest patches that were measured, up to the tolerance.
void settle(Search& search, double separation) noexcept {
  search.rest = std::min(search.rest, separation);
  if (separation < search.query.tolerance) search.out.high = std::min(search.out.high, separation);
}

// Settles a pair, or leaves it to be divided.
void add(Search& search, SeparationPair p) noexcept {
  if (is_leaf_pair(search, p.a, p.b))
    return settle(search, measure_finest(search, p.a, p.b, search.query.tolerance));
  const double want = wanted(search);
  if (p.low < want) p.low = std::max(p.low, lower_bound(search, p, want));
  std::vector<SeparationPair>& pairs = search.scratch.pairs;
  if (p.low >= want || pairs.size() == pairs.capacity()) {
    search.is_full = search.is_full || p.low < want;
    search.rest = std::min(search.rest, p.low);
    return;
  }
  pairs.push_back(p);
  std::push_heap(pairs.begin(), pairs.end(), is_higher);
}

void divide(Search& search, const SeparationPair& p) noexcept {
  ++search.out.expansions;
  const bool of_a = splits_object(search, p.a, p.b);
  const ClodNode& parent = of_a ? node_a(search, p.a) : node_b(search, p.b);
  for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
    SeparationPair child{.low = p.low, .a = of_a ? c : p.a, .b = of_a ? p.b : c};
    std::copy(p.axis, p.axis + 3, child.axis);
    add(search, child);
  }
}

// Two finest patches that are likely near: down to the child whose ball reaches farthest towards
// the other's centre.
void probe_below(Search& search, std::int32_t a, std::int32_t b) noexcept {
  while (!is_leaf_pair(search, a, b)) {
    const ClodNode &na = node_a(search, a), &nb = node_b(search, b);
    const bool of_a = splits_object(search, a, b);
    const Vec3 other =
        of_a ? Vec3(search.pose.rotation * nb.center + search.pose.translation)
             : Vec3(search.pose.rotation.transpose() * (na.center - search.pose.translation));
    const ClodNode& parent = of_a ? na : nb;
    const std::vector<ClodNode>& nodes = of_a ? search.object.nodes : search.scene.nodes;
    double least = kInfinity;
    std::int32_t next = parent.first_child;
    for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
      const ClodNode& child = nodes[idx(c)];
      const double gap = std::sqrt((child.center - other).squaredNorm()) - child.radius;
      if (!(gap < least)) continue;
      least = gap;
      next = c;
    }
    (of_a ? a : b) = next;
  }
  search.out.high = std::min(search.out.high, measure_finest(search, a, b, kInfinity));
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
void add_contact(Search& search, const Contact& c, const Mat3& object_from_world) noexcept {
  SeparationPair p{.low = -c.depth - c.bound,
                   .a = contact_node(search.object, c.object_patch),
                   .b = contact_node(search.scene, c.scene_patch)};
  if (p.a < 0 || p.b < 0) return;
  if (is_leaf_pair(search, p.a, p.b)) return settle(search, -c.depth);
  const Vec3 axis = object_from_world * c.normal;
  for (int i = 0; i < 3; ++i) p.axis[i] = static_cast<float>(axis[i]);
  add(search, p);
}

void start(Search& search, const ContactSet& set, const Mat3& object_from_world) noexcept {
  if (set.dropped > 0) return add(search, {});
  for (const Contact* c : nearest(set, search.query.body)) {
    if (c == nullptr) break;
    const std::int32_t a = contact_node(search.object, c->object_patch);
    const std::int32_t b = contact_node(search.scene, c->scene_patch);
    if (a >= 0 && b >= 0) probe_below(search, a, b);
  }
  for (const Contact& c : set.contacts) {
    if (c.body == search.query.body) add_contact(search, c, object_from_world);
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

SeparationInterval least_separation(const PlacedHierarchy& object, const PlacedHierarchy& scene,
                                    const ContactSet& contacts, const SeparationQuery& query,
                                    SeparationScratch& scratch) noexcept {
  const ClodHierarchy &a = object.hierarchy, &b = scene.hierarchy;
  const RelativePose pose = relative_pose(object.world_from_body, scene.world_from_body);
  const bool is_answerable = !a.nodes.empty() && !b.nodes.empty() && pose.rotation.allFinite() &&
                             pose.translation.allFinite();
  if (!is_answerable || !has_memory(scratch, a, b)) return {};
  const CrossingContext crossing{&a, &b, pose, scratch.object_closed, scratch.scene_closed};
  const double smaller = std::min(a.radius, b.radius);
  const double width = kOfWidth * std::max(query.width, 0.0) * smaller;
  Search search{a, b, pose, query, width, crossing_probe(crossing), scratch};
  std::vector<SeparationPair>& pairs = scratch.pairs;
  pairs.clear();
  start(search, contacts, object.world_from_body.orientation.toRotationMatrix().transpose());
  while (!pairs.empty() && pairs.front().low < wanted(search) &&
         search.out.expansions < query.budget) {
    std::pop_heap(pairs.begin(), pairs.end(), is_higher);
    const SeparationPair lowest = pairs.back();
    pairs.pop_back();
    divide(search, lowest);
  }
  search.out.low = std::min({search.rest, query.tolerance, search.out.high});
  if (!pairs.empty()) search.out.low = std::min(search.out.low, pairs.front().low);
  search.out.is_narrow = !(search.out.low < wanted(search));
  return search.out;
}

}  // namespace thigma
