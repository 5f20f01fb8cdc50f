#include "thigma/constraint/surface_features.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "thigma/core/index.h"

namespace thigma {
namespace {

struct PositionHash {
  std::size_t operator()(const std::array<std::uint64_t, 3>& p) const {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const std::uint64_t part : p) h = (h ^ part) * 0xff51afd7ed558ccdu + (h >> 29);
    return static_cast<std::size_t>(h);
  }
};

std::array<std::uint64_t, 3> bits_of(const Vec3& p) {
  // -0 and 0 are one position
  return {std::bit_cast<std::uint64_t>(p.x() + 0.0), std::bit_cast<std::uint64_t>(p.y() + 0.0),
          std::bit_cast<std::uint64_t>(p.z() + 0.0)};
}

/// Triangles by vertices that are one where positions are equal.
class Welded {
 public:
  explicit Welded(SurfaceFeatures& features) : features_(features) {}

  std::int32_t vertex(const Vec3& position) {
    const auto next = static_cast<std::int32_t>(features_.vertices.size());
    const auto [found, is_new] = known_.emplace(bits_of(position), next);
    if (is_new) features_.vertices.push_back(position);
    return found->second;
  }

 private:
  SurfaceFeatures& features_;
  std::unordered_map<std::array<std::uint64_t, 3>, std::int32_t, PositionHash> known_;
};

void add_patch(const ClodHierarchy& h, const ClodPatch& patch, Welded& weld,
               SurfaceFeatures& features) {
  const HullView hull = hull_view(h, patch.node);
  for (int t = 0; t < hull.triangle_count; ++t) {
    SurfaceTriangle triangle;
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = hull.vertices[hull.triangles[t].corner[k]];
      triangle.vertex[k] = weld.vertex(p[k]);
    }
    const Vec3 area = (p[1] - p[0]).cross(p[2] - p[0]);
    const double size = area.norm();
    if (!(size > 0.0)) continue;  // its edges are those of its neighbours
    triangle.normal = area / size;
    triangle.center = (p[0] + p[1] + p[2]) / 3.0;
    for (const Vec3& corner : p)
      triangle.radius = std::max(triangle.radius, (corner - triangle.center).norm());
    features.patch_triangles.push_back(static_cast<std::int32_t>(features.triangles.size()));
    features.triangles.push_back(triangle);
  }
  features.first_triangle.push_back(static_cast<std::int32_t>(features.patch_triangles.size()));
}

/// Triangles left and right of an edge from the lower vertex to the higher.
struct Sides {
  std::int32_t left = -1, right = -1;
};
using EdgeMap = std::map<std::pair<std::int32_t, std::int32_t>, Sides>;

EdgeMap find_edges(const SurfaceFeatures& features) {
  EdgeMap edges;
  for (std::size_t t = 0; t < features.triangles.size(); ++t) {
    const auto& v = features.triangles[t].vertex;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = v[k], b = v[(k + 1) % 3];
      Sides& sides = edges[{std::min(a, b), std::max(a, b)}];
      (a < b ? sides.left : sides.right) = static_cast<std::int32_t>(t);
    }
  }
  return edges;
}

Vec3 into(const SurfaceFeatures& features, std::int32_t triangle, const Vec3& along) {
  if (triangle < 0) return Vec3::Zero();
  return features.triangles[idx(triangle)].normal.cross(along);
}

/// Convex by more than rounding, or with one side only.
bool may_touch(const SurfaceFeatures& features, const Sides& sides, const ConvexEdge& edge) {
  if (sides.left < 0 || sides.right < 0) return true;
  // The other side's face goes down from this one's plane.
  constexpr double kRounding = 1e-9;
  return features.triangles[idx(sides.left)].normal.dot(edge.into_right) < -kRounding;
}

void add_directions(const EdgeMap& edges, SurfaceFeatures& features) {
  std::vector<std::vector<std::int32_t>> neighbours(features.vertices.size());
  for (const auto& [ends, sides] : edges) {
    neighbours[idx(ends.first)].push_back(ends.second);
    neighbours[idx(ends.second)].push_back(ends.first);
  }
  features.first_direction.push_back(0);
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    for (const std::int32_t w : neighbours[v])
      features.directions.push_back(
          (features.vertices[idx(w)] - features.vertices[v]).normalized());
    features.first_direction.push_back(static_cast<std::int32_t>(features.directions.size()));
  }
}

