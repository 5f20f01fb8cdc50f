#include "thigma/clod/surface_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "thigma/convex/quickhull.h"
#include "thigma/convex/visit_triangles.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

constexpr int kDivisions = 6;       // of a triangle into four, one after the other
constexpr int kFirstSamples = 4;    // of an edge of a triangle that has to be divided
constexpr double kTightness = 1.1;  // of the bound over the largest distance met

double distance_to(const DeviationTarget& target, const Vec3& p, std::int32_t t) {
  const auto& v = target.mesh->triangles[idx(t)];
  const auto& x = target.mesh->positions;
  return point_triangle_distance(p, x[idx(v[0])], x[idx(v[1])], x[idx(v[2])]);
}

double box_distance(const TreeBox& box, const Vec3& p) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(Vec3::Zero()).norm();
}

void search(const DeviationTarget& target, std::int32_t index, const Vec3& p, double& best,
            std::int32_t& nearest) {
  const TreeNode& node = target.tree.nodes[idx(index)];
  if (node.count > 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = target.tree.order[idx(i)];
      if (box_distance(target.tree.boxes[idx(t)], p) >= best) continue;
      const double distance = distance_to(target, p, t);
      if (distance >= best) continue;
      best = distance;
      nearest = t;
    }
    return;
  }
  std::int32_t one = index + 1, other = node.right;
  double to_one = box_distance(target.tree.nodes[idx(one)].box, p);
  double to_other = box_distance(target.tree.nodes[idx(other)].box, p);
  if (to_other < to_one) {
    std::swap(one, other);
    std::swap(to_one, to_other);
  }
  if (to_one < best) search(target, one, p, best, nearest);
  if (to_other < best) search(target, other, p, best, nearest);
}

struct Polygon {
  std::array<Vec3, 10> corner;  // the first `count`; the others are not set
  std::size_t count = 0;
  void add(const Vec3& p) { corner[count++] = p; }
};

/// The part of a polygon on the inner side of the upright plane through a and b.
void cut(Polygon& polygon, const Vec3& a, const Vec3& b) {
  const auto side = [&](const Vec3& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  };
  std::array<double, 10> over;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    over[i] = side(polygon.corner[i]);
    inside += over[i] >= 0.0;
  }
  if (inside == polygon.count) return;
  Polygon left;
  for (std::size_t i = 0; i < polygon.count && inside > 0; ++i) {
    const std::size_t j = i + 1 < polygon.count ? i + 1 : 0;
    const Vec3 &p = polygon.corner[i], &q = polygon.corner[j];
    const double over_p = over[i], over_q = over[j];
    if (over_p >= 0.0) left.add(p);
    if ((over_p > 0.0 && over_q < 0.0) || (over_p < 0.0 && over_q > 0.0))
      left.add(p + over_p / (over_p - over_q) * (q - p));
  }
  std::copy_n(left.corner.begin(), left.count, polygon.corner.begin());
  polygon.count = left.count;
}

double area_above(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 &p = polygon.corner[i], &q = polygon.corner[(i + 1) % polygon.count];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

struct SheetBound {
  double distance = std::numeric_limits<double>::infinity();  // along the normal, at most
  std::int32_t over = -1;  // triangle of the surface with the largest part over this one
};

/// Largest distance along the normal to the sheet over the triangle; infinite when not one sheet
/// covers it once.
SheetBound bound_by_sheet(const DeviationTarget& target, const std::array<Vec3, 3>& triangle,
                          double sheet_reach) {
  const Vec3 cross = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double length = cross.norm();
  const double edge = (triangle[1] - triangle[0]).norm();
  if (!(length > 1e-6 * edge * (triangle[2] - triangle[0]).norm())) return {};
  Mat3 frame;  // rows: two directions in the plane, and the normal
  frame.row(0) = (triangle[1] - triangle[0]) / edge;
  const Vec3 normal = cross / length;
  frame.row(2) = normal;
  frame.row(1) = frame.row(2).cross(frame.row(0));
  std::array<Vec3, 3> flat;
  for (std::size_t k = 0; k < 3; ++k) flat[k] = frame * (triangle[k] - triangle[0]);
  const Vec3 reach = sheet_reach * normal.cwiseAbs();
  const TreeBox box{triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]) - reach,
                    triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]) + reach};
  double covered = 0.0;
  SheetBound bound{0.0, -1};
  double largest_part = 0.0;
  visit_triangles(target.tree, box, [&](std::int32_t t) {
    const auto& corner = target.mesh->triangles[idx(t)];
    int above = 0, below = 0;
    for (const std::int32_t v : corner) {
      const double height = normal.dot(target.mesh->positions[idx(v)] - triangle[0]);
      above += height > sheet_reach;
      below += height < -sheet_reach;
    }
    if (above == 3 || below == 3) return;  // another sheet, or the far end of this one
    Polygon piece;
    for (const std::int32_t v : corner)
      piece.add(frame * (target.mesh->positions[idx(v)] - triangle[0]));
    const Vec3 turned =
        (piece.corner[1] - piece.corner[0]).cross(piece.corner[2] - piece.corner[0]);
    if (!(turned.z() > 0.0)) return;  // seen from behind, or edge on
    for (std::size_t k = 0; k < 3 && piece.count > 0; ++k) cut(piece, flat[k], flat[(k + 1) % 3]);
    if (piece.count < 3) return;
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
    for (std::size_t i = 0; i < piece.count; ++i) {
      nearest = std::min(nearest, std::fabs(piece.corner[i].z()));
      farthest = std::max(farthest, std::fabs(piece.corner[i].z()));
    }
    if (nearest > sheet_reach) return;  // another sheet
    const double part = area_above(piece);
    covered += part;
    if (part > largest_part) {
      largest_part = part;
      bound.over = t;
    }
    bound.distance = std::max(bound.distance, farthest);
  });
  if (std::fabs(covered - 0.5 * length) > 1e-6 * 0.5 * length)
    bound.distance = std::numeric_limits<double>::infinity();
  return bound;
}

