#include "experiments/common/fine_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "thigma/core/index.h"
#include "thigma/math/plane_cross.h"

namespace thigma::experiments {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNothing = -kInfinity;
// of barycentric coordinates: a point of an edge is on both triangles
constexpr double kSlack = 1e-9;
// cosine: coarse triangles steeper than 84 degrees are no ground to look over (D82)
constexpr double kSteepest = 0.1;

/// A triangle over the plane, its height along the way its side faces.
struct Facet {
  std::array<Vec2, 3> at;
  std::array<double, 3> height{};
  double area = 0.0;  // twice, signed
};

struct Box {
  Vec2 low = Vec2::Constant(kInfinity), high = Vec2::Constant(kNothing);
  void add(const Vec2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  bool touches(const Box& o) const {
    return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
  }
};

Box box_of(const Facet& f) {
  Box box;
  for (const Vec2& p : f.at) box.add(p);
  return box;
}

/// Height of a facet over a point, kNothing beside it.
double height_over(const Facet& f, const Vec2& at) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 &a = f.at[(k + 1) % 3], &b = f.at[(k + 2) % 3];
    const double weight = cross(b - a, at - a) / f.area;
    if (weight < -kSlack) return kNothing;
    sum += weight * f.height[k];
  }
  return sum;
}

/// Facets of some triangles of a mesh that face along sign * n, and touch a box.
std::vector<Facet> project(const TriangleMesh& mesh, std::span<const std::int32_t> chosen,
                           bool is_all, const Pose& pose, const Mat3& axes, const Vec3& origin,
                           double sign, double steepest, const Box& over) {
  const Mat3 turn = axes.transpose() * pose.orientation.toRotationMatrix();
  const Vec3 shift = axes.transpose() * (pose.position - origin);
  std::vector<Facet> facets;
  const std::size_t count = is_all ? mesh.triangles.size() : chosen.size();
  std::vector<Vec3> points;
  if (is_all)
    for (const Vec3& p : mesh.positions) points.push_back(turn * p + shift);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& corners = mesh.triangles[is_all ? i : idx(chosen[i])];
    std::array<Vec3, 3> p;
    Facet f;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] =
          is_all ? points[idx(corners[k])] : Vec3(turn * mesh.positions[idx(corners[k])] + shift);
      f.at[k] = p[k].head<2>();
      f.height[k] = sign * p[k].z();
    }
    if (!box_of(f).touches(over)) continue;
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    f.area = normal.z();
    if (sign * normal.z() > steepest * normal.norm()) facets.push_back(f);
  }
  return facets;
}

/// Facets by the cell of a grid that they touch.
struct Cells {
  static constexpr int kSide = 96;
  Box box;
  std::vector<std::vector<std::int32_t>> lists =
      std::vector<std::vector<std::int32_t>>(idx(kSide * kSide));

  Vec2 size() const { return (box.high - box.low) / kSide; }
  int along(double x, int axis) const {
    return std::clamp(static_cast<int>(std::floor((x - box.low[axis]) / size()[axis])), 0,
                      kSide - 1);
  }
  const std::vector<std::int32_t>& over(const Vec2& p) const {
    return lists[idx(along(p.y(), 1) * kSide + along(p.x(), 0))];
  }
  void add(const std::vector<Facet>& facets) {
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const Box own = box_of(facets[i]);
      for (int j = along(own.low.y(), 1); j <= along(own.high.y(), 1); ++j)
        for (int k = along(own.low.x(), 0); k <= along(own.high.x(), 0); ++k)
          lists[idx(j * kSide + k)].push_back(static_cast<std::int32_t>(i));
    }
  }
};

double outermost(const std::vector<Facet>& facets, const Cells& cells, const Vec2& p, double low,
                 double high) {
  double best = kNothing;
  for (const std::int32_t i : cells.over(p)) {
    const double h = height_over(facets[idx(i)], p);
    if (h >= low && h <= high) best = std::max(best, h);
  }
  return best;
}

/// A side over the common box.
struct Side {
  std::vector<Facet> fine, coarse;
  Cells fine_cells, coarse_cells;
  double band = 0.0;

  double coarse_height(const Vec2& p) const {
    return outermost(coarse, coarse_cells, p, kNothing, kInfinity);
  }
  double height(const Vec2& p) const {
    const double ground = coarse_height(p);
    return ground == kNothing ? kNothing
                              : outermost(fine, fine_cells, p, ground - band, ground + band);
  }
  double most_in(std::size_t cell) const {
    double most = kNothing;
    for (const std::int32_t i : fine_cells.lists[cell])
      most =
          std::max(most, *std::max_element(fine[idx(i)].height.begin(), fine[idx(i)].height.end()));
    double ground = kNothing;
    for (const std::int32_t i : coarse_cells.lists[cell])
      ground = std::max(
          ground, *std::max_element(coarse[idx(i)].height.begin(), coarse[idx(i)].height.end()));
    return std::min(most, ground + band);
  }
};