/// Whether directions lie strictly on one side of a plane. The normals of all planes that have them
/// on one side form a cone, whose extreme rays are among the cross products of two of them, and
/// across these where all lie in one plane; the sum is inside the cone, and touches no direction
/// where the cone is not flat.
bool are_strict(std::span<const Vec3> directions) {
  constexpr double kFlat = 1e-9;
  constexpr std::size_t kMany = 48;  // in doubt a corner: rows too many do no harm
  if (directions.size() > kMany) return true;
  Vec3 sum = Vec3::Zero();
  const auto add = [&](const Vec3& normal) {
    const auto is_above = [&](const Vec3& d) { return d.dot(normal) >= -kFlat; };
    if (std::all_of(directions.begin(), directions.end(), is_above)) sum += normal;
  };
  for (const Vec3& a : directions) {
    for (const Vec3& b : directions) {
      const Vec3 cross = a.cross(b);
      const double size = cross.norm();
      if (size < kFlat) continue;
      add(cross / size);
      add(cross.cross(a) / size);
      add(a.cross(cross) / size);
    }
  }
  const double length = sum.norm();
  return length > kFlat && std::all_of(directions.begin(), directions.end(),
                                       [&](const Vec3& d) { return d.dot(sum) > kFlat * length; });
}

void find_corners(SurfaceFeatures& features) {
  for (std::size_t v = 0; v < features.vertices.size(); ++v) {
    const auto first = static_cast<std::size_t>(features.first_direction[v]);
    const auto last = static_cast<std::size_t>(features.first_direction[v + 1]);
    features.is_corner.push_back(are_strict({features.directions.data() + first, last - first}));
  }
}

/// Convex edges with the triangles on their sides.
struct FoundEdge {
  ConvexEdge edge;
  std::vector<std::int32_t> triangles;
};

std::vector<FoundEdge> convex_edges(const EdgeMap& edges, const SurfaceFeatures& features) {
  std::vector<FoundEdge> found;
  for (const auto& [ends, sides] : edges) {
    FoundEdge one;
    ConvexEdge& edge = one.edge;
    edge.tail = ends.first;
    edge.head = ends.second;
    edge.direction =
        (features.vertices[idx(edge.head)] - features.vertices[idx(edge.tail)]).normalized();
    // Left of an edge that its triangle has in this direction is across it to the left.
    edge.into_left = into(features, sides.left, edge.direction);
    edge.into_right = into(features, sides.right, -edge.direction);
    if (!may_touch(features, sides, edge)) continue;
    for (const std::int32_t t : {sides.left, sides.right}) {
      if (t < 0) continue;
      one.triangles.push_back(t);
      edge.outward += features.triangles[idx(t)].normal;
    }
    found.push_back(std::move(one));
  }
  return found;
}

bool is_same(const Vec3& a, const Vec3& b) {
  constexpr double kRounding = 1e-9;
  return (a - b).norm() <= kRounding;
}

/// The second of two edges made part of the first, where both are one straight edge between the
/// same two faces that a vertex divides.
bool join(FoundEdge& first, FoundEdge& second, std::int32_t vertex) {
  ConvexEdge& a = first.edge;
  ConvexEdge b = second.edge;
  if ((a.head == vertex) != (b.tail == vertex)) {
    std::swap(b.tail, b.head);
    b.direction = -b.direction;
    std::swap(b.into_left, b.into_right);
  }
  if (!is_same(a.direction, b.direction) || !is_same(a.into_left, b.into_left) ||
      !is_same(a.into_right, b.into_right))
    return false;
  (a.head == vertex ? a.head : a.tail) = a.head == vertex ? b.head : b.tail;
  first.triangles.insert(first.triangles.end(), second.triangles.begin(), second.triangles.end());
  return true;
}

