#include "thigma/depth/detail/grid_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/core/static_vector.h"

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

// How high the surfaces may be between a summit of the samples and those beside it: as a tent whose
// flanks go through them.
float tent_height(const HeightMap& a, const HeightMap& b, const MapMaximum& summit) noexcept {
  const auto sum_at = [&](int column, int row) {
    const int i = std::clamp(row, 0, a.rows - 1) * a.columns + std::clamp(column, 0, a.columns - 1);
    const float sum =
        a.heights[static_cast<std::size_t>(i)] + b.heights[static_cast<std::size_t>(i)];
    return sum > kEmptySample ? sum : summit.sum;
  };
  const int column = summit.column, row = summit.row;
  return summit.sum + 0.5f * std::fabs(sum_at(column + 1, row) - sum_at(column - 1, row)) +
         0.5f * std::fabs(sum_at(column, row + 1) - sum_at(column, row - 1));
}

constexpr int kLooked = 8;       // summits that are looked at more closely
constexpr int kClimbs = 3;       // of them climbed from, at most
constexpr int kFine = 16;        // samples each way of the closer look
constexpr double kAround = 1.5;  // cells it goes each way from the summit

// A summit of a part of the grid, and how high it may be: as a tent between its samples, then from
// a closer look [m].
struct Rival {
  double hope = kNoDepth;
  Vec2 at = Vec2::Zero();
};
using Rivals = StaticVector<Rival, kLooked>;

bool is_lower(const Rival& a, const Rival& b) noexcept { return a.hope < b.hope; }

// The best sample, and those with the highest tents. Crests narrower than the grid are as likely to
// be the maximum as broad ones.
Rivals rivals_of(const HeightMap& a, const HeightMap& b, const MapGrid& grid,
                 const MapMaximum& best) noexcept {
  Rivals rivals;
  rivals.push_back({std::numeric_limits<double>::infinity(), grid.at(best.column, best.row)});
  for (int row = 0; row < a.rows; row += kPart) {
    for (int column = 0; column < a.columns; column += kPart) {
      const MapMaximum here = best_of_part(a, b, column, row);
      const bool is_best = here.column == best.column && here.row == best.row;
      if (is_best || !(here.sum > kEmptySample) || !is_summit(a, b, here)) continue;
      const Rival rival{static_cast<double>(tent_height(a, b, here)),
                        grid.at(here.column, here.row)};
      if (rivals.push_back(rival)) continue;
      Rival& lowest = *std::min_element(rivals.begin(), rivals.end(), is_lower);
      if (is_lower(lowest, rival)) lowest = rival;
    }
  }
  return rivals;
}

// Samples more finely around a summit: moves it to the best of them. Its hope is the depth there,
// and what the tent over these samples adds.
void look_closer(PreparedContact& prepared, const MapGrid& grid, SpanWidth width,
                 Rival& rival) noexcept {
  const Vec2 around = kAround * grid.spacing();
  const MapGrid fine{intersection({rival.at - around, rival.at + around}, grid.box), kFine, kFine};
  render_heights(prepared.object, fine, width, prepared.fine_object);
  render_heights(prepared.scene, fine, width, prepared.fine_scene);
  const MapMaximum best = largest_sum(prepared.fine_object, prepared.fine_scene);
  rival.hope = kNoDepth;
  if (best.column < 0) return;
  rival.at = fine.at(best.column, best.row);
  NearTriangles triangles;
  // Maps are of first order: the depth itself says how high the tent stands.
  const double depth = depth_at(prepared, rival.at, triangles);
  const float tent = tent_height(prepared.fine_object, prepared.fine_scene, best);
  rival.hope = (depth == kNoDepth ? static_cast<double>(best.sum) : depth) +
               static_cast<double>(tent - best.sum);
}

}  // namespace

void choose_difference_steps(const DepthContact& contact, const MapGrid& grid,
                             const DepthRequest& request, DepthSamples& result) noexcept {
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

void climb_to_maximum(const GridDepthParams& params, PreparedContact& prepared,
                      const RenderedMaps& maps, const MapMaximum& best,
                      DepthSamples& result) noexcept {
  const MapGrid& grid = maps.grid;
  result.at = grid.at(best.column, best.row);
  result.depth[0] = static_cast<double>(best.sum);
  if (!params.is_polished) return;
  Rivals rivals = rivals_of(maps.object, maps.scene, grid, best);
  for (Rival& rival : rivals) look_closer(prepared, grid, params.width, rival);
  double deepest = kNoDepth;
  for (int k = 0; k < kClimbs; ++k) {
    Rival& rival = *std::max_element(rivals.begin(), rivals.end(), is_lower);
    if (!(rival.hope > deepest)) break;
    rival.hope = kNoDepth;
    const double depth = climb(prepared, grid.spacing(), rival.at);
    if (!(depth > deepest)) continue;
    result.depth[0] = deepest = depth;
    result.at = rival.at;
  }
}

}  // namespace thigma::detail
