#include "thigma/contact/detail/shared_area.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "thigma/math/infinity.h"
#include "thigma/math/plane_cross.h"

// Both patches are convex surfaces, so that their facing triangles cover each point of the plane at
// most once. Pairs of them are cut into pieces by Sutherland-Hodgman: a's triangle by the
// tolerance, then by the sides of b's. Hundreds of pairs of patches go through here each frame:
// most are left as soon as what of them is near enough is seen to be small, and nothing is filled
// in that is not read.

namespace thigma::detail {
namespace {

// cosine: triangles at more than 84 degrees to the plane are left out
constexpr double kLeastFacing = 0.1;

// Extent in the frame (u, v, normal).
struct Box {
  Vec3 low, high;

  void add(const Vec3& p) noexcept {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  bool is_over(const Box& other) const noexcept {
    return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
           other.low.y() <= high.y();
  }
};

// A triangle in the frame (u, v, normal) about the centre of a.
struct Facet {
  Vec3 corner[3];
  Vec2 slope;  // of the height over (u, v)
  Box box;
};
struct Facets {
  std::array<Facet, 2 * kMaxHullVertices> list;
  std::size_t count = 0;
};

struct PieceCorner {
  Vec2 at;
  double height, reach;  // of a; depth + tolerance
};
struct Piece {
  std::array<PieceCorner, 8> corner;  // 3, one more a cut
  std::size_t count = 0;
};

// The vertices of a hull in that frame.
struct Placed {
  std::array<Vec3, kMaxHullVertices> at;
  double low = kInfinity, high = -kInfinity;
};

struct Moments {
  double size = 0.0, weight = 0.0;
  Vec2 first = Vec2::Zero();
  double height = 0.0;
  double uu = 0.0, uv = 0.0, vv = 0.0;
};

// Rows u, v, normal.
Mat3 plane_frame(const Vec3& normal) noexcept {
  const Vec3 u = normal.unitOrthogonal();
  Mat3 frame;
  frame << u.transpose(), normal.cross(u).transpose(), normal.transpose();
  return frame;
}

Placed place(const HullView& hull, const Mat3& frame_from_hull, const Vec3& offset) noexcept {
  Placed placed;
  const int count = std::min(hull.vertex_count, kMaxHullVertices);
  for (int i = 0; i < count; ++i) {
    const Vec3 p = frame_from_hull * hull.vertices[i] + offset;
    placed.at[static_cast<std::size_t>(i)] = p;
    placed.low = std::min(placed.low, p.z());
    placed.high = std::max(placed.high, p.z());
  }
  return placed;
}

// Extent of what of the triangles lies beyond a height: above it for side 1, below it for -1.
Box extent_beyond(const HullView& hull, const Placed& placed, double side, double height) noexcept {
  Box box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (int i = 0; i < hull.triangle_count; ++i) {
    const auto& corner = hull.triangles[i].corner;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = placed.at[corner[k]], &q = placed.at[corner[(k + 1) % 3]];
      const double at_p = side * (p.z() - height), at_q = side * (q.z() - height);
      if (at_p >= 0.0) box.add(p);
      if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
        box.add(p + at_p / (at_p - at_q) * (q - p));
    }
  }
  return box;
}

// The triangles of a hull over `within` that face along +-normal.
void list_facets(const HullView& hull, const Placed& placed, double side, const Box& within,
                 Facets& facets) noexcept {
  for (int i = 0; i < hull.triangle_count && facets.count < facets.list.size(); ++i) {
    const auto& corner = hull.triangles[i].corner;
    const Vec3 &p = placed.at[corner[0]], &q = placed.at[corner[1]], &r = placed.at[corner[2]];
    Facet& f = facets.list[facets.count];
    f.box = {p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
    if (!f.box.is_over(within)) continue;
    const Vec3 across = (q - p).cross(r - p);
    const double up = side * across.z();
    if (!(up > 0.0) || !(up * up > kLeastFacing * kLeastFacing * across.squaredNorm())) continue;
    f.corner[0] = p;
    f.corner[1] = q;
    f.corner[2] = r;
    f.slope = Vec2(-across.x(), -across.y()) / across.z();
    ++facets.count;
  }
}

template <class Value>
void keep_positive(const Value& value, Piece& piece) noexcept {
  std::array<double, 8> at;
  bool is_whole = true;
  for (std::size_t i = 0; i < piece.count; ++i) {
    at[i] = value(piece.corner[i]);
    is_whole &= at[i] >= 0.0;
  }
  if (is_whole) return;
  Piece kept;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const std::size_t next = i + 1 < piece.count ? i + 1 : 0;
    const PieceCorner &p = piece.corner[i], &q = piece.corner[next];
    if (at[i] >= 0.0) kept.corner[kept.count++] = p;
    if ((at[i] > 0.0 && at[next] < 0.0) || (at[i] < 0.0 && at[next] > 0.0)) {
      const double t = at[i] / (at[i] - at[next]);
      kept.corner[kept.count++] = {p.at + t * (q.at - p.at), p.height + t * (q.height - p.height),
                                   p.reach + t * (q.reach - p.reach)};
    }
  }
  piece = kept;
}

// Twice the area of a triangle, positive anticlockwise.
double twice_area(const Vec2& o, const Vec2& p, const Vec2& q) noexcept {
  return cross(p - o, q - o);
}

// The piece that two triangles share within the tolerance.
void cut_piece(const Facet& a, const Facet& b, double tolerance, Piece& piece) noexcept {
  piece.count = 0;
  for (const Vec3& corner : a.corner) {
    const Vec2 at = corner.head<2>();
    const double depth = corner.z() - b.corner[0].z() - b.slope.dot(at - b.corner[0].head<2>());
    piece.corner[piece.count++] = {at, corner.z(), depth + tolerance};
  }
  keep_positive([](const PieceCorner& c) { return c.reach; }, piece);
  // b faces down: seen along the normal its corners go clockwise.
  for (int k = 0; k < 3 && piece.count >= 3; ++k) {
    const Vec2 from = b.corner[(k + 1) % 3].head<2>(), to = b.corner[k].head<2>();
    keep_positive([&](const PieceCorner& c) { return twice_area(from, to, c.at); }, piece);
  }
}

// Adds a piece: four points a triangle, exact up to the third power (reach times a product of
// coordinates).
void add_piece(const Piece& piece, Moments& sum) noexcept {
  constexpr double kMiddle = -27.0 / 48.0, kOthers = 25.0 / 48.0;
  for (std::size_t i = 1; i + 1 < piece.count; ++i) {
    const PieceCorner* corner[3] = {&piece.corner[0], &piece.corner[i], &piece.corner[i + 1]};
    const double area =
        std::max(0.5 * twice_area(corner[0]->at, corner[1]->at, corner[2]->at), 0.0);
    sum.size += area;
    for (int k = 0; k < 4; ++k) {  // 3: the middle
      const double share = area * (k == 3 ? kMiddle : kOthers), other = k == 3 ? 1.0 / 3.0 : 0.2;
      double own[3] = {other, other, other};
      if (k < 3) own[k] = 0.6;
      const Vec2 at = own[0] * corner[0]->at + own[1] * corner[1]->at + own[2] * corner[2]->at;
      const double w = share * (own[0] * corner[0]->reach + own[1] * corner[1]->reach +
                                own[2] * corner[2]->reach);
      sum.weight += w;
      sum.first += w * at;
      sum.height += w * (own[0] * corner[0]->height + own[1] * corner[1]->height +
                         own[2] * corner[2]->height);
      sum.uu += w * at.x() * at.x();
      sum.uv += w * at.x() * at.y();
      sum.vv += w * at.y() * at.y();
    }
  }
}

// Mean and principal axes, out of the plane's frame.
SharedArea area_of(const Moments& sum, const Mat3& frame, const Vec3& origin) noexcept {
  SharedArea area;
  area.size = sum.size;
  if (!(sum.weight > 0.0)) return area;
  area.weight = sum.weight;
  const Vec2 mean = sum.first / sum.weight;
  area.middle = frame.transpose() * Vec3(mean.x(), mean.y(), sum.height / sum.weight) + origin;
  const double uu = sum.uu / sum.weight - mean.x() * mean.x(),
               vv = sum.vv / sum.weight - mean.y() * mean.y();
  const double uv = sum.uv / sum.weight - mean.x() * mean.y();
  const double half = 0.5 * (uu + vv), across = 0.5 * (uu - vv);
  // not hypot, whose last bit is its library's
  const double apart = std::sqrt(across * across + uv * uv);
  // The direction of the larger moment, from whichever of its two forms does not cancel.
  Vec2 along = across > 0.0 ? Vec2(across + apart, uv) : Vec2(uv, apart - across);
  const double length = along.norm();
  along = length > 0.0 ? Vec2(along / length) : Vec2(Vec2::UnitX());
  const double most = std::sqrt(std::max(half + apart, 0.0)),
               least = std::sqrt(std::max(half - apart, 0.0));
  area.axis[0] = frame.transpose() * Vec3(most * along.x(), most * along.y(), 0.0);
  area.axis[1] = frame.transpose() * Vec3(-least * along.y(), least * along.x(), 0.0);
  return area;
}

}  // namespace

SharedArea shared_area(const HullPair& pair, const Vec3& normal, double tolerance,
                       double least_width) noexcept {
  const HullView &a = pair.a, &b = pair.b;
  const RelativePose& a_from_b = pair.a_from_b;
  const Mat3 frame = plane_frame(normal);
  const Placed in_a = place(a, frame, frame * -a.center);
  const Placed in_b =
      place(b, frame * a_from_b.rotation, frame * (a_from_b.translation - a.center));
  const Box of_a = extent_beyond(a, in_a, 1.0, in_b.low - tolerance);
  const Box of_b = extent_beyond(b, in_b, -1.0, in_a.high + tolerance);
  const Box both{of_a.low.cwiseMax(of_b.low), of_a.high.cwiseMin(of_b.high)};
  // Whatever lies in a box, its deviation is at most half the diagonal.
  const Vec2 sides = (both.high - both.low).head<2>();
  if (!(sides.minCoeff() > 0.0) || sides.squaredNorm() <= 4.0 * least_width * least_width)
    return {};
  Facets up, down;
  list_facets(a, in_a, 1.0, both, up);
  list_facets(b, in_b, -1.0, both, down);
  Moments sum;
  Piece piece;
  for (std::size_t i = 0; i < up.count; ++i) {
    const Facet& f = up.list[i];
    for (std::size_t j = 0; j < down.count; ++j) {
      const Facet& g = down.list[j];
      if (!g.box.is_over(f.box) || f.box.high.z() + tolerance < g.box.low.z()) continue;
      cut_piece(f, g, tolerance, piece);
      add_piece(piece, sum);
    }
  }
  return area_of(sum, frame, a.center);
}

}  // namespace thigma::detail