/// Straight edges as long as they are: where a vertex divides one it is no corner.
void join_straight_edges(const SurfaceFeatures& features, std::vector<FoundEdge>& edges) {
  std::vector<std::vector<std::size_t>> at_vertex(features.vertices.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    at_vertex[idx(edges[i].edge.tail)].push_back(i);
    at_vertex[idx(edges[i].edge.head)].push_back(i);
  }
  for (std::size_t v = 0; v < at_vertex.size(); ++v) {
    if (features.is_corner[v] != 0 || at_vertex[v].size() != 2) continue;
    const std::size_t a = at_vertex[v][0], b = at_vertex[v][1];
    if (a == b || !join(edges[a], edges[b], static_cast<std::int32_t>(v))) continue;
    const ConvexEdge& joined = edges[a].edge;
    for (const std::int32_t end : {joined.tail, joined.head})
      std::replace(at_vertex[idx(end)].begin(), at_vertex[idx(end)].end(), b, a);
    edges[b].triangles.clear();
  }
  std::erase_if(edges, [](const FoundEdge& e) { return e.triangles.empty(); });
}

void measure(const SurfaceFeatures& features, ConvexEdge& edge) {
  const Vec3 span = features.vertices[idx(edge.head)] - features.vertices[idx(edge.tail)];
  edge.middle = features.vertices[idx(edge.tail)] + 0.5 * span;
  edge.half = 0.5 * span.norm();
}

PatchBall ball_about(const SurfaceFeatures& features, const std::vector<std::int32_t>& vertices) {
  PatchBall ball;
  for (const std::int32_t v : vertices) ball.center += features.vertices[idx(v)];
  ball.center /= std::max(static_cast<double>(vertices.size()), 1.0);
  for (const std::int32_t v : vertices)
    ball.radius = std::max(ball.radius, (features.vertices[idx(v)] - ball.center).norm());
  return ball;
}

/// Patches by triangle.
std::vector<std::int32_t> patches_of(const ClodHierarchy& h, const SurfaceFeatures& features) {
  std::vector<std::int32_t> patch_of(features.triangles.size());
  for (std::size_t p = 0; p < h.patches.size(); ++p) {
    for (std::int32_t i = features.first_triangle[p]; i < features.first_triangle[p + 1]; ++i)
      patch_of[idx(features.patch_triangles[idx(i)])] = static_cast<std::int32_t>(p);
  }
  return patch_of;
}

void add_patch_lists(const ClodHierarchy& h, const std::vector<FoundEdge>& found,
                     SurfaceFeatures& features) {
  const std::vector<std::int32_t> patch_of = patches_of(h, features);
  std::vector<std::vector<std::int32_t>> edges(h.patches.size());
  for (std::size_t e = 0; e < found.size(); ++e) {
    for (const std::int32_t t : found[e].triangles) {
      auto& list = edges[idx(patch_of[idx(t)])];
      const auto index = static_cast<std::int32_t>(e);
      if (list.empty() || list.back() != index) list.push_back(index);
    }
  }
  features.first_vertex.push_back(0);
  features.first_edge.push_back(0);
  for (std::size_t p = 0; p < h.patches.size(); ++p) {
    std::vector<std::int32_t> vertices;
    for (std::int32_t i = features.first_triangle[p]; i < features.first_triangle[p + 1]; ++i) {
      const auto& v = features.triangles[idx(features.patch_triangles[idx(i)])].vertex;
      vertices.insert(vertices.end(), v.begin(), v.end());
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    auto& all = features.patch_vertices;
    all.insert(all.end(), vertices.begin(), vertices.end());
    features.first_vertex.push_back(static_cast<std::int32_t>(all.size()));
    features.patch_edges.insert(features.patch_edges.end(), edges[p].begin(), edges[p].end());
    features.first_edge.push_back(static_cast<std::int32_t>(features.patch_edges.size()));
    features.patch_balls.push_back(ball_about(features, vertices));
  }
}

}  // namespace

SurfaceFeatures find_features(const ClodHierarchy& hierarchy) {
  SurfaceFeatures features;
  Welded weld(features);
  features.first_triangle.push_back(0);
  for (const ClodPatch& patch : hierarchy.patches) add_patch(hierarchy, patch, weld, features);
  const EdgeMap edges = find_edges(features);
  add_directions(edges, features);
  find_corners(features);
  std::vector<FoundEdge> found = convex_edges(edges, features);
  join_straight_edges(features, found);
  for (FoundEdge& one : found) {
    measure(features, one.edge);
    features.edges.push_back(one.edge);
  }
  add_patch_lists(hierarchy, found, features);
  for (const Vec3& v : features.vertices) features.size = std::max(features.size, v.norm());
  return features;
}

}  // namespace thigma
