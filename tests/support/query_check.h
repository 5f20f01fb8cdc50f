#pragma once
// Checks one answer of the exact query against the independent search.

#include <cstring>
#include <map>
#include <string>

#include "support/triangle_search.h"
#include <gtest/gtest.h>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/query_contacts.h"

namespace thigma::test {

/// Finest patch of every triangle of the mesh, -1 for those without an area.
inline std::vector<int> patch_of_triangles(const ClodHierarchy& h) {
  std::vector<int> patch(static_cast<std::size_t>(h.triangle_count), -1);
  for (std::size_t p = 0; p < h.patches.size(); ++p) {
    for (int i = 0; i < h.patches[p].triangle_count; ++i) {
      const auto id = static_cast<std::size_t>(
          h.triangle_ids[static_cast<std::size_t>(h.patches[p].first_triangle + i)]);
      if (id < patch.size()) patch[id] = static_cast<int>(p);
    }
  }
  return patch;
}

/// Two objects with everything the check needs. Trees are in the frames of the bodies.
struct CheckedPair {
  std::string name;
  ClodHierarchy object, scene;
  TriangleTree object_tree, scene_tree;
  std::vector<int> object_patch, scene_patch;
  double radius = 0.0;  // of the smaller
};

inline CheckedPair make_checked_pair(std::string name, const TriangleMesh& object_mesh,
                                     const TriangleMesh& scene_mesh, ClodHierarchy object,
                                     ClodHierarchy scene) {
  CheckedPair pair{std::move(name),
                   std::move(object),
                   std::move(scene),
                   build_triangle_tree(object_mesh),
                   build_triangle_tree(scene_mesh),
                   {},
                   {},
                   0.0};
  pair.object_patch = patch_of_triangles(pair.object);
  pair.scene_patch = patch_of_triangles(pair.scene);
  pair.radius = std::min(pair.object.radius, pair.scene.radius);
  return pair;
}

/// A tree carried along by a pose: triangles moved, boxes rebuilt.
inline TriangleTree placed(const TriangleTree& tree, const Pose& pose) {
  TriangleTree moved = tree;
  for (Triangle& t : moved.triangles) {
    for (Vec3& p : t) p = transform_point(pose, p);
  }
  for (std::size_t i = moved.nodes.size(); i-- > 0;) {  // children follow their parent
    TriangleTree::Node& n = moved.nodes[i];
    n.box = {};
    if (n.left < 0) {
      for (const Vec3& p : moved.triangles[static_cast<std::size_t>(n.first)]) n.box.add(p);
      continue;
    }
    for (const int child : {n.left, n.right}) {
      n.box.add(moved.nodes[static_cast<std::size_t>(child)].box.low);
      n.box.add(moved.nodes[static_cast<std::size_t>(child)].box.high);
    }
  }
  return moved;
}

struct CheckCounts {
  std::int64_t poses = 0, contacts = 0, triangle_pairs = 0, intersecting = 0;
  double worst_distance = 0.0;  // of the smallest separation, relative to the radius
  double worst_contact = 0.0;   // of one contact's separation, relative to the radius
};

/// Compares one answer with the search at one pose of the object; the scene is at the identity.
inline void check_against_search(const CheckedPair& pair, const Pose& pose, double d,
                                 const ContactSet& got, CheckCounts& counts) {
  const TriangleTree object = placed(pair.object_tree, pose);
  const double eps = 1e-9 * pair.radius;
  const double least = least_triangle_distance(object, pair.scene_tree);
  const double reported = least_distance(got);
  if (least == 0.0) {
    EXPECT_LE(reported, eps) << pair.name << ": triangles intersect and no contact says so";
    ++counts.intersecting;
  } else if (least <= d - eps || !got.contacts.empty()) {
    if (reported >= 0.0) {
      EXPECT_NEAR(reported, least, eps) << pair.name;
      counts.worst_distance =
          std::max(counts.worst_distance, std::fabs(reported - least) / pair.radius);
    }
  }
  // The least separation of each pair of patches, from the original triangles.
  std::map<std::pair<int, int>, double> truth;
  for (const TrianglePair& t : triangle_pairs_within(object, pair.scene_tree, d + eps)) {
    const std::pair key(pair.object_patch[static_cast<std::size_t>(t.a)],
                        pair.scene_patch[static_cast<std::size_t>(t.b)]);
    const auto [entry, is_new] = truth.try_emplace(key, t.distance);
    if (!is_new) entry->second = std::min(entry->second, t.distance);
    ++counts.triangle_pairs;
  }
  std::map<std::pair<int, int>, const Contact*> contacts;
  int beyond = 0;
  for (const Contact& c : got.contacts) {
    const std::pair key(c.object_patch, c.scene_patch);
    EXPECT_TRUE(contacts.emplace(key, &c).second)
        << pair.name << ": a pair of patches is reported twice";
    EXPECT_GE(c.depth, -d) << pair.name;
    EXPECT_NEAR(c.normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(c.normal.dot(c.point - c.scene_point), c.depth,
                1e-12 * (pair.radius + c.point.norm()));
    if (truth.count(key) == 0) ++beyond;
  }
  EXPECT_EQ(beyond, 0) << pair.name << ": reported pairs with no triangles within d";
  int missing = 0, wrong = 0;
  for (const auto& [key, distance] : truth) {
    const auto found = contacts.find(key);
    if (found == contacts.end()) {
      if (distance <= d - eps) ++missing;
    } else if (found->second->status == ContactStatus::separated) {
      const double error = std::fabs(-found->second->depth - distance);
      if (error > eps) ++wrong;
      counts.worst_contact = std::max(counts.worst_contact, error / pair.radius);
    }
  }
  EXPECT_EQ(missing, 0) << pair.name << ": of " << truth.size()
                        << " patch pairs with triangles within d";
  EXPECT_EQ(wrong, 0) << pair.name << ": separations off by more than 1e-9 of the radius";
  counts.contacts += static_cast<std::int64_t>(got.contacts.size());
  ++counts.poses;
}

inline bool same_bits(const Contact& x, const Contact& y) {
  auto same = [](const auto& p, const auto& q) { return std::memcmp(&p, &q, sizeof(p)) == 0; };
  return same(x.point, y.point) && same(x.scene_point, y.scene_point) && same(x.normal, y.normal) &&
         same(x.depth, y.depth) && same(x.bound, y.bound) && same(x.weight, y.weight) &&
         x.body == y.body && x.object_patch == y.object_patch && x.scene_patch == y.scene_patch &&
         x.object_level == y.object_level && x.scene_level == y.scene_level && x.status == y.status;
}

/// Index of the first contact that differs, -1 when the sets are equal to the bit.
inline int first_difference(const ContactSet& x, const ContactSet& y) {
  const std::size_t n = std::min(x.contacts.size(), y.contacts.size());
  for (std::size_t i = 0; i < n; ++i) {
    if (!same_bits(x.contacts[i], y.contacts[i])) return static_cast<int>(i);
  }
  return x.contacts.size() == y.contacts.size() ? -1 : static_cast<int>(n);
}

/// Pose at which the object, moved along `direction` from `start`, stands `gap` away from the
/// scene. Found by sphere steps of the search, so `start` must be outside. Touch is where gap is 0;
/// negative gaps press in.
inline Pose pose_at_gap(const CheckedPair& pair, Pose start, const Vec3& direction, double gap) {
  for (int i = 0; i < 40; ++i) {
    const double distance =
        least_triangle_distance(placed(pair.object_tree, start), pair.scene_tree);
    const double step = distance - std::max(gap, 1e-5 * pair.radius);
    if (step < 1e-5 * pair.radius) break;
    start.position += step * direction;
  }
  if (gap < 0.0) start.position -= gap * direction;
  return start;
}

}  // namespace thigma::test
