#include "thigma/depth/depth_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "thigma/core/index.h"
#include "thigma/depth/detail/prepared_contact.h"

namespace thigma {
namespace {

using detail::PreparedContact;

constexpr int kLook = 40;    // samples each way of a look at the whole domain
constexpr int kLooks = 4;    // until the part that counts is found
constexpr int kFinest = 96;  // samples each way of the last
constexpr int kBlocks = 8;   // each way: every block of samples has a peak at most
static_assert(kBlocks * kBlocks <= static_cast<int>(kMaxPeaks));
constexpr int kRing = 8;  // ways that a shape is fitted to
// Of a texel, the last steps of a climb: depths of short ways are told apart.
constexpr double kLastStep = 0.06;

/// Both sides as maps.
struct Maps {
  MapGrid grid;
  HeightMap object, scene;

  double sum(int column, int row) const noexcept {
    const std::size_t i = idx(row * grid.columns + column);
    return static_cast<double>(object.heights[i] + scene.heights[i]);
  }
};

void render(const PreparedContact& prepared, const MapGrid& grid, Maps& maps) noexcept {
  maps.grid = grid;
  render_heights(prepared.object, grid, SpanWidth::widest, maps.object);
  render_heights(prepared.scene, grid, SpanWidth::widest, maps.scene);
}

/// The part of a grid's box with samples above a depth, a cell wider; empty without.
PlaneBox part_above(const Maps& maps, double least) noexcept {
  int left = maps.grid.columns, right = -1, bottom = maps.grid.rows, top = -1;
  for (int row = 0; row < maps.grid.rows; ++row) {
    for (int column = 0; column < maps.grid.columns; ++column) {
      if (!(maps.sum(column, row) >= least)) continue;
      left = std::min(left, column), right = std::max(right, column);
      bottom = std::min(bottom, row), top = std::max(top, row);
    }
  }
  if (right < 0) return {};
  const PlaneBox part{maps.grid.at(left - 1.5, bottom - 1.5), maps.grid.at(right + 1.5, top + 1.5)};
  return intersection(part, maps.grid.box);
}

double side_of(const PlaneBox& box) noexcept { return (box.high - box.low).maxCoeff(); }

/// A sample that none beside it is above, or would be after a turn.
struct Summit {
  double score = kNoDepth;  // depth, and what a turn may add to it far out
  int column = 0, row = 0;
};

bool is_summit(const Maps& maps, int column, int row, double most) noexcept {
  for (int j = std::max(row - 1, 0); j <= std::min(row + 1, maps.grid.rows - 1); ++j)
    for (int i = std::max(column - 1, 0); i <= std::min(column + 1, maps.grid.columns - 1); ++i)
      if (maps.sum(i, j) > most) return false;
  return true;
}

/// A summit of every block that has one, the one that a turn may bring nearest, such first. Along a
/// ridge that lies on another all samples are summits: its far ends count.
void find_summits(const Maps& maps, double least, double turn,
                  std::vector<Summit>& summits) noexcept {
  const Vec2 middle = 0.5 * (maps.grid.box.low + maps.grid.box.high);
  const double slack = turn * maps.grid.spacing().maxCoeff();
  summits.assign(idx(kBlocks * kBlocks), {});
  for (int row = 0; row < maps.grid.rows; ++row) {
    for (int column = 0; column < maps.grid.columns; ++column) {
      const double depth = maps.sum(column, row);
      if (!(depth >= least)) continue;
      const int block =
          row * kBlocks / maps.grid.rows * kBlocks + column * kBlocks / maps.grid.columns;
      const double score = depth + turn * (maps.grid.at(column, row) - middle).norm();
      if (score > summits[idx(block)].score && is_summit(maps, column, row, depth + slack))
        summits[idx(block)] = {score, column, row};
    }
  }
  summits.erase(std::remove_if(summits.begin(), summits.end(),
                               [](const Summit& s) { return s.score == kNoDepth; }),
                summits.end());
  std::sort(summits.begin(), summits.end(), [](const Summit& a, const Summit& b) {
    if (a.score != b.score) return a.score > b.score;
    return a.row != b.row ? a.row < b.row : a.column < b.column;
  });
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

using Ring = std::array<double, kRing>;  // depths

/// Slope and bend through the depth at the peak and as near as can be to those of a ring: the first
/// three pairs of a Fourier series.
void fit(const Ring& ring, double radius, DepthPeak& peak) noexcept {
  Vec2 slope = Vec2::Zero();
  double mean = 0.0, stretch = 0.0, shear = 0.0;
  for (int i = 0; i < kRing; ++i) {
    const Vec2 u = on_ring(i);
    const double rise = ring[idx(i)] - peak.depth;
    slope += rise * u;
    mean += rise;
    stretch += rise * (u.x() * u.x() - u.y() * u.y());
    shear += rise * 2.0 * u.x() * u.y();
  }
  const double scale = 2.0 / (radius * radius * kRing);
  peak.slope = (2.0 / (kRing * radius)) * slope;
  const double off = scale * 2.0 * shear;
  peak.bend << scale * (mean + 2.0 * stretch), off, off, scale * (mean - 2.0 * stretch);
}

double shape_at(const DepthPeak& peak, const Vec2& way) noexcept {
  return peak.depth + peak.slope.dot(way) + 0.5 * way.dot(peak.bend * way);
}

/// Where the surfaces part, the shape is that of the other side turned about.
Ring closed(const Ring& ring, double depth) noexcept {
  Ring whole = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ring[i] != kNoDepth) continue;
    const double across = ring[(i + kRing / 2) % kRing];
    whole[i] = across == kNoDepth ? depth : 2.0 * depth - across;
  }
  return whole;
}

/// By how much a depth on a way is above all shapes.
double above(const DepthPeaks& peaks, const Vec2& way, double depth) noexcept {
  double highest = kNoDepth;
  for (const DepthPeak& peak : peaks) highest = std::max(highest, shape_at(peak, way));
  return depth - highest;
}

/// Depths of a peak with the object moved.
struct Around {
  detail::NearTriangles near;  // at the peak
  Ring ring{};
  std::array<double, kRing / 2> half{};
};

class GridPeaks final : public PeakSearch {
 public:
  PeakStats find(const DepthContact& contact, const PeakRequest& request,
                 DepthPeaks& peaks) noexcept override {
    PeakStats stats;
    peaks.clear();
    if (!detail::prepare_contact(contact, prepared_)) return stats;
    domain_ = prepared_.box;
    prepared_.finest = kLastStep;
    reach_ = Vec2::Constant(contact.reach);
    if (!look(contact, request, stats)) return stats;
    find_summits(maps_, request.least, request.turn, summits_);
    climb_all(peaks, stats);
    stats.travel = shape_within(request, peaks, stats);
    if (!peaks.empty()) stats.is_height_field = detail::is_upright(prepared_, peaks[0].at);
    return stats;
  }

