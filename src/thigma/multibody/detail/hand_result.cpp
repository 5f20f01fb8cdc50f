#include "thigma/multibody/detail/hand_result.h"

#include <algorithm>

#include "thigma/core/index.h"
#include "thigma/multibody/detail/row_rules.h"

namespace thigma::detail {
namespace {

/// Puts a row among the strongest.
void list_pressing(const PressingRow& row, PressingRows& list) THIGMA_RT {
  if (list.push_back(row)) return;
  PressingRow* weakest = std::min_element(
      list.begin(), list.end(),
      [](const auto& a, const auto& b) { return a.force.squaredNorm() < b.force.squaredNorm(); });
  if (weakest->force.squaredNorm() < row.force.squaredNorm()) *weakest = row;
}

}  // namespace

void keep_rows(const HandWork& work, ConstrainedStep& result) THIGMA_RT {
  HandScratch& s = work.s;
  for (std::size_t i = 0; i < work.model.rows.size(); ++i) {
    work.memory.impulses[i] = Vec3::Zero();
    work.memory.is_sliding[i] = false;
  }
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const IslandRow& row = s.rows[r];
    if (!(row.impulse.x() > 0.0)) continue;
    const RowSource& source = s.sources[r];
    const bool slides = is_sliding(row);
    work.memory.impulses[idx(source.row)] = row.impulse;
    work.memory.is_sliding[idx(source.row)] = slides;
    if (row.a != 0 && row.b != 0) continue;
    ++result.solution.active;
    if (row.friction > 0.0) ++(slides ? result.slip.sliding : result.slip.sticking);
    const Vec3 p = row.impulse.x() * row.normal + row.impulse.y() * row.first +
                   row.impulse.z() * row.normal.cross(row.first);
    const double sign = row.a == 0 ? -1.0 : 1.0;
    list_pressing({work.model.rows[idx(source.row)].row.id, sign / work.dt * p}, result.pressing);
  }
  std::sort(result.pressing.begin(), result.pressing.end(), [](const auto& a, const auto& b) {
    const double x = a.force.squaredNorm(), y = b.force.squaredNorm();
    return x != y ? x > y : a.id < b.id;
  });
}

void keep_bodies(const HandWork& work, double share) THIGMA_RT {
  if (!work.goes) return;
  HandMemory& memory = work.memory;
  for (std::size_t i = 1; i < work.model.bodies.size(); ++i) {
    memory.states[i] = work.s.next[i];
    if (work.s.place[i] >= 0)
      memory.velocities[i] = share * work.s.bodies[idx(work.s.place[i])].velocity;
  }
  memory.left -= work.dt;
}

}  // namespace thigma::detail
