#include "thigma/contact/surface_crossing.h"

#include <array>
#include <cmath>

// A segment crosses a triangle when the three edges pass it on the same side. In the plane across
// the segment an edge function has the same value with the opposite sign for the two triangles that
// share the edge, so a segment cannot slip through between them; a value of zero is given a sign by
// the order of the end points, opposite for the two.

namespace thigma {
namespace {

constexpr double kEnds = 1e-6;  // of the segment: its ends lie on surfaces themselves

struct Segment {
  Vec3 origin, direction;  // not normalized
  Vec3 u, v;               // span the plane across it
  double length = 0.0, inverse_length2 = 0.0;
};

struct Projected {
  double x, y, along;
};

Segment make_segment(const Vec3& from, const Vec3& to) noexcept {
  Segment segment{from, to - from, {}, {}, 0.0, 0.0};
  segment.length = std::sqrt(segment.direction.squaredNorm());
  segment.inverse_length2 = 1.0 / segment.direction.squaredNorm();
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::fabs(segment.direction[i]) < std::fabs(segment.direction[least])) least = i;
  }
  segment.u = segment.direction.cross(Vec3::Unit(least)) / segment.length;
  segment.v = segment.direction.cross(segment.u) / segment.length;
  return segment;
}

Projected project(const Segment& segment, const Vec3& p) noexcept {
  const Vec3 r = p - segment.origin;
  return {segment.u.dot(r), segment.v.dot(r), segment.direction.dot(r)};
}

// Side of the origin on which the edge p -> q lies; never zero, and of opposite sign for q -> p.
double side(const Projected& p, const Projected& q) noexcept {
  const double value = p.x * q.y - q.x * p.y;
  if (value != 0.0) return value;
  const bool ordered =
      p.x < q.x || (p.x == q.x && (p.y < q.y || (p.y == q.y && p.along < q.along)));
  return ordered ? 1e-300 : -1e-300;
}

// Adds the crossing of one triangle, if there is one.
void cross(const Segment& segment, const Vec3& a, const Vec3& b, const Vec3& c,
           Crossings& count) noexcept {
  const Projected p = project(segment, a), q = project(segment, b), r = project(segment, c);
  const double pq = side(p, q), qr = side(q, r), rp = side(r, p);
  if ((pq > 0.0) != (qr > 0.0) || (qr > 0.0) != (rp > 0.0)) return;
  const double t = (qr * p.along + rp * q.along + pq * r.along) /
                   ((pq + qr + rp) * segment.length * segment.length);
  if (t <= kEnds || (t >= 1.0 - kEnds && t <= 1.0 + kEnds)) return;
  // counter-clockwise seen along the ray: its normal points along it
  const int exits = pq > 0.0 ? 1 : -1;
  if (t < 1.0)
    ++count.between;
  else
    count.exits_after_to += exits;
  count.exits_after_from += exits;
}

bool near_ray(const Segment& segment, const ClodNode& node) noexcept {
  const Vec3 r = node.center - segment.origin;
  const double t = std::fmax(r.dot(segment.direction) * segment.inverse_length2, 0.0);
  const double reach = (node.radius + node.hausdorff) * (1.0 + 1e-9) +
                       1e-12 * (node.center.lpNorm<1>() + segment.length);
  return (r - t * segment.direction).squaredNorm() <= reach * reach;
}

void cross_patch(const Segment& segment, const HullView& hull, Crossings& count) noexcept {
  for (int t = 0; t < hull.triangle_count; ++t) {
    const std::uint8_t* corner = hull.triangles[t].corner;
    cross(segment, hull.vertices[corner[0]], hull.vertices[corner[1]], hull.vertices[corner[2]],
          count);
  }
}

// Depth first. The stack holds a node's waiting siblings as one range, so its size is the depth of
// the tree; what would not fit is searched by recursion.
void descend(const ClodHierarchy& hierarchy, const Segment& segment, std::int32_t start,
             Crossings& count) noexcept {
  struct Range {
    std::int32_t next, end;
  };
  std::array<Range, 128> stack;
  std::size_t top = 0;
  stack[top++] = {start, start + 1};
  while (top > 0) {
    Range& range = stack[top - 1];
    if (range.next == range.end) {
      --top;
      continue;
    }
    const std::int32_t index = range.next++;
    const ClodNode& node = hierarchy.nodes[static_cast<std::size_t>(index)];
    if (!near_ray(segment, node)) continue;
    if (node.child_count == 0) {
      cross_patch(segment, hull_view(hierarchy, index), count);
    } else if (top < stack.size()) {
      stack[top++] = {node.first_child, node.first_child + node.child_count};
    } else {
      for (std::int32_t c = 0; c < node.child_count; ++c)
        descend(hierarchy, segment, node.first_child + c, count);
    }
  }
}

