#include "thigma/depth/detail/grid_refinement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <xmmintrin.h>

#include "thigma/depth/detail/fine_sheets.h"
#include "thigma/depth/detail/rim_search.h"

namespace thigma::detail {
namespace {

constexpr int kPart = 4;  // samples of a part of the grid, each way

/// Sums of two maps.
struct Sums {
  const float* at = nullptr;  // row by row
  int columns = 0, rows = 0;
  float operator()(int column, int row) const noexcept { return at[row * columns + column]; }
};

Sums sum_maps(const HeightMap& a, const HeightMap& b, std::vector<float>& sums) noexcept {
  const std::size_t count = a.heights.size(), whole = count - count % 4;
  if (sums.size() < count) sums.resize(count);
  const float *x = a.heights.data(), *y = b.heights.data();
  float* const out = sums.data();
  for (std::size_t i = 0; i < whole; i += 4)
    _mm_storeu_ps(out + i, _mm_add_ps(_mm_loadu_ps(x + i), _mm_loadu_ps(y + i)));
  for (std::size_t i = whole; i < count; ++i) out[i] = x[i] + y[i];
  return {out, a.columns, a.rows};
}

// Whether no sample beside is higher.
bool is_summit(const Sums& sums, const MapMaximum& of) noexcept {
  const int first = std::max(of.column - 1, 0), last = std::min(of.column + 1, sums.columns - 1);
  for (int row = std::max(of.row - 1, 0); row <= std::min(of.row + 1, sums.rows - 1); ++row)
    for (int column = first; column <= last; ++column)
      if (sums(column, row) > of.sum) return false;
  return true;
}

// The first of the largest samples of a part that is whole.
MapMaximum best_of_whole(const Sums& sums, int first_column, int first_row) noexcept {
  const float* const at = sums.at + first_row * sums.columns + first_column;
  const __m128 rows[kPart] = {_mm_loadu_ps(at), _mm_loadu_ps(at + sums.columns),
                              _mm_loadu_ps(at + 2 * sums.columns),
                              _mm_loadu_ps(at + 3 * sums.columns)};
  __m128 most = _mm_max_ps(_mm_max_ps(rows[0], rows[1]), _mm_max_ps(rows[2], rows[3]));
  most = _mm_max_ps(most, _mm_shuffle_ps(most, most, _MM_SHUFFLE(1, 0, 3, 2)));
  most = _mm_max_ps(most, _mm_shuffle_ps(most, most, _MM_SHUFFLE(2, 3, 0, 1)));
  unsigned where = 0;
  for (int k = 0; k < kPart; ++k)
    where |= static_cast<unsigned>(_mm_movemask_ps(_mm_cmpeq_ps(rows[k], most))) << (kPart * k);
  const int i = std::countr_zero(where | 1u << (kPart * kPart));
  return {_mm_cvtss_f32(most), first_column + i % kPart, first_row + i / kPart};
}

MapMaximum best_of_part(const Sums& sums, int first_column, int first_row) noexcept {
  if (first_column + kPart <= sums.columns && first_row + kPart <= sums.rows)
    return best_of_whole(sums, first_column, first_row);
  MapMaximum best;
  for (int row = first_row; row < std::min(first_row + kPart, sums.rows); ++row)
    for (int column = first_column; column < std::min(first_column + kPart, sums.columns); ++column)
      if (sums(column, row) > best.sum) best = {sums(column, row), column, row};
  return best;
}

// How high the surfaces may be between a summit of the samples and those beside it: as a tent whose
// flanks go through them.
float tent_height(const Sums& sums, const MapMaximum& summit) noexcept {
  const auto sum_at = [&](int column, int row) {
    const float sum =
        sums(std::clamp(column, 0, sums.columns - 1), std::clamp(row, 0, sums.rows - 1));
    return sum > kEmptySample ? sum : summit.sum;
  };
  const int column = summit.column, row = summit.row;
  return summit.sum + 0.5f * std::fabs(sum_at(column + 1, row) - sum_at(column - 1, row)) +
         0.5f * std::fabs(sum_at(column, row + 1) - sum_at(column, row - 1));
}

constexpr int kClimbs = 3;       // of summits at most, and of places on rims
constexpr int kFine = 16;        // samples each way of the closer look
constexpr double kAround = 1.5;  // cells it goes each way from the summit

// The best sample, and those with the highest tents. Crests narrower than the grid are as likely to
// be the maximum as broad ones.
Rivals rivals_of(const Sums& sums, const MapGrid& grid, const MapMaximum& best) noexcept {
  Rivals rivals;
  rivals.push_back({std::numeric_limits<double>::infinity(), grid.at(best.column, best.row)});
  for (int row = 0; row < sums.rows; row += kPart) {
    for (int column = 0; column < sums.columns; column += kPart) {
      const MapMaximum here = best_of_part(sums, column, row);
      const bool is_best = here.column == best.column && here.row == best.row;
      if (is_best || !(here.sum > kEmptySample) || !is_summit(sums, here)) continue;
      add_rival({static_cast<double>(tent_height(sums, here)), grid.at(here.column, here.row)},
                rivals);
    }
  }
  return rivals;
}

// Maps are of first order: the depth itself says how high the tent stands; a sample where there is
// none.
void raise_to_depth(const PreparedContact& prepared, double sample, Rival& rival) noexcept {
  NearFeet feet;
  const double depth = depth_near(prepared, rival.at, feet);
  rival.hope = (depth == kNoDepth ? sample : depth) + rival.tent;
}

// Samples more finely around a summit: moves it to the best of them. Its hope is the depth there,
// and what the tent over these samples adds.
void look_closer(PreparedContact& prepared, const MapGrid& grid, const MapReading& reading,
                 Rival& rival) noexcept {
  const Vec2 around = kAround * grid.spacing();
  const MapGrid fine{intersection({rival.at - around, rival.at + around}, grid.box), kFine, kFine};
  render_heights(prepared.object, fine, reading, prepared.fine_object);
  render_heights(prepared.scene, fine, reading, prepared.fine_scene);
  const MapMaximum best = largest_sum(prepared.fine_object, prepared.fine_scene);
  rival.hope = kNoDepth;
  if (best.column < 0) return;
  rival.at = fine.at(best.column, best.row);
  const float tent =
      tent_height(sum_maps(prepared.fine_object, prepared.fine_scene, prepared.sums), best);
  rival.tent = static_cast<double>(tent - best.sum);
  raise_to_depth(prepared, static_cast<double>(best.sum), rival);
}

// Along a rim, of the grid's spacing: about as near as the samples of a closer look.
constexpr double kRimApart = 0.25;

// Climbs from the highest rivals while they may be deeper than what is known; returns what then is.
double climb_from(const PreparedContact& prepared, const Vec2& spacing, Rivals& rivals,
                  double deepest, DepthSamples& result) noexcept {
  for (int k = 0; k < kClimbs && !rivals.empty(); ++k) {
    Rival& rival = *std::max_element(rivals.begin(), rivals.end(), is_lower);
    if (!(rival.hope > deepest)) break;
    rival.hope = kNoDepth;
    const double depth = climb(prepared, spacing, rival.at);
    if (!(depth > deepest)) continue;
    result.depth[0] = deepest = depth;
    result.at = rival.at;
  }
  return deepest;
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
  if (!params.is_polished) {
    result.is_height_field = is_upright(prepared, result.at);
    return;
  }
  bind_near(prepared);
  Rivals rivals = rivals_of(sum_maps(maps.object, maps.scene, prepared.sums), grid, best);
  for (Rival& rival : rivals) look_closer(prepared, grid, reading_of(params), rival);
  double deepest = climb_from(prepared, grid.spacing(), rivals, kNoDepth, result);
  rivals = rivals_on_rims(prepared, kRimApart * grid.spacing(), reading_of(params), deepest);
  for (Rival& rival : rivals) raise_to_depth(prepared, kNoDepth, rival);
  climb_from(prepared, 2.0 * kRimApart * grid.spacing(), rivals, deepest, result);
  settle_height_field(prepared, grid.spacing(), result);
}

}  // namespace thigma::detail