/// How far the corners are from a point, at most.
double radius_about(const Vec3& middle, const std::array<Vec3, 3>& c) {
  double radius2 = 0.0;
  for (const Vec3& p : c) radius2 = std::max(radius2, (p - middle).squaredNorm());
  return std::sqrt(radius2);
}

/// What a part has to stay below to be done.
double enough(const DeviationRange& range) { return std::max(range.bound, kTightness * range.met); }

double farthest_corner(const DeviationTarget& target, const std::array<Vec3, 3>& c,
                       std::int32_t t) {
  double farthest = 0.0;
  for (const Vec3& p : c) farthest = std::max(farthest, distance_to(target, p, t));
  return farthest;
}

/// A surface, and how far from a triangle its sheet may be [m].
struct SheetSearch {
  const DeviationTarget& target;
  double reach;
};

/// Bound over a part; extends range.met. Its bound stays: what a sibling was allowed must not
/// loosen this one.
double bound_by_division(const SheetSearch& search, const std::array<Vec3, 3>& c, int divisions,
                         std::int32_t nearest, DeviationRange& range) {
  const DeviationTarget& target = search.target;
  const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
  const double at_middle = nearest_distance(target, middle, nearest);
  range.met = std::max(range.met, at_middle);
  double bound = std::min(at_middle + radius_about(middle, c), farthest_corner(target, c, nearest));
  if (bound <= enough(range)) return bound;
  bound = std::min(bound, bound_by_sheet(target, c, search.reach).distance);
  if (divisions == 0 || bound <= enough(range)) return bound;
  const Vec3 ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), ca = 0.5 * (c[2] + c[0]);
  const std::array<std::array<Vec3, 3>, 4> parts = {
      {{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}}};
  double largest = 0.0;
  for (const auto& part : parts)
    largest = std::max(largest, bound_by_division(search, part, divisions - 1, nearest, range));
  return std::min(bound, largest);
}

/// Distances of points spread over a triangle, so that parts measured first are not measured closer
/// than they need be.
void meet_samples(const DeviationTarget& target, const std::array<Vec3, 3>& c, std::int32_t nearest,
                  DeviationRange& range) {
  for (int i = 0; i <= kFirstSamples; ++i)
    for (int j = 0; i + j <= kFirstSamples; ++j) {
      const Vec3 p = (i * c[0] + j * c[1] + (kFirstSamples - i - j) * c[2]) / kFirstSamples;
      range.met = std::max(range.met, nearest_distance(target, p, nearest));
    }
}

}  // namespace

DeviationTarget build_deviation_target(const TriangleMesh& mesh) {
  DeviationTarget target;
  target.mesh = &mesh;
  std::vector<std::int32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  target.tree = build_triangle_tree(mesh, std::move(all));
  return target;
}

double nearest_distance(const DeviationTarget& target, const Vec3& p, std::int32_t& nearest) {
  double best = distance_to(target, p, nearest);
  search(target, 0, p, best, nearest);
  return best;
}

void extend_deviation(const DeviationTarget& target, const std::array<Vec3, 3>& triangle,
                      double reach, DeviationRange& range, std::int32_t& nearest) {
  if (farthest_corner(target, triangle, nearest) <= range.bound) return;
  const SheetBound sheet = bound_by_sheet(target, triangle, reach);
  if (sheet.over >= 0) nearest = sheet.over;
  if (sheet.distance <= range.bound) return;
  meet_samples(target, triangle, nearest, range);
  const double bound =
      sheet.distance <= enough(range)
          ? sheet.distance
          : bound_by_division({target, reach}, triangle, kDivisions, nearest, range);
  range.bound = std::max(range.bound, bound);
}

}  // namespace thigma
