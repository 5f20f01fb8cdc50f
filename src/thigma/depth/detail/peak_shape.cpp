#include "thigma/depth/detail/peak_shape.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/depth/detail/climb.h"

namespace thigma::detail {
namespace {

// Of a texel, the last steps of a climb: depths of short ways are told apart.
constexpr double kLastStep = 0.06;
constexpr double kWander = 3.0;  // of a way: farther the deepest place is another

using Ring = std::array<double, kRing>;  // heights or depths

/// Height of one side, kNoSurface beside its patch.
double height_of(const NearSurface& side, const Vec2& at, SurfaceFoot& foot) noexcept {
  return contains(side.patch->box, at) ? height_near(side, at, foot) : kNoSurface;
}

/// What is missing is that of the other side turned about.
Ring closed(const Ring& ring, double middle) noexcept {
  Ring whole = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != kNoDepth) continue;
    const double across = ring[(i + kRing / 2) % kRing];
    whole[i] = across == kNoDepth ? middle : 2.0 * middle - across;
  }
  return whole;
}

/// A function of second order of the way.
struct Bent {
  Vec2 slope = Vec2::Zero();
  Mat2 bend = Mat2::Zero();
};

Bent fit(const Ring& ring, double middle, double radius) noexcept {
  Bent bent;
  double mean = 0.0, stretch = 0.0, shear = 0.0;
  for (int i = 0; i < kRing; ++i) {
    const Vec2 u = on_ring(i);
    const double rise = ring[idx(i)] - middle;
    bent.slope += rise * u;
    mean += rise;
    stretch += rise * (u.x() * u.x() - u.y() * u.y());
    shear += rise * 2.0 * u.x() * u.y();
  }
  const double scale = 2.0 / (radius * radius * kRing);
  bent.slope *= 2.0 / (kRing * radius);
  const double off = scale * 2.0 * shear;
  bent.bend << scale * (mean + 2.0 * stretch), off, off, scale * (mean - 2.0 * stretch);
  return bent;
}

/// Both surfaces about a place, and what follows of where the deepest place goes.
struct Sides {
  NearFeet feet;
  double object = 0.0, scene = 0.0;  // heights at the place
  Ring object_ring{}, scene_ring{};
  bool is_cut = false;
  Bent of_object, of_sum;
};

Sides sides_at(const PeakField& field, const Vec2& at, double radius) noexcept {
  Sides s;
  s.object = height_of(field.object, at, s.feet.object);
  s.scene = height_of(field.scene, at, s.feet.scene);
  for (int i = 0; i < kRing; ++i) {
    NearFeet feet = s.feet;
    const Vec2 beside = at + radius * on_ring(i);
    s.object_ring[idx(i)] = height_of(field.object, beside, feet.object);
    s.scene_ring[idx(i)] = height_of(field.scene, beside, feet.scene);
    s.is_cut = s.is_cut || s.object_ring[idx(i)] == kNoSurface ||
               s.scene_ring[idx(i)] == kNoSurface || !contains(field.reach, beside);
  }
  s.of_object = fit(closed(s.object_ring, s.object), s.object, radius);
  const Bent of_scene = fit(closed(s.scene_ring, s.scene), s.scene, radius);
  s.of_sum = {s.of_object.slope + of_scene.slope, s.of_object.bend + of_scene.bend};
  return s;
}

/// Where the sum of both surfaces, taken as of second order, is deepest after a way of the object.
/// Along what hardly bends, or bends the other way, no farther than kWander.
Vec2 deepest_after(const Sides& s, const Vec2& way) noexcept {
  constexpr double kFlat = 0.02;  // of how the surfaces bend
  const Mat2& bend = s.of_sum.bend;
  const double flat = kFlat * (s.of_object.bend.norm() + (bend - s.of_object.bend).norm());
  const double mean = 0.5 * (bend(0, 0) + bend(1, 1)), half = 0.5 * (bend(0, 0) - bend(1, 1)),
               off = bend(0, 1);
  const double size = std::sqrt(half * half + off * off);
  const double angle_x = size > 0.0 ? half / size : 1.0, angle_y = size > 0.0 ? off / size : 0.0;
  const Vec2 first(std::sqrt(std::max(0.5 * (1.0 + angle_x), 0.0)),
                   std::copysign(std::sqrt(std::max(0.5 * (1.0 - angle_x), 0.0)), angle_y));
  const Vec2 second(-first.y(), first.x());
  const Vec2 rise = s.of_sum.slope - s.of_object.bend * way;
  const auto along = [&](const Vec2& axis, double by) {
    const double most = std::min(by, -flat);
    return most < 0.0 ? Vec2(axis * (-axis.dot(rise) / most)) : Vec2(Vec2::Zero());
  };
  const Vec2 to = along(first, mean + size) + along(second, mean - size);
  const double length = to.norm(), farthest = kWander * way.norm();
  return length > farthest ? Vec2(to * (farthest / length)) : to;
}