struct Segment {
  Vec2 from, to;
  int family = 0;
};

void add_segments(const std::vector<Facet>& facets, const std::vector<std::int32_t>& list,
                  int family, std::vector<Segment>& segments) {
  for (const std::int32_t i : list)
    for (std::size_t k = 0; k < 3; ++k)
      segments.push_back({facets[idx(i)].at[k], facets[idx(i)].at[(k + 1) % 3], family});
}

class Search {
 public:
  Search(Side object, Side scene, const Box& box)
      : object_(std::move(object)), scene_(std::move(scene)), box_(box) {}

  FineDepth run() {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < object_.fine_cells.lists.size(); ++i) {
      const double bound = object_.most_in(i) + scene_.most_in(i);
      if (bound > kNothing) order.emplace_back(-bound, i);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [minus_bound, cell] : order) {
      if (found_.is_found && !(-minus_bound > found_.depth)) break;
      try_cell(cell);
    }
    if (found_.is_found) found_.is_at_rim = is_at_rim({found_.u, found_.v});
    return found_;
  }

 private:
  void try_cell(std::size_t cell) {
    segments_.clear();
    add_segments(object_.fine, object_.fine_cells.lists[cell], 0, segments_);
    add_segments(object_.coarse, object_.coarse_cells.lists[cell], 1, segments_);
    add_segments(scene_.fine, scene_.fine_cells.lists[cell], 2, segments_);
    add_segments(scene_.coarse, scene_.coarse_cells.lists[cell], 3, segments_);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& a = segments_[i];
      try_place(a.from);
      for (std::size_t j = i + 1; j < segments_.size(); ++j) {
        const Segment& b = segments_[j];
        if (a.family == b.family) continue;
        const Vec2 along = a.to - a.from, other = b.to - b.from, way = b.from - a.from;
        const double area = cross(along, other);
        if (area == 0.0) continue;
        const double s = cross(way, other) / area, t = cross(way, along) / area;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) try_place(a.from + s * along);
      }
    }
  }

  void try_place(const Vec2& p) {
    if (!(p.array() >= box_.low.array()).all() || !(p.array() <= box_.high.array()).all()) return;
    const double object = object_.height(p);
    if (object == kNothing) return;
    const double scene = scene_.height(p);
    if (scene == kNothing || (found_.is_found && object + scene <= found_.depth)) return;
    found_ = {true, object + scene, p.x(), p.y(), false};
  }

  bool is_at_rim(const Vec2& p) const {
    const double step = 1e-4 * (box_.high - box_.low).maxCoeff();
    for (int i = 0; i < 9; ++i) {
      const Vec2 beside = p + step * Vec2(i % 3 - 1, i / 3 - 1);
      if (object_.coarse_height(beside) == kNothing || scene_.coarse_height(beside) == kNothing)
        return true;
    }
    return false;
  }

  Side object_, scene_;
  Box box_;
  std::vector<Segment> segments_;
  FineDepth found_;
};

Side make_side(const FineSide& side, const Mat3& axes, const Vec3& origin, double sign,
               const Box& over, double band) {
  Side made;
  made.band = band;
  made.coarse = project(*side.coarse, side.triangles, false, side.world_from_body, axes, origin,
                        sign, kSteepest, over);
  made.fine = project(*side.fine, {}, true, side.world_from_body, axes, origin, sign, 0.0, over);
  made.coarse_cells.box = made.fine_cells.box = over;
  made.coarse_cells.add(made.coarse);
  made.fine_cells.add(made.fine);
  return made;
}

Box ground(const FineSide& side, const Mat3& axes, const Vec3& origin, double sign) {
  const Box everywhere{Vec2::Constant(kNothing), Vec2::Constant(kInfinity)};
  Box box;
  for (const Facet& f : project(*side.coarse, side.triangles, false, side.world_from_body, axes,
                                origin, sign, kSteepest, everywhere))
    for (const Vec2& p : f.at) box.add(p);
  return box;
}

}  // namespace

FineDepth fine_depth(const FineSide& object, const FineSide& scene, const Mat3& world_from_contact,
                     const Vec3& origin, double band) {
  const Box a = ground(object, world_from_contact, origin, 1.0),
            b = ground(scene, world_from_contact, origin, -1.0);
  const Box box{a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)};
  if (!(box.low.array() < box.high.array()).all()) return {};
  return Search(make_side(object, world_from_contact, origin, 1.0, box, band),
                make_side(scene, world_from_contact, origin, -1.0, box, band), box)
      .run();
}

}  // namespace thigma::experiments
