#include "thigma/depth/detail/peak_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

constexpr int kLook = 40;         // samples each way of a look at the whole domain
constexpr int kLooks = 4;         // until the part that counts is found
constexpr int kFinest = 96 * 96;  // samples of the last, in all
constexpr int kLeast = 16;        // of them, each way

void render(const PreparedContact& prepared, const MapGrid& grid, PeakMaps& maps) noexcept {
  maps.grid = grid;
  render_heights(prepared.object, grid, {}, maps.object);
  render_heights(prepared.scene, grid, {}, maps.scene);
}

/// The part of a grid's box with samples above a depth, a cell wider; empty without.
PlaneBox part_above(const PeakMaps& maps, double least) noexcept {
  const MapGrid& grid = maps.grid;
  int left = grid.columns, right = -1, bottom = grid.rows, top = -1;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t i = idx(row * grid.columns + column);
      if (!(static_cast<double>(maps.object.heights[i] + maps.scene.heights[i]) >= least)) continue;
      left = std::min(left, column), right = std::max(right, column);
      bottom = std::min(bottom, row), top = std::max(top, row);
    }
  }
  if (right < 0) return {};
  const PlaneBox part{grid.at(left - 1.5, bottom - 1.5), grid.at(right + 1.5, top + 1.5)};
  return intersection(part, grid.box);
}

double side_of(const PlaneBox& box) noexcept { return (box.high - box.low).maxCoeff(); }

/// A grid over a part, its samples a texel apart or as near as their number allows, as far along
/// one axis as along the other.
MapGrid finest_grid(const PlaneBox& part, double texel) noexcept {
  const Vec2 size = part.high - part.low;
  const double apart = std::max(texel, std::sqrt(size.x() * size.y() / kFinest));
  const auto samples = [&](double side) {
    return std::clamp(static_cast<int>(std::min(side / apart, 1e6)) + 1, kLeast, kFinest / kLeast);
  };
  return {part, samples(size.x()), samples(size.y())};
}

/// Sums with the object moved, and the largest about every sample.
void sum_moved(const Vec2& shift, PeakMaps& maps) noexcept {
  const int columns = maps.grid.columns, rows = maps.grid.rows;
  const std::size_t count = idx(columns * rows);
  const bool is_moved = shift != Vec2::Zero();
  if (is_moved) move_map(maps.object, maps.grid, {Vec2::Zero(), 0.0, shift}, maps.moved);
  const float* const object = (is_moved ? maps.moved : maps.object).heights.data();
  const float* const scene = maps.scene.heights.data();
  maps.sum.resize(count);
  maps.row_most.resize(count);
  maps.most.resize(count);
  float* const sum = maps.sum.data();
  for (std::size_t i = 0; i < count; ++i) sum[i] = object[i] + scene[i];
  const auto larger = [](float a, float b) { return a > b ? a : b; };
  for (int row = 0; row < rows; ++row) {
    const float* const s = sum + row * columns;
    float* const most = maps.row_most.data() + row * columns;
    most[0] = larger(s[0], s[1]);
    most[columns - 1] = larger(s[columns - 2], s[columns - 1]);
    for (int i = 1; i + 1 < columns; ++i) most[i] = larger(larger(s[i - 1], s[i]), s[i + 1]);
  }
  for (int row = 0; row < rows; ++row) {
    const float* const here = maps.row_most.data() + row * columns;
    const float* const below = row > 0 ? here - columns : here;
    const float* const above = row + 1 < rows ? here + columns : here;
    float* const most = maps.most.data() + row * columns;
    for (int i = 0; i < columns; ++i) most[i] = larger(larger(below[i], here[i]), above[i]);
  }
}

/// Blocks of a grid, about square.
struct Blocks {
  int columns = 1, rows = 1;
};

Blocks blocks_of(const MapGrid& grid) noexcept {
  const Vec2 size = grid.box.high - grid.box.low;
  const double share = std::sqrt(kMostBlocks * size.x() / size.y());
  const int columns = std::clamp(static_cast<int>(share + 0.5), 1, kMostBlocks);
  return {std::min(columns, grid.columns), std::min(kMostBlocks / columns, grid.rows)};
}

using BestOfBlocks = std::array<Summit, kMostBlocks>;

/// The best summit of the sums of every block.
BestOfBlocks find_best(const PeakMaps& maps, double least, double turn) noexcept {
  const MapGrid& grid = maps.grid;
  const Blocks blocks = blocks_of(grid);
  const Vec2 middle = 0.5 * (grid.box.low + grid.box.high);
  const float slack = static_cast<float>(turn * grid.spacing().maxCoeff()),
              above = static_cast<float>(least);
  BestOfBlocks best;
  for (int row = 0; row < grid.rows; ++row) {
    const float* const sum = maps.sum.data() + row * grid.columns;
    const float* const most = maps.most.data() + row * grid.columns;
    for (int column = 0; column < grid.columns; ++column) {
      if (!(sum[column] >= above) || sum[column] + slack < most[column]) continue;
      const Vec2 at = grid.at(column, row);
      const double score = static_cast<double>(sum[column]) + turn * (at - middle).norm();
      Summit& of_block = best[idx(row * blocks.rows / grid.rows * blocks.columns +
                                  column * blocks.columns / grid.columns)];
      if (score > of_block.score) of_block = {score, at, Vec2::Zero()};
    }
  }
  return best;
}

