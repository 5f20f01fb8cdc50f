// Local penetration of patches: directional overlap along the directions real faces and edges allow
// (contract at pair_contact). Patches are thin, so "penetrating" cannot be read off the hulls: a
// patch is through another one long before the bodies overlap noticeably. What decides is which
// sides of the surfaces face each other.
#include "thigma/convex/penetration.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace thigma {
namespace {

// Sine of the angle by which both backs must face each other, and cosine of that between the line of the closest points
// and the way out, for the overlap to count fully. Smaller makes the turn from "beside" to "through" faster than the
// motion: depth * normal then changes by more than 4 times the step.
constexpr double kFullyThrough = 0.9;
// At the border of a patch the object goes on where the patch does not know: directions up to this
// tangent beyond the face (17 degrees) count as allowed. Without it an edge-edge touch at a border
// jumps to the overlap along a face.
constexpr double kBorderTilt = 0.3;
constexpr double kBorderScale = 0.95782628522115137;  // 1 / sqrt(1 + kBorderTilt^2)
// Directions within this factor of the least overlap are equal to a caller who remembers one.
constexpr double kNearEqual = 1.05;

// The pair in the frame of a about a local origin.
struct Placed {
  const HullView* a;
  const HullView* b;
  Mat3 rotation;
  Vec3 origin;
  Vec3 pa[kMaxHullVertices], pb[kMaxHullVertices];
};

void place(const HullView& a, const HullView& b, const RelativePose& x, Placed& p) {
  p.a = &a;
  p.b = &b;
  p.rotation = x.rotation;
  p.origin = a.center;
  for (int i = 0; i < a.vertex_count; ++i) p.pa[i] = a.vertices[i] - p.origin;
  const Vec3 shift = x.translation - p.origin;
  for (int i = 0; i < b.vertex_count; ++i) p.pb[i] = x.rotation * b.vertices[i] + shift;
}

struct Extent {
  double top_a, bottom_b;  // max_a n.p, min_b n.p about the local origin [m]
  double overlap() const { return top_a - bottom_b; }
};

Extent extent_along(const Placed& p, const Vec3& n) {
  Extent e{n.dot(p.pa[0]), n.dot(p.pb[0])};
  for (int i = 1; i < p.a->vertex_count; ++i) e.top_a = std::max(e.top_a, n.dot(p.pa[i]));
  for (int i = 1; i < p.b->vertex_count; ++i) e.bottom_b = std::min(e.bottom_b, n.dot(p.pb[i]));
  return e;
}

// The arc of normals of an edge between its two faces; lengths of `to` and `pole` do not matter.
struct Arc {
  Vec3 from, to, pole;  // pole = from x to
  Vec3 edge;
  int tail = 0;  // hull vertex
};

// False for an edge without a real face.
bool arc_of(const HullView& h, const RealEdge& e, Arc& arc) {
  const bool left = e.face_left >= 0;
  const int one = left ? e.face_left : e.face_right;
  const int other = left ? e.face_right : -1;
  if (one < 0) return false;
  arc.tail = e.tail;
  arc.edge = h.vertices[e.head] - h.vertices[e.tail];
  arc.from = h.faces[one].normal;
  if (other >= 0) {
    arc.to = h.faces[other].normal;
  } else {
    // The edge lies in the face, so their cross product is as long as the edge.
    const double length = std::sqrt(arc.edge.squaredNorm());
    if (!(length > 0.0)) return false;
    const Vec3 outward = arc.edge.cross(arc.from) * ((left ? kBorderTilt : -kBorderTilt) / length);
    arc.to = (arc.from + outward) * kBorderScale;
    const bool known = e.beyond.squaredNorm() > 0.0;
    if (known && e.beyond.dot(arc.from) < arc.to.dot(arc.from)) arc.to = e.beyond;
  }
  arc.pole = arc.from.cross(arc.to);
  return true;
}

// Whether two arcs on the sphere of directions cross (Gregorius 2013): their crossing is the
// allowed direction.
bool arcs_cross(const Arc& a, const Arc& b) {
  const double cba = b.from.dot(a.pole), dba = b.to.dot(a.pole);
  if (!(cba * dba < 0.0)) return false;
  const double adc = a.from.dot(b.pole), bdc = a.to.dot(b.pole);
  return adc * bdc < 0.0 && cba * bdc > 0.0;
}

struct Choice {
  Vec3 normal = Vec3::UnitZ();
  double overlap = std::numeric_limits<double>::infinity();
};

// The search over allowed directions. Every direction comes with a bound that needs no extent: the
// overlap is at least the height of a vertex of a over one of b. What cannot come near the least is
// dropped by it; what stays is kept for a caller who remembers a direction.
class DirectionSearch {
 public:
  explicit DirectionSearch(const Placed& p) : p_(p) {}

