// Three generators carry all shapes: a grid of quadrilaterals, a turned profile and a set of
// lattice cells. Everything is written with thigma/math/elementary.h, so a shape has the same bits
// on every machine.

#include "thigma/mesh/shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <utility>

#include "thigma/math/elementary.h"

namespace thigma {
namespace {

std::int32_t add_vertex(TriangleMesh& mesh, const Vec3& p) {
  mesh.positions.push_back(p);
  return static_cast<std::int32_t>(mesh.positions.size() - 1);
}

/// Point i of n on the unit circle.
Vec2 on_circle(int i, int n) {
  const SinCos a = sin_cos(2.0 * kPi * i / n);
  return {a.cos, a.sin};
}

/// Appends n points after the last one of a profile, evenly up to `end`.
void extend(std::vector<Vec2>& profile, const Vec2& end, int n) {
  const Vec2 start = profile.back();
  for (int i = 1; i < n; ++i)
    profile.push_back(start + (end - start) * (static_cast<double>(i) / n));
  profile.push_back(end);
}

struct IcosahedronParts {
  std::array<Vec3, 12> corners;
  std::array<std::array<int, 3>, 20> faces;
};

IcosahedronParts icosahedron() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  IcosahedronParts parts;
  parts.corners = {Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0),
                   Vec3(0, -1, g), Vec3(0, 1, g), Vec3(0, -1, -g), Vec3(0, 1, -g),
                   Vec3(g, 0, -1), Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1)};
  parts.faces = {{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  return parts;
}

/// Vertices of the icosahedron's 30 edges, made once and seen from either end.
class EdgePoints {
 public:
  EdgePoints(TriangleMesh& mesh, const IcosahedronParts& parts, int frequency)
      : mesh_(mesh), parts_(parts), frequency_(frequency) {
    for (auto& row : first_) row.fill(-1);
  }
  /// Vertex at step i of 0..frequency from corner a to corner b.
  std::int32_t at(int a, int b, int i) {
    if (i == 0) return a;
    if (i == frequency_) return b;
    if (a > b) return at(b, a, frequency_ - i);
    std::int32_t& first = first_[a][b];
    if (first < 0) {
      first = static_cast<std::int32_t>(mesh_.positions.size());
      for (int k = 1; k < frequency_; ++k) {
        mesh_.positions.push_back(parts_.corners[a] * (frequency_ - k) + parts_.corners[b] * k);
      }
    }
    return first + i - 1;
  }

 private:
  TriangleMesh& mesh_;
  const IcosahedronParts& parts_;
  int frequency_;
  std::array<std::array<std::int32_t, 12>, 12> first_;
};

}  // namespace

TriangleMesh make_grid(int rows, int columns, GridEnds ends,
                       const std::function<Vec3(int, int)>& point) {
  const bool rows_join = ends == GridEnds::rows_joined || ends == GridEnds::both_joined;
  const bool columns_join = ends == GridEnds::columns_joined || ends == GridEnds::both_joined;
  assert(rows >= (rows_join ? 3 : 2) && columns >= (columns_join ? 3 : 2));
  TriangleMesh mesh;
  mesh.positions.reserve(static_cast<std::size_t>(rows) * columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) mesh.positions.push_back(point(i, j));
  }
  const auto index = [&](int i, int j) { return (i % rows) * columns + j % columns; };
  const int row_cells = rows_join ? rows : rows - 1;
  const int column_cells = columns_join ? columns : columns - 1;
  mesh.triangles.reserve(2 * static_cast<std::size_t>(row_cells) * column_cells);
  for (int i = 0; i < row_cells; ++i) {
    for (int j = 0; j < column_cells; ++j) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return mesh;
}

