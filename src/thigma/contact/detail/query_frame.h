#pragma once
// One query of a pair of bodies, as the exact and the multires algorithm share it: its input, the
// culling test of a pair of nodes, and the report of a contact.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "thigma/contact/detail/node_gap.h"
#include "thigma/contact/detail/patch_pair.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/core/index.h"
#include "thigma/math/infinity.h"

namespace thigma::detail {

struct QueryFrame {
  const ClodHierarchy& object;
  const ClodHierarchy& scene;
  ContactQuery query;   // its tolerance shrinks where there are too many pairs
  RelativePose pose;    // object_from_scene
  Mat3 world_rotation;  // of the object
  Vec3 world_position;
  ContactFront& front;
  ContactSet& set;
  std::size_t first;                             // contact of this query in the set
  bool is_full = false;                          // contacts are a heap by now
  bool is_carrying = false, is_holding = false;  // this query does
  double margin = 0.0;                           // of what is certain of held pairs [m]
};

inline QueryFrame make_frame(const PlacedHierarchy& object, const PlacedHierarchy& scene,
                             const ContactQuery& query, ContactFront& front,
                             ContactSet& set) noexcept {
  return {object.hierarchy,
          scene.hierarchy,
          query,
          relative_pose(object.world_from_body, scene.world_from_body),
          object.world_from_body.orientation.toRotationMatrix(),
          object.world_from_body.position,
          front,
          set,
          set.contacts.size()};
}

inline const ClodNode& node_a(const QueryFrame& frame, std::int32_t i) noexcept {
  return frame.object.nodes[idx(i)];
}
inline const ClodNode& node_b(const QueryFrame& frame, std::int32_t i) noexcept {
  return frame.scene.nodes[idx(i)];
}

inline bool is_leaf_pair(const QueryFrame& frame, std::int32_t a, std::int32_t b) noexcept {
  return node_a(frame, a).child_count == 0 && node_b(frame, b).child_count == 0;
}

/// By how much a pair misses d_ab = d + h(a) + h(b) (Eq. 3.5), at least; <= 0: not culled. The
/// spheres' bound is enough where it outlives the next frame; that of the known axis where it
/// culls, as it costs a tenth of a search; the search ends with the first bound that outlives the
/// next frame.
///
/// found  the distance of hulls within d_ab, if it was needed
inline double slack_of(QueryFrame& frame, FrontNode& node, Separation* found = nullptr) noexcept {
  ++frame.set.stats.tests;
  const ClodNode &a = node_a(frame, node.a), &b = node_b(frame, node.b);
  const double reach = frame.query.tolerance + a.hausdorff + b.hausdorff;
  const HullView hull_a = bare_hull(frame.object, a), hull_b = bare_hull(frame.scene, b);
  const PlacedHulls hulls = place(hull_a, hull_b, frame.pose);
  double slack = sphere_gap(hulls) - reach;
  const double enough = frame.front.last_step;
  if (slack > enough) return slack;
  if (node.axis[0] != 0.0f || node.axis[1] != 0.0f || node.axis[2] != 0.0f) {
    slack = std::max(slack, axis_gap(hulls, frame.pose, node.axis) - reach);
    if (slack > 0.0) return slack;
  }
  ++frame.set.stats.pair_queries;
  if (node.gjk.count == 0) start_along(hulls, frame.pose, node.axis, node.gjk);
  constexpr double kLonger = 1.5;  // than a frame's motion: one that is a little faster
  const Separation s =
      closest_points(hulls.a, hulls.b, frame.pose, reach + kLonger * enough, node.gjk);
  if (s.status == GjkStatus::overlapping || !(s.distance > 0.0)) return std::max(slack, -reach);
  if (found != nullptr && s.status == GjkStatus::separated && s.distance <= reach) *found = s;
  // Where the search stopped early the distance is less than that of the witnesses.
  const Vec3 axis = (s.witness_b - s.witness_a).normalized();
  if (!node.has_normal) {
    for (int i = 0; i < 3; ++i) node.axis[i] = static_cast<float>(axis[i]);
  }
  const double rounding = hulls.rounding + 1e-11 * (hulls.a.radius + hulls.b.radius);
  if (s.status == GjkStatus::gave_up) {
    return std::max(slack, axis_gap(hulls, frame.pose, node.axis) - reach);
  }
  return std::max(slack, s.distance - rounding - reach);
}

/// Whether hulls that are apart are as good as their triangles.
inline bool measures_hulls(const ContactQuery& query) noexcept {
  const Resolution& r = query.resolution;
  return query.measures_hulls && (r.is_exact || r.exact_within > 0.0);
}

/// Measures the finest patches of a leaf pair.
inline PatchPair measure_leaf_pair(QueryFrame& frame, FrontNode& node,
                                   const SegmentProbe& probe) noexcept {
  ++frame.set.stats.tests;
  return measure_patches({.a = hull_view(frame.object, node.a),
                          .b = hull_view(frame.scene, node.b),
                          .a_from_b = frame.pose,
                          .tolerance = frame.query.tolerance,
                          .measures_hulls = measures_hulls(frame.query),
                          .keeps_direction = frame.query.keep_directions,
                          .probe = probe},
                         node, frame.set.stats);
}

inline bool is_before(const Contact& x, const Contact& y) noexcept {
  return x.object_patch != y.object_patch ? x.object_patch < y.object_patch
                                          : x.scene_patch < y.scene_patch;
}

/// Heap order of a full set: the least worth keeping on top.
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
    case PairContactStatus::grazing:
      return ContactStatus::grazing;
  }
  return ContactStatus::separated;
}

inline std::int32_t patch_id(const ClodHierarchy& hierarchy, const ClodNode& node) noexcept {
  return node.patch >= 0 ? node.patch
                         : static_cast<std::int32_t>(hierarchy.patches.size()) + node.contact;
}

inline Contact make_contact(const QueryFrame& frame, const FrontNode& node,
                            const PatchPair& pair) noexcept {
  Contact c;
  c.point = frame.world_rotation * pair.witness_a + frame.world_position;
  c.scene_point = frame.world_rotation * pair.witness_b + frame.world_position;
  c.normal = frame.world_rotation * pair.normal;
  c.depth = pair.depth;
  c.body = frame.query.body;
  c.object_patch = patch_id(frame.object, node_a(frame, node.a));
  c.scene_patch = patch_id(frame.scene, node_b(frame, node.b));
  c.object_level = node_a(frame, node.a).level;
  c.scene_level = node_b(frame, node.b).level;
  c.status = status_of(pair.status);
  return c;
}

/// Keeps the deepest of more contacts than fit.
inline void report(QueryFrame& frame, const Contact& contact) noexcept {
  std::vector<Contact>& all = frame.set.contacts;
  if (all.size() < all.capacity()) {
    all.push_back(contact);
    return;
  }
  ++frame.set.dropped;
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(frame.first);
  if (begin == all.end()) return;
  if (!frame.is_full) std::make_heap(begin, all.end(), is_deeper);
  frame.is_full = true;
  if (!is_deeper(contact, *begin)) return;
  std::pop_heap(begin, all.end(), is_deeper);
  all.back() = contact;
  std::push_heap(begin, all.end(), is_deeper);
}

}  // namespace thigma::detail
