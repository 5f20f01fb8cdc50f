#include "thigma/depth/detail/rim_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "thigma/core/index.h"
#include "thigma/depth/detail/triangle_rows.h"
#include "thigma/math/plane_cross.h"

namespace thigma::detail {
namespace {

/// A part of a line through the plane, from one share of it to another.
struct Part {
  Vec2 from = Vec2::Zero(), way = Vec2::Zero();
  double low = 0.0, high = 1.0;
  bool is_empty() const noexcept { return !(low <= high); }
  Vec2 at(double share) const noexcept { return from + share * way; }
};

/// Leaves what has `inside` + share * `by` not below zero.
void cut(double inside, double by, Part& part) noexcept {
  if (by > 0.0) {
    part.low = std::max(part.low, -inside / by);
  } else if (by < 0.0) {
    part.high = std::min(part.high, -inside / by);
  } else if (inside < 0.0) {
    part.high = part.low - 1.0;
  }
}

Part within(Part part, const PlaneBox& box) noexcept {
  for (int k = 0; k < 2; ++k) {
    cut(part.from[k] - box.low[k], part.way[k], part);
    cut(box.high[k] - part.from[k], -part.way[k], part);
  }
  return part;
}

Part over(Part part, const ProjectedTriangle& t) noexcept {
  for (std::size_t k = 0; k < 3; ++k)
    cut(cross(t.edges[k], part.from - t.at[k]), cross(t.edges[k], part.way), part);
  return part;
}

/// The edges of a patch that may cross a box, by their vertices, so that those of two triangles lie
/// beside each other.
void sort_edges(const ProjectedPatch& patch, const PlaneBox& box,
                std::vector<PatchEdge>& edges) noexcept {
  edges.clear();
  edges.reserve(3 * patch.triangles.capacity());
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    if (!overlap(patch.triangles[i].box, box)) continue;
    const auto& corners = patch.texture->coarse.triangles[idx(patch.triangles[i].triangle)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 &a = patch.triangles[i].at[k], &b = patch.triangles[i].at[(k + 1) % 3];
      if (!overlap({a.cwiseMin(b), a.cwiseMax(b)}, box)) continue;
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      edges.push_back({low, high, static_cast<std::int32_t>(3 * i + k)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const PatchEdge& a, const PatchEdge& b) {
    return std::tie(a.low, a.high, a.edge) < std::tie(b.low, b.high, b.edge);
  });
}

/// One side's rim over the other side's triangles.
class RimOver {
 public:
  RimOver(const PreparedContact& prepared, const ProjectedPatch& rim, const ProjectedPatch& other,
          const Vec2& apart, const MapReading& reading) noexcept
      : prepared_(prepared), rim_(rim), other_(other), apart_(apart), reading_(reading) {}

  void add_edge(std::int32_t edge, double deepest, Rivals& rivals) const noexcept {
    const ProjectedTriangle& t = rim_.triangles[idx(edge / 3)];
    const std::size_t k = idx(edge % 3);
    const Part whole = within({.from = t.at[k], .way = t.at[(k + 1) % 3] - t.at[k]}, prepared_.box);
    if (whole.is_empty()) return;
    PlaneBox box{whole.at(whole.low), whole.at(whole.low)};
    box.low = box.low.cwiseMin(whole.at(whole.high));
    box.high = box.high.cwiseMax(whole.at(whole.high));
    const double own = most_relief(rim_, t);
    for (const ProjectedTriangle& u : other_.triangles) {
      if (!overlap(u.box, box)) continue;
      const Part part = over(whole, u);
      if (part.is_empty()) continue;
      const double bound =
          std::max(ground(t, u, part.at(part.low)), ground(t, u, part.at(part.high))) + own +
          most_relief(other_, u);
      if (bound > deepest) add_part(t, u, part, rivals);
    }
  }

 private:
  static double ground(const ProjectedTriangle& t, const ProjectedTriangle& u,
                       const Vec2& at) noexcept {
    return t.height_origin + t.height_by_at.dot(at) + u.height_origin + u.height_by_at.dot(at);
  }

  // The highest sample of a part, and how high a tent over it and those beside it stands.
  void add_part(const ProjectedTriangle& t, const ProjectedTriangle& u, const Part& part,
                Rivals& rivals) const noexcept {
    constexpr double kLeast = 4.0, kMost = 1e6;  // steps
    const Vec2 way = (part.high - part.low) * part.way;
    const double wanted = way.cwiseAbs().cwiseQuotient(apart_).sum() + 1.0;
    const int steps = static_cast<int>(std::clamp(wanted, kLeast, kMost));
    const auto place = [&](int i) -> Vec2 { return part.at(part.low) + way * i / steps; };
    const auto sum = [&](int i) {
      const Vec2 at = place(std::clamp(i, 0, steps));
      return height_on(rim_, t, at) + height_on(other_, u, at);
    };
    const int best = highest_along(t, u, place(0), way / steps, steps + 1);
    const double tent = 0.5 * std::fabs(sum(best + 1) - sum(best - 1));
    add_rival({sum(best) + tent, place(best), tent}, rivals);
  }

  // The first of the highest samples of a line over both triangles.
  int highest_along(const ProjectedTriangle& t, const ProjectedTriangle& u, const Vec2& from,
                    const Vec2& step, int samples) const noexcept {
    std::array<float, kMostOfLine> own, other;
    LineRow own_line, other_line;
    int best = 0;
    float most = 2.0f * kEmptySample;
    for (int first = 0; first < samples; first += kMostOfLine) {
      const int count = std::min(kMostOfLine, samples - first);
      const Vec2 begin = from + first * step;
      const auto look = [&](const ProjectedPatch& patch, const ProjectedTriangle& triangle,
                            std::array<float, kMostOfLine>& out, LineRow& line) {
        std::fill_n(out.begin(), count, kEmptySample);
        look_for_line(patch, triangle, begin, step, reading_, {out.data(), idx(count)}, line);
      };
      look(rim_, t, own, own_line);
      look(other_, u, other, other_line);
      raise_line(reading_, own_line);
      raise_line(reading_, other_line);
      for (int i = 0; i < count; ++i) {
        const float sum = own[idx(i)] + other[idx(i)];
        if (sum > most) most = sum, best = first + i;
      }
    }
    return best;
  }

  const PreparedContact& prepared_;
  const ProjectedPatch &rim_, &other_;
  Vec2 apart_;
  MapReading reading_;
};

void add_rim(PreparedContact& prepared, const ProjectedPatch& rim, const ProjectedPatch& other,
             const Vec2& apart, const MapReading& reading, double deepest,
             Rivals& rivals) noexcept {
  std::vector<PatchEdge>& edges = prepared.edges;
  sort_edges(rim, prepared.box, edges);
  const RimOver over_other(prepared, rim, other, apart, reading);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high)
      ++end;
    if (end == i + 1) over_other.add_edge(edges[i].edge, deepest, rivals);
    i = end;
  }
}

}  // namespace

void add_rival(const Rival& rival, Rivals& rivals) noexcept {
  if (rivals.push_back(rival)) return;
  Rival& lowest = *std::min_element(rivals.begin(), rivals.end(), is_lower);
  if (is_lower(lowest, rival)) lowest = rival;
}

Rivals rivals_on_rims(PreparedContact& prepared, const Vec2& apart, const MapReading& reading,
                      double deepest) noexcept {
  Rivals rivals;
  add_rim(prepared, prepared.object, prepared.scene, apart, reading, deepest, rivals);
  add_rim(prepared, prepared.scene, prepared.object, apart, reading, deepest, rivals);
  return rivals;
}

}  // namespace thigma::detail
