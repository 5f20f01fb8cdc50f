#include "thigma/convex/detail/least_overlap.h"

#include <algorithm>
#include <bit>
#include <cmath>

// Every direction comes with bounds that need no extent: the overlap along it is no less than the
// height of any vertex of a over any of b. The two that lie deepest along the best direction so far
// tell about nearly all others, and about whole arcs of the normals of an edge, that they cannot be
// better; few arcs are left to be crossed with each other. Which two those will be is guessed
// first, so that most faces and edges are looked at once, in the frame of their hull.

namespace thigma::detail {
namespace {

// At the border of a patch the object goes on where the patch does not know: directions up to this
// tangent beyond the face (17 degrees) count as allowed. Without it an edge-edge touch at a border
// jumps to the overlap along a face.
constexpr double kBorderTilt = 0.3;
constexpr double kBorderScale = 0.95782628522115137;  // 1 / sqrt(1 + kBorderTilt^2)
// Directions within this factor of the least overlap are equal to a caller who remembers one.
constexpr double kNearEqual = 1.05;
// By how much the cross of two edges may lie off their arcs, as the triangles of a face lie in its
// plane to rounding.
constexpr double kOffArc = 1e-6;
// Of an overlap that was found by a guess and will be found again, by the size of the pair: far
// above rounding.
constexpr double kAgain = 1e-12;

// The arc of normals of an edge between its two faces; lengths of `to` and `pole` do not matter.
struct Arc {
  Vec3 from, to, pole;  // pole = from x to
  Vec3 edge;
  int tail;  // hull vertex
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

class Search {
 public:
  Search(const PlacedPair& p, const Vec3* last) : p_(p), last_(last) {}

  WayOut run() {
    guess();
    find_heights(p_.a, deep_b_ + p_.origin, height_a_);
    find_heights(p_.b, to_b(deep_a_), height_b_);
    lower_ceiling();
    for (int i = 0; i < faces_of(p_.a); ++i) {
      if (height_a_[i] <= limit()) offer(p_.a.faces[i].normal);
    }
    for (int i = 0; i < faces_of(p_.b); ++i) {
      if (height_b_[i] <= limit()) offer(-(p_.pose.rotation * p_.b.faces[i].normal));
    }
    find_deepest(best_.normal);
    search_edges();
    return last_ == nullptr ? best_ : nearest_to(*last_);
  }

 private:
  static constexpr int kMaxEdges = 3 * kMaxHullVertices;
  static constexpr int kMaxNear = 64;
  static constexpr int kMaxFaces = 2 * kMaxHullVertices;  // a patch on so many vertices has fewer

  static int faces_of(const HullView& h) { return std::min(h.face_count, kMaxFaces); }

  // No larger overlap is of interest.
  double limit() const {
    const double least = std::min(best_.overlap, ceiling_);
    return last_ == nullptr ? least : kNearEqual * std::max(least, 0.0);
  }

  // A point about the origin of the search in the frame of b.
  Vec3 to_b(const Vec3& p) const {
    return p_.pose.rotation.transpose() * (p + p_.origin - p_.pose.translation);
  }

  // The overlap along the face that promises the least over the vertices nearest to the other hull:
  // no direction with more is of interest. And the vertices that lie deepest along it.
  void guess() {
    const Vec3 between = p_.pose.rotation * p_.b.center + p_.pose.translation - p_.origin;
    size_ = p_.a.radius + p_.b.radius + between.lpNorm<1>();
    find_deepest(between);
    const Vec3 over_a = deep_b_ + p_.origin, over_b = to_b(deep_a_);
    double least = std::numeric_limits<double>::infinity();
    const auto promises = [&](const RealFace& face, const Vec3& over) {
      const double promise = face.offset - face.normal.dot(over);
      if (!(promise < least)) return false;
      least = promise;
      return true;
    };
    int of_a = -1, of_b = -1;
    for (int i = 0; i < faces_of(p_.a); ++i) of_a = promises(p_.a.faces[i], over_a) ? i : of_a;
    for (int i = 0; i < faces_of(p_.b); ++i) of_b = promises(p_.b.faces[i], over_b) ? i : of_b;
    if (of_a < 0 && of_b < 0) return;
    const Vec3 n =
        of_b >= 0 ? Vec3(-(p_.pose.rotation * p_.b.faces[of_b].normal)) : p_.a.faces[of_a].normal;
    ceiling_ = extent_along(p_, n).overlap() + kAgain * size_;
    find_deepest(n);
  }

