#include "benchmarks/baselines/point_shell.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "benchmarks/baselines/nearest_point.h"

namespace thigma::bench {
namespace {

constexpr std::int32_t kLeaf = 8;

struct Sampling {
  std::vector<Vec3> points, normals;
};

void add_point(Sampling& out, const Vec3& p, const Vec3& n) {
  out.points.push_back(p);
  out.normals.push_back(n);
}

// Between the corners of a triangle, on a lattice no coarser than the spacing. Points on a shared
// edge come from the triangle whose edge runs upwards in vertex numbers.
void sample_triangle(const TriangleMesh& mesh, std::size_t t, const Vec3& normal, double spacing,
                     Sampling& out) {
  const auto& v = mesh.triangles[t];
  const Vec3& a = mesh.positions[static_cast<std::size_t>(v[0])];
  const Vec3& b = mesh.positions[static_cast<std::size_t>(v[1])];
  const Vec3& c = mesh.positions[static_cast<std::size_t>(v[2])];
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const int n = static_cast<int>(std::ceil(longest / spacing));
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      const int k = n - i - j;
      const bool is_corner = i == n || j == n || k == n;
      const bool is_foreign =
          (k == 0 && v[0] > v[1]) || (i == 0 && v[1] > v[2]) || (j == 0 && v[2] > v[0]);
      if (is_corner || is_foreign) continue;
      add_point(out, (i * a + j * b + k * c) / n, normal);
    }
  }
}

Sampling sample_surface(const TriangleMesh& mesh, double spacing) {
  const SurfaceNormals normals = surface_normals(mesh);
  Sampling out;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    add_point(out, mesh.positions[v], normals.vertex[v].normalized());
  }
  if (spacing > 0.0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      sample_triangle(mesh, t, normals.face[t], spacing, out);
    }
  }
  return out;
}

// A ball around points, a few percent larger than the smallest (Badoiu and Clarkson 2003).
void enclose(const std::vector<Vec3>& points, std::span<const std::int32_t> subset, Vec3& center,
             double& radius) {
  center = points[static_cast<std::size_t>(subset[0])];
  auto farthest = [&] {
    std::int32_t best = subset[0];
    radius = -1.0;
    for (const std::int32_t i : subset) {
      const double d2 = (points[static_cast<std::size_t>(i)] - center).squaredNorm();
      if (d2 > radius) {
        radius = d2;
        best = i;
      }
    }
    radius = std::sqrt(radius);
    return best;
  };
  Vec3 best_center = center;
  double best = std::numeric_limits<double>::infinity();
  for (int turn = 1; turn <= 24; ++turn) {
    const std::int32_t far = farthest();
    if (radius < best) {
      best = radius;
      best_center = center;
    }
    center += (points[static_cast<std::size_t>(far)] - center) / (turn + 1);
  }
  center = best_center;
  radius = best;
}

struct Builder {
  const Sampling* sampling = nullptr;
  std::vector<std::int32_t> order;
  PointShell* shell = nullptr;
};

// Half of the points of a range to either side of its widest extent, in whole leaves.
std::int32_t split(Builder& b, std::int32_t first, std::int32_t last) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::int32_t i = first; i < last; ++i) {
    const Vec3& p =
        b.sampling->points[static_cast<std::size_t>(b.order[static_cast<std::size_t>(i)])];
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::int32_t leaves = (last - first + kLeaf - 1) / kLeaf;
  const std::int32_t middle = first + (leaves + 1) / 2 * kLeaf;
  std::nth_element(b.order.begin() + first, b.order.begin() + middle, b.order.begin() + last,
                   [&](std::int32_t x, std::int32_t y) {
                     const double px = b.sampling->points[static_cast<std::size_t>(x)][axis];
                     const double py = b.sampling->points[static_cast<std::size_t>(y)][axis];
                     return px != py ? px < py : x < y;
                   });
  return middle;
}

std::int32_t add_leaf(Builder& b, std::int32_t first, std::int32_t last) {
  ShellLeaf leaf;
  leaf.count = last - first;
  for (std::int32_t i = 0; i < kLeaf; ++i) {
    const std::int32_t point = b.order[static_cast<std::size_t>(std::min(first + i, last - 1))];
    const Vec3& p = b.sampling->points[static_cast<std::size_t>(point)];
    const auto lane = static_cast<std::size_t>(i);
    leaf.x[lane] = static_cast<float>(p.x());
    leaf.y[lane] = static_cast<float>(p.y());
    leaf.z[lane] = static_cast<float>(p.z());
    leaf.point[lane] = point;
  }
  b.shell->leaves.push_back(leaf);
  return -static_cast<std::int32_t>(b.shell->leaves.size());
}

