#include "thigma/clod/validate_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "thigma/clod/detail/clod_fields.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

using detail::Dimension;
using detail::Range;

// Searches of a tree recurse. Levels of detail need a few dozen, chains of merges a few more.
constexpr std::int32_t kMostLevels = 4096;
// A traversal keeps the siblings of every node of a way down. Trees of levels are far below this
// times their nodes.
constexpr std::int64_t kMostWaiting = 64, kLeastWaiting = 65536;
// Fifth powers stay finite (as kMaxCoordinate of meshes).
constexpr double kMostLength = 1e51;
constexpr double kRounding = 1e-9;  // of unit vectors and spheres: computed, scaled and rounded

std::string text(std::size_t i) { return std::to_string(i); }

struct Flaws {
  const ClodHierarchy& h;
  std::string first;

  /// Notes a broken promise; returns whether it holds.
  bool check(bool holds, const char* what, const char* kind, std::size_t index,
             const char* expected) {
    if (!holds && first.empty())
      first = std::string(what) + ", " + kind + " " + text(index) + ", expected " + expected;
    return holds;
  }
};

bool is_in(std::int64_t first, std::int64_t count, std::size_t size) {
  return first >= 0 && count >= 0 && first + count <= static_cast<std::int64_t>(size);
}

/// Refuses numbers that are not finite.
struct FiniteCheck {
  Flaws& flaws;
  const char* chunk = "";
  std::size_t index = 0;

  template <class T>
  void operator()(const char* name, const T& field, Dimension = Dimension::none,
                  Range range = Range::finite) {
    if (!is_fine(field, range) && flaws.first.empty())
      flaws.first = std::string("a number that is not finite, ") + chunk + " " + text(index) + " " +
                    name + ", expected a number";
  }
  template <class T>
  void record(const char* name, const T& item) {
    chunk = name;
    index = 0;
    detail::visit_fields(item, *this);
  }
  template <class T>
  void records(const char* name, const std::vector<T>& items) {
    chunk = name;
    for (index = 0; index < items.size(); ++index) detail::visit_fields(items[index], *this);
  }
  template <class T, class A>
  void numbers(const char* name, const std::vector<T, A>& items, Dimension) {
    chunk = name;
    for (index = 0; index < items.size(); ++index) (*this)("", items[index]);
  }

 private:
  static bool is_fine(double x, Range range) {
    return range == Range::infinite ? !std::isnan(x) : std::fabs(x) <= kMostLength * kMostLength;
  }
  static bool is_fine(float x, Range) { return std::isfinite(x); }
  static bool is_fine(const Vec3& v, Range range) {
    return is_fine(v.x(), range) && is_fine(v.y(), range) && is_fine(v.z(), range);
  }
  static bool is_fine(const std::array<double, 2>& v, Range range) {
    return is_fine(v[0], range) && is_fine(v[1], range);
  }
  template <class T>
  static bool is_fine(const T&, Range) {
    static_assert(!std::is_floating_point_v<T>);
    return true;
  }
};

// ---- tree
// ------------------------------------------------------------

bool check_node(Flaws& flaws, std::size_t i) {
  const ClodNode& n = flaws.h.nodes[i];
  const auto says = [&](bool holds, const char* what, const char* expected) {
    return flaws.check(holds, what, "node", i, expected);
  };
  if (!says(n.level >= 0 && idx(n.level) < flaws.h.levels.size(), "a level out of range",
            "a level there is"))
    return false;
  const bool is_leaf = n.child_count == 0;
  if (!says(n.child_count >= 0 &&
                (is_leaf || (n.first_child > static_cast<std::int64_t>(i) &&
                             is_in(n.first_child, n.child_count, flaws.h.nodes.size()))),
            "children out of range", "children behind their parent"))
    return false;
  const bool has_contact = n.level > 0 && !flaws.h.levels[idx(n.level)].is_free;
  return says(is_leaf == (n.level == 0), "a leaf above level 0, or none in it",
              "leaves in level 0") &&
         says(is_leaf ? n.patch >= 0 && idx(n.patch) < flaws.h.patches.size() &&
                            flaws.h.patches[idx(n.patch)].node == static_cast<std::int64_t>(i)
                      : n.patch == -1,
              "a wrong patch", "each patch at one leaf") &&
         says(has_contact ? n.contact >= 0 && idx(n.contact) < flaws.h.level_patches.size() &&
                                flaws.h.level_patches[idx(n.contact)].patch.node ==
                                    static_cast<std::int64_t>(i) &&
                                flaws.h.level_patches[idx(n.contact)].level == n.level
                          : n.contact == -1,
              "a wrong contact patch", "that of its level") &&
         says(n.hausdorff >= 0.0, "a negative distance h", "0 or more");
}