 private:
  /// Maps of the part of the domain that counts; false where there is none.
  bool look(const DepthContact& contact, const PeakRequest& request, PeakStats& stats) noexcept {
    const double unseen =
        2.0 * (contact.object.texture->amplitude + contact.scene.texture->amplitude);
    PlaneBox part = domain_;
    for (int k = 0; k < kLooks; ++k) {
      render(prepared_, {part, kLook, kLook}, maps_);
      stats.is_found = stats.is_found || largest_sum(maps_.object, maps_.scene).column >= 0;
      const PlaneBox next = part_above(maps_, request.least - unseen);
      if (next.is_empty()) return false;
      const bool is_enough = side_of(next) > 0.7 * side_of(part);
      part = next;
      if (is_enough || side_of(part) <= kLook * prepared_.texel) break;
    }
    const double texel = prepared_.texel > 0.0 ? prepared_.texel : side_of(part) / kLook;
    const auto samples = [&](double side) {
      return std::clamp(static_cast<int>(std::min(side / texel, 1e6)) + 1, 16, kFinest);
    };
    const Vec2 size = part.high - part.low;
    render(prepared_, {part, samples(size.x()), samples(size.y())}, maps_);
    stats.is_coarse = maps_.grid.spacing().maxCoeff() > 2.0 * texel;
    return true;
  }

  void climb_all(DepthPeaks& peaks, PeakStats& stats) noexcept {
    const Vec2 spacing = maps_.grid.spacing();
    const double apart = std::max(prepared_.texel, spacing.maxCoeff());
    for (const Summit& summit : summits_) {
      DepthPeak peak;
      peak.at = maps_.grid.at(summit.column, summit.row);
      peak.depth = detail::climb(prepared_, spacing, peak.at);
      if (peak.depth == kNoDepth) continue;
      const bool is_known = std::any_of(peaks.begin(), peaks.end(), [&](const DepthPeak& p) {
        return (p.at - peak.at).norm() < apart;
      });
      if (is_known) continue;
      std::int32_t near = -1;
      peak.object_point << peak.at, height_at(prepared_.object, peak.at, near);
      stats.left_out += peaks.push_back(peak) ? 0 : 1;
    }
    std::sort(peaks.begin(), peaks.end(), [](const DepthPeak& a, const DepthPeak& b) {
      if (a.depth != b.depth) return a.depth > b.depth;
      return a.at.y() != b.at.y() ? a.at.y() < b.at.y() : a.at.x() < b.at.x();
    });
  }

