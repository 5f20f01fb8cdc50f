#pragma once
// Bodies that touch, directly or through others, and the rows between them, island by island.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/multibody/detail/pair_models.h"
#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// Where a row comes from.
struct RowSource {
  std::int32_t pair = -1, row = -1;  // into PairModels::near and its model
  double room = 0.0;                 // gap less the stand-off, at least 0 [m]
  double gap = 0.0;                  // before the step [m]
  double lead = 0.0;                 // speed at which it is led apart, else 0 [m/s]
};

/// Ranges of one island in the lists of all.
struct Island {
  std::int32_t first_body = 0, bodies = 0, first_row = 0, rows = 0, first_joint = 0, joints = 0;
  double share = 1.0;  // with joints: of what acts through a part in the velocities that move it
};

/// All islands of a step: grows while warming up, never after.
struct Islands {
  std::vector<Island> islands;
  std::vector<std::int32_t> body;   // by place: the body of the world
  std::vector<std::int32_t> place;  // by body: its place, or -1: it does not move in this step
  std::vector<IslandBody> bodies;   // by place
  std::vector<IslandRow> rows;      // `a` and `b` are places within their island
  std::vector<RowSource> sources;   // of the rows
  std::vector<std::int32_t> joint;  // joints of the world, island by island
  // of the search
  std::vector<std::int32_t> first_neighbour, neighbour, queue;
  std::vector<std::uint8_t> is_seen;
};

/// Finds the islands of the bodies that move, with their joints: breadth first from the body with
/// the fewest neighbours, so that bodies that touch have near places.
void find_islands(std::span<const std::uint8_t> moves, std::span<NearPair* const> near,
                  std::span<const WorldJoint> joints, Islands& islands);

/// Fills the rows of all islands at the states given.
///
/// dt   length of the step [s]
void fill_rows(const World& world, std::span<const BodyState> states,
               std::span<NearPair* const> near, double dt, Islands& islands);

/// Speed at which a gap may close in a step, or has to open. From the stand-off down to an eighth
/// of it a gap stays; what is nearer is led apart slowly [m/s].
double limit_of(double gap, double slop, double dt) noexcept;

}  // namespace thigma::detail
