#pragma once
// Which rows a body needs: those that the others do not imply, wherever it may go.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/constraint/feature_rows.h"
#include "thigma/dynamics/body.h"

namespace thigma {

/// How far a body may go, and how well rows keep their gaps.
struct RowBounds {
  double travel = 0.0;  // no point of the object moves farther, > 0 [m]
  double reach = 0.0;   // of the object's farthest point from its centre of mass, > 0 [m]
  // Rows that are kept stay at least this far apart, or as far as they were; rows that are left out
  // never meet [m].
  double margin = 0.0;
};

/// A row as a linear function of the body's displacement: of the centre of mass, and the rotation
/// vector times the reach.
struct RowGradient {
  Vec3 arm = Vec3::Zero();    // from the centre of mass [m; world]
  std::array<double, 6> g{};  // normal, and what turning makes of the travel
  double gap = 0.0;           // [m]
  double cost = 0.0;          // of the gap, what the row may lose [m]
  std::uint64_t id = 0;
  std::int32_t row = -1;  // of the list
  RowKind kind = RowKind::edges;
};

/// Working memory of needed_rows: grows while warming up, never after.
struct ImpliedScratch {
  std::vector<RowGradient> all;
  std::array<std::vector<RowGradient>, 2> kept;  // planes of the scene, and of the object
  std::vector<std::int32_t> needed;              // result
};

/// Room for so many rows. Thread [offline]; throws std::bad_alloc.
void reserve_implied(ImpliedScratch& scratch, std::size_t rows);

/// The rows that have to be kept, nearest first, as indices of the list.
///
/// rows     of one state of the body; object points and directions in the frame of the body
/// state    of the body
/// bounds   how far the body may go
/// most     stops when there are more
/// returns  valid until the next call; one more than `most`: not all have been looked at
/// Thread   [contact]; no failure
/// Source   Farkas: gradient_j = sum lambda_i gradient_i with lambda >= 0 gives
///          gap_j >= gap_j0 - sum lambda_i (gap_i0 - gap_i). What is left of the gradient, times
///          the travel, and what turning adds in second order, have to be less than that. Edges
///          and relief are not compared: their normals turn.
std::span<const std::int32_t> needed_rows(std::span<const FoundRow> rows, const BodyState& state,
                                          const RowBounds& bounds, std::size_t most,
                                          ImpliedScratch& scratch) noexcept;

/// The same of the rows of the last call of needed_rows, for another travel: their gradients and
/// their order stay.
/// Thread   [contact]; no failure
std::span<const std::int32_t> needed_again(const RowBounds& bounds, std::size_t most,
                                           ImpliedScratch& scratch) noexcept;

}  // namespace thigma