bool check_tree(Flaws& flaws) {
  const std::vector<ClodNode>& nodes = flaws.h.nodes;
  std::vector<std::int32_t> depth(nodes.size(), -1), count(flaws.h.levels.size(), 0);
  depth[0] = 0;
  std::int64_t deepest = 0, widest = 1, leaves = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!check_node(flaws, i)) return false;
    if (!flaws.check(depth[i] >= 0, "a node without a parent", "node", i, "one below the root"))
      return false;
    ++count[idx(nodes[i].level)];
    leaves += nodes[i].child_count == 0;
    deepest = std::max<std::int64_t>(deepest, depth[i]);
    widest = std::max<std::int64_t>(widest, nodes[i].child_count);
    for (std::int32_t k = nodes[i].first_child; k < nodes[i].first_child + nodes[i].child_count;
         ++k) {
      if (!flaws.check(depth[idx(k)] < 0, "a node with two parents", "node", idx(k), "one"))
        return false;
      if (!flaws.check(nodes[idx(k)].level < nodes[i].level, "a level above its parent's", "node",
                       idx(k), "levels that rise to the root"))
        return false;
      depth[idx(k)] = depth[i] + 1;
    }
  }
  if (!flaws.check(leaves == static_cast<std::int64_t>(flaws.h.patches.size()),
                   "patches without a leaf", "leaves", static_cast<std::size_t>(leaves),
                   "one for each patch"))
    return false;
  for (std::size_t k = 0; k < count.size(); ++k)
    if (!flaws.check(count[k] == flaws.h.levels[k].node_count, "a wrong count of nodes", "level", k,
                     "those of the level"))
      return false;
  return flaws.check((deepest + 2) * widest <=
                         kMostWaiting * static_cast<std::int64_t>(nodes.size()) + kLeastWaiting,
                     "a tree too deep for its width", "depth", static_cast<std::size_t>(deepest),
                     "few siblings on a way down");
}

// ---- hulls
// ------------------------------------------------------------

/// Vertices, lanes and sphere of a node or contact patch.
template <class Hull>
bool check_hull(Flaws& flaws, const Hull& n, const char* kind, std::size_t i) {
  if (!flaws.check(n.vertex_count >= 1 && n.vertex_count <= kMaxHullVertices &&
                       is_in(n.first_vertex, n.vertex_count, flaws.h.vertices.size()),
                   "vertices out of range", kind, i, "1 to 32 there are"))
    return false;
  const std::int64_t lanes = 3 * std::int64_t{n.lane_count};
  if (!flaws.check(n.lane_count == (n.vertex_count + 7) / 8 * 8 && n.first_lane % 8 == 0 &&
                       is_in(n.first_lane, lanes, flaws.h.lanes.size()),
                   "lanes out of range", kind, i, "whole eights there are"))
    return false;
  double farthest = 0.0;
  bool is_same = true;
  for (std::int32_t k = 0; k < n.lane_count; ++k) {
    const Vec3& p = flaws.h.vertices[idx(n.first_vertex + std::min(k, n.vertex_count - 1))];
    farthest = std::max(farthest, (p - n.center).squaredNorm());
    for (int axis = 0; axis < 3; ++axis)
      is_same = is_same && flaws.h.lanes[idx(n.first_lane + axis * n.lane_count + k)] ==
                               static_cast<float>(p[axis] - n.center[axis]);
  }
  const double slack = kRounding * n.radius + 1e-14 * n.center.template lpNorm<1>();
  return flaws.check(is_same, "lanes that are not its vertices", kind, i,
                     "the vertices about the centre") &&
         flaws.check(n.radius >= 0.0 && std::sqrt(farthest) <= n.radius + slack,
                     "a vertex outside its sphere", kind, i, "a sphere around all");
}

bool is_unit(const Vec3& v) { return std::fabs(v.squaredNorm() - 1.0) <= kRounding; }

