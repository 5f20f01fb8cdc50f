#include "thigma/contact/level_changes.h"

#include <algorithm>
#include <iterator>

#include "thigma/contact/contact_node.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

constexpr int kMostSteps = 2;  // levels that a pair may move by in a frame and still be found

std::vector<std::int32_t> parents_of(const ClodHierarchy& hierarchy) {
  std::vector<std::int32_t> parents(hierarchy.nodes.size(), -1);
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i) {
    const ClodNode& node = hierarchy.nodes[i];
    for (std::int32_t k = 0; k < node.child_count; ++k) {
      parents[static_cast<std::size_t>(node.first_child + k)] = static_cast<std::int32_t>(i);
    }
  }
  return parents;
}

std::vector<std::int32_t> triangles_of_nodes(const ClodHierarchy& hierarchy) {
  std::vector<std::int32_t> triangles(hierarchy.nodes.size(), 0);
  for (std::size_t i = hierarchy.nodes.size(); i-- > 0;) {  // children come after their parents
    const ClodNode& node = hierarchy.nodes[i];
    if (node.patch >= 0)
      triangles[i] = hierarchy.patches[static_cast<std::size_t>(node.patch)].triangle_count;
    for (std::int32_t k = 0; k < node.child_count; ++k)
      triangles[i] += triangles[static_cast<std::size_t>(node.first_child + k)];
  }
  return triangles;
}

std::int32_t parent(const std::vector<std::int32_t>& parents, std::int32_t node) noexcept {
  const auto at = static_cast<std::size_t>(node);
  return node >= 0 && at < parents.size() ? parents[at] : -1;
}

/// Counts a pair above which, but not itself, one of sorted pairs stands.
void count_if_below(const LevelHistory& history, const std::vector<NodePair>& pairs,
                    const NodePair& pair, LevelChanges& changes) noexcept {
  bool is_below = false, presses = pair.presses;
  const std::vector<std::int32_t>& scene_parents =
      history.scene_parents[static_cast<std::size_t>(pair.body)];
  std::int32_t object = pair.object;
  for (int i = 0; i <= kMostSteps && object >= 0; ++i) {
    std::int32_t scene = pair.scene;
    for (int j = 0; j <= kMostSteps && scene >= 0; ++j) {
      const NodePair above{pair.body, object, scene};
      const auto at = i + j > 0 ? std::lower_bound(pairs.begin(), pairs.end(), above) : pairs.end();
      if (at != pairs.end() && *at == above) {
        is_below = true;
        presses = presses || at->presses;
      }
      scene = parent(scene_parents, scene);
    }
    object = parent(history.object_parents, object);
  }
  if (!is_below) return;
  ++changes.all;
  if (presses) ++changes.pressing;
}

/// What `pairs` has and `others` lacks; both sorted.
void subtract(const std::vector<NodePair>& pairs, const std::vector<NodePair>& others,
              std::vector<NodePair>& rest) noexcept {
  rest.clear();
  std::set_difference(pairs.begin(), pairs.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
}

/// What is in both, pressing if in either; both sorted.
void intersect(const std::vector<NodePair>& last, const std::vector<NodePair>& now,
               std::vector<NodePair>& both) noexcept {
  both.clear();
  auto before = last.begin();
  for (const NodePair& pair : now) {
    while (before != last.end() && *before < pair) ++before;
    if (before == last.end() || *before != pair) continue;
    both.push_back(pair);
    both.back().presses = pair.presses || before->presses;
  }
}

/// Counts those of `pairs` that stand below one of `others`.
void count_below(const LevelHistory& history, const std::vector<NodePair>& pairs,
                 const std::vector<NodePair>& others, LevelChanges& changes) noexcept {
  if (others.empty()) return;
  for (const NodePair& pair : pairs) count_if_below(history, others, pair, changes);
}

}  // namespace

void reserve_level_history(const ClodHierarchy& object, std::span<const SceneBody> scene,
                           std::size_t contacts, LevelHistory& history) {
  history.object_parents = parents_of(object);
  history.object_triangles = triangles_of_nodes(object);
  history.scene_parents.clear();
  history.scene_triangles.clear();
  for (const SceneBody& body : scene) {
    history.scene_parents.push_back(parents_of(*body.hierarchy));
    history.scene_triangles.push_back(triangles_of_nodes(*body.hierarchy));
  }
  history.last.clear();
  history.last.reserve(contacts);
  history.now.reserve(contacts);
  history.gone.reserve(contacts);
  history.stayed.reserve(contacts);
}

LevelChanges count_level_changes(const ClodHierarchy& object, std::span<const SceneBody> scene,
                                 std::span<const Contact> contacts, double tolerance,
                                 LevelHistory& history) noexcept {
  history.now.clear();
  for (const Contact& c : contacts) {
    if (c.body < 0 || static_cast<std::size_t>(c.body) >= history.scene_parents.size()) continue;
    const ClodHierarchy& other = *scene[static_cast<std::size_t>(c.body)].hierarchy;
    const NodePair pair{c.body, contact_node(object, c.object_patch),
                        contact_node(other, c.scene_patch), c.depth > -tolerance};
    if (pair.object >= 0 && pair.scene >= 0) history.now.push_back(pair);
  }
  std::sort(history.now.begin(), history.now.end());
  subtract(history.last, history.now, history.gone);
  // Refined: what went stands above something that is there; coarsened: below it. What came and
  // stands below what was there and stays, as while both are blended, is refined as well.
  LevelChanges changes;
  count_below(history, history.now, history.gone, changes);
  count_below(history, history.gone, history.now, changes);
  intersect(history.last, history.now, history.stayed);
  std::vector<NodePair>& came = history.gone;
  subtract(history.now, history.last, came);
  count_below(history, came, history.stayed, changes);
  count_below(history, history.stayed, came, changes);
  std::swap(history.last, history.now);
  return changes;
}

double triangles_below(const LevelHistory& history) noexcept {
  double sum = 0.0;
  for (const NodePair& pair : history.last) {
    sum += 0.5 * history.object_triangles[static_cast<std::size_t>(pair.object)];
    sum += 0.5 * history.scene_triangles[static_cast<std::size_t>(pair.body)]
                                        [static_cast<std::size_t>(pair.scene)];
  }
  return sum;
}

}  // namespace thigma
