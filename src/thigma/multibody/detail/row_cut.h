#pragma once
// Which of an island's rows its solver gets: where surfaces fit each other hundreds of rows are
// near and a few press.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/multibody/detail/islands.h"
#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// Pairs with at most so many rows hand over all of them.
inline constexpr std::int32_t kWholePair = 16;
/// Rows that a pair with more hands to a solve, at most.
inline constexpr std::int32_t kMostHanded = 32;

/// Working memory: grows while warming up, never after.
struct RowCut {
  struct Pair {  // a range of the island's rows
    std::int32_t first = 0, rows = 0, handed = 0;
  };
  struct Candidate {  // a row that a solution violates
    std::int32_t row = -1;
    double speed = 0.0;  // by so much [m/s]
    double apart = 0.0;  // of the rows that are handed over, a squared distance of gradients
  };
  std::vector<Pair> pairs;
  std::vector<std::uint8_t> is_handed;  // by row of the island
  std::vector<IslandRow> rows;          // those that are
  std::vector<Candidate> candidates;
};

/// What a cut solve did.
struct CutSolution {
  IslandSolution solution;       // the last solve's; newton of all, residual of all rows
  std::int32_t rounds = 0;       // solves
  std::int32_t most_handed = 0;  // rows of a pair in a solve
  std::int64_t handed = 0;       // rows of all solves
};

/// Room for so many rows of an island. Thread [offline]; throws std::bad_alloc.
void reserve_cut(std::size_t pairs, std::size_t rows, RowCut& cut);

/// solve_island for islands of many rows: of each pair with more than kWholePair rows the solver
/// gets those that pressed before and some that the free velocities violate, then, as long as its
/// solution violates others, the most violated of these that are unlike each other. Rows that are
/// left out have no impulse.
///
/// sources  of the rows: those of a pair stand together
/// returns  a solution of all rows, unless `residual` is large: then rows that were left out are
///          violated after the last round, and the step has to be made shorter
/// Thread   [contact]; throws std::bad_alloc where memory grows. The same bits for the same input
/// Source   cutting planes (Kelley 1960): where all rows hold, what solves the problem of some of
///          them solves that of all
CutSolution solve_cut(std::span<IslandBody> bodies, std::span<IslandRow> rows,
                      std::span<const RowSource> sources, std::span<JointRow> joints, RowCut& cut,
                      IslandScratch& scratch);

}  // namespace thigma::detail
