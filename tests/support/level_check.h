#pragma once
// Checks answers with levels of detail against the original triangles below the patches they were
// measured on.

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <vector>

#include "support/query_check.h"
#include "support/query_path.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"

namespace thigma::test {

/// What is below each patch of one body, by the patch numbers of contacts. Trees are made when
/// first asked for.
class PatchSurfaces {
 public:
  PatchSurfaces(const ClodHierarchy& h, const TriangleMesh& mesh)
      : h_(h), mesh_(mesh), parent_(h.nodes.size(), -1) {
    for (std::size_t i = 0; i < h.nodes.size(); ++i) {
      for (int c = 0; c < h.nodes[i].child_count; ++c) {
        parent_[static_cast<std::size_t>(h.nodes[i].first_child + c)] = static_cast<int>(i);
      }
    }
  }

  int node_of(int id) const {
    const auto finest = static_cast<int>(h_.patches.size());
    return id < finest ? h_.patches[static_cast<std::size_t>(id)].node
                       : h_.level_patches[static_cast<std::size_t>(id - finest)].patch.node;
  }

  /// s + h of a patch.
  double promise(int id) const {
    const auto finest = static_cast<int>(h_.patches.size());
    if (id < finest) return 0.0;
    const LevelPatch& c = h_.level_patches[static_cast<std::size_t>(id - finest)];
    return c.deviation + c.hausdorff;
  }

  double deviation(int id) const {
    const auto finest = static_cast<int>(h_.patches.size());
    return id < finest ? 0.0 : h_.level_patches[static_cast<std::size_t>(id - finest)].deviation;
  }

  const TriangleTree& below(int id) {
    const auto [entry, is_new] = trees_.try_emplace(id);
    if (is_new) {
      TriangleMesh part;
      part.positions = mesh_.positions;
      gather(node_of(id), part);
      entry->second = build_triangle_tree(part);
    }
    return entry->second;
  }

  /// Patch numbers of a finest patch and of everything above it that has one.
  std::vector<int> line_of(int patch) const {
    std::vector<int> line(1, patch);
    for (int i =
             parent_[static_cast<std::size_t>(h_.patches[static_cast<std::size_t>(patch)].node)];
         i >= 0; i = parent_[static_cast<std::size_t>(i)]) {
      const int contact = h_.nodes[static_cast<std::size_t>(i)].contact;
      if (contact >= 0) line.push_back(static_cast<int>(h_.patches.size()) + contact);
    }
    return line;
  }

 private:
  void gather(int node, TriangleMesh& part) const {
    const ClodNode& n = h_.nodes[static_cast<std::size_t>(node)];
    for (int c = 0; c < n.child_count; ++c) gather(n.first_child + c, part);
    if (n.patch < 0) return;
    const ClodPatch& p = h_.patches[static_cast<std::size_t>(n.patch)];
    for (int t = 0; t < p.triangle_count; ++t) {
      const int id = h_.triangle_ids[static_cast<std::size_t>(p.first_triangle + t)];
      part.triangles.push_back(mesh_.triangles[static_cast<std::size_t>(id)]);
    }
  }

