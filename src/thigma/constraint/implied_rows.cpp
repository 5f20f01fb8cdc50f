#include "thigma/constraint/implied_rows.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

// Of an angle of less than a right one over its chord.
constexpr double kChord = 1.1;

using Six = std::array<double, 6>;

double dot(const Six& a, const Six& b) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k) sum += a[k] * b[k];
  return sum;
}

Six minus(const Six& a, const Six& b) noexcept {
  Six c;
  for (std::size_t k = 0; k < 6; ++k) c[k] = a[k] - b[k];
  return c;
}

/// Square of what is left of a gradient: its travel at most.
double square(const Six& r) noexcept {
  return std::max(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], r[3] * r[3] + r[4] * r[4] + r[5] * r[5]);
}

RowGradient gradient_of(const FoundRow& found, const BodyState& state, const Mat3& rotation,
                        const RowBounds& bounds) noexcept {
  const RowAtState at = row_at(found.row, state.position, rotation);
  const Vec3 moment = kChord / bounds.reach * at.arm.cross(at.normal);
  RowGradient row;
  row.arm = at.arm;
  row.g = {at.normal.x(), at.normal.y(), at.normal.z(), moment.x(), moment.y(), moment.z()};
  row.gap = at.gap;
  row.cost = std::max(at.gap - bounds.margin, 0.0);
  row.id = found.row.id;
  row.kind = found.row.kind;
  return row;
}

/// The rows nearest to one by their gradients.
struct Neighbours {
  static constexpr int kMost = 8;
  std::array<const RowGradient*, kMost> row{};
  std::array<double, kMost> far{};
  int count = 0;

  void add(const RowGradient& candidate, double distance) noexcept {
    if (count == kMost && distance >= far[kMost - 1]) return;
    int at = count < kMost ? count++ : kMost - 1;
    for (; at > 0 && far[idx(at - 1)] > distance; --at) {
      far[idx(at)] = far[idx(at - 1)];
      row[idx(at)] = row[idx(at - 1)];
    }
    far[idx(at)] = distance;
    row[idx(at)] = &candidate;
  }
};

/// A combination of rows, lambda >= 0.
struct Combination {
  std::array<double, Neighbours::kMost> lambda{};
  Six left{};  // of the gradient
};

/// Whether a combination implies a row.
bool implies(const RowGradient& row, const Neighbours& near, const Combination& c,
             const RowBounds& bounds) noexcept {
  double cost = 0.0, apart = 0.0;
  for (int i = 0; i < near.count; ++i) {
    const double lambda = c.lambda[idx(i)];
    if (!(lambda > 0.0)) continue;
    const RowGradient& other = *near.row[idx(i)];
    cost += lambda * other.cost;
    apart += lambda * (row.arm - other.arm).norm();
  }
  const double turn = kChord * bounds.travel / bounds.reach;
  const double rest = std::sqrt(square(c.left));
  const double bend = 0.5 * turn * turn * (rest * row.arm.norm() + apart);
  return row.gap - cost >= rest * bounds.travel + bend;
}

/// Moves weight from the row that serves least to the one that serves most.
bool improve(const Neighbours& near, double travel, Combination& c) noexcept {
  const double size = std::sqrt(square(c.left));
  const auto serves = [&](int i) {
    return dot(c.left, near.row[idx(i)]->g) - size / travel * near.row[idx(i)]->cost;
  };
  int best = 0, worst = -1;
  double most = -1.0, least = 0.0;
  for (int i = 0; i < near.count; ++i) {
    const double value = serves(i);
    if (i == 0 || value > most) {
      most = value;
      best = i;
    }
    if (c.lambda[idx(i)] > 0.0 && (worst < 0 || value < least)) {
      least = value;
      worst = i;
    }
  }
  const Six along = minus(near.row[idx(best)]->g, near.row[idx(worst)]->g);
  const double length = dot(along, along);
  if (!(most > least) || !(length > 0.0)) return false;
  const double step = std::min((most - least) / length, c.lambda[idx(worst)]);
  c.lambda[idx(best)] += step;
  c.lambda[idx(worst)] -= step;
  for (std::size_t k = 0; k < 6; ++k) c.left[k] -= step * along[k];
  return true;
}

bool is_implied(const RowGradient& row, std::span<const RowGradient> kept,
                const RowBounds& bounds) noexcept {
  Neighbours near;
  for (const RowGradient& other : kept) near.add(other, square(minus(row.g, other.g)));
  if (near.count == 0) return false;
  Combination c;
  c.lambda[0] = 1.0;
  c.left = minus(row.g, near.row[0]->g);
  constexpr int kTurns = 12;
  for (int turn = 0; turn < kTurns; ++turn) {
    if (implies(row, near, c, bounds)) return true;
    if (!improve(near, bounds.travel, c)) return false;
  }
  return implies(row, near, c, bounds);
}

}  // namespace

void reserve_implied(ImpliedScratch& scratch, std::size_t rows) {
  scratch.all.reserve(rows);
  for (auto& kept : scratch.kept) kept.reserve(kMaxRows + 1);
  scratch.needed.reserve(kMaxRows + 1);
}

std::span<const std::int32_t> needed_rows(std::span<const FoundRow> rows, const BodyState& state,
                                          const RowBounds& bounds, std::size_t most,
                                          ImpliedScratch& scratch) noexcept {
  auto& all = scratch.all;
  all.clear();
  const Mat3 rotation = rotation_matrix(state.orientation);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    all.push_back(gradient_of(rows[i], state, rotation, bounds));
    all.back().row = static_cast<std::int32_t>(i);
  }
  std::sort(all.begin(), all.end(), [](const RowGradient& a, const RowGradient& b) {
    return std::tie(a.gap, a.id, a.row) < std::tie(b.gap, b.id, b.row);
  });
  return needed_again(bounds, most, scratch);
}

std::span<const std::int32_t> needed_again(const RowBounds& bounds, std::size_t most,
                                           ImpliedScratch& scratch) noexcept {
  for (auto& kept : scratch.kept) kept.clear();
  scratch.needed.clear();
  for (const RowGradient& row : scratch.all) {
    if (scratch.needed.size() > most) break;
    if (row.kind == RowKind::scene_plane || row.kind == RowKind::object_plane) {
      auto& kept = scratch.kept[row.kind == RowKind::scene_plane ? 0 : 1];
      if (row.gap > bounds.margin && is_implied(row, kept, bounds)) continue;
      kept.push_back(row);
    }
    scratch.needed.push_back(row.row);
  }
  return scratch.needed;
}

}  // namespace thigma
