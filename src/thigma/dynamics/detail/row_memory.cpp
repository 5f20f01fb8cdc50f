#include "thigma/dynamics/detail/row_memory.h"

#include <algorithm>
#include <utility>

namespace thigma::detail {

void recall(const ConstraintModel& model, const RowMemory& memory,
            RowImpulses& impulses) THIGMA_RT {
  // Where all that presses slides, so does what comes in its way: a surface cut into many triangles
  // brings new rows all the time.
  bool is_sliding = !memory.entries.empty();
  for (const RowMemory::Entry& entry : memory.entries) is_sliding = is_sliding && entry.is_sliding;
  if (is_sliding) impulses.is_sliding.fill(true);
  for (const RowMemory::Entry& entry : memory.entries) {
    for (std::size_t i = 0; i < model.rows.size(); ++i) {
      if (model.rows[i].id != entry.id) continue;
      impulses.normal[i] = entry.normal;
      impulses.tangential[i] = entry.tangential;
      impulses.is_sliding[i] = entry.is_sliding;
      if (entry.is_active && impulses.active_count < kMaxActive)
        impulses.active[static_cast<std::size_t>(impulses.active_count++)] =
            static_cast<std::int32_t>(i);
      break;
    }
  }
}

void keep(const ConstraintModel& model, const RowImpulses& impulses, RowMemory& memory) THIGMA_RT {
  memory.entries.clear();
  const auto end = impulses.active.begin() + impulses.active_count;
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    const bool is_active =
        std::find(impulses.active.begin(), end, static_cast<std::int32_t>(i)) != end;
    if (!is_active && !(impulses.normal[i] > 0.0)) continue;
    memory.entries.push_back({model.rows[i].id, impulses.normal[i], impulses.tangential[i],
                              is_active, impulses.is_sliding[i]});
  }
}

void list_pressing(const ConstraintModel& model, const VelocityRows& rows,
                   const RowImpulses& impulses, double dt, PressingRows& pressing) THIGMA_RT {
  pressing.clear();
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    if (!(impulses.normal[i] > 0.0)) continue;
    const Vec3 normal(rows.gradient[0][i], rows.gradient[1][i], rows.gradient[2][i]);
    const auto& [first, second] = impulses.tangential[i];
    const Vec3 impulse = impulses.normal[i] * normal + first * rows.tangent[i] +
                         second * normal.cross(rows.tangent[i]);
    PressingRow next{model.rows[i].id, impulse / -dt};
    for (PressingRow& other : pressing)
      if (next.force.squaredNorm() > other.force.squaredNorm()) std::swap(next, other);
    pressing.push_back(next);
  }
}

}  // namespace thigma::detail