  void run() {
    for (int i = 0; i < p_.a->face_count; ++i) {
      const RealFace& face = p_.a->faces[i];
      offer(face.normal, p_.pa[first_of(face.vertices)], p_.pb[0]);
    }
    for (int i = 0; i < p_.b->face_count; ++i) {
      const RealFace& face = p_.b->faces[i];
      offer(-(p_.rotation * face.normal), p_.pa[0], p_.pb[first_of(face.vertices)]);
    }
    search_edges();
  }

  Choice least() const { return best_; }

  // Among the directions within kNearEqual of the least overlap, `last` among them, the one nearest to it.
  Choice nearest_to(const Vec3& last) const {
    Choice kept = best_;
    double agreement = best_.normal.dot(last);
    const double limit = kNearEqual * best_.overlap;
    const auto consider = [&](const Choice& choice) {
      const double match = choice.normal.dot(last);
      if (!(match > agreement) || choice.overlap > limit) return;
      agreement = match;
      kept = choice;
    };
    for (int i = 0; i < near_count_; ++i) consider(near_[i]);
    consider({last, extent_along(p_, last).overlap()});
    return kept;
  }

 private:
  static constexpr int kMaxEdges = 3 * kMaxHullVertices;
  static constexpr int kMaxNear = 64;

  static int first_of(std::uint32_t vertices) { return vertices == 0 ? 0 : std::countr_zero(vertices); }

  double near_limit() const { return kNearEqual * std::max(best_.overlap, 0.0); }

  // on_a, on_b: any vertices of the two; the bound is good where they support n.
  void offer(const Vec3& n, const Vec3& on_a, const Vec3& on_b) {
    if (n.dot(on_a - on_b) > near_limit()) return;
    const double overlap = extent_along(p_, n).overlap();
    if (overlap < best_.overlap) best_ = {n, overlap};
    if (overlap > near_limit()) return;
    if (near_count_ == kMaxNear) forget_far();
    if (near_count_ < kMaxNear) near_[near_count_++] = {n, overlap};
  }

  void forget_far() {
    int kept = 0;
    for (int i = 0; i < near_count_; ++i) {
      if (near_[i].overlap <= near_limit()) near_[kept++] = near_[i];
    }
    near_count_ = kept;
  }

  void search_edges() {
    Arc arcs_b[kMaxEdges];
    int count_b = 0;
    for (int j = 0; j < std::min(p_.b->edge_count, kMaxEdges); ++j) {
      Arc& arc = arcs_b[count_b];
      if (!arc_of(*p_.b, p_.b->edges[j], arc)) continue;
      arc.from = -(p_.rotation * arc.from);
      arc.to = -(p_.rotation * arc.to);
      arc.pole = p_.rotation * arc.pole;  // two signs cancel
      arc.edge = p_.rotation * arc.edge;
      ++count_b;
    }
    for (int i = 0; i < p_.a->edge_count; ++i) {
      Arc arc;
      if (!arc_of(*p_.a, p_.a->edges[i], arc)) continue;
      for (int j = 0; j < count_b; ++j) {
        if (arcs_cross(arc, arcs_b[j])) offer_cross(arc, arcs_b[j]);
      }
    }
  }

  void offer_cross(const Arc& a, const Arc& b) {
    const Vec3 n = a.edge.cross(b.edge);
    const double squared = n.squaredNorm();
    // Parallel edges: the faces cover their direction.
    if (!(squared > 1e-28 * a.edge.squaredNorm() * b.edge.squaredNorm())) return;
    const double length = std::sqrt(squared);
    offer(n * (n.dot(a.from) + n.dot(a.to) > 0.0 ? 1.0 / length : -1.0 / length), p_.pa[a.tail], p_.pb[b.tail]);
  }

