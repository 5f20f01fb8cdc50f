// Quickhull (Barber, Dobkin, Huhdanpaa 1996): every point outside belongs to one face that sees it;
// the farthest point of a face replaces the faces it sees by a fan around their rim. Whether a face
// is seen is decided exactly, so the faces seen are always one disc and the hull is always closed;
// the tolerance only decides whether a point is worth adding.

#include "thigma/convex/quickhull.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/plane_cross.h"
#include "thigma/mesh/predicates.h"

namespace thigma {
namespace {

void set_plane(const Quickhull& hull, GrowingFace& face) {
  const Vec3& a = hull.points[idx(face.corner[0])];
  const Vec3& b = hull.points[idx(face.corner[1])];
  const Vec3& c = hull.points[idx(face.corner[2])];
  const Vec3 cross = (b - a).cross(c - a);
  const double length = cross.norm();
  face.normal = Vec3::Zero();
  if (length > 0.0) face.normal = cross / length;
  face.offset = face.normal.dot(a);
}

double height_over(const GrowingFace& face, const Vec3& p) {
  return face.normal.dot(p) - face.offset;
}

void keep_outside(Quickhull& hull, GrowingFace& face, std::int32_t point, double height) {
  hull.next[idx(point)] = face.first_outside;
  face.first_outside = point;
  if (height > face.farthest_height) {
    face.farthest_height = height;
    face.farthest = point;
  }
}

/// Gives the point to that of some faces which it is highest over; false when it is over none of
/// them.
bool assign(Quickhull& hull, std::int32_t point, std::span<const std::int32_t> faces) {
  double best_height = hull.tolerance;
  std::int32_t best = -1;
  for (const std::int32_t i : faces) {
    const double height = height_over(hull.faces[idx(i)], hull.points[idx(point)]);
    if (height > best_height) {
      best_height = height;
      best = i;
    }
  }
  if (best < 0) return false;
  keep_outside(hull, hull.faces[idx(best)], point, best_height);
  return true;
}

/// Gives the point to any face, or drops it as inside. In real arithmetic a point outside that
/// loses its face is over a new one; slivers whose height is rounding can hide that.
void assign_anywhere(Quickhull& hull, std::int32_t point) {
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    if (!hull.faces[i].is_alive) continue;
    const double height = height_over(hull.faces[i], hull.points[idx(point)]);
    if (height <= hull.tolerance) continue;
    keep_outside(hull, hull.faces[i], point, height);
    return;
  }
}

/// For a point that is over its face by rounding alone.
void release_farthest(Quickhull& hull, std::int32_t index) {
  GrowingFace& face = hull.faces[idx(index)];
  const std::int32_t released = face.farthest;
  std::int32_t point = face.first_outside;
  face.first_outside = -1;
  face.farthest = -1;
  face.farthest_height = 0.0;
  while (point >= 0) {
    const std::int32_t following = hull.next[idx(point)];
    if (point != released)
      keep_outside(hull, face, point, height_over(face, hull.points[idx(point)]));
    point = following;
  }
  // Only to faces that see it exactly, lest it wander between slivers for ever.
  for (std::size_t i = 0; i < hull.faces.size(); ++i) {
    const auto& v = hull.faces[i].corner;
    if (!hull.faces[i].is_alive || static_cast<std::int32_t>(i) == index) continue;
    const double height = height_over(hull.faces[i], hull.points[idx(released)]);
    if (height <= hull.tolerance ||
        orient3d(hull.points[idx(v[0])], hull.points[idx(v[1])], hull.points[idx(v[2])],
                 hull.points[idx(released)]) <= 0)
      continue;
    keep_outside(hull, hull.faces[i], released, height);
    return;
  }
}

/// Marks the faces that the point sees, from one of them, as not alive and lists them.
void collect_visible(Quickhull& hull, std::int32_t seed, const Vec3& p) {
  hull.visible.assign(1, seed);
  hull.faces[idx(seed)].is_alive = false;
  for (std::size_t i = 0; i < hull.visible.size(); ++i) {
    for (const std::int32_t other : hull.faces[idx(hull.visible[i])].neighbor) {
      GrowingFace& face = hull.faces[idx(other)];
      if (!face.is_alive) continue;
      const auto& v = face.corner;
      if (orient3d(hull.points[idx(v[0])], hull.points[idx(v[1])], hull.points[idx(v[2])], p) <= 0)
        continue;
      face.is_alive = false;
      hull.visible.push_back(other);
    }
  }
}

/// A fan from the point over the rim of the visible faces.
void close_hole(Quickhull& hull, std::int32_t point) {
  hull.fresh.clear();
  for (const std::int32_t seen : hull.visible) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t outer = hull.faces[idx(seen)].neighbor[i];
      if (!hull.faces[idx(outer)].is_alive) continue;
      const auto index = static_cast<std::int32_t>(hull.faces.size());
      GrowingFace face;
      face.corner = {hull.faces[idx(seen)].corner[i], hull.faces[idx(seen)].corner[(i + 1) % 3],
                     point};
      face.neighbor[0] = outer;
      face.is_alive = true;
      set_plane(hull, face);
      GrowingFace& beyond = hull.faces[idx(outer)];
      for (std::size_t k = 0; k < 3; ++k)
        if (beyond.corner[k] == face.corner[1] && beyond.corner[(k + 1) % 3] == face.corner[0])
          beyond.neighbor[k] = index;
      hull.face_behind[idx(face.corner[0])] = index;
      hull.fresh.push_back(index);
      hull.faces.push_back(face);
    }
  }
  // The new faces are marked alive above, yet none of them is a neighbour of a seen face: the rim
  // is complete.
  for (const std::int32_t index : hull.fresh) {
    const std::int32_t following = hull.face_behind[idx(hull.faces[idx(index)].corner[1])];
    hull.faces[idx(index)].neighbor[1] = following;
    hull.faces[idx(following)].neighbor[2] = index;
  }
}