/// Depth at the sample nearest to a place, the object where it is.
double depth_near(const PeakMaps& maps, const Vec2& at) noexcept {
  const MapGrid& grid = maps.grid;
  const Vec2 cell = (at - grid.box.low).cwiseQuotient(grid.spacing());
  const int column = std::clamp(static_cast<int>(cell.x()), 0, grid.columns - 1),
            row = std::clamp(static_cast<int>(cell.y()), 0, grid.rows - 1);
  const std::size_t i = idx(row * grid.columns + column);
  return static_cast<double>(maps.object.heights[i] + maps.scene.heights[i]);
}

/// Of what lies nearest in each block after some way, apart from what does now: the one that is
/// farthest now, which the shapes of the others tell least of.
void add_moved(const PeakMaps& maps, const BestOfBlocks& still, const BestOfBlocks& moved,
               BestOfBlocks& least_told) noexcept {
  for (std::size_t i = 0; i < still.size(); ++i) {
    if (moved[i].score == kNoDepth) continue;
    const Vec2 now = moved[i].at - 0.5 * moved[i].shift;
    // A peak that goes along with the object is the same.
    const double apart = moved[i].shift.norm() + 1.5 * maps.grid.spacing().maxCoeff();
    if (still[i].score != kNoDepth && (still[i].at - now).norm() < apart) continue;
    const Summit& known = least_told[i];
    if (known.score == kNoDepth ||
        depth_near(maps, now) < depth_near(maps, known.at - 0.5 * known.shift))
      least_told[i] = moved[i];
  }
}

void add_sorted(const BestOfBlocks& best, std::vector<Summit>& summits) noexcept {
  const auto first = static_cast<std::ptrdiff_t>(summits.size());
  for (const Summit& summit : best)
    if (summit.score != kNoDepth) summits.push_back(summit);
  std::sort(summits.begin() + first, summits.end(), [](const Summit& a, const Summit& b) {
    if (a.score != b.score) return a.score > b.score;
    return a.at.y() != b.at.y() ? a.at.y() < b.at.y() : a.at.x() < b.at.x();
  });
}

}  // namespace

void reserve_maps(PeakMaps& maps) {
  // As many samples each way as fit, and one.
  constexpr std::size_t kMost = idx(kFinest + kFinest / kLeast + kLeast + 1 + 2 * 96);
  for (HeightMap* const map : {&maps.object, &maps.scene, &maps.moved}) map->heights.reserve(kMost);
  for (std::vector<float>* const list : {&maps.sum, &maps.row_most, &maps.most})
    list->reserve(kMost);
}

bool look_for_peaks(const PreparedContact& prepared, double least, PeakMaps& maps,
                    bool& is_found) noexcept {
  const double unseen =
      2.0 * (prepared.object.texture->amplitude + prepared.scene.texture->amplitude);
  PlaneBox part = prepared.box;
  for (int k = 0; k < kLooks; ++k) {
    render(prepared, {part, kLook, kLook}, maps);
    is_found = is_found || largest_sum(maps.object, maps.scene).column >= 0;
    const PlaneBox next = part_above(maps, least - unseen);
    if (next.is_empty()) return false;
    const bool is_enough = side_of(next) > 0.7 * side_of(part);
    part = next;
    if (is_enough || side_of(part) <= kLook * prepared.texel) break;
  }
  const double texel = prepared.texel > 0.0 ? prepared.texel : side_of(part) / kLook;
  render(prepared, finest_grid(part, texel), maps);
  return true;
}

void find_summits(const SummitWish& wish, PeakMaps& maps, std::vector<Summit>& summits) noexcept {
  constexpr std::array<std::array<double, 2>, 4> kWays = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  constexpr double kSlant = 1.4142135623730951;  // so far, ways between the axes count as well
  summits.clear();
  sum_moved(Vec2::Zero(), maps);
  const BestOfBlocks still = find_best(maps, wish.least, wish.turn);
  add_sorted(still, summits);
  if (!(wish.way > 0.0)) return;
  BestOfBlocks least_told;
  for (const auto& way : kWays) {
    const Vec2 shift = kSlant * wish.way * Vec2(way[0], way[1]);
    sum_moved(shift, maps);
    BestOfBlocks moved = find_best(maps, wish.least_moved, wish.turn);
    for (Summit& summit : moved) summit.shift = shift;
    add_moved(maps, still, moved, least_told);
  }
  add_sorted(least_told, summits);
}

}  // namespace thigma::detail
