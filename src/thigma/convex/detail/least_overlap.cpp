#include "thigma/convex/detail/least_overlap.h"

#include <algorithm>
#include <bit>
#include <cmath>

// Every direction comes with bounds that need no extent: the overlap along it is no less than the height of any vertex
// of a over any of b. The two that lie deepest along the best direction so far tell about nearly all others, and about
// whole arcs of the normals of an edge, that they cannot be better; few arcs are left to be crossed with each other.

namespace thigma::detail {
namespace {

// At the border of a patch the object goes on where the patch does not know: directions up to this
// tangent beyond the face (17 degrees) count as allowed. Without it an edge-edge touch at a border
// jumps to the overlap along a face.
constexpr double kBorderTilt = 0.3;
constexpr double kBorderScale = 0.95782628522115137;  // 1 / sqrt(1 + kBorderTilt^2)
// Directions within this factor of the least overlap are equal to a caller who remembers one.
constexpr double kNearEqual = 1.05;
// By how much the cross of two edges may lie off their arcs, as the triangles of a face lie in its plane to rounding.
constexpr double kOffArc = 1e-6;

// The arc of normals of an edge between its two faces; lengths of `to` and `pole` do not matter.
struct Arc {
  Vec3 from, to, pole;  // pole = from x to
  Vec3 edge;
  int tail = 0;  // hull vertex
};

// The ends of the arc of an edge with a real face, and the edge; false where there is none.
bool ends_of(const HullView& h, const RealEdge& e, Arc& arc) {
  const bool left = e.face_left >= 0;
  const int one = left ? e.face_left : e.face_right;
  const int other = left ? e.face_right : -1;
  if (one < 0) return false;
  arc.tail = e.tail;
  arc.edge = h.vertices[e.head] - h.vertices[e.tail];
  arc.from = h.faces[one].normal;
  if (other >= 0) {
    arc.to = h.faces[other].normal;
    return true;
  }
  // The edge lies in the face, so their cross product is as long as the edge.
  const double length = std::sqrt(arc.edge.squaredNorm());
  if (!(length > 0.0)) return false;
  const Vec3 outward = arc.edge.cross(arc.from) * ((left ? kBorderTilt : -kBorderTilt) / length);
  arc.to = (arc.from + outward) * kBorderScale;
  const bool known = e.beyond.squaredNorm() > 0.0;
  if (known && e.beyond.dot(arc.from) < arc.to.dot(arc.from)) arc.to = e.beyond;
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

int first_of(std::uint32_t vertices) { return vertices == 0 ? 0 : std::countr_zero(vertices); }

class Search {
 public:
  Search(const PlacedPair& p, const Vec3* last) : p_(p), last_(last) {}

  WayOut run() {
    for (int i = 0; i < p_.a.face_count; ++i) {
      const RealFace& face = p_.a.faces[i];
      offer(face.normal, p_.pa[first_of(face.vertices)], deep_b_);
    }
    for (int i = 0; i < p_.b.face_count; ++i) {
      const RealFace& face = p_.b.faces[i];
      offer(-(p_.pose.rotation * face.normal), deep_a_, p_.pb[first_of(face.vertices)]);
    }
    search_edges();
    return last_ == nullptr ? best_ : nearest_to(*last_);
  }

 private:
  static constexpr int kMaxEdges = 3 * kMaxHullVertices;
  static constexpr int kMaxNear = 64;

  // No larger overlap is of interest.
  double limit() const {
    return last_ == nullptr ? best_.overlap : kNearEqual * std::max(best_.overlap, 0.0);
  }

  // on_a, on_b: any vertices of the two; the bound is good where they support n.
  void offer(const Vec3& n, const Vec3& on_a, const Vec3& on_b) {
    if (n.dot(on_a - on_b) > limit()) return;
    const double overlap = extent_along(p_, n).overlap();
    if (overlap < best_.overlap) {
      best_ = {n, overlap};
      find_deepest();
    }
    if (last_ == nullptr || overlap > limit()) return;
    if (near_count_ == kMaxNear) forget_far();
    if (near_count_ < kMaxNear) near_[near_count_++] = {n, overlap};
  }

  // The vertices that support the best direction.
  void find_deepest() {
    int a = 0, b = 0;
    double top = best_.normal.dot(p_.pa[0]), bottom = best_.normal.dot(p_.pb[0]);
    for (int i = 1; i < p_.pa.count; ++i) {
      const double height = best_.normal.dot(p_.pa[i]);
      a = height > top ? i : a;
      top = std::max(height, top);
    }
    for (int i = 1; i < p_.pb.count; ++i) {
      const double height = best_.normal.dot(p_.pb[i]);
      b = height < bottom ? i : b;
      bottom = std::min(height, bottom);
    }
    deep_a_ = p_.pa[a];
    deep_b_ = p_.pb[b];
  }

  // Among the directions within kNearEqual of the least overlap, `last` among them, the one nearest to it.
  WayOut nearest_to(const Vec3& last) const {
    WayOut kept = best_;
    double agreement = best_.normal.dot(last);
    const double most = kNearEqual * best_.overlap;
    const auto consider = [&](const WayOut& choice) {
      const double match = choice.normal.dot(last);
      if (!(match > agreement) || choice.overlap > most) return;
      agreement = match;
      kept = choice;
    };
    for (int i = 0; i < near_count_; ++i) consider(near_[i]);
    consider({last, extent_along(p_, last).overlap()});
    return kept;
  }

  void forget_far() {
    int kept = 0;
    for (int i = 0; i < near_count_; ++i) {
      if (near_[i].overlap <= limit()) near_[kept++] = near_[i];
    }
    near_count_ = kept;
  }

  // Whether all directions of an arc overlap too much. span: from a vertex of b to one of a. A unit direction between
  // two unit vectors is a sum of parts of them that are no shorter together, so along it the span is no lower than
  // along the lower end, if that is positive.
  bool is_too_deep(const Arc& arc, const Vec3& span) const {
    const double most = std::max(limit(), 0.0) + kOffArc * span.lpNorm<1>();
    return arc.from.dot(span) > most && arc.to.dot(span) > most;
  }

  int arcs_of_a(Arc* arcs) const {
    int count = 0;
    for (int i = 0; i < std::min(p_.a.edge_count, kMaxEdges); ++i) {
      Arc& arc = arcs[count];
      if (!ends_of(p_.a, p_.a.edges[i], arc) || is_too_deep(arc, p_.pa[arc.tail] - deep_b_))
        continue;
      arc.pole = arc.from.cross(arc.to);
      ++count;
    }
    return count;
  }

  int arcs_of_b(Arc* arcs) const {
    const Mat3& rotation = p_.pose.rotation;
    int count = 0;
    for (int j = 0; j < std::min(p_.b.edge_count, kMaxEdges); ++j) {
      Arc& arc = arcs[count];
      if (!ends_of(p_.b, p_.b.edges[j], arc)) continue;
      // In the frame of b, where the normals of b point the other way.
      if (is_too_deep(arc, rotation.transpose() * (p_.pb[arc.tail] - deep_a_))) continue;
      arc.pole = rotation * arc.from.cross(arc.to);  // two signs cancel
      arc.from = -(rotation * arc.from);
      arc.to = -(rotation * arc.to);
      arc.edge = rotation * arc.edge;
      ++count;
    }
    return count;
  }

  void search_edges() {
    Arc arcs_a[kMaxEdges], arcs_b[kMaxEdges];
    const int count_a = arcs_of_a(arcs_a);
    const int count_b = count_a > 0 ? arcs_of_b(arcs_b) : 0;
    for (int i = 0; i < count_a; ++i) {
      for (int j = 0; j < count_b; ++j) {
        if (arcs_cross(arcs_a[i], arcs_b[j])) offer_cross(arcs_a[i], arcs_b[j]);
      }
    }
  }

  void offer_cross(const Arc& a, const Arc& b) {
    const Vec3 n = a.edge.cross(b.edge);
    const double squared = n.squaredNorm();
    // Parallel edges: the faces cover their direction.
    if (!(squared > 1e-28 * a.edge.squaredNorm() * b.edge.squaredNorm())) return;
    const double length = std::sqrt(squared);
    offer(n * (n.dot(a.from) + n.dot(a.to) > 0.0 ? 1.0 / length : -1.0 / length), p_.pa[a.tail],
          p_.pb[b.tail]);
  }

  const PlacedPair& p_;
  const Vec3* last_;
  WayOut best_;
  Vec3 deep_a_ = p_.pa[0], deep_b_ = p_.pb[0];  // the vertices that reach farthest along best_
  WayOut near_[kMaxNear];
  int near_count_ = 0;
};

}  // namespace

WayOut least_overlap(const PlacedPair& p, const Vec3* last) { return Search(p, last).run(); }

}  // namespace thigma::detail
