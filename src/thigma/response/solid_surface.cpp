#include "thigma/response/solid_surface.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "thigma/core/index.h"
#include "thigma/math/elementary.h"

namespace thigma {
namespace {

/// Triangles that have an area, with the corners they share.
TriangleMesh finest_mesh(const ClodHierarchy& h) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, std::int32_t> known;
  const auto vertex_of = [&](const Vec3& p) {
    const auto [at, is_new] = known.try_emplace(
        {p.x(), p.y(), p.z()}, static_cast<std::int32_t>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(p);
    return at->second;
  };
  for (const ClodPatch& patch : h.patches) {
    const HullView hull = hull_view(h, patch.node);
    for (int t = 0; t < hull.triangle_count; ++t) {
      std::array<std::int32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = vertex_of(hull.vertices[hull.triangles[t].corner[k]]);
      const Vec3 &a = mesh.positions[idx(corners[0])], &b = mesh.positions[idx(corners[1])],
                 &c = mesh.positions[idx(corners[2])];
      if ((b - a).cross(c - a).norm() > 0.0) mesh.triangles.push_back(corners);
    }
  }
  return mesh;
}

using EdgeKey = std::array<std::int32_t, 2>;
EdgeKey edge_key(const std::array<std::int32_t, 3>& t, std::size_t k) {
  const std::int32_t a = t[k], b = t[(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

double angle_between(const Vec3& a, const Vec3& b) {
  return arc_tangent2(a.cross(b).norm(), a.dot(b));
}

void find_normals(SolidSurface& s) {
  const TriangleMesh& mesh = s.mesh;
  struct Sides {
    Vec3 sum = Vec3::Zero();
    int count = 0;
  };
  std::map<EdgeKey, Sides> edges;
  s.vertex.assign(mesh.positions.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.positions[idx(t[k])];
    s.face.push_back((p[1] - p[0]).cross(p[2] - p[0]).normalized());
    for (std::size_t k = 0; k < 3; ++k) {
      Sides& sides = edges[edge_key(t, k)];
      sides.sum += s.face.back();
      ++sides.count;
      s.vertex[idx(t[k])] +=
          angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]) * s.face.back();
    }
  }
  s.edge.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Sides& sides = edges[edge_key(mesh.triangles[i], k)];
      s.edge[i][k] = sides.count > 1 ? sides.sum : Vec3::Zero();
    }
  for (const auto& [key, sides] : edges)
    if (sides.count == 1) s.vertex[idx(key[0])] = s.vertex[idx(key[1])] = Vec3::Zero();
}

/// The point of a triangle nearest to another, and the part it lies on: 0 the face, 1 to 3 an edge
/// from that corner on, 4 to 6 a corner.
struct Nearest {
  Vec3 at = Vec3::Zero();
  double square = 0.0;
  int part = 0;
};

Nearest nearest_on(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const auto found = [&](const Vec3& at, int part) {
    return Nearest{at, (p - at).squaredNorm(), part};
  };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return found(a, 4);
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return found(b, 5);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return found(a + d1 / (d1 - d3) * ab, 1);
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return found(c, 6);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return found(a + d2 / (d2 - d6) * ac, 3);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6)
    return found(b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 2);
  const double all = va + vb + vc;
  return found(a + (vb / all) * ab + (vc / all) * ac, 0);
}

struct Search {
  const SolidSurface& surface;
  Vec3 point;
  Nearest best;
  std::int32_t triangle = -1;

  void look_at(std::int32_t t) noexcept {
    const auto& v = surface.mesh.triangles[idx(t)];
    const std::vector<Vec3>& p = surface.mesh.positions;
    const Nearest here = nearest_on(point, p[idx(v[0])], p[idx(v[1])], p[idx(v[2])]);
    if (triangle >= 0 && !(here.square < best.square)) return;
    best = here;
    triangle = t;
  }
};

double square_distance(const TreeBox& box, const Vec3& p) noexcept {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(0.0).squaredNorm();
}

void descend(Search& search) noexcept {
  struct Open {
    std::int32_t node;
    double square;
  };
  std::array<Open, 64> stack;  // one a level; the tree halves
  std::size_t top = 0;
  const TriangleTree& tree = search.surface.tree;
  stack[top++] = {0, 0.0};
  while (top > 0) {
    const Open open = stack[--top];
    if (search.triangle >= 0 && !(open.square < search.best.square)) continue;
    const TreeNode& node = tree.nodes[idx(open.node)];
    if (node.count > 0) {
      for (std::int32_t i = node.first; i < node.first + node.count; ++i)
        search.look_at(tree.order[idx(i)]);
      continue;
    }
    Open near{open.node + 1, square_distance(tree.nodes[idx(open.node + 1)].box, search.point)};
    Open far{node.right, square_distance(tree.nodes[idx(node.right)].box, search.point)};
    if (far.square < near.square) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
}

}  // namespace

SolidSurface make_solid_surface(const ClodHierarchy& hierarchy) {
  SolidSurface s;
  s.mesh = finest_mesh(hierarchy);
  std::vector<std::int32_t> all(s.mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  s.tree = build_triangle_tree(s.mesh, std::move(all));
  find_normals(s);
  return s;
}

PointDepth depth_inside(const SolidSurface& surface, const Vec3& point,
                        std::int32_t guess) noexcept {
  Search search{surface, point, {}, -1};
  if (guess >= 0) search.look_at(guess);
  descend(search);
  const auto t = idx(search.triangle);
  const auto part = static_cast<std::size_t>(search.best.part);
  const Vec3 side = part == 0  ? surface.face[t]
                    : part < 4 ? surface.edge[t][part - 1]
                               : surface.vertex[idx(surface.mesh.triangles[t][part - 4])];
  const Vec3 away = point - search.best.at;
  const double distance = away.norm();
  const double over = away.dot(side);
  const bool is_inside = over < 0.0;
  PointDepth found;
  found.triangle = search.triangle;
  found.depth = is_inside ? distance : -distance;
  // On the surface itself the way to it has no direction.
  constexpr double kRounding = 1e-9;
  const double size = side.norm();
  if (std::fabs(over) > kRounding * size * point.norm())
    found.outward = (is_inside ? -away : away) / distance;
  else if (size > 0.0)
    found.outward = side / size;
  else if (distance > 0.0)
    found.outward = away / distance;
  return found;
}

}  // namespace thigma