bool check_face(const RealFace& face, std::int32_t vertex_count) {
  return is_unit(face.normal) && face.vertices != 0 &&
         face.vertices >> (vertex_count - 1) >> 1 == 0;
}

bool check_edge(const RealEdge& e, std::int32_t vertex_count, std::int32_t face_count) {
  return e.tail < vertex_count && e.head < vertex_count && e.tail != e.head && e.face_left >= -1 &&
         e.face_left < face_count && e.face_right >= -1 && e.face_right < face_count &&
         (e.face_left >= 0 || e.face_right >= 0) && (e.beyond == Vec3::Zero() || is_unit(e.beyond));
}

bool check_triangle(const HullTriangle& t, std::int32_t vertex_count) {
  std::uint32_t mask = 0;
  for (const std::uint8_t corner : t.corner) {
    if (corner >= vertex_count) return false;
    mask |= 1u << corner;
  }
  return mask == t.mask;
}

// A patch, and what the message calls it.
struct NamedPatch {
  const ClodPatch& patch;
  std::int32_t vertex_count;
  std::int64_t level_triangles;  // of its level
  const char* kind;
  std::size_t index;
};

bool check_patch(Flaws& flaws, const NamedPatch& named) {
  const ClodHierarchy& hierarchy = flaws.h;
  const ClodPatch& p = named.patch;
  const std::int32_t vertex_count = named.vertex_count;
  if (!flaws.check(p.triangle_count >= 1 &&
                       is_in(p.first_triangle, p.triangle_count, hierarchy.hull_triangles.size()) &&
                       is_in(p.first_face, p.face_count, hierarchy.faces.size()) &&
                       is_in(p.first_edge, p.edge_count, hierarchy.edges.size()),
                   "triangles, faces or edges out of range", named.kind, named.index,
                   "those there are"))
    return false;
  if (!flaws.check(p.face_count <= std::numeric_limits<std::int16_t>::max() && p.thickness >= 0.0,
                   "a negative thickness or too many faces", named.kind, named.index,
                   "0 or more; at most 32767"))
    return false;
  bool is_right = true;
  for (std::int32_t k = 0; k < p.face_count && is_right; ++k)
    is_right = check_face(hierarchy.faces[idx(p.first_face + k)], vertex_count);
  for (std::int32_t k = 0; k < p.edge_count && is_right; ++k)
    is_right = check_edge(hierarchy.edges[idx(p.first_edge + k)], vertex_count, p.face_count);
  if (!flaws.check(is_right, "a wrong face or edge", named.kind, named.index,
                   "unit normals and its own vertices"))
    return false;
  for (std::int32_t k = 0; k < p.triangle_count && is_right; ++k) {
    const std::int32_t id = hierarchy.triangle_ids[idx(p.first_triangle + k)];
    is_right = id >= 0 && id < named.level_triangles &&
               check_triangle(hierarchy.hull_triangles[idx(p.first_triangle + k)], vertex_count);
  }
  return flaws.check(is_right, "a wrong triangle", named.kind, named.index,
                     "its own vertices and a triangle of its level");
}

// ---- levels
// ------------------------------------------------------------

bool check_levels(Flaws& flaws) {
  const std::vector<ClodLevel>& levels = flaws.h.levels;
  std::vector<std::int32_t> patches(levels.size(), 0);
  std::int32_t last = 1;
  for (std::size_t i = 0; i < flaws.h.level_patches.size(); ++i) {
    const LevelPatch& patch = flaws.h.level_patches[i];
    const std::int32_t node = patch.patch.node;
    if (!flaws.check(patch.level >= last && idx(patch.level) < levels.size() &&
                         !levels[idx(patch.level)].is_free,
                     "a wrong level", "contact patch", i, "simplified levels in order"))
      return false;
    if (!flaws.check(
            node == -1 || (node >= 0 && idx(node) < flaws.h.nodes.size() &&
                           flaws.h.nodes[idx(node)].contact == static_cast<std::int64_t>(i)),
            "a wrong node", "contact patch", i, "the node it belongs to"))
      return false;
    if (!flaws.check(patch.deviation >= 0.0 && patch.hausdorff >= 0.0 && patch.from_below >= 0.0 &&
                         patch.to_below >= 0.0,
                     "a negative distance", "contact patch", i, "0 or more"))
      return false;
    last = patch.level;
    ++patches[idx(patch.level)];
  }
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const ClodLevel& l = levels[k];
    const bool is_simplified = k > 0 && !l.is_free;
    if (!flaws.check(k > 0 ? l.is_free || !levels[k - 1].is_free : !l.is_free,
                     "a level out of order", "level", k,
                     "the original, simplified levels, free levels"))
      return false;
    if (!flaws.check(!is_simplified || (l.resolution > 0.0 && l.patch_count == patches[k] &&
                                        l.triangle_count >= 0),
                     "a wrong resolution or count", "level", k,
                     "a resolution above 0 and the patches of the level"))
      return false;
  }
  return true;
}

