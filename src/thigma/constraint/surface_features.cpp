#include "thigma/constraint/surface_features.h"

#include <algorithm>
#include <utility>

#include "thigma/core/index.h"
#include "thigma/import/read_mesh.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

/// Whether a triangle is as good as a line: one that rounding has folded over faces anywhere, and
/// would hide the convex edge it lies along.
bool is_sliver(const std::array<Vec3, 3>& p, double size) {
  constexpr double kRounding = 3e-7;  // of the size: a few last digits in single precision
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, (p[(k + 1) % 3] - p[k]).norm());
  return !((p[1] - p[0]).cross(p[2] - p[0]).norm() > kRounding * size * longest);
}

/// Triangles of the finest patches that have an area, patch by patch, each with corners of its own.
TriangleMesh collect_triangles(const ClodHierarchy& h, SurfaceFeatures& features) {
  TriangleMesh mesh;
  features.first_triangle.push_back(0);
  for (const ClodPatch& patch : h.patches) {
    const HullView hull = hull_view(h, patch.node);
    for (int t = 0; t < hull.triangle_count; ++t) {
      std::array<Vec3, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = hull.vertices[hull.triangles[t].corner[k]];
      // the edges of one without an area are those of its neighbours
      if (is_sliver(p, h.radius)) continue;
      const auto first = static_cast<std::int32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), p.begin(), p.end());
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    features.first_triangle.push_back(static_cast<std::int32_t>(mesh.triangles.size()));
  }
  return mesh;
}

void add_triangles(const TriangleMesh& mesh, SurfaceFeatures& features) {
  for (const auto& t : mesh.triangles) {
    SurfaceTriangle triangle;
    triangle.vertex = t;
    const Vec3 &a = mesh.positions[idx(t[0])], &b = mesh.positions[idx(t[1])],
               &c = mesh.positions[idx(t[2])];
    const Vec3 area = (b - a).cross(c - a);
    triangle.normal = area / area.norm();
    triangle.center = (a + b + c) / 3.0;
    for (const Vec3& corner : {a, b, c})
      triangle.radius = std::max(triangle.radius, (corner - triangle.center).norm());
    features.patch_triangles.push_back(static_cast<std::int32_t>(features.triangles.size()));
    features.triangles.push_back(triangle);
  }
}

/// Triangles left and right of an edge from its lower vertex to the higher.
struct Sides {
  std::int32_t left = -1, right = -1;
};

Sides sides_of(const EdgeTable& table, const MeshEdge& edge) {
  Sides sides;
  for (const EdgeUse& use : table.uses_of(edge))
    (use.is_forward ? sides.left : sides.right) = use.triangle;
  return sides;
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

void add_neighbours(const EdgeTable& table, SurfaceFeatures& features) {
  for (const MeshEdge& edge : table.edges) {
    const Sides sides = sides_of(table, edge);
    const auto link = [&](std::int32_t triangle, std::int32_t tail, std::int32_t other) {
      if (triangle < 0) return;
      SurfaceTriangle& of = features.triangles[idx(triangle)];
      const auto place = std::find(of.vertex.begin(), of.vertex.end(), tail);
      of.across[static_cast<std::size_t>(place - of.vertex.begin())] = other;
    };
    link(sides.left, edge.a, sides.right);
    link(sides.right, edge.b, sides.left);
  }
}

void add_directions(const EdgeTable& table, SurfaceFeatures& features) {
  std::vector<std::vector<std::int32_t>> neighbours(features.vertices.size());
  for (const MeshEdge& edge : table.edges) {
    neighbours[idx(edge.a)].push_back(edge.b);
    neighbours[idx(edge.b)].push_back(edge.a);
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

std::vector<FoundEdge> convex_edges(const EdgeTable& table, const SurfaceFeatures& features) {
  std::vector<FoundEdge> found;
  for (const MeshEdge& of_mesh : table.edges) {
    const Sides sides = sides_of(table, of_mesh);
    FoundEdge one;
    ConvexEdge& edge = one.edge;
    edge.tail = of_mesh.a;
    edge.head = of_mesh.b;
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

/// Patches by triangle.
std::vector<std::int32_t> patches_of(const ClodHierarchy& h, const SurfaceFeatures& features) {
  std::vector<std::int32_t> patch_of(features.triangles.size());
  for (std::size_t p = 0; p < h.patches.size(); ++p) {
    for (std::int32_t i = features.first_triangle[p]; i < features.first_triangle[p + 1]; ++i)
      patch_of[idx(features.patch_triangles[idx(i)])] = static_cast<std::int32_t>(p);
  }
  return patch_of;
}

PatchNormals normals_of(const SurfaceFeatures& features, std::size_t patch) {
  constexpr double kRounding = 1e-12;
  const auto triangles =
      part_of(features.patch_triangles, features.first_triangle, static_cast<std::int32_t>(patch));
  PatchNormals normals;
  for (const std::int32_t t : triangles) normals.axis += features.triangles[idx(t)].normal;
  const double length = normals.axis.norm();
  normals.axis = length > kRounding ? Vec3(normals.axis / length) : Vec3::Zero();
  for (const std::int32_t t : triangles)
    normals.spread =
        std::max(normals.spread, (features.triangles[idx(t)].normal - normals.axis).norm());
  normals.spread += kRounding;
  return normals;
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
    const ClodNode& node = h.nodes[idx(h.patches[p].node)];
    features.patch_balls.push_back({node.center, node.radius});
    features.patch_normals.push_back(normals_of(features, p));
  }
}

}  // namespace

SurfaceFeatures find_features(const ClodHierarchy& hierarchy) {
  SurfaceFeatures features;
  const TriangleMesh mesh = merge_equal_positions(collect_triangles(hierarchy, features)).mesh;
  features.vertices = mesh.positions;
  add_triangles(mesh, features);
  const EdgeTable edges = build_edge_table(mesh);
  add_neighbours(edges, features);
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
