#pragma once
// The climb to a local maximum of the depth, whatever computes it.

#include <algorithm>

#include "thigma/depth/detail/prepared_contact.h"
#include "thigma/math/plane_cross.h"

namespace thigma::detail {

/// Where climbs may go, and how finely.
struct ClimbField {
  const ProjectedPatch &object, &scene;
  const PlaneBox& box;
  Vec2 shift = Vec2::Zero();  // of the object along the plane since it was projected [m]
  double finest = 0.0;        // steps no longer than this end a climb [m]
  double flat = -1.0;         // nor does one go on where no step goes down by more [m]
};

inline std::int32_t triangle_of(std::int32_t near) noexcept { return near; }

/// Climbs from a point to a local maximum within a box: steps along both axes and diagonals, from
/// `spacing` halved down to `finest`; where triangles end or change also along their edges.
///
/// Near      where a point was found: members object and scene, each a triangle or what
///           triangle_of makes one of
/// depth_at  double(const Vec2& at, Near& near): depth there, kNoDepth where a side does not lie
/// Thread    [contact]; no failure.
template <class Near, class DepthAt>
class Climb {
 public:
  Climb(const ClimbField& field, const DepthAt& depth_at) : field_(field), depth_at_(depth_at) {}

  /// at: start and result. near: where to look first. found: optional, where the result was.
  /// returns the depth there, of the start if it is no number.
  double run(const Vec2& spacing, const Near& near, Vec2& at,
             Near* found = nullptr) const noexcept {
    constexpr int kMostHalvings = 24;
    constexpr int kMostMoves = 32;  // along edges, all together
    Place here{at, kNoDepth, near};
    here.depth = depth_at_(at, here.near);
    Vec2 step = spacing;
    int moves = 0;
    for (int k = 0; k < kMostHalvings && step.minCoeff() > field_.finest; ++k) {
      step *= 0.5;
      const Surroundings around = look_around(here, step);
      const bool is_flat = !around.is_cut && around.best.depth <= here.depth &&
                           here.depth - around.least <= field_.flat;
      here = around.best;
      if (is_flat) break;
      // On a slanting edge, of the domain or of a fold, steps along the axes lose more than they
      // gain along it.
      while (around.is_cut && moves < kMostMoves) {
        const Place along = look_along_edges(here, step.norm());
        if (!(along.depth > here.depth)) break;
        here = along;
        ++moves;
      }
    }
    at = here.at;
    if (found) *found = here.near;
    return here.depth;
  }

 private:
  // A point of the plane, how deep it is there, and on which triangles.
  struct Place {
    Vec2 at = Vec2::Zero();
    double depth = kNoDepth;
    Near near;
  };

  // The deepest place found around one, and whether some of them lay on other triangles or on none.
  struct Surroundings {
    Place best;
    bool is_cut = false;
    double least = 0.0;
  };

  void try_point(const Place& from, const Vec2& point, Surroundings& around) const noexcept {
    Place to{point.cwiseMax(field_.box.low).cwiseMin(field_.box.high), kNoDepth, from.near};
    to.depth = depth_at_(to.at, to.near);
    around.is_cut = around.is_cut || to.depth == kNoDepth ||
                    triangle_of(to.near.object) != triangle_of(from.near.object) ||
                    triangle_of(to.near.scene) != triangle_of(from.near.scene);
    around.least = std::min(around.least, to.depth);
    if (to.depth > around.best.depth) around.best = to;
  }

  // Eight steps along the axes and diagonals.
  Surroundings look_around(const Place& from, const Vec2& step) const noexcept {
    Surroundings around{from, false, from.depth};
    for (int i = 0; i < 9; ++i) {
      if (i == 4) continue;
      try_point(from, from.at + step.cwiseProduct(Vec2(i % 3 - 1, i / 3 - 1)), around);
    }
    return around;
  }

  // Steps to and fro parallel to the edges of the triangles it lies on, those that a step may
  // reach.
  Place look_along_edges(const Place& from, double length) const noexcept {
    constexpr double kNearEdge = 2.0;  // of a step: edges farther away do not cut what lies around
    Surroundings around{from, false, from.depth};
    const auto try_edges = [&](const ProjectedPatch& patch, std::int32_t triangle, const Vec2& at) {
      if (triangle < 0) return;
      const ProjectedTriangle& t = projected_triangle(patch, triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& edge = t.edges[k];
        // By as much as its points move sideways the fine surface may end beside the edge.
        const double far = cross(edge, at - t.at[k]) + t.least[k];
        if (far > kNearEdge * length * edge.norm()) continue;
        const Vec2 step = length * edge.normalized();
        try_point(from, from.at + step, around);
        try_point(from, from.at - step, around);
      }
    };
    try_edges(field_.object, triangle_of(from.near.object), from.at - field_.shift);
    try_edges(field_.scene, triangle_of(from.near.scene), from.at);
    return around.best;
  }

  const ClimbField& field_;
  const DepthAt& depth_at_;
};

}  // namespace thigma::detail
