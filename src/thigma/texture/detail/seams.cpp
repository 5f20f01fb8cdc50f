#include "thigma/texture/detail/seams.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/mesh/topology.h"

namespace thigma::detail {
namespace {

/// Four texels around a place of the map and their shares in what is interpolated there.
struct Cell {
  std::array<std::size_t, 4> texel{};
  std::array<double, 4> share{};
};

Cell cell_at(const Vec2& place, int width, int height) {
  const double x = std::clamp(place.x(), 0.0, width - 1.0),
               y = std::clamp(place.y(), 0.0, height - 1.0);
  const int column = std::min(static_cast<int>(x), width - 2),
            row = std::min(static_cast<int>(y), height - 2);
  const double u = x - column, v = y - row;
  const auto index = [&](int c, int r) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(c);
  };
  return {{index(column, row), index(column + 1, row), index(column, row + 1),
           index(column + 1, row + 1)},
          {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v}};
}

Vec3 value_of(const Cell& cell, const std::vector<Vec3>& texels) {
  Vec3 value = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) value += cell.share[k] * texels[cell.texel[k]];
  return value;
}

/// The same point of a seam, seen from either side.
struct Meeting {
  std::array<Cell, 2> side;
  double weight = 0.0;  // sum of all squared shares times the ease of their texels
};

std::vector<Meeting> meetings_of(std::span<const Seam> seams,
                                 std::span<const std::array<Vec2, 3>> corners,
                                 const StitchedMap& map) {
  // a texel along the seam: what is interpolated is a parabola between the lines of texels
  constexpr double kEach = 3.0;
  std::vector<Meeting> meetings;
  for (const Seam& seam : seams) {
    const auto end = [&](const Seam::Side& side, std::size_t k) {
      return corners[idx(side.triangle)][static_cast<std::size_t>(side.corner[k])];
    };
    double length = 0.0;
    for (const Seam::Side& side : seam.sides)
      length = std::max(length, (end(side, 1) - end(side, 0)).norm());
    const int count = static_cast<int>(std::ceil(kEach * length)) + 1;
    for (int i = 0; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      Meeting meeting;
      for (std::size_t s = 0; s < 2; ++s) {
        const Seam::Side& side = seam.sides[s];
        const Cell cell =
            cell_at((1.0 - share) * end(side, 0) + share * end(side, 1), map.width, map.height);
        for (std::size_t k = 0; k < 4; ++k)
          meeting.weight += map.ease[cell.texel[k]] * cell.share[k] * cell.share[k];
        meeting.side[s] = cell;
      }
      meetings.push_back(meeting);
    }
  }
  return meetings;
}

}  // namespace

std::vector<Seam> find_seams(const TriangleMesh& coarse,
                             std::span<const std::array<Vec2, 3>> corners) {
  const EdgeTable table = build_edge_table(coarse);
  std::vector<Seam> seams;
  for (const MeshEdge& edge : table.edges) {
    if (edge.use_count != 2) continue;
    Seam seam;
    for (std::size_t s = 0; s < 2; ++s) {
      const EdgeUse& use = table.uses_of(edge)[s];
      const int own = use.corner, next = (use.corner + 1) % 3;
      seam.sides[s] = {use.triangle,
                       use.is_forward ? std::array{own, next} : std::array{next, own}};
    }
    const auto place = [&](std::size_t s, std::size_t k) {
      const Seam::Side& side = seam.sides[s];
      return corners[idx(side.triangle)][static_cast<std::size_t>(side.corner[k])];
    };
    if (place(0, 0) != place(1, 0) || place(0, 1) != place(1, 1)) seams.push_back(seam);
  }
  return seams;
}

Vec3 seam_weights(const Seam::Side& side, double share) noexcept {
  Vec3 weights = Vec3::Zero();
  weights[side.corner[0]] = 1.0 - share;
  weights[side.corner[1]] = share;
  return weights;
}

void stitch_seams(std::span<const Seam> seams, std::span<const std::array<Vec2, 3>> corners,
                  StitchedMap& map) {
  constexpr int kSweeps = 200;
  const std::vector<Meeting> meetings = meetings_of(seams, corners, map);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const Meeting& m : meetings) {
      const Vec3 step =
          (value_of(m.side[0], map.texels) - value_of(m.side[1], map.texels)) / m.weight;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t i = m.side[0].texel[k], j = m.side[1].texel[k];
        map.texels[i] -= map.ease[i] * m.side[0].share[k] * step;
        map.texels[j] += map.ease[j] * m.side[1].share[k] * step;
      }
    }
  }
}

}  // namespace thigma::detail