void add_farthest(Quickhull& hull, std::int32_t index) {
  const std::int32_t point = hull.faces[idx(index)].farthest;
  const auto v = hull.faces[idx(index)].corner;
  if (orient3d(hull.points[idx(v[0])], hull.points[idx(v[1])], hull.points[idx(v[2])],
               hull.points[idx(point)]) <= 0) {
    release_farthest(hull, index);
    return;
  }
  collect_visible(hull, index, hull.points[idx(point)]);
  close_hole(hull, point);
  hull.vertices.push_back(point);
  for (const std::int32_t seen : hull.visible) {
    std::int32_t orphan = hull.faces[idx(seen)].first_outside;
    while (orphan >= 0) {
      const std::int32_t following = hull.next[idx(orphan)];
      if (orphan != point && !assign(hull, orphan, hull.fresh)) assign_anywhere(hull, orphan);
      orphan = following;
    }
    hull.faces[idx(seen)].first_outside = -1;
    hull.faces[idx(seen)].farthest = -1;
  }
}

template <class Measure>
std::int32_t argmax(const Quickhull& hull, Measure measure) {
  std::int32_t best = 0;
  double best_value = measure(hull.points[0]);
  for (std::size_t i = 1; i < hull.points.size(); ++i) {
    const double value = measure(hull.points[i]);
    if (value > best_value) {
      best_value = value;
      best = static_cast<std::int32_t>(i);
    }
  }
  return best;
}

/// Every extreme point of a flat set, in order around it (Andrew's chain).
void order_rim(Quickhull& hull, const Vec3& normal) {
  const Vec3 u = normal.unitOrthogonal(), w = normal.cross(u);
  const std::size_t n = hull.points.size();
  std::vector<Vec2> flat(n);
  std::vector<std::int32_t> order(n);
  for (std::size_t i = 0; i < n; ++i) {
    flat[i] = {u.dot(hull.points[i]), w.dot(hull.points[i])};
    order[i] = static_cast<std::int32_t>(i);
  }
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const Vec2 &p = flat[idx(a)], &q = flat[idx(b)];
    if (p.x() != q.x()) return p.x() < q.x();
    return p.y() != q.y() ? p.y() < q.y() : a < b;
  });
  const auto turns_left = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    const Vec2 ab = flat[idx(b)] - flat[idx(a)], ac = flat[idx(c)] - flat[idx(a)];
    return cross(ab, ac) > 0.0;
  };
  hull.rim.clear();
  const auto append = [&](std::int32_t i, std::size_t keep) {
    while (hull.rim.size() > keep && !turns_left(hull.rim[hull.rim.size() - 2], hull.rim.back(), i))
      hull.rim.pop_back();
    hull.rim.push_back(i);
  };
  for (const std::int32_t i : order) append(i, 1);
  const std::size_t lower = hull.rim.size();
  for (std::size_t k = n - 1; k-- > 0;) append(order[k], lower);
  hull.rim.pop_back();
}