  const Placed& p_;
  Choice best_;
  Choice near_[kMaxNear];
  int near_count_ = 0;
};

Choice least_overlap(const Placed& p, const Vec3* last) {
  DirectionSearch search(p);
  search.run();
  return last == nullptr ? search.least() : search.nearest_to(*last);
}

// How far the direction from witness to witness lies behind every real face that holds the witness:
// the least sine, > 0 when the back of the surface is what faces the other patch.
double back_facing(const HullView& h, std::uint32_t feature, const Vec3& toward_other) {
  double least = 1.0;
  bool found = false;
  for (int i = 0; i < h.face_count; ++i) {
    if ((feature & ~h.faces[i].vertices) != 0) continue;
    least = std::min(least, -h.faces[i].normal.dot(toward_other));
    found = true;
  }
  return found ? least : -1.0;
}

PairContactStatus status_of(const Placed& p, double depth) {
  const double valid = 0.5 * std::min(p.a->thickness, p.b->thickness);
  return depth > valid ? PairContactStatus::deep : PairContactStatus::penetrating;
}

void report_overlap(const Placed& p, const Vec3& n, const Vec3& middle, PairContact& out) {
  const Extent e = extent_along(p, n);
  const double at = n.dot(middle - p.origin);
  out.normal = n;
  out.depth = e.overlap();
  out.witness_a = middle + (e.top_a - at) * n;
  out.witness_b = middle + (e.bottom_b - at) * n;
  out.status = status_of(p, out.depth);
}

// A pair whose backs face each other turns from beside to through: from minus the separation along the direction
// between the closest points to the overlap, as far as that direction opposes the way out. Beside each other the first
// is right, one above the other the second; where one took over, depth times normal would jump by the distance of the
// patches.
void report_turning(const Placed& p, const PatchSeparation& gap, double back, const Choice& way_out, PairContact& out) {
  const Vec3 between = (gap.point_b - gap.point_a) / gap.distance;
  const double through = std::min(std::min(back, -between.dot(way_out.normal)) / kFullyThrough, 1.0);
  if (!(through > 0.0)) return;  // as separated as before
  const Vec3 turned = (1.0 - through) * between + through * way_out.normal;
  const double length = turned.norm();
  const Vec3 middle = 0.5 * (gap.point_a + gap.point_b);
  if (through == 1.0 || !(length > 1e-6)) return report_overlap(p, way_out.normal, middle, out);
  out.normal = turned / length;
  out.depth = through * way_out.overlap - (1.0 - through) * gap.distance;
  out.witness_a = middle + 0.5 * out.depth * out.normal;
  out.witness_b = middle - 0.5 * out.depth * out.normal;
  out.status = out.depth > 0.0 ? status_of(p, out.depth) : PairContactStatus::beside;
}

void report_penetration(const HullView& a, const HullView& b, const RelativePose& x,
                        const PatchSeparation& gap, double back, const Vec3* last,
                        PairContact& out) {
  Placed p;
  place(a, b, x, p);
  if (gap.intersecting) return report_overlap(p, least_overlap(p, last).normal, gap.point_a, out);
  // A remembered direction is one of overlap; while turning it would drift with the closest points.
  report_turning(p, gap, back, least_overlap(p, nullptr), out);
}

}  // namespace

double backs_facing(const HullView& a, std::uint32_t feature_a, const HullView& b,
                    std::uint32_t feature_b, const RelativePose& x,
                    const Vec3& direction) noexcept {
  const double of_a = back_facing(a, feature_a, direction);
  return of_a > 0.0
             ? std::min(of_a, back_facing(b, feature_b, -(x.rotation.transpose() * direction)))
             : of_a;
}

PairContact pair_contact(const HullView& a, const HullView& b, const RelativePose& x,
                         double tolerance, GjkCache& cache, const Vec3* last_normal,
                         const SegmentProbe& probe) noexcept {
  return pair_contact(a, b, x, tolerance, patch_separation(a, b, x, tolerance, cache), last_normal,
                      probe);
}

PairContact pair_contact(const HullView& a, const HullView& b, const RelativePose& x,
                         double tolerance, const PatchSeparation& gap, const Vec3* last_normal,
                         const SegmentProbe& probe) noexcept {
  PairContact out;
  out.triangle_pairs = static_cast<std::int16_t>(gap.triangle_pairs);
  out.separation = gap.distance;
  out.depth = -gap.distance;
  if (gap.distance > tolerance) return out;
  if (gap.intersecting) {
    report_penetration(a, b, x, gap, 1.0, last_normal, out);
    return out;
  }
  out.status = PairContactStatus::separated;
  out.witness_a = gap.point_a;
  out.witness_b = gap.point_b;
  out.feature_a = gap.feature_a;
  out.feature_b = gap.feature_b;
  out.normal = (gap.point_b - gap.point_a) / gap.distance;
  const double back = backs_facing(a, gap.feature_a, b, gap.feature_b, x, out.normal);
  if (!(back > 0.0)) return out;
  out.backs_facing = true;
  if (probe.separates != nullptr && probe.separates(probe.context, gap.point_a, gap.point_b))
    return out;
  report_penetration(a, b, x, gap, back, last_normal, out);
  return out;
}

}  // namespace thigma
