#include "thigma/multibody/detail/row_cut.h"

#include <algorithm>

#include "thigma/core/index.h"
#include "thigma/multibody/detail/row_speed.h"

namespace thigma::detail {
namespace {

constexpr int kRounds = 12;  // solves of an island, at most
// Pairs of which so many pressed begin with these; others get more, as friction of few places
// settles badly.
constexpr int kEnough = 20;
constexpr int kAdded = 6;  // rows of a pair in a round, at most

/// An island whose rows are cut.
struct Cutting {
  std::span<IslandBody> bodies;
  std::span<IslandRow> rows;
  RowCut& cut;
  double enough = 0.0;  // less than this is no violation [m/s]
};

void list_pairs(std::span<const RowSource> sources, RowCut& cut) {
  cut.pairs.clear();
  for (std::size_t r = 0; r < sources.size(); ++r) {
    if (r == 0 || sources[r].pair != sources[r - 1].pair)
      cut.pairs.push_back({static_cast<std::int32_t>(r), 0, 0});
    ++cut.pairs.back().rows;
  }
}

/// Normal speed of a row beyond its limit [m/s].
double violation_of(const Cutting& c, const IslandRow& row, Vec6 IslandBody::*u) noexcept {
  const auto of = [&](std::int32_t body) { return body < 0 ? nullptr : &(c.bodies[idx(body)].*u); };
  return normal_speed(row, of(row.a), of(row.b)) - row.limit;
}

/// Squared distance of two rows of a pair by their gradients, arms over a length.
double apart(const IslandRow& x, const IslandRow& y, double length) noexcept {
  const bool has_a = x.a >= 0;
  const Vec3 mx = (has_a ? x.arm_a : x.arm_b).cross(x.normal);
  const Vec3 my = (has_a ? y.arm_a : y.arm_b).cross(y.normal);
  return (x.normal - y.normal).squaredNorm() + (mx - my).squaredNorm() / (length * length);
}

void hand_over(RowCut& cut, RowCut::Pair& pair, std::int32_t row) noexcept {
  if (cut.is_handed[idx(row)] != 0) return;
  cut.is_handed[idx(row)] = 1;
  ++pair.handed;
}

/// Takes back rows that do not press, where others need their room; the weakest one if all press.
void make_room(const Cutting& c, RowCut::Pair& pair) noexcept {
  std::int32_t weakest = -1;
  double least = 0.0;
  for (std::int32_t r = pair.first; r < pair.first + pair.rows; ++r) {
    if (c.cut.is_handed[idx(r)] == 0) continue;
    const double impulse = c.rows[idx(r)].impulse.x();
    if (weakest < 0 || impulse < least) {
      weakest = r;
      least = impulse;
    }
    if (impulse > 0.0) continue;
    c.cut.is_handed[idx(r)] = 0;
    --pair.handed;
  }
  if (pair.handed < kMostHanded) return;
  c.cut.is_handed[idx(weakest)] = 0;
  c.rows[idx(weakest)].impulse = Vec3::Zero();
  --pair.handed;
}

/// Rows of a pair that velocities violate and the solver has not got; the largest violation.
double list_violated(const Cutting& c, const RowCut::Pair& pair, Vec6 IslandBody::*u) {
  c.cut.candidates.clear();
  double most = 0.0;
  for (std::int32_t r = pair.first; r < pair.first + pair.rows; ++r) {
    if (c.cut.is_handed[idx(r)] != 0) continue;
    const double speed = violation_of(c, c.rows[idx(r)], u);
    most = std::max(most, speed);
    if (!(speed > c.enough)) continue;
    c.cut.candidates.push_back({r, speed, kInfinity});
  }
  return most;
}

/// Hands over the most violated row, then those that are violated and unlike what is handed over.
void add_candidates(const Cutting& c, RowCut::Pair& pair) noexcept {
  double length = 0.0;
  for (const RowCut::Candidate& candidate : c.cut.candidates) {
    const IslandRow& row = c.rows[idx(candidate.row)];
    length = std::max(length, (row.a >= 0 ? row.arm_a : row.arm_b).norm());
  }
  if (!(length > 0.0)) length = 1.0;
  const auto keep_apart = [&](std::int32_t from) {
    for (RowCut::Candidate& candidate : c.cut.candidates)
      candidate.apart =
          std::min(candidate.apart, apart(c.rows[idx(from)], c.rows[idx(candidate.row)], length));
  };
  for (std::int32_t r = pair.first; r < pair.first + pair.rows; ++r)
    if (c.cut.is_handed[idx(r)] != 0) keep_apart(r);
  for (int added = 0; added < kAdded; ++added) {
    const RowCut::Candidate* best = nullptr;
    double most = 0.0;
    for (const RowCut::Candidate& candidate : c.cut.candidates) {
      if (c.cut.is_handed[idx(candidate.row)] != 0) continue;
      const double value = added == 0 ? candidate.speed : candidate.speed * candidate.apart;
      if (best != nullptr && !(value > most)) continue;
      best = &candidate;
      most = value;
    }
    if (best == nullptr || !(most > 0.0)) return;
    if (pair.handed >= kMostHanded) {
      if (added > 0) return;
      make_room(c, pair);
    }
    hand_over(c.cut, pair, best->row);
    keep_apart(best->row);
  }
}

/// The largest violation of a row that the solver has not got [m/s]; where `adds`, violated rows of
/// all pairs are handed over.
double find_violated(const Cutting& c, bool adds) {
  double most = 0.0;
  for (RowCut::Pair& pair : c.cut.pairs) {
    if (pair.handed == pair.rows) continue;
    most = std::max(most, list_violated(c, pair, &IslandBody::velocity));
    if (adds && !c.cut.candidates.empty()) add_candidates(c, pair);
  }
  return most;
}

/// The first rows of pairs of which little pressed before: that the free velocities violate.
void begin_unknown(const Cutting& c) {
  for (RowCut::Pair& pair : c.cut.pairs) {
    if (pair.handed > kEnough) continue;
    list_violated(c, pair, &IslandBody::free);
    if (!c.cut.candidates.empty()) add_candidates(c, pair);
  }
}

/// Whole pairs, and what pressed before.
void begin(const Cutting& c) noexcept {
  for (RowCut::Pair& pair : c.cut.pairs) {
    const bool is_whole = pair.rows <= kWholePair;
    for (std::int32_t r = pair.first; r < pair.first + pair.rows; ++r) {
      IslandRow& row = c.rows[idx(r)];
      if (is_whole || (row.impulse.x() > 0.0 && pair.handed < kMostHanded))
        hand_over(c.cut, pair, r);
      else
        row.impulse = Vec3::Zero();
    }
  }
}

/// The scale of an island's speeds, as solve_island has it [m/s].
double scale_of(const Cutting& c) noexcept {
  double most = 0.0;
  for (const IslandBody& body : c.bodies) most = std::max(most, free_speed(body));
  for (const IslandRow& row : c.rows) most = std::max(most, -row.limit);
  return most;
}

/// One solve of the rows handed over; their impulses.
IslandSolution solve_handed(const Cutting& c, std::span<JointRow> joints, IslandScratch& scratch) {
  RowCut& cut = c.cut;
  cut.rows.clear();
  for (std::size_t r = 0; r < c.rows.size(); ++r)
    if (cut.is_handed[r] != 0) cut.rows.push_back(c.rows[r]);
  const IslandSolution solution = solve_island(c.bodies, cut.rows, joints, scratch);
  std::size_t next = 0;
  for (std::size_t r = 0; r < c.rows.size(); ++r)
    if (cut.is_handed[r] != 0) c.rows[r].impulse = cut.rows[next++].impulse;
  return solution;
}

}  // namespace

void reserve_cut(std::size_t pairs, std::size_t rows, RowCut& cut) {
  cut.pairs.reserve(pairs);
  cut.is_handed.reserve(rows);
  cut.rows.reserve(pairs * idx(kMostHanded));
  cut.candidates.reserve(kMaxRows);
}

CutSolution solve_cut(std::span<IslandBody> bodies, std::span<IslandRow> rows,
                      std::span<const RowSource> sources, std::span<JointRow> joints, RowCut& cut,
                      IslandScratch& scratch) {
  CutSolution result;
  list_pairs(sources, cut);
  std::int32_t most = 0;
  for (const RowCut::Pair& pair : cut.pairs) most = std::max(most, pair.rows);
  if (most <= kWholePair) {
    result.solution = solve_island(bodies, rows, joints, scratch);
    result.rounds = 1;
    result.most_handed = most;
    result.handed = static_cast<std::int64_t>(rows.size());
    return result;
  }
  Cutting c{bodies, rows, cut};
  c.enough = kRowsMet * scale_of(c);
  cut.is_handed.assign(rows.size(), 0);
  begin(c);
  begin_unknown(c);
  std::int32_t newton = 0;
  for (double violated = kInfinity; violated > c.enough && result.rounds < kRounds;) {
    result.solution = solve_handed(c, joints, scratch);
    ++result.rounds;
    newton += result.solution.newton;
    result.handed += static_cast<std::int64_t>(cut.rows.size());
    for (const RowCut::Pair& pair : cut.pairs)
      result.most_handed = std::max(result.most_handed, pair.handed);
    violated = find_violated(c, result.rounds < kRounds);
    result.solution.residual = std::max(result.solution.residual, violated);
  }
  result.solution.newton = newton;
  return result;
}

}  // namespace thigma::detail
