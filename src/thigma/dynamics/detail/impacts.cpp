#include "thigma/dynamics/detail/impacts.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

// An approach is an impact from so many times on what a step adds to it.
constexpr double kSteps = 4.0;

bool pressed_before(std::uint64_t id, const RowMemory& memory) THIGMA_RT {
  const auto is_it = [&](const RowMemory::Entry& e) { return e.id == id && e.normal > 0.0; };
  return std::any_of(memory.entries.begin(), memory.entries.end(), is_it);
}

double along_row(const VelocityRows& rows, std::size_t row, const Vec6& velocity) THIGMA_RT {
  double sum = 0.0;
  for (std::size_t k = 0; k < 6; ++k)
    sum += rows.gradient[k][row] * velocity[static_cast<Eigen::Index>(k)];
  return sum;
}

/// Speed at which a row's gap closes where it is closed.
double approach_of(const SolvedRows& solved, std::size_t row) THIGMA_RT {
  const double before = along_row(solved.rows, row, solved.before);
  const double free = along_row(solved.rows, row, solved.free);
  const double added = free - before;
  const double least = std::max(kSteps * std::fabs(added), solved.bounds.params.recovery_speed);
  if (!(before > least)) return 0.0;
  const double share = std::clamp(solved.rows.limit[row] / before, 0.0, 1.0);
  return before + share * added;
}

}  // namespace

Impacts find_impacts(const SolvedRows& solved, const RowMemory& memory) THIGMA_RT {
  Impacts impacts;
  const ConstraintModel& model = solved.bounds.model;
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    const double impulse = solved.impulses.normal[i];
    if (!(impulse > 0.0) || pressed_before(model.rows[i].id, memory)) continue;
    const double speed = approach_of(solved, i);
    if (!(speed > 0.0)) continue;
    const VelocityRows& rows = solved.rows;
    const Vec3 normal(rows.gradient[0][i], rows.gradient[1][i], rows.gradient[2][i]);
    impacts.push_back({model.rows[i].body, normal, rows.arm[i], speed, impulse});
  }
  return impacts;
}

void note_bounces(const Impacts& impacts, const StepBounds& bounds, RowMemory& memory) THIGMA_RT {
  memory.bounces.clear();
  for (const Impact& impact : impacts) {
    const std::size_t body = idx(impact.body);
    if (impact.body < 0 || body >= bounds.pairs.size()) continue;
    const double speed = bounds.pairs[body].restitution * impact.speed;
    if (speed > 0.0) memory.bounces.push_back({impact.normal, impact.arm, speed});
  }
}

void add_bounces(const RowMemory& memory, VelocityRows& rows) THIGMA_RT {
  for (const RowMemory::Bounce& bounce : memory.bounces) {
    if (rows.count == kMaxRows) return;
    const std::size_t r = idx(rows.count++);
    const Vec3 moment = bounce.arm.cross(bounce.normal);
    for (std::size_t k = 0; k < 3; ++k) {
      rows.gradient[k][r] = bounce.normal[static_cast<Eigen::Index>(k)];
      rows.gradient[k + 3][r] = moment[static_cast<Eigen::Index>(k)];
    }
    rows.limit[r] = -bounce.speed;
    rows.friction[r] = {};
    rows.arm[r] = bounce.arm;
  }
}

}  // namespace thigma::detail
