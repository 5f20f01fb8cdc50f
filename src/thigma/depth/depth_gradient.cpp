#include "thigma/depth/depth_gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "thigma/depth/detail/prepared_contact.h"

namespace thigma {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"central_differences", "envelope",
                                                    "smoothed_envelope"};

// Eq. 4.8, turned from {u, v, n} to the world (Eq. 4.7).
DepthGradient by_differences(const DepthSamples& s) noexcept {
  DepthGradient gradient;
  Vec3 slope(0.0, 0.0, 1.0), turn;
  for (int pair = 0; pair < 5; ++pair) {
    const std::size_t i = static_cast<std::size_t>(1 + 2 * pair);
    const double step = pair < 2 ? s.shift : s.turn;
    const double derivative = (s.depth[i] - s.depth[i + 1]) / (2.0 * step);
    if (!std::isfinite(derivative)) return gradient;
    if (pair < 2) {
      slope[pair] = derivative;
    } else {
      turn[pair - 2] = derivative;
    }
  }
  gradient.is_valid = true;
  gradient.linear = s.frame.world_from_contact * slope;
  gradient.angular = s.frame.world_from_contact * turn;
  return gradient;
}

// A place of the maximum, with the surfaces there.
struct MaximumPlace {
  const SurfaceJet& object;
  const SurfaceJet& scene;
  const Vec2& at;
  detail::NearFeet near;  // where it was found
};

// Whether the maximum is held at a point by the end of a side's domain: the depth would still rise
// beyond it.
int edge_at(const GradientScratch& scratch, const MaximumPlace& place, double texel) noexcept {
  // Of the depth along the plane, as the search saw it: differences of texels take in what lies
  // beside a chart.
  const Vec2 rising = place.object.facet_slope + place.scene.facet_slope;
  const double length = rising.norm();
  if (!(length > 0.0)) return 0;
  constexpr double kBeyond = 0.25;  // of a texel: twice what the climb to the maximum leaves
  const Vec2 beyond = place.at + (kBeyond * texel / length) * rising;
  detail::NearFeet near = place.near;
  if (height_at(scratch.object, beyond, near.object) == kNoSurface) return -1;
  return height_at(scratch.scene, beyond, near.scene) == kNoSurface ? 1 : 0;
}

// At a maximum held by a crease of one side, such as the edge of a box, the slope that counts is
// the other's: the one that changes less across the point. A side that ends within the step, as the
// top of a box beside its wall, is the crease. Signs as of edge_at.
int crease_at(const GradientScratch& scratch, const MaximumPlace& place, double texel) noexcept {
  const Vec2 rising = place.object.slope + place.scene.slope;
  const double length = rising.norm();
  if (!(length > 0.0)) return 0;
  const Vec2 step = (texel / length) * rising;
  const auto change = [&](const ProjectedPatch& patch, SurfaceFoot foot) {
    const SurfaceJet before = surface_jet(patch, place.at - step, foot),
                     after = surface_jet(patch, place.at + step, foot);
    return before.is_covered && after.is_covered ? (after.slope - before.slope).norm()
                                                 : std::numeric_limits<double>::infinity();
  };
  const double of_object = change(scratch.object, place.near.object),
               of_scene = change(scratch.scene, place.near.scene);
  constexpr double kClearly = 2.0;  // less apart, neither is the crease
  if (of_object > kClearly * of_scene) return -1;
  return of_scene > kClearly * of_object ? 1 : 0;
}

