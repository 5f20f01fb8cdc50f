#include "thigma/response/solid_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

#include "thigma/core/index.h"
#include "thigma/math/elementary.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma {
namespace {

/// Triangles before their equal corners are made one.
struct Gathering {
  TriangleMesh mesh;
  // which edges, from corner k on, a border of the surface is known to run along; empty: those of
  // one triangle
  std::vector<std::array<bool, 3>> is_rim;

  std::int32_t vertex(const Vec3& p) {
    mesh.positions.push_back(p);
    return static_cast<std::int32_t>(mesh.positions.size()) - 1;
  }
};

/// Makes equal positions one and takes out triangles without an area.
void merge_corners(Gathering& all) {
  const std::vector<Vec3> given = std::move(all.mesh.positions);
  std::vector<std::int32_t> order(given.size()), merged(given.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t v) {
    const Vec3& p = given[idx(v)];
    return std::make_tuple(p.x(), p.y(), p.z(), v);
  };
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  std::vector<Vec3>& kept = all.mesh.positions;
  kept.clear();
  for (const std::int32_t v : order) {
    if (kept.empty() || kept.back() != given[idx(v)]) kept.push_back(given[idx(v)]);
    merged[idx(v)] = static_cast<std::int32_t>(kept.size()) - 1;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < all.mesh.triangles.size(); ++i) {
    std::array<std::int32_t, 3> t = all.mesh.triangles[i];
    for (std::int32_t& v : t) v = merged[idx(v)];
    const Vec3 &a = kept[idx(t[0])], &b = kept[idx(t[1])], &c = kept[idx(t[2])];
    if (!((b - a).cross(c - a).norm() > 0.0)) continue;
    all.mesh.triangles[count] = t;
    if (!all.is_rim.empty()) all.is_rim[count] = all.is_rim[i];
    ++count;
  }
  all.mesh.triangles.resize(count);
  if (!all.is_rim.empty()) all.is_rim.resize(count);
}

Gathering finest_mesh(const ClodHierarchy& h) {
  Gathering all;
  for (const ClodPatch& patch : h.patches) {
    const HullView hull = hull_view(h, patch.node);
    for (int t = 0; t < hull.triangle_count; ++t) {
      std::array<std::int32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = all.vertex(hull.vertices[hull.triangles[t].corner[k]]);
      all.mesh.triangles.push_back(corners);
    }
  }
  return all;
}

using EdgeKey = std::array<std::int32_t, 2>;
EdgeKey edge_key(const std::array<std::int32_t, 3>& t, std::size_t k) {
  const std::int32_t a = t[k], b = t[(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

double angle_between(const Vec3& a, const Vec3& b) {
  return arc_tangent2(a.cross(b).norm(), a.dot(b));
}

/// An edge of a triangle.
struct Side {
  EdgeKey key;
  std::int32_t triangle;
  std::int32_t corner;  // it runs on from
};

Vec3 normal_of(const TriangleMesh& mesh, std::int32_t triangle) noexcept {
  const auto& t = mesh.triangles[idx(triangle)];
  const Vec3& a = mesh.positions[idx(t[0])];
  return (mesh.positions[idx(t[1])] - a).cross(mesh.positions[idx(t[2])] - a).normalized();
}

void find_neighbours(const std::vector<std::array<bool, 3>>& is_rim, SolidSurface& s) {
  std::vector<Side> sides;
  sides.reserve(3 * s.mesh.triangles.size());
  for (std::size_t i = 0; i < s.mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back({edge_key(s.mesh.triangles[i], k), static_cast<std::int32_t>(i),
                       static_cast<std::int32_t>(k)});
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.key, a.triangle, a.corner) < std::tie(b.key, b.triangle, b.corner);
  });
  s.across.resize(s.mesh.triangles.size());
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    for (last = first; last < sides.size() && sides[last].key == sides[first].key;) ++last;
    const Side& one = sides[first];
    // Where the rim is not told, what one triangle has alone; seams of textures gape.
    const bool is_border =
        is_rim.empty() ? last == first + 1 : is_rim[idx(one.triangle)][idx(one.corner)];
    if (is_border) s.vertex[idx(one.key[0])] = s.vertex[idx(one.key[1])] = Vec3::Zero();
    for (std::size_t i = first; i < last; ++i) {
      const Side& next = sides[i + 1 < last ? i + 1 : first];
      s.across[idx(sides[i].triangle)][idx(sides[i].corner)] = is_border ? -1 : next.triangle;
    }
  }
}

void find_normals(const std::vector<std::array<bool, 3>>& is_rim, SolidSurface& s) {
  const TriangleMesh& mesh = s.mesh;
  s.vertex.assign(mesh.positions.size(), Vec3::Zero());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Vec3 normal = normal_of(mesh, static_cast<std::int32_t>(i));
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[idx(t[k])];
      s.vertex[idx(t[k])] += angle_between(mesh.positions[idx(t[(k + 1) % 3])] - p,
                                           mesh.positions[idx(t[(k + 2) % 3])] - p) *
                             normal;
    }
  }
  find_neighbours(is_rim, s);
}

