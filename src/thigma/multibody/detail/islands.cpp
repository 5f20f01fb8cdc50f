#include "thigma/multibody/detail/islands.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/row_rules.h"

namespace thigma::detail {
namespace {

bool is_between(std::span<const std::uint8_t> moves, const NearPair& pair) noexcept {
  return moves[idx(pair.first)] != 0 && moves[idx(pair.second)] != 0 && !pair.model.rows.empty();
}

/// Whether a joint is between two bodies that move.
bool is_between(std::span<const std::uint8_t> moves, const WorldJoint& joint) noexcept {
  return joint.b >= 0 && moves[idx(joint.a)] != 0 && moves[idx(joint.b)] != 0;
}

void list_neighbours(std::span<const std::uint8_t> moves, std::span<NearPair* const> near,
                     std::span<const WorldJoint> joints, Islands& s) {
  const std::size_t count = moves.size();
  s.first_neighbour.assign(count + 1, 0);
  for (const NearPair* pair : near) {
    if (!is_between(moves, *pair)) continue;
    ++s.first_neighbour[idx(pair->first) + 1];
    ++s.first_neighbour[idx(pair->second) + 1];
  }
  for (const WorldJoint& joint : joints) {
    if (!is_between(moves, joint)) continue;
    ++s.first_neighbour[idx(joint.a) + 1];
    ++s.first_neighbour[idx(joint.b) + 1];
  }
  for (std::size_t i = 0; i < count; ++i) s.first_neighbour[i + 1] += s.first_neighbour[i];
  s.neighbour.resize(idx(s.first_neighbour[count]));
  s.queue.assign(s.first_neighbour.begin(), s.first_neighbour.end() - 1);
  for (const NearPair* pair : near) {  // sorted, so that each list is
    if (!is_between(moves, *pair)) continue;
    s.neighbour[idx(s.queue[idx(pair->first)]++)] = pair->second;
    s.neighbour[idx(s.queue[idx(pair->second)]++)] = pair->first;
  }
  for (const WorldJoint& joint : joints) {
    if (!is_between(moves, joint)) continue;
    s.neighbour[idx(s.queue[idx(joint.a)]++)] = joint.b;
    s.neighbour[idx(s.queue[idx(joint.b)]++)] = joint.a;
  }
}

/// The body of fewest neighbours among all that a search from one reaches.
std::int32_t loneliest_near(std::int32_t from, Islands& s) noexcept {
  const auto degree = [&](std::int32_t b) {
    return s.first_neighbour[idx(b) + 1] - s.first_neighbour[idx(b)];
  };
  s.queue.clear();
  s.queue.push_back(from);
  s.is_seen[idx(from)] = 1;
  std::int32_t best = from;
  for (std::size_t next = 0; next < s.queue.size(); ++next) {
    const std::int32_t body = s.queue[next];
    if (degree(body) < degree(best)) best = body;
    for (std::int32_t k = s.first_neighbour[idx(body)]; k < s.first_neighbour[idx(body) + 1]; ++k) {
      const std::int32_t other = s.neighbour[idx(k)];
      if (s.is_seen[idx(other)] != 0) continue;
      s.is_seen[idx(other)] = 1;
      s.queue.push_back(other);
    }
  }
  for (const std::int32_t body : s.queue) s.is_seen[idx(body)] = 0;
  return best;
}

void gather_island(std::int32_t from, Islands& s) {
  Island island;
  island.first_body = static_cast<std::int32_t>(s.body.size());
  s.body.push_back(from);
  s.is_seen[idx(from)] = 1;
  for (std::size_t next = idx(island.first_body); next < s.body.size(); ++next) {
    const std::int32_t body = s.body[next];
    s.place[idx(body)] = static_cast<std::int32_t>(next);
    for (std::int32_t k = s.first_neighbour[idx(body)]; k < s.first_neighbour[idx(body) + 1]; ++k) {
      const std::int32_t other = s.neighbour[idx(k)];
      if (s.is_seen[idx(other)] != 0) continue;
      s.is_seen[idx(other)] = 1;
      s.body.push_back(other);
    }
  }
  island.bodies = static_cast<std::int32_t>(s.body.size()) - island.first_body;
  s.islands.push_back(island);
}

std::int32_t island_of_place(const Islands& s, std::int32_t place) noexcept {
  const auto after =
      std::upper_bound(s.islands.begin(), s.islands.end(), place,
                       [](std::int32_t p, const Island& island) { return p < island.first_body; });
  return static_cast<std::int32_t>(after - s.islands.begin()) - 1;
}

/// The pair's island: of whichever body moves.
std::int32_t island_of(const Islands& s, const NearPair& pair) noexcept {
  const std::int32_t first = s.place[idx(pair.first)], second = s.place[idx(pair.second)];
  if (first < 0 && second < 0) return -1;
  return island_of_place(s, first >= 0 ? first : second);
}

/// Joints in the order of their islands.
void list_joints(std::span<const WorldJoint> joints, Islands& s) {
  s.joint.clear();
  if (joints.empty()) return;
  const auto island_of_joint = [&](std::int32_t number) {
    const WorldJoint& joint = joints[idx(number)];
    const std::int32_t a = s.place[idx(joint.a)], b = joint.b < 0 ? -1 : s.place[idx(joint.b)];
    return a < 0 && b < 0 ? -1 : island_of_place(s, a >= 0 ? a : b);
  };
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (island_of_joint(static_cast<std::int32_t>(i)) >= 0)
      s.joint.push_back(static_cast<std::int32_t>(i));
  std::sort(s.joint.begin(), s.joint.end(), [&](std::int32_t x, std::int32_t y) {
    const std::int32_t ix = island_of_joint(x), iy = island_of_joint(y);
    return ix != iy ? ix < iy : x < y;
  });
  std::int32_t next = 0;
  for (std::size_t k = 0; k < s.islands.size(); ++k) {
    s.islands[k].first_joint = next;
    while (next < static_cast<std::int32_t>(s.joint.size()) &&
           island_of_joint(s.joint[idx(next)]) == static_cast<std::int32_t>(k))
      ++next;
    s.islands[k].joints = next - s.islands[k].first_joint;
  }
}

/// Rows of one pair, appended.
void append_rows(const World& world, std::span<const BodyState> states, const NearPair& pair,
                 std::int32_t number, double dt, const Island& island, Islands& s) {
  const BodyState &first = states[idx(pair.first)], &second = states[idx(pair.second)];
  const BodyState relative = relative_state(first, second);
  const Mat3 turn = rotation_matrix(relative.orientation);
  const Mat3 world_from_second = rotation_matrix(second.orientation);
  const double slop = pair_kind(world, pair.kind).constraints.slop;
  const auto local = [&](std::int32_t body) {
    const std::int32_t place = s.place[idx(body)];
    return place < 0 ? -1 : place - island.first_body;
  };
  for (std::size_t i = 0; i < pair.model.rows.size(); ++i) {
    const ContactRow& model = pair.model.rows[i];
    const RowAtState at = row_at(model, relative.position, turn);
    if (!std::isfinite(at.gap)) continue;
    IslandRow row;
    row.a = local(pair.first);
    row.b = local(pair.second);
    place_row(at, world_from_second, relative.position, row);
    row.limit = limit_of(at.gap, slop, dt);
    const RowHistory& last = pair.history[i];
    row.friction = last.is_sliding ? model.friction.kinetic : model.friction.at_rest;
    row.impulse = last.impulse;
    s.rows.push_back(row);
    s.sources.push_back({number, static_cast<std::int32_t>(i), std::max(at.gap - slop, 0.0), at.gap,
                         std::max(-row.limit, 0.0)});
  }
}

}  // namespace

double limit_of(double gap, double slop, double dt) noexcept {
  constexpr double kLeast = 0.125;   // of the stand-off: nearer is too near
  constexpr double kRecovery = 0.2;  // of what is missing, in a step
  constexpr double kSpeed = 1000.0;  // of the stand-off, in a second, at most
  if (gap >= slop) return (gap - slop) / dt;
  if (gap >= kLeast * slop) return 0.0;
  return -std::min(kRecovery * (kLeast * slop - gap) / dt, kSpeed * slop);
}

void find_islands(std::span<const std::uint8_t> moves, std::span<NearPair* const> near,
                  std::span<const WorldJoint> joints, Islands& s) {
  s.islands.clear();
  s.body.clear();
  s.place.assign(moves.size(), -1);
  s.is_seen.assign(moves.size(), 0);
  list_neighbours(moves, near, joints, s);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i] == 0 || s.place[i] >= 0) continue;
    gather_island(loneliest_near(static_cast<std::int32_t>(i), s), s);
  }
  list_joints(joints, s);
}