std::int32_t add_node(Builder& b, std::int32_t first, std::int32_t last) {
  const auto index = static_cast<std::int32_t>(b.shell->nodes.size());
  b.shell->nodes.emplace_back();
  std::vector<std::int32_t> cuts = {first, last};
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = cuts.size() - 1; i-- > 0;) {
      if (cuts[i + 1] - cuts[i] > kLeaf)
        cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    split(b, cuts[i], cuts[i + 1]));
    }
  }
  ShellNode node;
  node.count = static_cast<std::int32_t>(cuts.size()) - 1;
  for (std::size_t c = 0; c < 4; ++c) {
    const std::size_t from = std::min(c, cuts.size() - 2);
    const std::int32_t low = cuts[from], high = cuts[from + 1];
    Vec3 center;
    double radius = 0.0;
    enclose(b.sampling->points,
            std::span(b.order).subspan(static_cast<std::size_t>(low),
                                       static_cast<std::size_t>(high - low)),
            center, radius);
    node.x[c] = static_cast<float>(center.x());
    node.y[c] = static_cast<float>(center.y());
    node.z[c] = static_cast<float>(center.z());
    node.radius[c] = static_cast<float>(radius * (1.0 + 1e-5) + 1e-6 * center.norm());
    if (c != from) continue;
    node.child[c] = high - low > kLeaf ? add_node(b, low, high) : add_leaf(b, low, high);
  }
  b.shell->nodes[static_cast<std::size_t>(index)] = node;
  return index;
}

// A pose in single precision.
struct Motion {
  float r[9];
  float t[3];
};

Motion motion_of(const Pose& pose) {
  const Mat3 m = pose.orientation.toRotationMatrix();
  Motion out{};
  for (int i = 0; i < 9; ++i) out.r[i] = static_cast<float>(m(i / 3, i % 3));
  for (int i = 0; i < 3; ++i) out.t[i] = static_cast<float>(pose.position[i]);
  return out;
}

// N points at once; the compiler makes vectors of it.
template <std::size_t N>
struct Moved {
  alignas(16) float x[N], y[N], z[N];
};

template <std::size_t N>
Moved<N> move(const Motion& m, const std::array<float, N>& x, const std::array<float, N>& y,
              const std::array<float, N>& z) {
  Moved<N> out;
  for (std::size_t i = 0; i < N; ++i)
    out.x[i] = m.r[0] * x[i] + m.r[1] * y[i] + m.r[2] * z[i] + m.t[0];
  for (std::size_t i = 0; i < N; ++i)
    out.y[i] = m.r[3] * x[i] + m.r[4] * y[i] + m.r[5] * z[i] + m.t[1];
  for (std::size_t i = 0; i < N; ++i)
    out.z[i] = m.r[6] * x[i] + m.r[7] * y[i] + m.r[8] * z[i] + m.t[2];
  return out;
}

struct OneWay {
  const PointShell* shell = nullptr;
  const PointShell* other = nullptr;
  Motion other_from_shell;
  Mat3 world_from_other;
  Vec3 offset;  // of the other in the world [m]
  Mat3 world_from_shell;
  float tolerance = 0.0f;
  bool is_of_object = false;
  std::vector<ShellContact>* contacts = nullptr;
};