[[gnu::always_inline]] inline double squared_height_over_segment(const Vec3& p, const Vec3& a,
                                                                 const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(along.dot(p - a) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).squaredNorm();
}

double height_over_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return std::sqrt(squared_height_over_segment(p, a, b));
}

/// The points of the rim with the largest distance from the polygon so far, until max_vertices or
/// the tolerance.
void grow_polygon(Quickhull& hull, int max_vertices) {
  const std::size_t n = hull.rim.size();
  std::vector<char> is_used(n, 0);
  is_used[0] = 1;
  int used = 1;
  while (used < max_vertices) {
    double best_height = hull.tolerance;
    std::size_t best = n;
    for (std::size_t start = 0; start < n;) {
      std::size_t stop = start + 1;
      while (stop < n && !is_used[stop]) ++stop;
      for (std::size_t i = start + 1; i < stop; ++i) {
        const double height =
            height_over_segment(hull.points[idx(hull.rim[i])], hull.points[idx(hull.rim[start])],
                                hull.points[idx(hull.rim[stop % n])]);
        if (height > best_height) {
          best_height = height;
          best = i;
        }
      }
      start = stop;
    }
    if (best == n) break;
    is_used[best] = 1;
    ++used;
  }
  hull.vertices.clear();
  for (std::size_t i = 0; i < n; ++i)
    if (is_used[i]) hull.vertices.push_back(hull.rim[i]);
}

void set_simplex(Quickhull& hull, std::array<std::int32_t, 4> v) {
  const auto side = orient3d(hull.points[idx(v[0])], hull.points[idx(v[1])], hull.points[idx(v[2])],
                             hull.points[idx(v[3])]);
  if (side > 0) std::swap(v[1], v[2]);
  // Face i leaves out corner i; with v[3] below v[0] v[1] v[2] all four turn outwards.
  constexpr std::int32_t corners[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  for (const auto& c : corners) {
    GrowingFace face;
    for (std::size_t k = 0; k < 3; ++k) {
      face.corner[k] = v[idx(c[k])];
      face.neighbor[k] = c[(k + 2) % 3];  // the face that leaves out the corner opposite this edge
    }
    face.is_alive = true;
    set_plane(hull, face);
    hull.faces.push_back(face);
  }
  hull.vertices.assign(v.begin(), v.end());
  constexpr std::int32_t all[4] = {0, 1, 2, 3};
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    const auto point = static_cast<std::int32_t>(i);
    if (std::find(v.begin(), v.end(), point) == v.end()) assign(hull, point, all);
  }
}

}  // namespace

void start_hull(Quickhull& hull, std::span<const Vec3> points, double relative_tolerance) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  hull.origin = 0.5 * low + 0.5 * high;
  const double extent = (high - low).norm();
  hull.scale = extent > 0.0 ? std::ldexp(1.0, -std::ilogb(extent)) : 1.0;
  hull.tolerance = std::max(relative_tolerance, 1e-12) * extent * hull.scale;
  hull.points.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    hull.points[i] = (points[i] - hull.origin) * hull.scale;
  hull.faces.clear();
  hull.rim.clear();
  hull.next.assign(points.size(), -1);
  hull.face_behind.resize(points.size());

  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::int32_t a = argmax(hull, [&](const Vec3& p) { return -p[axis]; });
  const std::int32_t b =
      argmax(hull, [&](const Vec3& p) { return (p - hull.points[idx(a)]).squaredNorm(); });
  const Vec3 pa = hull.points[idx(a)], ab = hull.points[idx(b)] - pa;
  const double length = ab.norm();
  hull.dimension = 0;
  hull.vertices.assign(1, a);
  if (!(length > hull.tolerance)) return;
  const std::int32_t c =
      argmax(hull, [&](const Vec3& p) { return ab.cross(p - pa).squaredNorm(); });
  const Vec3 across = ab.cross(hull.points[idx(c)] - pa);
  hull.dimension = 1;
  hull.vertices.push_back(b);
  if (!(across.norm() > hull.tolerance * length)) return;
  const Vec3 normal = across.normalized();
  const std::int32_t d = argmax(hull, [&](const Vec3& p) { return std::fabs(normal.dot(p - pa)); });
  const double thickness = std::fabs(normal.dot(hull.points[idx(d)] - pa));
  hull.dimension = 2;
  if (!(thickness > hull.tolerance)) {
    order_rim(hull, normal);
    return;
  }
  // The faces of a thin set meet at small angles: a point far out beside it is hardly over any of
  // them.
  hull.tolerance = std::max(hull.tolerance * std::min(1.0, thickness / length), 1e-15);
  hull.dimension = 3;
  set_simplex(hull, {a, b, c, d});
}

