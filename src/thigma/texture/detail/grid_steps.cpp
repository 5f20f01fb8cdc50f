#include "thigma/texture/detail/grid_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace thigma::detail {
namespace {

constexpr int kPart = 4;  // samples of a part of the grid, each way

// Whether no sample beside is higher.
bool is_summit(const HeightMap& a, const HeightMap& b, const MapMaximum& of) noexcept {
  for (int row = std::max(of.row - 1, 0); row <= std::min(of.row + 1, a.rows - 1); ++row) {
    for (int column = std::max(of.column - 1, 0); column <= std::min(of.column + 1, a.columns - 1);
         ++column) {
      const std::size_t i = static_cast<std::size_t>(row * a.columns + column);
      if (a.heights[i] + b.heights[i] > of.sum) return false;
    }
  }
  return true;
}

MapMaximum best_of_part(const HeightMap& a, const HeightMap& b, int first_column,
                        int first_row) noexcept {
  MapMaximum best;
  for (int row = first_row; row < std::min(first_row + kPart, a.rows); ++row) {
    for (int column = first_column; column < std::min(first_column + kPart, a.columns); ++column) {
      const std::size_t i = static_cast<std::size_t>(row * a.columns + column);
      const float sum = a.heights[i] + b.heights[i];
      if (sum > best.sum) best = {sum, column, row};
    }
  }
  return best;
}

// How high the surfaces may be between a summit of the samples and those beside it: as a tent whose flanks go through them.
float tent_height(const HeightMap& a, const HeightMap& b, const MapMaximum& summit) noexcept {
  const auto sum_at = [&](int column, int row) {
    const int i = std::clamp(row, 0, a.rows - 1) * a.columns + std::clamp(column, 0, a.columns - 1);
    const float sum = a.heights[static_cast<std::size_t>(i)] + b.heights[static_cast<std::size_t>(i)];
    return sum > kEmptySample ? sum : summit.sum;
  };
  const int column = summit.column, row = summit.row;
  return summit.sum + 0.5f * std::fabs(sum_at(column + 1, row) - sum_at(column - 1, row)) +
         0.5f * std::fabs(sum_at(column, row + 1) - sum_at(column, row - 1));
}

// Summits of parts of the grid, other than the best sample, that may be highest between the samples, with those heights,
// the highest first; column -1 for none. Crests narrower than the grid are as likely to be the maximum as broad ones, and
// maps rank them to first order in what lies sideways.
using Rivals = std::array<MapMaximum, 3>;

Rivals rivals_of(const HeightMap& a, const HeightMap& b, const MapMaximum& best) noexcept {
  Rivals rivals;
  for (int row = 0; row < a.rows; row += kPart) {
    for (int column = 0; column < a.columns; column += kPart) {
      MapMaximum here = best_of_part(a, b, column, row);
      const bool is_best = here.column == best.column && here.row == best.row;
      if (is_best || !(here.sum > kEmptySample) || !is_summit(a, b, here)) continue;
      here.sum = tent_height(a, b, here);
      for (MapMaximum& rival : rivals)
        if (here.sum > rival.sum) std::swap(here, rival);
    }
  }
  return rivals;
}

}  // namespace

double DepthRounding::rounded(float sum) const noexcept {
  const double depth = static_cast<double>(sum);
  return quantum > 0.0 ? least + quantum * std::round((depth - least) / quantum) : depth;
}

DepthRounding depth_rounding(const GridDepthParams& params, float least, float largest) noexcept {
  if (!params.is_16_bit) return {};
  const double low = static_cast<double>(least);
  return {low, (static_cast<double>(largest) - low) / 65535.0};
}

void choose_steps(const DepthContact& contact, const MapGrid& grid, const DepthRequest& request,
                  DepthSamples& result) noexcept {
  const Vec2 spacing = grid.spacing();
  result.shift = request.step > 0.0 ? request.step : spacing.minCoeff();
  const double arm = std::max((contact.point - contact.centre).norm(), spacing.maxCoeff());
  result.turn = result.shift / arm;
}

PlaneMotion plane_motion(const DepthContact& contact, const DepthSamples& result,
                         int configuration) noexcept {
  const Vec3 centre =
      result.frame.world_from_contact.transpose() * (contact.centre - result.frame.origin);
  PlaneMotion motion{.centre = centre.head<2>()};
  if (configuration == 0) return motion;
  const int pair = (configuration - 1) / 2;
  const double sign = configuration % 2 == 1 ? 1.0 : -1.0;
  if (pair < 2) motion.shift[pair] = sign * result.shift;
  if (pair == 4) motion.turn = sign * result.turn;
  return motion;
}

void finish_depth(const GridDepthParams& params, const PreparedContact& prepared,
                  const MapGrid& grid, const MapMaximum& best, const DepthRounding& rounding,
                  DepthSamples& result) noexcept {
  result.at = grid.at(best.column, best.row);
  double depth = rounding.rounded(best.sum);
  if (params.is_polished && !params.is_16_bit) {
    const double finished = climb(prepared, grid.spacing(), result.at);
    if (finished != kNoDepth) depth = finished;
  }
  result.depth[0] = depth;
}

void try_rivals(const PreparedContact& prepared, const HeightMap& object, const HeightMap& scene,
               const MapGrid& grid, const MapMaximum& best, DepthSamples& result) noexcept {
  for (const MapMaximum& rival : rivals_of(object, scene, best)) {
    if (rival.column < 0 || !(static_cast<double>(rival.sum) > result.depth[0])) return;
    Vec2 at = grid.at(rival.column, rival.row);
    const double depth = climb(prepared, grid.spacing(), at);
    if (!(depth > result.depth[0])) continue;
    result.depth[0] = depth;
    result.at = at;
  }
}

}  // namespace thigma::detail