  const ClodHierarchy& h_;
  const TriangleMesh& mesh_;
  std::vector<int> parent_;
  std::map<int, TriangleTree> trees_;
};

/// Two objects with levels and their surfaces.
struct LevelPairCheck {
  std::string name;
  TriangleMesh object_mesh, scene_mesh;
  CheckedPair exact;           // hierarchies with levels
  std::vector<double> ratios;  // of bound to error
  std::int64_t contacts = 0, coarse = 0, poses = 0, true_pairs = 0;
  double worst_promise = 0.0;  // bound over s + s + h + h
};

inline LevelPairCheck make_level_pair(std::string name, TriangleMesh object, TriangleMesh scene) {
  LevelPairCheck pair;
  pair.name = std::move(name);
  pair.object_mesh = std::move(object);
  pair.scene_mesh = std::move(scene);
  pair.exact = make_checked_pair(pair.name, pair.object_mesh, pair.scene_mesh,
                                 build_clod(pair.object_mesh), build_clod(pair.scene_mesh));
  return pair;
}

inline double top_along(const TriangleTree& tree, const Vec3& n) {
  double top = -1e300;
  for (const Triangle& t : tree.triangles) {
    for (const Vec3& p : t) top = std::max(top, n.dot(p));
  }
  return top;
}

/// How far one contact is from what the original triangles below it say.
inline double contact_error(const Contact& c, const TriangleTree& object,
                            const TriangleTree& scene) {
  if (c.status == ContactStatus::separated || c.status == ContactStatus::grazing) {
    return std::fabs(-c.depth - least_triangle_distance(object, scene));
  }
  return std::fabs(c.depth - (top_along(object, c.normal) + top_along(scene, -c.normal)));
}

/// Pairs of finest patches within d by an independent search that neither a contact of theirs nor
/// one of patches above them stands for. true_pairs: all of them are added to it
inline int count_missed(const LevelPairCheck& pair, const PatchSurfaces& objects,
                        const PatchSurfaces& scenes, const Pose& pose, double d,
                        const ContactSet& got, std::int64_t& true_pairs) {
  std::set<std::pair<int, int>> reported, truth;
  for (const Contact& c : got.contacts) reported.emplace(c.object_patch, c.scene_patch);
  const TriangleTree object = placed(pair.exact.object_tree, pose);
  for (const TrianglePair& t : triangle_pairs_within(object, pair.exact.scene_tree, d)) {
    truth.emplace(pair.exact.object_patch[static_cast<std::size_t>(t.a)],
                  pair.exact.scene_patch[static_cast<std::size_t>(t.b)]);
  }
  int missed = 0;
  for (const auto& [a, b] : truth) {
    const std::vector<int> above_a = objects.line_of(a), above_b = scenes.line_of(b);
    bool found = false;
    for (const int x : above_a) {
      for (const int y : above_b) found = found || reported.count({x, y}) != 0;
    }
    missed += found ? 0 : 1;
  }
  true_pairs += static_cast<std::int64_t>(truth.size());
  return missed;
}

/// Every contact within its bound, the bound within what s and h promise, and no true pair left
/// out.
/// carried  what the bounds of contacts that were carried along may have grown by, at most [m]
inline void check_levels(LevelPairCheck& pair, PatchSurfaces& objects, PatchSurfaces& scenes,
                         const Pose& pose, double d, const ContactSet& got, double carried = 0.0) {
  const double eps = 1e-9 * pair.exact.radius;
  std::set<std::pair<int, int>> reported;
  int over_bound = 0, over_promise = 0, beyond = 0;
  for (const Contact& c : got.contacts) {
    EXPECT_TRUE(reported.emplace(c.object_patch, c.scene_patch).second)
        << pair.name << ": reported twice";
    EXPECT_NEAR(c.normal.dot(c.point - c.scene_point), c.depth,
                1e-11 * (pair.exact.radius + c.point.norm()));
    if (-c.depth - c.bound > d + eps) ++beyond;
    const double promise = objects.promise(c.object_patch) + scenes.promise(c.scene_patch);
    // Exact contacts in penetration may be turning from beside to through: the exact query's own
    // test.
    if (promise == 0.0 && c.status != ContactStatus::separated) continue;
    if (c.bound > promise + carried + eps) ++over_promise;
    const double error =
        contact_error(c, placed(objects.below(c.object_patch), pose), scenes.below(c.scene_patch));
    if (error > c.bound + eps) {
      ++over_bound;
      if (over_bound == 1) {
        ADD_FAILURE() << pair.name << ": depth " << c.depth << " bound " << c.bound << " error "
                      << error << " status " << static_cast<int>(c.status) << " levels "
                      << c.object_level << ' ' << c.scene_level;
      }
    }
    if (promise == 0.0) continue;
    ++pair.coarse;
    pair.worst_promise = std::max(pair.worst_promise, c.bound / promise);
    if (error > eps) pair.ratios.push_back(c.bound / error);
  }
  EXPECT_EQ(over_bound, 0) << pair.name << ": of " << got.contacts.size();
  EXPECT_EQ(over_promise, 0) << pair.name << ": of " << got.contacts.size();
  EXPECT_EQ(beyond, 0) << pair.name;
  pair.contacts += static_cast<std::int64_t>(got.contacts.size());
  ++pair.poses;
  EXPECT_EQ(count_missed(pair, objects, scenes, pose, d - eps, got, pair.true_pairs), 0)
      << pair.name << ": pairs of finest patches within d";
}

}  // namespace thigma::test