void complete_hull(Quickhull& hull) {
  if (hull.dimension == 2) grow_polygon(hull, std::numeric_limits<int>::max());
  if (hull.dimension < 3) return;
  for (std::size_t i = 0; i < hull.faces.size(); ++i)
    while (hull.faces[i].is_alive && hull.faces[i].farthest >= 0)
      add_farthest(hull, static_cast<std::int32_t>(i));
}

void grow_hull(Quickhull& hull, int max_vertices) {
  if (hull.dimension == 2) grow_polygon(hull, max_vertices);
  if (hull.dimension < 3) return;
  while (static_cast<int>(hull.vertices.size()) < max_vertices) {
    std::int32_t best = -1;
    double best_height = 0.0;
    for (std::size_t i = 0; i < hull.faces.size(); ++i) {
      const GrowingFace& face = hull.faces[i];
      if (!face.is_alive || face.farthest < 0 || face.farthest_height <= best_height) continue;
      best = static_cast<std::int32_t>(i);
      best_height = face.farthest_height;
    }
    if (best < 0) return;
    add_farthest(hull, best);
  }
}

double point_triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double n2 = n.squaredNorm();
  if (n2 > 0.0 && n.dot((b - a).cross(p - a)) >= 0.0 && n.dot((c - b).cross(p - b)) >= 0.0 &&
      n.dot((a - c).cross(p - c)) >= 0.0)
    return std::fabs(n.dot(p - a)) / std::sqrt(n2);
  // The root is monotonic: that of the least square is the least of the roots.
  return std::sqrt(
      std::min({squared_height_over_segment(p, a, b), squared_height_over_segment(p, b, c),
                squared_height_over_segment(p, c, a)}));
}

double outside_distance(const Quickhull& hull) {
  const auto& points = hull.points;
  double largest = 0.0;
  const auto distance_to = [&](const Vec3& p, const GrowingFace& face) {
    return point_triangle_distance(p, points[idx(face.corner[0])], points[idx(face.corner[1])],
                                   points[idx(face.corner[2])]);
  };
  for (const GrowingFace& face : hull.faces) {
    if (!face.is_alive) continue;
    for (std::int32_t i = face.first_outside; i >= 0; i = hull.next[idx(i)]) {
      double distance = distance_to(points[idx(i)], face);
      for (std::size_t k = 0; k < hull.faces.size() && distance > largest; ++k)
        if (hull.faces[k].is_alive && height_over(hull.faces[k], points[idx(i)]) > 0.0)
          distance = std::min(distance, distance_to(points[idx(i)], hull.faces[k]));
      largest = std::max(largest, distance);
    }
  }
  for (const std::int32_t i : hull.rim) {  // dimension 2
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < hull.vertices.size(); ++k)
      distance =
          std::min(distance,
                   height_over_segment(points[idx(i)], points[idx(hull.vertices[k])],
                                       points[idx(hull.vertices[(k + 1) % hull.vertices.size()])]));
    largest = std::max(largest, distance);
  }
  return largest / hull.scale;
}

void list_outside(const Quickhull& hull, std::vector<std::int32_t>& points) {
  points.clear();
  for (const GrowingFace& face : hull.faces)
    if (face.is_alive)
      for (std::int32_t i = face.first_outside; i >= 0; i = hull.next[idx(i)]) points.push_back(i);
  for (const std::int32_t i : hull.rim)
    if (std::find(hull.vertices.begin(), hull.vertices.end(), i) == hull.vertices.end())
      points.push_back(i);
  std::sort(points.begin(), points.end());
}

}  // namespace thigma