TriangleMesh make_revolution(std::span<const Vec2> profile, int around) {
  assert(profile.size() >= 2 && around >= 3);
  TriangleMesh mesh;
  std::vector<std::int32_t> first(profile.size());  // vertex of each profile point at angle 0
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const Vec2& p = profile[k];
    const bool is_pole = p.x() == 0.0;
    assert(!is_pole || k == 0 || k + 1 == profile.size());
    first[k] = static_cast<std::int32_t>(mesh.positions.size());
    for (int i = 0; i < (is_pole ? 1 : around); ++i) {
      const Vec2 c = on_circle(i, around);
      add_vertex(mesh, {p.x() * c.x(), p.x() * c.y(), p.y()});
    }
  }
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    const bool low_pole = profile[k].x() == 0.0;
    const bool high_pole = profile[k + 1].x() == 0.0;
    for (int i = 0; i < around; ++i) {
      const int next = (i + 1) % around;
      const std::int32_t a = first[k] + (low_pole ? 0 : i);
      const std::int32_t b = first[k] + next;
      const std::int32_t c = first[k + 1] + (high_pole ? 0 : next);
      const std::int32_t d = first[k + 1] + i;
      if (!low_pole) mesh.triangles.push_back({a, b, c});
      if (!high_pole) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

TriangleMesh make_blocks(std::span<const double> xs, std::span<const double> ys,
                         std::span<const double> zs,
                         const std::function<bool(int, int, int)>& is_solid) {
  const std::array<std::span<const double>, 3> planes = {xs, ys, zs};
  const std::array<int, 3> cells = {static_cast<int>(xs.size()) - 1,
                                    static_cast<int>(ys.size()) - 1,
                                    static_cast<int>(zs.size()) - 1};
  assert(cells[0] >= 1 && cells[1] >= 1 && cells[2] >= 1);
  TriangleMesh mesh;
  std::vector<std::int32_t> vertex(xs.size() * ys.size() * zs.size(), -1);
  const auto solid = [&](const std::array<int, 3>& c) {
    for (int a = 0; a < 3; ++a) {
      if (c[a] < 0 || c[a] >= cells[a]) return false;
    }
    return is_solid(c[0], c[1], c[2]);
  };
  const auto vertex_at = [&](const std::array<int, 3>& p) {
    std::int32_t& v = vertex[(p[2] * ys.size() + p[1]) * xs.size() + p[0]];
    if (v < 0) v = add_vertex(mesh, {planes[0][p[0]], planes[1][p[1]], planes[2][p[2]]});
    return v;
  };
  for (int k = 0; k < cells[2]; ++k) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int i = 0; i < cells[0]; ++i) {
        const std::array<int, 3> cell = {i, j, k};
        if (!solid(cell)) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (int side = 0; side < 2; ++side) {
            std::array<int, 3> neighbour = cell;
            neighbour[axis] += side ? 1 : -1;
            if (solid(neighbour)) continue;
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            std::array<std::array<int, 3>, 4> corner;
            corner.fill(cell);
            for (auto& c : corner) c[axis] += side;
            corner[1][u] += 1, corner[2][u] += 1, corner[2][v] += 1, corner[3][v] += 1;
            if (!side) std::swap(corner[1], corner[3]);
            const std::int32_t p = vertex_at(corner[0]), q = vertex_at(corner[1]),
                               r = vertex_at(corner[2]);
            mesh.triangles.push_back({p, q, r});
            mesh.triangles.push_back({p, r, vertex_at(corner[3])});
          }
        }
      }
    }
  }
  return mesh;
}

