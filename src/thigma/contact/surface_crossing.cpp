#include "thigma/contact/surface_crossing.h"

#include <array>
#include <cmath>

// A segment crosses a triangle when the three edges pass it on the same side. In the plane across the segment an edge
// function has the same value with the opposite sign for the two triangles that share the edge, so a segment cannot
// slip through between them; a value of zero is given a sign by the order of the end points, opposite for the two.

namespace thigma {
namespace {

constexpr double kEnds = 1e-6;  // of the length: the ends lie on surfaces themselves

struct Segment {
  Vec3 origin, direction;  // not normalized
  Vec3 u, v;               // span the plane across it
  double length = 0.0;
};

struct Projected {
  double x, y, along;
};

Segment make_segment(const Vec3& from, const Vec3& to) noexcept {
  Segment s{from, to - from, {}, {}, 0.0};
  s.length = std::sqrt(s.direction.squaredNorm());
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::fabs(s.direction[i]) < std::fabs(s.direction[least])) least = i;
  }
  s.u = s.direction.cross(Vec3::Unit(least)) / s.length;
  s.v = s.direction.cross(s.u) / s.length;
  return s;
}

Projected project(const Segment& s, const Vec3& p) noexcept {
  const Vec3 r = p - s.origin;
  return {s.u.dot(r), s.v.dot(r), s.direction.dot(r)};
}

// Side of the origin on which the edge p -> q lies; never zero, and of opposite sign for q -> p.
double side(const Projected& p, const Projected& q) noexcept {
  const double value = p.x * q.y - q.x * p.y;
  if (value != 0.0) return value;
  const bool ordered = p.x < q.x || (p.x == q.x && (p.y < q.y || (p.y == q.y && p.along < q.along)));
  return ordered ? 1e-300 : -1e-300;
}

bool crosses(const Segment& s, const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const Projected p = project(s, a), q = project(s, b), r = project(s, c);
  const double pq = side(p, q), qr = side(q, r), rp = side(r, p);
  if ((pq > 0.0) != (qr > 0.0) || (qr > 0.0) != (rp > 0.0)) return false;
  const double sum = pq + qr + rp;
  const double along = (qr * p.along + rp * q.along + pq * r.along) / sum;
  const double length2 = s.length * s.length;
  return along > kEnds * length2 && along < (1.0 - kEnds) * length2;
}

bool near_segment(const Segment& s, const ClodNode& node) noexcept {
  const Vec3 r = node.center - s.origin;
  const double t = std::fmin(std::fmax(r.dot(s.direction) / (s.length * s.length), 0.0), 1.0);
  const double reach = (node.radius + node.hausdorff) * (1.0 + 1e-9) + 1e-12 * (node.center.lpNorm<1>() + s.length);
  return (r - t * s.direction).squaredNorm() <= reach * reach;
}

int crossings_of_patch(const Segment& s, const HullView& hull) noexcept {
  int count = 0;
  for (int t = 0; t < hull.triangle_count; ++t) {
    const std::uint8_t* corner = hull.triangles[t].corner;
    count += crosses(s, hull.vertices[corner[0]], hull.vertices[corner[1]], hull.vertices[corner[2]]) ? 1 : 0;
  }
  return count;
}

// Depth first. The stack holds a node's waiting siblings as one range, so its size is the depth of the tree; what
// would not fit is searched by recursion.
int descend(const ClodHierarchy& h, const Segment& s, std::int32_t start) noexcept {
  struct Range {
    std::int32_t next, end;
  };
  std::array<Range, 128> stack;
  std::size_t top = 0;
  stack[top++] = {start, start + 1};
  int count = 0;
  while (top > 0) {
    Range& range = stack[top - 1];
    if (range.next == range.end) {
      --top;
      continue;
    }
    const std::int32_t index = range.next++;
    const ClodNode& node = h.nodes[static_cast<std::size_t>(index)];
    if (!near_segment(s, node)) continue;
    if (node.child_count == 0) {
      count += crossings_of_patch(s, hull_view(h, index));
    } else if (top < stack.size()) {
      stack[top++] = {node.first_child, node.first_child + node.child_count};
    } else {
      for (std::int32_t c = 0; c < node.child_count; ++c) count += descend(h, s, node.first_child + c);
    }
  }
  return count;
}

bool separates(const void* context, const Vec3& from, const Vec3& to) noexcept {
  const auto& objects = *static_cast<const CrossingContext*>(context);
  if (count_crossings(*objects.object, from, to) % 2 != 0) return true;
  const RelativePose& pose = objects.object_from_scene;
  const Vec3 from_b = pose.rotation.transpose() * (from - pose.translation);
  const Vec3 to_b = pose.rotation.transpose() * (to - pose.translation);
  return count_crossings(*objects.scene, from_b, to_b) % 2 != 0;
}

}  // namespace

int count_crossings(const ClodHierarchy& hierarchy, const Vec3& from, const Vec3& to) noexcept {
  const Segment s = make_segment(from, to);
  if (!(s.length > 0.0) || hierarchy.nodes.empty()) return 0;
  return descend(hierarchy, s, 0);
}

SegmentProbe crossing_probe(const CrossingContext& context) noexcept {
  return {&separates, &context};
}

}  // namespace thigma