/// Depth of a place after a way: the largest of what stays, what goes and where it should be.
double largest_after(PeakField& field, const DepthPeak& peak, const Sides& s, const Vec2& way,
                     double stays, double goes) noexcept {
  const Vec2 to = peak.at + deepest_after(s, way);
  NearFeet feet = s.feet;
  const double there = depth_of(field, way, to, feet);
  if (!s.is_cut) return std::max({stays, goes, there});
  Vec2 at = there >= std::max(stays, goes) ? to : Vec2(stays >= goes ? peak.at : peak.at + way);
  const PlaneBox object{field.object.patch->box.low + way, field.object.patch->box.high + way};
  const PlaneBox box = intersection(intersection(object, field.scene.patch->box), field.reach);
  at = at.cwiseMax(box.low).cwiseMin(box.high);
  return climb_moved(field, way, way.norm(), kWander * way.norm() + 2.0 * field.texel, s.feet, at);
}

double sum_of(double object, double scene) noexcept {
  return object == kNoSurface || scene == kNoSurface ? kNoDepth : object + scene;
}

}  // namespace

double depth_of(const PeakField& field, const Vec2& shift, const Vec2& at,
                NearFeet& feet) noexcept {
  if (!contains(field.reach, at)) return kNoDepth;
  const double object = height_of(field.object, at - shift, feet.object);
  if (object == kNoSurface) return kNoDepth;
  return sum_of(object, height_of(field.scene, at, feet.scene));
}

double climb_moved(PeakField& field, const Vec2& shift, double spacing, double within,
                   const NearFeet& feet, Vec2& at) noexcept {
  const Vec2 around = Vec2::Constant(within);
  const ProjectedPatch &object = *field.object.patch, &scene = *field.scene.patch;
  const PlaneBox moved{object.box.low + shift, object.box.high + shift};
  const PlaneBox box = intersection(intersection(intersection(moved, scene.box), field.reach),
                                    {at - around, at + around});
  if (box.is_empty()) return kNoDepth;
  const ClimbField where{object, scene, box, shift, kLastStep * field.texel, field.flat};
  const auto depth = [&](const Vec2& there, NearFeet& near) {
    return depth_of(field, shift, there, near);
  };
  return Climb<NearFeet, decltype(depth)>(where, depth).run(Vec2::Constant(spacing), feet, at);
}

Vec2 on_ring(int i) noexcept {
  constexpr double kSlant = 0.70710678118654752;
  constexpr std::array<std::array<double, 2>, kRing> kWays = {{{1, 0},
                                                               {kSlant, kSlant},
                                                               {0, 1},
                                                               {-kSlant, kSlant},
                                                               {-1, 0},
                                                               {-kSlant, -kSlant},
                                                               {0, -1},
                                                               {kSlant, -kSlant}}};
  return {kWays[idx(i)][0], kWays[idx(i)][1]};
}

void look_about(PeakField& field, const DepthPeak& peak, double radius, Around& around) noexcept {
  const Vec2 far = Vec2::Constant((kWander + 1.0) * radius + 2.0 * field.texel);
  look_over({peak.at - far, peak.at + far}, field.object);
  look_over({peak.at - far, peak.at + far}, field.scene);
  const Sides s = sides_at(field, peak.at, radius);
  for (int i = 0; i < kRing; ++i) {
    const std::size_t across = idx((i + kRing / 2) % kRing);
    around.ring[idx(i)] =
        largest_after(field, peak, s, radius * on_ring(i), sum_of(s.object_ring[across], s.scene),
                      sum_of(s.object, s.scene_ring[idx(i)]));
  }
  for (int i = 0; i < kRing; i += 2) {
    const Vec2 way = 0.5 * radius * on_ring(i);
    NearFeet stays = s.feet, goes = s.feet;
    around.half[idx(i / 2)] =
        largest_after(field, peak, s, way, depth_of(field, way, peak.at, stays),
                      depth_of(field, way, peak.at + way, goes));
  }
}

void fit_shape(const Around& around, double radius, DepthPeak& peak) noexcept {
  const Bent bent = fit(closed(around.ring, peak.depth), peak.depth, radius);
  peak.slope = bent.slope;
  peak.bend = bent.bend;
}

}  // namespace thigma::detail