TriangleMesh make_tetrahedron(double edge) {
  const double a = edge / std::sqrt(8.0);
  TriangleMesh mesh;
  mesh.positions = {{a, a, a}, {a, -a, -a}, {-a, a, -a}, {-a, -a, a}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

TriangleMesh make_box(const Vec3& size, std::array<int, 3> segments) {
  std::array<std::vector<double>, 3> planes;
  for (int a = 0; a < 3; ++a) {
    assert(segments[a] >= 1);
    for (int i = 0; i <= segments[a]; ++i) {
      planes[a].push_back(size[a] * (static_cast<double>(i) / segments[a] - 0.5));
    }
  }
  return make_blocks(planes[0], planes[1], planes[2], [](int, int, int) { return true; });
}

TriangleMesh make_ball(double radius, int frequency) {
  return make_ellipsoid(Vec3::Constant(radius), frequency);
}

TriangleMesh make_ellipsoid(const Vec3& semi_axes, int frequency) {
  assert(frequency >= 1);
  const IcosahedronParts parts = icosahedron();
  TriangleMesh mesh;
  for (const Vec3& c : parts.corners) mesh.positions.push_back(c * frequency);
  EdgePoints edges(mesh, parts, frequency);
  std::vector<std::int32_t> lattice((frequency + 1) * (frequency + 1));
  for (const auto& [a, b, c] : parts.faces) {
    // Step i from a to b and j from a to c; i + j <= frequency.
    const auto at = [&](int i, int j) -> std::int32_t& { return lattice[i * (frequency + 1) + j]; };
    for (int i = 0; i <= frequency; ++i) {
      for (int j = 0; i + j <= frequency; ++j) {
        if (j == 0) {
          at(i, j) = edges.at(a, b, i);
        } else if (i == 0) {
          at(i, j) = edges.at(a, c, j);
        } else if (i + j == frequency) {
          at(i, j) = edges.at(b, c, j);
        } else {
          at(i, j) = add_vertex(mesh, parts.corners[a] * (frequency - i - j) +
                                          parts.corners[b] * i + parts.corners[c] * j);
        }
      }
    }
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < frequency)
          mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  for (Vec3& p : mesh.positions) p = (p / std::sqrt(p.squaredNorm())).cwiseProduct(semi_axes);
  return mesh;
}

TriangleMesh make_polar_ellipsoid(const Vec3& semi_axes, int around, int along) {
  assert(along >= 2);
  std::vector<Vec2> profile;
  for (int k = 0; k <= along; ++k) {
    const SinCos a = sin_cos(kPi * (static_cast<double>(k) / along - 0.5));
    profile.emplace_back(k == 0 || k == along ? 0.0 : a.cos, a.sin);
  }
  TriangleMesh mesh = make_revolution(profile, around);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(semi_axes);
  return mesh;
}

TriangleMesh make_cylinder(double radius, double height, int around, int along, int radial) {
  std::vector<Vec2> profile = {{0.0, -0.5 * height}};
  extend(profile, {radius, -0.5 * height}, radial);
  extend(profile, {radius, 0.5 * height}, along);
  extend(profile, {0.0, 0.5 * height}, radial);
  return make_revolution(profile, around);
}

TriangleMesh make_cone(double radius, double height, int around, int along, int radial) {
  std::vector<Vec2> profile = {{0.0, -0.5 * height}};
  extend(profile, {radius, -0.5 * height}, radial);
  extend(profile, {0.0, 0.5 * height}, along);
  return make_revolution(profile, around);
}

TriangleMesh make_capsule(double radius, double height, int around, int along) {
  const int quarter = std::max(1, around / 4);
  std::vector<Vec2> profile = {{0.0, -0.5 * height - radius}};
  for (int k = 1; k <= quarter; ++k) {
    const SinCos a = sin_cos(0.5 * kPi * (static_cast<double>(k) / quarter - 1.0));
    profile.emplace_back(radius * a.cos, radius * a.sin - 0.5 * height);
  }
  if (height > 0.0) extend(profile, {radius, 0.5 * height}, along);
  for (int k = 1; k < quarter; ++k) {
    const SinCos a = sin_cos(0.5 * kPi * k / quarter);
    profile.emplace_back(radius * a.cos, radius * a.sin + 0.5 * height);
  }
  profile.emplace_back(0.0, 0.5 * height + radius);
  return make_revolution(profile, around);
}

TriangleMesh make_torus(double major_radius, double minor_radius, int around, int across) {
  return make_grid(across, around, GridEnds::both_joined, [&](int i, int j) {
    const Vec2 c = on_circle(j, around);
    const Vec2 s = on_circle(i, across);
    const double r = major_radius + minor_radius * s.x();
    return Vec3(r * c.x(), r * c.y(), minor_radius * s.y());
  });
}

TriangleMesh make_l_shape(double size, double thickness) {
  assert(thickness > 0.0 && thickness < size);
  const std::array<double, 3> arms = {0.0, thickness, size};
  const std::array<double, 2> depth = {-0.5 * thickness, 0.5 * thickness};
  return make_blocks(arms, depth, arms, [](int i, int, int k) { return i == 0 || k == 0; });
}

TriangleMesh make_sheet(double size_x, double size_y, int nx, int ny) {
  return make_grid(ny + 1, nx + 1, GridEnds::open, [&](int i, int j) {
    return Vec3(size_x * (static_cast<double>(j) / nx - 0.5),
                size_y * (static_cast<double>(i) / ny - 0.5), 0.0);
  });
}

TriangleMesh make_dome(double radius, int around, int along) {
  std::vector<Vec2> profile;
  for (int k = 0; k <= along; ++k) {
    const SinCos a = sin_cos(0.5 * kPi * k / along);
    profile.emplace_back(k == along ? 0.0 : radius * a.cos, radius * a.sin);
  }
  return make_revolution(profile, around);
}

TriangleMesh make_moebius(double radius, double width, int around, int across) {
  assert(around >= 3 && across >= 1);
  TriangleMesh mesh;
  for (int j = 0; j < around; ++j) {
    const Vec2 c = on_circle(j, around);
    const SinCos half = sin_cos(kPi * j / around);
    for (int i = 0; i <= across; ++i) {
      const double v = width * (static_cast<double>(i) / across - 0.5);
      const double r = radius + v * half.cos;
      add_vertex(mesh, {r * c.x(), r * c.y(), v * half.sin});
    }
  }
  // The closing column meets column 0 upside down.
  const auto index = [&](int i, int j) { return j < around ? j * (across + 1) + i : across - i; };
  for (int j = 0; j < around; ++j) {
    for (int i = 0; i < across; ++i) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return mesh;
}

TriangleMesh make_hollow_ball(double outer_radius, double inner_radius, int frequency) {
  assert(inner_radius < outer_radius);
  return joined(make_ball(outer_radius, frequency), flipped(make_ball(inner_radius, frequency)));
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh = a;
  const std::int32_t first = static_cast<std::int32_t>(a.positions.size());
  mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return mesh;
}

TriangleMesh transformed(TriangleMesh mesh, const Pose& pose, double scale) {
  for (Vec3& p : mesh.positions) p = transform_point(pose, p * scale);
  return mesh;
}

TriangleMesh flipped(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh unwelded(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const auto& t : mesh.triangles) {
    const std::int32_t p = add_vertex(soup, mesh.positions[t[0]]);
    add_vertex(soup, mesh.positions[t[1]]);
    add_vertex(soup, mesh.positions[t[2]]);
    soup.triangles.push_back({p, p + 1, p + 2});
  }
  return soup;
}

}  // namespace thigma
