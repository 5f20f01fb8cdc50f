#include "experiments/common/outside_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace thigma::experiments {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

const Vec3& corner(const DepthSurface& s, std::int32_t triangle, int k) {
  const auto& t = s.mesh.triangles[static_cast<std::size_t>(triangle)];
  return s.mesh.positions[static_cast<std::size_t>(t[k])];
}

void set_box(const DepthSurface& s, DepthSurface::Node& node) {
  node.low = Vec3::Constant(kFar);
  node.high = Vec3::Constant(-kFar);
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& p = corner(s, s.order[static_cast<std::size_t>(i)], k);
      node.low = node.low.cwiseMin(p);
      node.high = node.high.cwiseMax(p);
    }
  }
}

void split(DepthSurface& s, std::int32_t index) {
  constexpr std::int32_t kLeaf = 4;
  set_box(s, s.nodes[static_cast<std::size_t>(index)]);
  const DepthSurface::Node node = s.nodes[static_cast<std::size_t>(index)];
  if (node.count <= kLeaf) return;
  int axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto middle_of = [&](std::int32_t t) {
    return corner(s, t, 0)[axis] + corner(s, t, 1)[axis] + corner(s, t, 2)[axis];
  };
  const auto begin = s.order.begin() + node.first;
  const std::int32_t half = node.count / 2;
  std::nth_element(begin, begin + half, begin + node.count,
                   [&](std::int32_t x, std::int32_t y) { return middle_of(x) < middle_of(y); });
  for (const bool is_left : {true, false}) {
    DepthSurface::Node child;
    child.first = is_left ? node.first : node.first + half;
    child.count = is_left ? half : node.count - half;
    const auto place = static_cast<std::int32_t>(s.nodes.size());
    s.nodes.push_back(child);
    auto& parent = s.nodes[static_cast<std::size_t>(index)];
    (is_left ? parent.left : parent.right) = place;
    split(s, place);
  }
}

void find_normals(DepthSurface& s) {
  std::map<std::pair<std::int32_t, std::int32_t>, Vec3> edges;
  const auto key = [](std::int32_t a, std::int32_t b) {
    return std::pair{std::min(a, b), std::max(a, b)};
  };
  s.vertex_normals.assign(s.mesh.positions.size(), Vec3::Zero());
  for (std::size_t i = 0; i < s.mesh.triangles.size(); ++i) {
    const auto t = static_cast<std::int32_t>(i);
    const auto& v = s.mesh.triangles[i];
    const Vec3 normal =
        (corner(s, t, 1) - corner(s, t, 0)).cross(corner(s, t, 2) - corner(s, t, 0)).normalized();
    s.face_normals.push_back(normal);
    for (int k = 0; k < 3; ++k) {
      const Vec3 to_next = corner(s, t, (k + 1) % 3) - corner(s, t, k);
      const Vec3 to_last = corner(s, t, (k + 2) % 3) - corner(s, t, k);
      const double angle = std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
      s.vertex_normals[static_cast<std::size_t>(v[k])] += angle * normal;
      edges.try_emplace(key(v[k], v[(k + 1) % 3]), Vec3::Zero()).first->second += normal;
    }
  }
  for (const auto& v : s.mesh.triangles)
    s.edge_normals.push_back(
        {edges.at(key(v[0], v[1])), edges.at(key(v[1], v[2])), edges.at(key(v[2], v[0]))});
}

/// Nearest point of a triangle and the normal of the feature it is on.
struct Nearest {
  double square = kFar;
  Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
};

void offer(const Vec3& p, const Vec3& at, const Vec3& normal, Nearest& best) {
  const double square = (p - at).squaredNorm();
  if (square < best.square) best = {square, at, normal};
}