  /// Depth of a peak with the object moved along the plane.
  double moved(const Around& place, const DepthPeak& peak, const Vec2& way) noexcept {
    constexpr double kWander = 3.0;  // of the way: farther a peak is another
    const Vec2 around = Vec2::Constant(kWander * way.norm() + 2.0 * prepared_.texel);
    const PlaneBox object{prepared_.object.box.low + way, prepared_.object.box.high + way};
    prepared_.box =
        intersection(intersection(intersection(object, prepared_.scene.box), {-reach_, reach_}),
                     {peak.at - around, peak.at + around});
    double depth = kNoDepth;
    if (!prepared_.box.is_empty()) {
      prepared_.shift = way;
      // The place stays with the scene, or goes with the object: the climb is from the deeper.
      detail::NearTriangles near = place.near;
      Vec2 at = within(peak.at), with_object = within(peak.at + way);
      const double stays = detail::depth_at(prepared_, at, near);
      near = place.near;
      if (detail::depth_at(prepared_, with_object, near) > stays) at = with_object;
      prepared_.start = place.near;
      depth = detail::climb(prepared_, Vec2::Constant(way.norm()), at);
    }
    prepared_.shift.setZero();
    prepared_.start = {};
    prepared_.box = domain_;
    return depth;
  }

  Vec2 within(const Vec2& at) const noexcept {
    return at.cwiseMax(prepared_.box.low).cwiseMin(prepared_.box.high);
  }

  /// Slope of a peak that is too far to be met, from the surfaces at its place.
  void slope_of_far(DepthPeak& peak) const noexcept {
    const SurfaceJet object = surface_jet(prepared_.object, peak.at),
                     scene = surface_jet(prepared_.scene, peak.at);
    peak.slope = 0.5 * (scene.slope - object.slope);
    peak.bend.setZero();
  }

  /// Depths of a peak with the object moved, on a ring and half of every other way.
  void look_about(const DepthPeak& peak, double travel, Around& around) noexcept {
    for (int i = 0; i < kRing; ++i) around.ring[idx(i)] = moved(around, peak, travel * on_ring(i));
    for (int i = 0; i < kRing; i += 2)
      around.half[idx(i / 2)] = moved(around, peak, 0.5 * travel * on_ring(i));
  }

  /// Fits all shapes to one travel; returns by how much a depth that was found is above them all.
  double shape_all(const PeakRequest& request, double travel, DepthPeaks& peaks) noexcept {
    for (std::size_t k = 0; k < peaks.size(); ++k) {
      peaks[k].travel = travel;
      if (peaks[k].depth < request.near) {
        slope_of_far(peaks[k]);
        continue;
      }
      around_[k].near = {};
      detail::depth_at(prepared_, peaks[k].at, around_[k].near);
      look_about(peaks[k], travel, around_[k]);
      fit(closed(around_[k].ring, peaks[k].depth), travel, peaks[k]);
    }
    double excess = 0.0;
    for (std::size_t k = 0; k < peaks.size(); ++k) {
      if (peaks[k].depth < request.near) continue;
      for (int i = 0; i < kRing; ++i)
        excess = std::max(excess, above(peaks, travel * on_ring(i), around_[k].ring[idx(i)]));
      for (int i = 0; i < kRing; i += 2)
        excess =
            std::max(excess, above(peaks, 0.5 * travel * on_ring(i), around_[k].half[idx(i / 2)]));
    }
    return excess;
  }

  /// Fits shapes; returns how far they hold. Never to less than half a texel, where they would tell
  /// facets of the interpolation.
  double shape_within(const PeakRequest& request, DepthPeaks& peaks, PeakStats& stats) noexcept {
    const double least_radius = 0.5 * prepared_.texel;
    double travel = request.travel;
    for (;;) {
      const double radius = std::max(travel, least_radius);
      stats.excess = shape_all(request, radius, peaks);
      if (stats.excess <= request.error || travel <= request.least_travel) return travel;
      // What a shape leaves out grows with the cube of the way, at a kink with the way itself.
      const double share = std::clamp(std::sqrt(request.error / stats.excess), 0.3, 0.8);
      travel = std::max(share * travel, request.least_travel);
      if (travel < least_radius) return travel;
    }
  }

  PreparedContact prepared_;
  PlaneBox domain_;
  Vec2 reach_ = Vec2::Zero();
  Maps maps_;
  std::vector<Summit> summits_;
  std::array<Around, kMaxPeaks> around_;
};

}  // namespace

std::unique_ptr<PeakSearch> make_peak_search() { return std::make_unique<GridPeaks>(); }

}  // namespace thigma