/// Bounds of levels are there where simplified levels are, and none is negative.
bool is_as_long(const std::vector<float>& bounds, std::size_t size,
                const ClodHierarchy& hierarchy) {
  return bounds.size() == (hierarchy.level_patches.empty() ? 0 : size) &&
         std::all_of(bounds.begin(), bounds.end(), [](float x) { return x >= 0.0f; });
}

bool check_sizes(Flaws& flaws) {
  const ClodHierarchy& hierarchy = flaws.h;
  const std::size_t largest =
      std::max({hierarchy.nodes.size(), hierarchy.patches.size(), hierarchy.level_patches.size(),
                hierarchy.vertices.size(), hierarchy.lanes.size(), hierarchy.faces.size(),
                hierarchy.edges.size(), hierarchy.hull_triangles.size(), hierarchy.levels.size()});
  return flaws.check(largest <= idx(std::numeric_limits<std::int32_t>::max()), "too large",
                     "an array of", largest, "32-bit indices") &&
         flaws.check(!hierarchy.nodes.empty() && !hierarchy.patches.empty(), "nothing", "nodes",
                     hierarchy.nodes.size(), "a root and patches") &&
         flaws.check(!hierarchy.levels.empty() && hierarchy.levels.size() <= idx(kMostLevels),
                     "too many or no levels", "levels", hierarchy.levels.size(), "1 to 4096") &&
         flaws.check(hierarchy.triangle_ids.size() == hierarchy.hull_triangles.size(),
                     "triangles without a number", "triangle_ids", hierarchy.triangle_ids.size(),
                     "one for each hull triangle") &&
         flaws.check(hierarchy.support.size() ==
                         (hierarchy.level_patches.empty() ? 0 : hierarchy.vertices.size()),
                     "support areas of other vertices", "support", hierarchy.support.size(),
                     "one for each vertex") &&
         flaws.check(is_as_long(hierarchy.vertex_to_below, hierarchy.vertices.size(), hierarchy) &&
                         is_as_long(hierarchy.triangle_to_below, hierarchy.hull_triangles.size(),
                                    hierarchy),
                     "bounds of other parts", "contact patches", hierarchy.level_patches.size(),
                     "bounds for each vertex and triangle") &&
         flaws.check(hierarchy.radius > 0.0 && hierarchy.radius <= kMostLength &&
                         hierarchy.triangle_count >= 1,
                     "no size", "object", 0, "a radius and triangles");
}

}  // namespace

std::string find_flaw(const ClodHierarchy& hierarchy) {
  Flaws flaws{hierarchy, {}};
  if (!check_sizes(flaws)) return flaws.first;
  detail::visit_parts(hierarchy, FiniteCheck{flaws});
  if (!flaws.first.empty() || !check_levels(flaws) || !check_tree(flaws)) return flaws.first;
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i)
    if (!check_hull(flaws, hierarchy.nodes[i], "node", i)) return flaws.first;
  for (std::size_t i = 0; i < hierarchy.level_patches.size(); ++i)
    if (!check_hull(flaws, hierarchy.level_patches[i], "contact patch", i)) return flaws.first;
  for (std::size_t i = 0; i < hierarchy.patches.size(); ++i)
    if (!check_patch(flaws, {hierarchy.patches[i],
                             hierarchy.nodes[idx(hierarchy.patches[i].node)].vertex_count,
                             hierarchy.triangle_count, "patch", i}))
      return flaws.first;
  for (std::size_t i = 0; i < hierarchy.level_patches.size(); ++i) {
    const LevelPatch& patch = hierarchy.level_patches[i];
    if (!check_patch(flaws,
                     {patch.patch, patch.vertex_count,
                      hierarchy.levels[idx(patch.level)].triangle_count, "contact patch", i}))
      return flaws.first;
  }
  return flaws.first;
}

}  // namespace thigma
