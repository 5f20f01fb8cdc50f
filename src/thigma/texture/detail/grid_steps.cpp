#include "thigma/texture/detail/grid_steps.h"

#include <algorithm>
#include <cmath>

namespace thigma::detail {

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
  if (!params.is_16_bit) {
    const Vec2 spacing = params.is_polished ? grid.spacing() : Vec2(Vec2::Zero());
    const double finished = climb(prepared, spacing, result.at);
    if (finished != kNoDepth) depth = finished;
  }
  result.depth[0] = depth;
}

}  // namespace thigma::detail