bool near_segment(const Segment& segment, const ClodNode& node) noexcept {
  const Vec3 r = node.center - segment.origin;
  const double t =
      std::fmin(std::fmax(r.dot(segment.direction) * segment.inverse_length2, 0.0), 1.0);
  const double reach = (node.radius + node.hausdorff) * (1.0 + 1e-9) +
                       1e-12 * (node.center.lpNorm<1>() + segment.length);
  return (r - t * segment.direction).squaredNorm() <= reach * reach;
}

// Whether any surface lies between the ends. Far cheaper than counting along the ray: what is near
// a short segment is a handful of patches.
bool is_crossed(const ClodHierarchy& hierarchy, const Segment& segment,
                std::int32_t index) noexcept {
  const ClodNode& node = hierarchy.nodes[static_cast<std::size_t>(index)];
  if (!near_segment(segment, node)) return false;
  if (node.child_count == 0) {
    Crossings count;
    cross_patch(segment, hull_view(hierarchy, index), count);
    return count.between > 0;
  }
  for (std::int32_t c = 0; c < node.child_count; ++c) {
    if (is_crossed(hierarchy, segment, node.first_child + c)) return true;
  }
  return false;
}

// Whether the material of an object reaches along the ray from `from`, on its surface, to `to`. The
// ray enters material at `from`, within a face or an edge (the caller has seen the back of the
// surface there), so without a surface in between it does. At a vertex it may leave into the open:
// there, what the ray meets on its way to infinity decides.
bool reaches(const ClodHierarchy& hierarchy, bool closed, const Vec3& from, const Vec3& to,
             bool from_vertex) noexcept {
  const Segment segment = make_segment(from, to);
  if (!(segment.length > 0.0)) return true;
  if (!(closed && from_vertex) && !is_crossed(hierarchy, segment, 0)) return true;
  const Crossings c = count_crossings(hierarchy, from, to);
  return closed ? c.exits_after_from > 0 && c.exits_after_to > 0 : c.between % 2 == 0;
}

bool separates(const void* context, const ProbeSegment& s) noexcept {
  const auto& objects = *static_cast<const CrossingContext*>(context);
  if (!reaches(*objects.object, objects.object_closed, s.from, s.to, s.from_vertex)) return true;
  const RelativePose& pose = objects.object_from_scene;
  const Vec3 from_b = pose.rotation.transpose() * (s.from - pose.translation);
  const Vec3 to_b = pose.rotation.transpose() * (s.to - pose.translation);
  return !reaches(*objects.scene, objects.scene_closed, to_b, from_b, s.to_vertex);
}

}  // namespace

Crossings count_crossings(const ClodHierarchy& hierarchy, const Vec3& from,
                          const Vec3& to) noexcept {
  Crossings count;
  const Segment segment = make_segment(from, to);
  if (segment.length > 0.0 && !hierarchy.nodes.empty()) descend(hierarchy, segment, 0, count);
  return count;
}

// Over a closed surface the area vectors sum to zero and the integral of x n^T dA is the volume
// times the identity; a rim leaves something in one of the two.
bool is_closed(const ClodHierarchy& hierarchy) noexcept {
  Vec3 area = Vec3::Zero();
  Mat3 moment = Mat3::Zero();
  double total = 0.0;
  for (const ClodPatch& patch : hierarchy.patches) {
    const HullView hull = hull_view(hierarchy, patch.node);
    for (int t = 0; t < hull.triangle_count; ++t) {
      const std::uint8_t* corner = hull.triangles[t].corner;
      const Vec3 a = hull.vertices[corner[0]] - hierarchy.center;
      const Vec3 b = hull.vertices[corner[1]] - hierarchy.center;
      const Vec3 c = hull.vertices[corner[2]] - hierarchy.center;
      const Vec3 n = 0.5 * (b - a).cross(c - a);
      area += n;
      moment += (1.0 / 3.0) * (a + b + c) * n.transpose();
      total += std::sqrt(n.squaredNorm());
    }
  }
  const double volume = moment.trace() / 3.0;
  const double rest = (moment - volume * Mat3::Identity()).cwiseAbs().maxCoeff();
  return area.cwiseAbs().maxCoeff() <= 1e-6 * total && rest <= 1e-6 * total * hierarchy.radius;
}

SegmentProbe crossing_probe(const CrossingContext& context) noexcept {
  return {&separates, &context};
}

}  // namespace thigma