void test_leaf(const OneWay& way, const ShellLeaf& leaf) {
  const DistanceField& field = way.other->field;
  const Moved<8> at = move<8>(way.other_from_shell, leaf.x, leaf.y, leaf.z);
  for (std::size_t i = 0; i < static_cast<std::size_t>(leaf.count); ++i) {
    const FieldCell cell = find_cell(field, at.x[i], at.y[i], at.z[i]);
    const float distance =
        cell.corner != nullptr ? cell_distance(cell) : cell.bound + field.brick_radius;
    if (!(distance < way.tolerance)) continue;
    ShellContact contact;
    // Out of the grasped object: against the field's gradient for its own points, along it for
    // others.
    if (cell.corner != nullptr) {
      const std::array<float, 3> rise = cell_rise(cell);
      const float norm2 = rise[0] * rise[0] + rise[1] * rise[1] + rise[2] * rise[2];
      const float scale = (way.is_of_object ? -1.0f : 1.0f) / std::sqrt(std::max(norm2, 1e-30f));
      contact.normal =
          way.world_from_other * Vec3(scale * rise[0], scale * rise[1], scale * rise[2]);
    } else {
      const std::array<float, 3>& n = way.shell->normals[static_cast<std::size_t>(leaf.point[i])];
      contact.normal = way.world_from_shell * Vec3(n[0], n[1], n[2]);
      if (!way.is_of_object) contact.normal = -contact.normal;
    }
    contact.point = way.world_from_other * Vec3(at.x[i], at.y[i], at.z[i]) + way.offset;
    contact.depth = -static_cast<double>(distance);
    contact.index = leaf.point[i];
    contact.is_of_object = way.is_of_object;
    way.contacts->push_back(contact);
  }
}

ShellStats walk(const OneWay& way) {
  const DistanceField& field = way.other->field;
  ShellStats stats;
  // three a level are left waiting, and 4^40 leaves are never reached
  std::array<std::int32_t, 128> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const ShellNode& node = way.shell->nodes[static_cast<std::size_t>(stack[--top])];
    const Moved<4> at = move<4>(way.other_from_shell, node.x, node.y, node.z);
    stats.spheres += node.count;
    for (std::size_t c = 0; c < static_cast<std::size_t>(node.count); ++c) {
      if (least_distance_at(field, at.x[c], at.y[c], at.z[c]) > node.radius[c] + way.tolerance)
        continue;
      if (node.child[c] >= 0) {
        stack[top++] = node.child[c];
      } else {
        const ShellLeaf& leaf = way.shell->leaves[static_cast<std::size_t>(-1 - node.child[c])];
        stats.points += leaf.count;
        test_leaf(way, leaf);
      }
    }
  }
  return stats;
}

}  // namespace

PointShell build_point_shell(const TriangleMesh& mesh, const ShellParams& params) {
  PointShell shell;
  shell.field = build_distance_field(mesh, params.field);
  const Sampling sampling = sample_surface(mesh, params.spacing);
  Builder builder;
  builder.sampling = &sampling;
  builder.order.resize(sampling.points.size());
  std::iota(builder.order.begin(), builder.order.end(), 0);
  builder.shell = &shell;
  if (!builder.order.empty()) add_node(builder, 0, static_cast<std::int32_t>(builder.order.size()));
  for (const Vec3& n : sampling.normals) {
    shell.normals.push_back(
        {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())});
  }
  return shell;
}

std::size_t shell_bytes(const PointShell& shell) {
  return field_bytes(shell.field) + shell.nodes.size() * sizeof(ShellNode) +
         shell.leaves.size() * sizeof(ShellLeaf) + shell.normals.size() * sizeof(shell.normals[0]);
}

ShellStats query_one_way(const PointShell& shell, const Pose& world_from_shell,
                         const PointShell& other, const Pose& world_from_other, double tolerance,
                         bool is_of_object, std::vector<ShellContact>& contacts) {
  if (shell.nodes.empty()) return {};
  OneWay way;
  way.shell = &shell;
  way.other = &other;
  way.other_from_shell = motion_of(inverse(world_from_other) * world_from_shell);
  way.world_from_other = world_from_other.orientation.toRotationMatrix();
  way.offset = world_from_other.position;
  way.world_from_shell = world_from_shell.orientation.toRotationMatrix();
  way.tolerance = static_cast<float>(tolerance);
  way.is_of_object = is_of_object;
  way.contacts = &contacts;
  return walk(way);
}

ShellStats query_shells(const PointShell& object, const Pose& world_from_object,
                        const PointShell& scene, const Pose& world_from_scene, double tolerance,
                        std::vector<ShellContact>& contacts) {
  contacts.clear();
  const ShellStats first =
      query_one_way(object, world_from_object, scene, world_from_scene, tolerance, true, contacts);
  const ShellStats second =
      query_one_way(scene, world_from_scene, object, world_from_object, tolerance, false, contacts);
  return {first.spheres + second.spheres, first.points + second.points};
}

}  // namespace thigma::bench