/// Which way is outside at a part of a triangle, of any length; zero at borders.
Vec3 outside_at(const SolidSurface& s, std::int32_t triangle, int part) noexcept {
  if (part == 0) return normal_of(s.mesh, triangle);
  const auto k = static_cast<std::size_t>(part);
  if (part > 3) return s.vertex[idx(s.mesh.triangles[idx(triangle)][k - 4])];
  const std::int32_t other = s.across[idx(triangle)][k - 1];
  if (other < 0) return Vec3::Zero();
  return normal_of(s.mesh, triangle) + normal_of(s.mesh, other);
}

SolidSurface finished(Gathering all) {
  merge_corners(all);
  SolidSurface s;
  s.mesh = std::move(all.mesh);
  std::vector<std::int32_t> order(s.mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  s.tree = build_triangle_tree(s.mesh, std::move(order));
  s.tree.boxes = {};
  find_normals(all.is_rim, s);
  return s;
}

/// How often the edges of a coarse triangle are divided: to a texel either way.
int divisions_of(const std::array<Vec2, 3>& corners) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).cwiseAbs().maxCoeff());
  return std::max(1, static_cast<int>(std::ceil(longest)));
}

/// A coarse triangle's part of the fine surface.
void add_fine(const HapticTexture& texture, std::size_t triangle, const std::array<bool, 3>& is_rim,
              Gathering& all) {
  const auto& t = texture.coarse.triangles[triangle];
  const auto& uv = texture.corners[triangle];
  const int n = divisions_of(uv);
  std::vector<std::int32_t> rows;  // of i = 0 .. n, j = 0 .. n - i
  const auto place = [n](int i, int j) {
    return static_cast<std::size_t>(i * (n + 1) - i * (i - 1) / 2 + j);
  };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n - i; ++j) {
      const double s = static_cast<double>(i) / n, r = static_cast<double>(j) / n, q = 1.0 - s - r;
      const auto mixed = [&](const auto& a, const auto& b, const auto& c) {
        return (q * a + s * b + r * c).eval();
      };
      const Vec3 coarse =
          mixed(texture.coarse.positions[idx(t[0])], texture.coarse.positions[idx(t[1])],
                texture.coarse.positions[idx(t[2])]);
      rows.push_back(all.vertex(coarse + displacement_at(texture, mixed(uv[0], uv[1], uv[2]))));
    }
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, std::array<bool, 3> rim) {
    all.mesh.triangles.push_back({rows[a], rows[b], rows[c]});
    all.is_rim.push_back(rim);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n - i; ++j) {
      // Edges of the coarse triangle: j = 0, i + j = n, i = 0.
      add(place(i, j), place(i + 1, j), place(i, j + 1),
          {j == 0 && is_rim[0], i + j + 1 == n && is_rim[1], i == 0 && is_rim[2]});
      if (i + j + 1 < n) add(place(i + 1, j), place(i + 1, j + 1), place(i, j + 1), {});
    }
  }
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
  return finished(finest_mesh(hierarchy));
}

SolidSurface make_solid_surface(const HapticTexture& texture) {
  constexpr double kMost = 8e6;
  double triangles = 0.0;
  for (const auto& corners : texture.corners) {
    const double n = divisions_of(corners);
    triangles += n * n;
  }
  if (triangles > kMost)
    throw std::invalid_argument("potential response: relief of " +
                                std::to_string(static_cast<std::int64_t>(triangles)) +
                                " triangles of a texel, expected at most 8000000");
  std::map<EdgeKey, int> uses;
  for (const auto& t : texture.coarse.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[edge_key(t, k)];
  Gathering all;
  for (std::size_t i = 0; i < texture.coarse.triangles.size(); ++i) {
    std::array<bool, 3> is_rim{};
    for (std::size_t k = 0; k < 3; ++k)
      is_rim[k] = uses[edge_key(texture.coarse.triangles[i], k)] == 1;
    add_fine(texture, i, is_rim, all);
  }
  return finished(std::move(all));
}

PointDepth depth_inside(const SolidSurface& surface, const Vec3& point,
                        std::int32_t guess) noexcept {
  Search search{surface, point, {}, -1};
  if (guess >= 0) search.look_at(guess);
  descend(search);
  const Vec3 side = outside_at(surface, search.triangle, search.best.part);
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
