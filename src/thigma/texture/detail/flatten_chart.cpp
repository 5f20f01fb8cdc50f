// With a triangle's own axes as complex numbers z and its corners in the plane as U, the map keeps
// angles where sum_k W_k U_k = 0, W_k the edge opposite corner k. Summed squares over all
// triangles, weighted by area, are least where their normal equations hold; two vertices are held,
// or all of it would shrink to a point.
#include "thigma/texture/detail/flatten_chart.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/SVD>
#include <Eigen/SparseCholesky>

#include "thigma/core/index.h"
#include "thigma/math/plane_cross.h"

namespace thigma::detail {
namespace {

// Corners in axes of the triangle's own.
std::array<Vec2, 3> own_corners(const TriangleMesh& mesh, std::int32_t t) {
  const auto& v = mesh.triangles[idx(t)];
  const Vec3& a = mesh.positions[idx(v[0])];
  const Vec3 x = (mesh.positions[idx(v[1])] - a).normalized();
  const Vec3 c = mesh.positions[idx(v[2])] - a;
  const double along = x.dot(c);
  return {Vec2(0.0, 0.0), Vec2((mesh.positions[idx(v[1])] - a).norm(), 0.0),
          Vec2(along, (c - along * x).norm())};
}

struct Vertices {
  std::vector<std::int32_t> all;                       // of the mesh, in order of appearance
  std::vector<std::array<std::int32_t, 3>> triangles;  // into `all`
};

Vertices collect(const TriangleMesh& mesh, std::span<const std::int32_t> triangles) {
  Vertices vertices;
  std::map<std::int32_t, std::int32_t> index;
  for (const std::int32_t t : triangles) {
    std::array<std::int32_t, 3> mine{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t v = mesh.triangles[idx(t)][k];
      const auto [found, is_new] = index.emplace(v, static_cast<std::int32_t>(vertices.all.size()));
      if (is_new) vertices.all.push_back(v);
      mine[k] = found->second;
    }
    vertices.triangles.push_back(mine);
  }
  return vertices;
}

std::int32_t farthest_from(const TriangleMesh& mesh, const Vertices& vertices, std::int32_t from) {
  std::int32_t best = 0;
  double most = -1.0;
  const Vec3& p = mesh.positions[idx(vertices.all[idx(from)])];
  for (std::size_t i = 0; i < vertices.all.size(); ++i) {
    const double distance = (mesh.positions[idx(vertices.all[i])] - p).squaredNorm();
    if (distance > most) {
      most = distance;
      best = static_cast<std::int32_t>(i);
    }
  }
  return best;
}

/// Places in the plane of the collected vertices; empty when the equations have no single solution.
std::vector<Vec2> solve(const TriangleMesh& mesh, std::span<const std::int32_t> triangles,
                        const Vertices& vertices) {
  const std::int32_t count = static_cast<std::int32_t>(vertices.all.size());
  const std::int32_t one = farthest_from(mesh, vertices, 0);
  const std::int32_t other = farthest_from(mesh, vertices, one);
  const double apart =
      (mesh.positions[idx(vertices.all[idx(one)])] - mesh.positions[idx(vertices.all[idx(other)])])
          .norm();
  std::vector<std::int32_t> column(idx(count), -1);
  std::int32_t unknowns = 0;
  for (std::int32_t i = 0; i < count; ++i)
    if (i != one && i != other) column[idx(i)] = unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::array<Vec2, 3> z = own_corners(mesh, triangles[i]);
    const double weight = 1.0 / std::sqrt(cross(z[1] - z[0], z[2] - z[0]));
    const auto row = static_cast<std::int32_t>(2 * i);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 w = weight * (z[(k + 2) % 3] - z[(k + 1) % 3]);
      const std::int32_t vertex = vertices.triangles[i][k];
      if (vertex == other) right.segment<2>(row) -= apart * w;  // it is held at (apart, 0)
      const std::int32_t u = column[idx(vertex)];
      if (u < 0) continue;
      entries.emplace_back(row, u, w.x());
      entries.emplace_back(row, unknowns + u, -w.y());
      entries.emplace_back(row + 1, u, w.y());
      entries.emplace_back(row + 1, unknowns + u, w.x());
    }
  }
  Eigen::SparseMatrix<double> matrix(right.size(), 2 * unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> normal = matrix.transpose() * matrix;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
  if (solver.info() != Eigen::Success) return {};
  const Eigen::VectorXd found = solver.solve(matrix.transpose() * right);
  if (!found.allFinite()) return {};
  std::vector<Vec2> places(idx(count));
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t u = column[idx(i)];
    places[idx(i)] =
        u >= 0 ? Vec2(found[u], found[unknowns + u]) : Vec2(i == other ? apart : 0.0, 0.0);
  }
  return places;
}