  // The same of the lowest of all faces: those that are not the way out are looked at no further
  // then.
  void lower_ceiling() {
    const int faces_a = faces_of(p_.a), faces_b = faces_of(p_.b);
    const double* of_a = std::min_element(height_a_, height_a_ + faces_a);
    const double* of_b = std::min_element(height_b_, height_b_ + faces_b);
    const bool is_of_b = faces_a == 0 || (faces_b > 0 && *of_b < *of_a);
    if (is_of_b && faces_b == 0) return;
    const Vec3 n = is_of_b ? Vec3(-(p_.pose.rotation * p_.b.faces[of_b - height_b_].normal))
                           : p_.a.faces[of_a - height_a_].normal;
    ceiling_ = std::min(ceiling_, extent_along(p_, n).overlap() + kAgain * size_);
  }

  // For each face the least height of its vertices over a vertex of the other hull, in the frame of
  // the face: no overlap along its normal is less, nor along the arc of an edge between two faces
  // less than the lower of theirs.
  static void find_heights(const HullView& h, const Vec3& over, double* height) {
    for (int i = 0; i < faces_of(h); ++i) {
      const RealFace& face = h.faces[i];
      double least = face.vertices == 0 ? -std::numeric_limits<double>::infinity()
                                        : std::numeric_limits<double>::infinity();
      for (std::uint32_t left = face.vertices; left != 0; left &= left - 1)
        least = std::min(least, face.normal.dot(h.vertices[std::countr_zero(left)] - over));
      height[i] = least;
    }
  }

  // n: worth a look by a bound of its overlap.
  void offer(const Vec3& n) {
    const double overlap = extent_along(p_, n).overlap();
    if (overlap < best_.overlap) best_ = {n, overlap};
    if (last_ == nullptr || overlap > limit()) return;
    if (near_count_ == kMaxNear) forget_far();
    if (near_count_ < kMaxNear) near_[near_count_++] = {n, overlap};
  }

  // The vertices that reach farthest along a direction, of any length.
  void find_deepest(const Vec3& n) {
    int a = 0, b = 0;
    double top = n.dot(p_.pa[0]), bottom = n.dot(p_.pb[0]);
    for (int i = 1; i < p_.pa.count; ++i) {
      const double height = n.dot(p_.pa[i]);
      a = height > top ? i : a;
      top = std::max(height, top);
    }
    for (int i = 1; i < p_.pb.count; ++i) {
      const double height = n.dot(p_.pb[i]);
      b = height < bottom ? i : b;
      bottom = std::min(height, bottom);
    }
    deep_a_ = p_.pa[a];
    deep_b_ = p_.pb[b];
  }

  // Among the directions within kNearEqual of the least overlap, `last` among them, the one nearest
  // to it.
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

  // Whether all directions of an arc overlap too much. span: from a vertex of b to one of a. A unit
  // direction between two unit vectors is a sum of parts of them that are no shorter together, so
  // along it the span is no lower than along the lower end, if that is positive.
  bool is_too_deep(const Arc& arc, const Vec3& span) const {
    const double most = std::max(limit(), 0.0) + kOffArc * span.lpNorm<1>();
    return arc.from.dot(span) > most && arc.to.dot(span) > most;
  }

  // The same from the heights of the two faces of an edge alone: most edges end here.
  bool has_deep_faces(const RealEdge& e, const double* height) const {
    if (e.face_left < 0 || e.face_right < 0 || std::max(e.face_left, e.face_right) >= kMaxFaces)
      return false;
    const double most = std::max(limit(), 0.0) + 4.0 * kOffArc * size_;
    return height[e.face_left] > most && height[e.face_right] > most;
  }

  int arcs_of_a(Arc* arcs) const {
    int count = 0;
    for (int i = 0; i < std::min(p_.a.edge_count, kMaxEdges); ++i) {
      if (has_deep_faces(p_.a.edges[i], height_a_)) continue;
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
      if (has_deep_faces(p_.b.edges[j], height_b_)) continue;
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
    const Vec3 unit = n * (n.dot(a.from) + n.dot(a.to) > 0.0 ? 1.0 / length : -1.0 / length);
    if (unit.dot(p_.pa[a.tail] - p_.pb[b.tail]) <= limit()) offer(unit);
  }

  const PlacedPair& p_;
  const Vec3* last_;
  WayOut best_;
  double ceiling_ = std::numeric_limits<double>::infinity();  // the least overlap is no more [m]
  double size_ = 0.0;  // vertices of the pair are no farther apart [m]
  double height_a_[kMaxFaces], height_b_[kMaxFaces];  // see find_heights
  Vec3 deep_a_ = p_.pa[0], deep_b_ = p_.pb[0];  // the vertices that reach farthest along best_
  WayOut near_[kMaxNear];
  int near_count_ = 0;
};

}  // namespace

WayOut least_overlap(const PlacedPair& p, const Vec3* last) { return Search(p, last).run(); }

}  // namespace thigma::detail