void look_at_triangle(const DepthSurface& s, std::int32_t t, const Vec3& p, Nearest& best) {
  const auto i = static_cast<std::size_t>(t);
  const Vec3& n = s.face_normals[i];
  bool is_over = true;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = corner(s, t, k), &b = corner(s, t, (k + 1) % 3);
    const Vec3 edge = b - a;
    if (n.cross(edge).dot(p - a) < 0.0) is_over = false;
    const double share = (p - a).dot(edge) / edge.squaredNorm();
    if (share <= 0.0) {
      const auto v = static_cast<std::size_t>(s.mesh.triangles[i][k]);
      offer(p, a, s.vertex_normals[v], best);
    } else if (share < 1.0) {
      offer(p, a + share * edge, s.edge_normals[i][static_cast<std::size_t>(k)], best);
    }
  }
  if (is_over) offer(p, p - n.dot(p - corner(s, t, 0)) * n, n, best);
}

double box_square(const DepthSurface::Node& node, const Vec3& p) {
  return (node.low - p).cwiseMax(p - node.high).cwiseMax(Vec3::Zero()).squaredNorm();
}

/// Signed distance of a point, negative inside [m]. Once the surface is known to be within `enough`
/// of it the search stops: the result is then no more than the distance, and at least -enough.
double distance_beyond(const DepthSurface& s, const Vec3& p, double enough) {
  Nearest best;
  const double enough_square = enough > 0.0 ? enough * enough : -1.0;
  std::vector<std::int32_t> stack{0};
  while (!stack.empty()) {
    const DepthSurface::Node& node = s.nodes[static_cast<std::size_t>(stack.back())];
    stack.pop_back();
    if (box_square(node, p) >= best.square) continue;
    if (node.left < 0) {
      for (std::int32_t i = node.first; i < node.first + node.count; ++i)
        look_at_triangle(s, s.order[static_cast<std::size_t>(i)], p, best);
      if (best.square <= enough_square) return -std::sqrt(best.square);
      continue;
    }
    std::int32_t near = node.left, far = node.right;
    if (box_square(s.nodes[static_cast<std::size_t>(far)], p) <
        box_square(s.nodes[static_cast<std::size_t>(near)], p))
      std::swap(near, far);
    stack.push_back(far);
    stack.push_back(near);
  }
  const double distance = std::sqrt(best.square);
  return best.normal.dot(p - best.point) < 0.0 ? -distance : distance;
}

bool boxes_meet(const DepthSurface::Node& node, const Vec3& low, const Vec3& high) {
  return (node.low.array() <= high.array()).all() && (node.high.array() >= low.array()).all();
}

/// Whether a segment passes through some triangle.
bool passes(const DepthSurface& s, const Vec3& from, const Vec3& to) {
  const Vec3 low = from.cwiseMin(to), high = from.cwiseMax(to);
  std::vector<std::int32_t> stack{0};
  while (!stack.empty()) {
    const DepthSurface::Node& node = s.nodes[static_cast<std::size_t>(stack.back())];
    stack.pop_back();
    if (!boxes_meet(node, low, high)) continue;
    if (node.left >= 0) {
      stack.push_back(node.left);
      stack.push_back(node.right);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = s.order[static_cast<std::size_t>(i)];
      const Vec3& n = s.face_normals[static_cast<std::size_t>(t)];
      const double a = n.dot(from - corner(s, t, 0)), b = n.dot(to - corner(s, t, 0));
      if ((a > 0.0) == (b > 0.0)) continue;
      const Vec3 at = from + a / (a - b) * (to - from);
      bool is_inside = true;
      for (int k = 0; k < 3; ++k) {
        const Vec3 edge = corner(s, t, (k + 1) % 3) - corner(s, t, k);
        is_inside = is_inside && n.cross(edge).dot(at - corner(s, t, k)) >= 0.0;
      }
      if (is_inside) return true;
    }
  }
  return false;
}

/// The vertices of a surface in the other's frame, and how far they are from it at the least.
struct Vertices {
  std::vector<Vec3> points;
  std::vector<double> distance;  // [m]; negative inside
};

Vertices place(const DepthSurface& a, const Pose& b_from_a, const DepthSurface& b,
               DepthMemory::Side& last) {
  Vertices at;
  last.points.resize(a.mesh.positions.size(), Vec3::Zero());
  last.distance.resize(a.mesh.positions.size(), -kFar);
  for (std::size_t i = 0; i < a.mesh.positions.size(); ++i) {
    at.points.push_back(transform_point(b_from_a, a.mesh.positions[i]));
    const double beside = box_square(b.nodes.front(), at.points[i]);
    const double remembered = last.distance[i] - (at.points[i] - last.points[i]).norm();
    at.distance.push_back(std::max(beside > 0.0 ? std::sqrt(beside) : -kFar, remembered));
  }
  return at;
}