void fill_rows(const World& world, std::span<const BodyState> states,
               std::span<NearPair* const> near, double dt, Islands& s) {
  s.rows.clear();
  s.sources.clear();
  // Pairs in the order of their islands: those of an island one after the other, else by number.
  s.queue.clear();
  for (std::size_t i = 0; i < near.size(); ++i)
    if (island_of(s, *near[i]) >= 0) s.queue.push_back(static_cast<std::int32_t>(i));
  std::sort(s.queue.begin(), s.queue.end(), [&](std::int32_t x, std::int32_t y) {
    const std::int32_t ix = island_of(s, *near[idx(x)]), iy = island_of(s, *near[idx(y)]);
    return ix != iy ? ix < iy : x < y;
  });
  std::size_t next = 0;
  for (std::size_t k = 0; k < s.islands.size(); ++k) {
    Island& island = s.islands[k];
    island.first_row = static_cast<std::int32_t>(s.rows.size());
    for (; next < s.queue.size(); ++next) {
      const NearPair& pair = *near[idx(s.queue[next])];
      if (island_of(s, pair) != static_cast<std::int32_t>(k)) break;
      append_rows(world, states, pair, s.queue[next], dt, island, s);
    }
    island.rows = static_cast<std::int32_t>(s.rows.size()) - island.first_row;
  }
}

}  // namespace thigma::detail
