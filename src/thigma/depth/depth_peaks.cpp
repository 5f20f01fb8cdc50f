#include "thigma/depth/depth_peaks.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma {
namespace {

using detail::on_ring;
using detail::shape_at;

// Of the travel: farther below a peak is met on no way of it.
constexpr double kMet = 1.25;
// Of what shapes may leave out: what climbs may.
constexpr double kFlat = 0.05;

/// The peak that a summit stands for: climbed to with the object moved as the summit wants it, and
/// told of where it is.
DepthPeak climb_from(const detail::Summit& summit, double spacing, PeakScratch& scratch) noexcept {
  constexpr double kWithin = 4.0;  // of the samples' distance: farther lies another summit
  detail::PeakField& field = scratch.field;
  const Vec2 around = Vec2::Constant(kWithin * spacing) + summit.shift.cwiseAbs();
  look_over({summit.at - around, summit.at + around}, field.object);
  look_over({summit.at - around, summit.at + around}, field.scene);
  DepthPeak peak;
  peak.at = summit.at;
  peak.depth = climb_moved(field, summit.shift, spacing, kWithin * spacing, {}, peak.at);
  if (peak.depth == kNoDepth) return peak;
  // Half the way back, so that it is beside the peak whether that stays or goes.
  peak.at = (peak.at - 0.5 * summit.shift)
                .cwiseMax(scratch.prepared.box.low)
                .cwiseMin(scratch.prepared.box.high);
  detail::NearFeet feet;
  peak.depth = depth_of(field, Vec2::Zero(), peak.at, feet);
  if (peak.depth == kNoDepth) return peak;
  feet.object.triangle = -1;
  peak.object_point << peak.at, height_near(field.object, peak.at, feet.object);
  return peak;
}

void climb_all(PeakScratch& scratch, DepthPeaks& peaks, PeakStats& stats) noexcept {
  const double spacing = scratch.maps.grid.spacing().maxCoeff();
  const double apart = std::max(scratch.prepared.texel, spacing);
  const auto is_known = [&](const Vec2& at, double within) {
    return std::any_of(peaks.begin(), peaks.end(),
                       [&](const DepthPeak& p) { return (p.at - at).norm() < within; });
  };
  for (const detail::Summit& summit : scratch.summits) {
    // A peak that goes along is the same.
    const double within = std::max(apart, summit.shift.norm());
    if (is_known(summit.at - 0.5 * summit.shift, within)) continue;
    const DepthPeak peak = climb_from(summit, spacing, scratch);
    if (peak.depth == kNoDepth || is_known(peak.at, within)) continue;
    stats.left_out += peaks.push_back(peak) ? 0 : 1;
  }
  std::sort(peaks.begin(), peaks.end(), [](const DepthPeak& a, const DepthPeak& b) {
    if (a.depth != b.depth) return a.depth > b.depth;
    return a.at.y() != b.at.y() ? a.at.y() < b.at.y() : a.at.x() < b.at.x();
  });
}

/// Slope of a peak that is too far to be met, from the surfaces at its place.
void slope_of_far(const detail::PreparedContact& prepared, DepthPeak& peak) noexcept {
  const SurfaceJet object = surface_jet(prepared.object, peak.at),
                   scene = surface_jet(prepared.scene, peak.at);
  peak.slope = 0.5 * (scene.slope - object.slope);
  peak.bend.setZero();
}

/// The larger of an excess, and by how much a depth on a way is above all shapes.
double above(const DepthPeaks& peaks, std::size_t own, const Vec2& way, double depth,
             double excess) noexcept {
  if (depth - shape_at(peaks[own], way) <= excess) return excess;
  double highest = kNoDepth;
  for (const DepthPeak& peak : peaks) highest = std::max(highest, shape_at(peak, way));
  return std::max(excess, depth - highest);
}

/// Fits all shapes to one travel; returns by how much a depth that was found is above them all.
double shape_all(const PeakRequest& request, double travel, PeakScratch& scratch,
                 DepthPeaks& peaks) noexcept {
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    peaks[k].travel = travel;
    if (peaks[k].depth < request.near) {
      slope_of_far(scratch.prepared, peaks[k]);
      continue;
    }
    look_about(scratch.field, peaks[k], travel, scratch.around[k]);
    fit_shape(scratch.around[k], travel, peaks[k]);
  }
  double excess = 0.0;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    if (peaks[k].depth < request.near) continue;
    const detail::Around& around = scratch.around[k];
    for (int i = 0; i < detail::kRing; ++i)
      excess = above(peaks, k, travel * on_ring(i), around.ring[idx(i)], excess);
    for (int i = 0; i < detail::kRing; i += 2)
      excess = above(peaks, k, 0.5 * travel * on_ring(i), around.half[idx(i / 2)], excess);
  }
  return excess;
}

/// Fits shapes; returns how far they hold. Never to less than half a texel, where they would tell
/// facets of the interpolation.
double shape_within(const PeakRequest& request, PeakScratch& scratch, DepthPeaks& peaks,
                    PeakStats& stats) noexcept {
  const double least_radius = 0.5 * scratch.prepared.texel;
  double travel = request.travel;
  for (;;) {
    const double radius = std::max(travel, least_radius);
    stats.excess = shape_all(request, radius, scratch, peaks);
    if (stats.excess <= request.error || travel <= request.least_travel) return travel;
    // What a shape leaves out grows with the cube of the way, at a kink with the way itself.
    const double share = std::clamp(std::sqrt(request.error / stats.excess), 0.3, 0.8);
    travel = std::max(share * travel, request.least_travel);
    if (travel < least_radius) return travel;
  }
}

}  // namespace

void reserve_peaks(PeakScratch& scratch) {
  detail::reserve_maps(scratch.maps);
  scratch.summits.reserve(2 * static_cast<std::size_t>(detail::kMostBlocks));
}

PeakStats find_peaks(const DepthContact& contact, const PeakRequest& request, PeakScratch& scratch,
                     DepthPeaks& peaks) noexcept {
  PeakStats stats;
  peaks.clear();
  detail::PreparedContact& prepared = scratch.prepared;
  if (!detail::prepare_contact(contact, prepared)) return stats;
  bind_surface(prepared.object, scratch.field.object);
  bind_surface(prepared.scene, scratch.field.scene);
  scratch.field.reach = {Vec2::Constant(-contact.reach), Vec2::Constant(contact.reach)};
  scratch.field.texel = prepared.texel;
  scratch.field.flat = kFlat * request.error;
  if (!look_for_peaks(prepared, request.least, scratch.maps, stats.is_found)) return stats;
  stats.is_coarse = scratch.maps.grid.spacing().maxCoeff() > 2.0 * prepared.texel;
  find_summits({request.least, request.turn, request.travel, -kMet * request.travel}, scratch.maps,
               scratch.summits);
  climb_all(scratch, peaks, stats);
  stats.travel = shape_within(request, scratch, peaks, stats);
  if (!peaks.empty()) stats.is_height_field = detail::is_upright(prepared, peaks[0].at);
  return stats;
}

}  // namespace thigma