DepthGradient by_envelope(const DepthContact& contact, const DepthSamples& sample, bool is_smoothed,
                          GradientScratch& scratch) noexcept {
  const double texel = detail::finer_texel(contact);
  double weights = 0.0;
  detail::NearFeet feet;  // of the last place
  const NearMaximum only{sample.at, 1.0};
  const NearMaximum* first = is_smoothed ? sample.near.begin() : &only;
  const NearMaximum* last = is_smoothed ? sample.near.end() : &only + 1;
  // Looked at are these places and what lies within a texel of them.
  PlaneBox over;
  for (const NearMaximum* near = first; near != last; ++near)
    over = {over.low.cwiseMin(near->at), over.high.cwiseMax(near->at)};
  const Vec2 around = Vec2::Constant(2.0 * texel);
  over = {over.low - around, over.high + around};
  detail::project_sides(contact, sample.frame, over, scratch.object, scratch.scene);
  DepthGradient sum;
  for (const NearMaximum* near = first; near != last; ++near) {
    const SurfaceJet object = surface_jet(scratch.object, near->at, feet.object);
    const SurfaceJet scene = surface_jet(scratch.scene, near->at, feet.scene);
    if (!object.is_covered || !scene.is_covered) continue;
    const MaximumPlace place{object, scene, near->at, feet};
    int edge = edge_at(scratch, place, texel);
    const SmoothPeak peak = smooth_peak(object, scene, texel);
    if (edge == 0 && !peak.is_near) edge = crease_at(scratch, place, texel);
    const DepthGradient here =
        gradient_at(edge == 0 && peak.is_near ? carried(object, peak.step) : object, sample.frame,
                    contact.centre, envelope_slope(object, scene, peak, edge));
    sum.linear += near->weight * here.linear;
    sum.angular += near->weight * here.angular;
    weights += near->weight;
  }
  if (!(weights > 0.0)) return {};
  return {true, sum.linear / weights, sum.angular / weights};
}

}  // namespace

bool gradient_kind(std::string_view name, GradientKind& kind) noexcept {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return false;
  kind = static_cast<GradientKind>(found - kNames.begin());
  return true;
}

std::string_view gradient_name(GradientKind kind) noexcept {
  return kNames[static_cast<std::size_t>(kind)];
}

DepthRequest depth_request(GradientKind kind, double amplitude, double smoothing) noexcept {
  DepthRequest request;
  request.has_differences = kind == GradientKind::central_differences;
  if (kind == GradientKind::smoothed_envelope) request.near = smoothing * amplitude;
  return request;
}

DepthGradient depth_gradient(const DepthContact& contact, const DepthSamples& sample,
                             GradientKind kind, GradientScratch& scratch) noexcept {
  if (!sample.is_found) return {};
  if (kind == GradientKind::central_differences) return by_differences(sample);
  return by_envelope(contact, sample, kind == GradientKind::smoothed_envelope, scratch);
}

DepthGradient gradient_at(const SurfaceJet& object, const ContactFrame& frame, const Vec3& centre,
                          const Vec2& slope) noexcept {
  // With the point s of the plane held, a motion V of the object moves the surface there by V of
  // its point: the height changes by n . V - slope . V.
  const Vec3 c = frame.world_from_contact.transpose() * (centre - frame.origin);
  const Vec3 off(-slope.x(), -slope.y(), 1.0);
  return {true, frame.world_from_contact * off,
          frame.world_from_contact * (object.point - c).cross(off)};
}

SmoothPeak smooth_peak(const SurfaceJet& object, const SurfaceJet& scene, double texel) noexcept {
  const Mat2 bowl = -(object.curvature + scene.curvature);  // of minus the depth
  if (!(bowl.determinant() > 0.0 && bowl.trace() > 0.0)) return {};
  const Vec2 step = bowl.inverse() * (object.slope + scene.slope);
  // A longer step would leave the texels the second derivatives are of.
  if (!(step.norm() <= texel)) return {};
  return {true, step, bowl};
}

SurfaceJet carried(const SurfaceJet& jet, const Vec2& step) noexcept {
  SurfaceJet there = jet;
  there.point.head<2>() += step;
  there.point.z() += jet.slope.dot(step);
  return there;
}

Vec2 envelope_slope(const SurfaceJet& object, const SurfaceJet& scene, const SmoothPeak& peak,
                    int edge) noexcept {
  // The scene's height along n is minus the one along its facing direction.
  const Vec2 from_object = object.slope, from_scene = -scene.slope;
  if (edge != 0) return edge < 0 ? from_scene : from_object;
  if (peak.is_near) return from_object + object.curvature * peak.step;
  return 0.5 * (from_object + from_scene);
}

}  // namespace thigma