/// The deepest vertex; what cannot be it is left alone.
double deepest_vertex(const DepthSurface& b, Vertices& at, DepthMemory::Side& memory) {
  double deepest = 0.0;
  const auto look_at = [&](std::size_t i) {
    if (-at.distance[i] <= deepest) return;
    const double distance = distance_beyond(b, at.points[i], deepest);
    at.distance[i] = memory.distance[i] = distance;
    memory.points[i] = at.points[i];
    if (-distance <= deepest) return;
    deepest = -distance;
    memory.deepest = i;
  };
  look_at(memory.deepest);
  for (std::size_t i = 0; i < at.points.size(); ++i) look_at(i);
  return deepest;
}

/// An edge, and how far its ends are from the other surface at the least; negative inside [m].
struct Edge {
  Vec3 from, to;
  double at_from, at_to;
};

/// The deepest of the points on an edge, where one is deeper than so much. A distance changes no
/// faster than its point moves: what cannot be deeper is not measured.
double deepest_on(const Edge& edge, const DepthSurface& b, int samples, double deepest) {
  const double length = (edge.to - edge.from).norm();
  double last = edge.at_from, last_share = 0.0;
  for (int n = 1; n < samples; ++n) {
    const double share = static_cast<double>(n) / samples;
    const double least =
        std::max(last - (share - last_share) * length, edge.at_to - (1.0 - share) * length);
    if (-least <= deepest) continue;
    last = distance_beyond(b, edge.from + share * (edge.to - edge.from), deepest);
    last_share = share;
    deepest = std::max(deepest, -last);
  }
  return deepest;
}

/// Depth of the points of one surface in the other.
double depth_of(const DepthSurface& a, const Pose& b_from_a, const DepthSurface& b, int samples,
                DepthMemory::Side& memory) {
  const DepthSurface::Node& all = b.nodes.front();
  Vertices at = place(a, b_from_a, b, memory);
  double deepest = deepest_vertex(b, at, memory);
  for (const auto& v : a.mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (v[k] > v[(k + 1) % 3]) continue;  // the other triangle's turn
      const auto i = static_cast<std::size_t>(v[k]), j = static_cast<std::size_t>(v[(k + 1) % 3]);
      const Vec3 &from = at.points[i], &to = at.points[j];
      // No point of the edge is deeper.
      if (0.5 * ((to - from).norm() - at.distance[i] - at.distance[j]) <= deepest) continue;
      if (!boxes_meet(all, from.cwiseMin(to), from.cwiseMax(to)) || !passes(b, from, to)) continue;
      deepest = deepest_on({from, to, at.distance[i], at.distance[j]}, b, samples, deepest);
    }
  }
  return deepest;
}

}  // namespace

DepthSurface make_depth_surface(const TriangleMesh& mesh) {
  DepthSurface s;
  s.mesh = mesh;
  s.order.resize(mesh.triangles.size());
  std::iota(s.order.begin(), s.order.end(), 0);
  s.nodes.push_back({});
  s.nodes.front().count = static_cast<std::int32_t>(s.order.size());
  split(s, 0);
  find_normals(s);
  return s;
}

double signed_distance(const DepthSurface& s, const Vec3& p) { return distance_beyond(s, p, -1.0); }

double outside_depth(const DepthSurface& a, const Pose& world_from_a, const DepthSurface& b,
                     DepthMemory& memory, int samples) {
  return std::max(depth_of(a, world_from_a, b, samples, memory.of_a),
                  depth_of(b, inverse(world_from_a), a, samples, memory.of_b));
}

double outside_depth(const DepthSurface& a, const Pose& world_from_a, const DepthSurface& b,
                     int samples) {
  DepthMemory none;
  return outside_depth(a, world_from_a, b, none, samples);
}

}  // namespace thigma::experiments