/// Whether an edge of one triangle has all of the other outside, to rounding. Both turn to the
/// left.
bool are_apart(const std::array<Vec2, 3>& one, const std::array<Vec2, 3>& other) {
  constexpr double kRounding = 1e-9;  // of the edge and its distance
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& a = one[k];
    const Vec2 edge = one[(k + 1) % 3] - a;
    bool is_outside = true;
    for (const Vec2& p : other)
      is_outside = is_outside &&
                   cross(edge, p - a) <= kRounding * edge.norm() * ((p - a).norm() + edge.norm());
    if (is_outside) return true;
  }
  return false;
}

/// Whether two triangles of a chart lie over each other. Its rim need not cross itself for that: it
/// may pass through one vertex twice.
bool overlaps_itself(const std::vector<std::array<Vec2, 3>>& triangles) {
  struct Box {
    Vec2 low, high;
    std::size_t triangle;
  };
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), i});
  }
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
    return a.low.x() != b.low.x() ? a.low.x() < b.low.x() : a.triangle < b.triangle;
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low.x() < boxes[i].high.x(); ++j) {
      if (boxes[j].low.y() >= boxes[i].high.y() || boxes[j].high.y() <= boxes[i].low.y()) continue;
      const auto &one = triangles[boxes[i].triangle], &other = triangles[boxes[j].triangle];
      if (!are_apart(one, other) && !are_apart(other, one)) return true;
    }
  }
  return false;
}

}  // namespace

FlatChart flatten_chart(const TriangleMesh& mesh, std::span<const std::int32_t> triangles) {
  FlatChart flat;
  const Vertices vertices = collect(mesh, triangles);
  std::vector<Vec2> places = solve(mesh, triangles, vertices);
  if (places.empty()) return flat;
  double on_surface = 0.0, in_plane = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::array<Vec2, 3> z = own_corners(mesh, triangles[i]);
    const auto& t = vertices.triangles[i];
    const double area =
        cross(places[idx(t[1])] - places[idx(t[0])], places[idx(t[2])] - places[idx(t[0])]);
    if (!(area > 0.0)) return flat;
    on_surface += cross(z[1] - z[0], z[2] - z[0]);
    in_plane += area;
  }
  const double scale = std::sqrt(on_surface / in_plane);
  for (Vec2& p : places) p *= scale;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::array<Vec2, 3> z = own_corners(mesh, triangles[i]);
    std::array<Vec2, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = places[idx(vertices.triangles[i][k])];
    Eigen::Matrix2d from, to;
    from << z[1] - z[0], z[2] - z[0];
    to << c[1] - c[0], c[2] - c[0];
    const Vec2 stretch = (to * from.inverse()).jacobiSvd().singularValues();
    flat.stretch = std::max({flat.stretch, stretch[0], 1.0 / stretch[1]});
    flat.at.push_back(c);
  }
  flat.is_usable = std::isfinite(flat.stretch) && !overlaps_itself(flat.at);
  return flat;
}

}  // namespace thigma::detail
