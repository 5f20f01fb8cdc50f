#include "thigma/multibody/island_solve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "thigma/core/index.h"
#include "thigma/multibody/detail/island_newton.h"
#include "thigma/multibody/detail/joint_terms.h"
#include "thigma/multibody/detail/multiplier_drift.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/multibody/detail/row_speed.h"

namespace thigma {
namespace {

using Work = detail::IslandWork;
using detail::add_impulse;
using detail::approach;

// The penalty of the augmented Lagrangian, in masses that a contact feels. A round leaves about one
// over it, times the length of a stack squared, of the error; more costs digits of the factor.
constexpr double kWeight = 1e5;
constexpr int kMostRounds = 60;        // a few are usual
constexpr int kMostNewton = 40;        // in a round
constexpr double kAccuracy = 1e-9;     // of the free speed: of the rows
constexpr double kSettled = 1e-7;      // of the largest impulse: of friction
constexpr double kNear = 1e-2;         // the same, where more rounds win nothing
constexpr double kSmall = 1e-7;        // of the free speed: changes that may stay then
constexpr double kBinds = 1.0 - 1e-6;  // of a bound of friction: it is reached
constexpr double kGradient = 1e-11;    // of the free momentum: of a round's minimum

/// How the multipliers changed in a round, in speeds, and their friction.
struct Change {
  double residual = 0.0, unsettled = 0.0, speed = 0.0;
};

/// The next multipliers.
Change take_multipliers(Work& work) noexcept {
  Change change;
  double most = 0.0, moved = 0.0;
  std::swap(work.s.change, work.s.change_before);
  std::swap(work.s.joint_change, work.s.joint_change_before);
  ++work.s.changes;
  for (std::size_t i = 0; i < work.rows.size(); ++i) {
    IslandRow& row = work.rows[i];
    const Vec3& f = work.s.force[i];
    const Vec3 by = f - row.impulse;
    change.speed = std::max(change.speed, by.norm() / work.s.weight[i]);
    change.residual = std::max(change.residual, approach(row, work.s.velocity).x() - row.limit);
    most = std::max(most, f.x());
    row.impulse = f;
    work.s.change[i] = by;
    const double radius = row.friction * f.x(), least = std::min(radius, work.s.radius[i]);
    // A bound that nothing reaches may change.
    if (f.tail<2>().norm() >= kBinds * least)
      moved = std::max(moved, std::fabs(radius - work.s.radius[i]));
  }
  if (most > 0.0) change.unsettled = moved / most;
  for (std::size_t i = 0; i < work.joints.size(); ++i) {
    JointRow& row = work.joints[i];
    const double by = work.s.joint_force[i] - row.impulse;
    row.impulse = work.s.joint_force[i];
    work.s.joint_change[i] = by;
    if (row.firmness > 0.0 || !(work.s.joint_weight[i] > 0.0)) continue;
    change.speed = std::max(change.speed, std::fabs(by) / work.s.joint_weight[i]);
    const double speed = detail::speed_of(row, work.s.velocity);
    change.residual = std::max(change.residual, detail::violation_of(row, speed));
  }
  return change;
}

/// Multipliers that changed the same way in the last two rounds go on to the first bound.
void follow_drift(Work& work) noexcept {
  IslandScratch& s = work.s;
  if (s.changes < 2) return;
  const double steps = detail::changes_to_bound({work.rows, work.joints, s.weight, s.joint_weight},
                                                {s.change, s.joint_change},
                                                {s.change_before, s.joint_change_before});
  if (!(steps > 0.0)) return;
  for (std::size_t i = 0; i < work.rows.size(); ++i) {
    Vec3& impulse = work.rows[i].impulse;
    s.change_before[i] = impulse;
    impulse += steps * s.change[i];
    impulse.x() = std::max(impulse.x(), 0.0);
  }
  for (std::size_t i = 0; i < work.joints.size(); ++i) {
    JointRow& row = work.joints[i];
    s.joint_change_before[i] = row.impulse;
    if (s.joint_weight[i] > 0.0)
      row.impulse = std::clamp(row.impulse + steps * s.joint_change[i], row.low, row.high);
  }
  s.changes = 0;
}

/// Takes back what follow_drift did where no round came after it.
void leave_drift(Work& work) noexcept {
  IslandScratch& s = work.s;
  if (s.changes > 0) return;
  for (std::size_t i = 0; i < work.rows.size(); ++i) work.rows[i].impulse = s.change_before[i];
  for (std::size_t i = 0; i < work.joints.size(); ++i)
    work.joints[i].impulse = s.joint_change_before[i];
}

/// The bounds of friction go a share of the way to what the normals allow: the whole of it, but
/// where they went to and fro. Rows that hold the same freedoms more than once share a load in more
/// ways than one; friction that follows one share changes it, and would do so for ever.
class Relaxation {
 public:
  void take_radius(Work& work, double unsettled) noexcept {
    constexpr double kFalls = 0.7, kLess = 0.6, kMore = 1.2, kLeast = 0.2;
    share_ = unsettled > kFalls * before_ ? std::max(kLeast, kLess * share_)
                                          : std::min(1.0, kMore * share_);
    before_ = unsettled;
    for (std::size_t i = 0; i < work.rows.size(); ++i) {
      const IslandRow& row = work.rows[i];
      double& radius = work.s.radius[i];
      radius += share_ * (row.friction * row.impulse.x() - radius);
    }
  }

 private:
  double share_ = 1.0, before_ = kInfinity;
};

/// Rounds whose changes are small and grow no smaller: more of them win nothing.
class Patience {
 public:
  /// After a round; whether it is at its end.
  bool is_over(double speed, double unsettled, double small) noexcept {
    constexpr int kRounds = 6;  // in which neither has halved
    if (speed < 0.5 * speed_ || unsettled < 0.5 * unsettled_) {
      speed_ = std::min(speed_, speed);
      unsettled_ = std::min(unsettled_, unsettled);
      rounds_ = 0;
    } else if (speed <= small) {
      ++rounds_;
    }
    return rounds_ >= kRounds;
  }

 private:
  double speed_ = kInfinity, unsettled_ = kInfinity;
  int rounds_ = 0;
};

double largest_mass(std::span<const IslandBody> bodies) noexcept {
  double most = 0.0;
  for (const IslandBody& body : bodies) most = std::max(most, body.metric(0, 0));
  return most;
}

/// Speed along a direction at a place for a unit of impulse there [1/kg].
double mobility_of(const Mat6& inverse, const Vec3& arm, const Vec3& direction) noexcept {
  Vec6 g;
  g << direction, arm.cross(direction);
  return g.dot(inverse * g);
}

/// Velocities and bounds of friction that a solve begins with.
void begin(Work& work) noexcept {
  IslandScratch& s = work.s;
  for (std::size_t i = 0; i < work.bodies.size(); ++i)
    s.velocity[i] = s.goes_on ? work.bodies[i].velocity : work.bodies[i].free;
  for (std::size_t i = 0; i < work.rows.size(); ++i)
    s.radius[i] = work.rows[i].friction * work.rows[i].impulse.x();
  s.changes = 0;
}

/// Weights of the joints' rows, and where they couple bodies.
void prepare_joints(Work& work) noexcept {
  IslandScratch& s = work.s;
  s.joint_force.resize(work.joints.size());
  s.joint_weight.resize(work.joints.size());
  s.joint_change.resize(work.joints.size());
  s.joint_change_before.resize(work.joints.size());
  s.joint_kept.resize(work.joints.size());
  for (std::size_t i = 0; i < work.joints.size(); ++i) {
    const JointRow& row = work.joints[i];
    const double mobility = detail::mobility_of(row, s.inverse);
    // A row that moves nothing asks for nothing.
    const double stiff = mobility > 0.0 ? kWeight / mobility : 0.0;
    s.joint_weight[i] = row.firmness > 0.0 ? row.firmness : stiff;
    const double share = row.firmness > 0.0 ? std::min(1.0, row.firmness * mobility) : 1.0;
    work.speed = std::max(work.speed, share * std::fabs(row.target));
    if (row.a < 0 || row.b < 0) continue;
    const std::int32_t high = std::max(row.a, row.b), low = std::min(row.a, row.b);
    s.hessian.first[idx(high)] = std::min(s.hessian.first[idx(high)], low);
  }
}

void prepare(Work& work) noexcept {
  IslandScratch& s = work.s;
  const std::size_t count = work.bodies.size();
  for (std::vector<Vec6>* list : {&s.velocity, &s.trial, &s.gradient, &s.trial_gradient, &s.step})
    list->resize(count);
  s.inverse.resize(count);
  s.force.resize(work.rows.size());
  s.weight.resize(work.rows.size());
  s.radius.resize(work.rows.size());
  s.change.resize(work.rows.size());
  s.change_before.resize(work.rows.size());
  s.kept.resize(work.rows.size());
  for (std::size_t i = 0; i < count; ++i) {
    const IslandBody& body = work.bodies[i];
    s.inverse[i] = body.metric.llt().solve(Mat6::Identity());
    work.speed = std::max(work.speed, detail::free_speed(body));
  }
  s.hessian.first.resize(count);
  for (std::size_t i = 0; i < count; ++i) s.hessian.first[i] = static_cast<std::int32_t>(i);
  for (std::size_t i = 0; i < work.rows.size(); ++i) {
    const IslandRow& row = work.rows[i];
    double mobility = 0.0;
    if (row.a >= 0) mobility += mobility_of(s.inverse[idx(row.a)], row.arm_a, row.normal);
    if (row.b >= 0) mobility += mobility_of(s.inverse[idx(row.b)], row.arm_b, row.normal);
    if (row.a >= 0 && row.b >= 0) {
      const std::int32_t high = std::max(row.a, row.b), low = std::min(row.a, row.b);
      s.hessian.first[idx(high)] = std::min(s.hessian.first[idx(high)], low);
    }
    s.weight[i] = kWeight / mobility;
    work.speed = std::max(work.speed, -row.limit);
  }
  prepare_joints(work);
  detail::shape_blocks(s.hessian);
  begin(work);
}

/// Whether the friction of some row is at its bound, for its normal impulse.
bool slides(std::span<const IslandRow> rows) noexcept {
  return std::any_of(rows.begin(), rows.end(), [](const IslandRow& row) {
    return row.friction > 0.0 && row.impulse.x() > 0.0 && detail::is_sliding(row);
  });
}

/// Tries whether nothing slides; else all is as it was but for the factors that this took.
bool solve_sticking(Work& work, double enough, IslandSolution& solution) noexcept {
  constexpr int kTried = 12;  // factors, where as many again are left
  constexpr int kRounds = 6;  // what is no number needs no factor
  IslandScratch& s = work.s;
  const bool has_friction = std::any_of(work.rows.begin(), work.rows.end(),
                                        [](const IslandRow& row) { return row.friction > 0.0; });
  if (!has_friction || slides(work.rows)) return false;
  if (s.newton_left >= 0 && s.newton_left < 2 * kTried) return false;
  for (std::size_t i = 0; i < work.rows.size(); ++i) s.kept[i] = work.rows[i].impulse;
  for (std::size_t i = 0; i < work.joints.size(); ++i) s.joint_kept[i] = work.joints[i].impulse;
  work.has_cones = true;
  bool is_met = false;
  while (!is_met && solution.newton < kTried && solution.rounds < kRounds) {
    solution.newton += detail::minimize(work, enough, kTried - solution.newton);
    if (solution.newton >= kTried) break;  // not at its minimum
    const Change change = take_multipliers(work);
    ++solution.rounds;
    if (slides(work.rows)) break;
    is_met = change.speed <= kAccuracy * work.speed;
    solution.residual = std::max(change.residual, 0.0);
  }
  work.has_cones = false;
  if (is_met) return true;
  for (std::size_t i = 0; i < work.rows.size(); ++i) work.rows[i].impulse = s.kept[i];
  for (std::size_t i = 0; i < work.joints.size(); ++i) work.joints[i].impulse = s.joint_kept[i];
  solution.rounds = 0;
  begin(work);
  return false;
}

/// Whatever slides: rounds, whose bounds of friction follow what the normals allow.
void solve_sliding(Work& work, double enough, IslandSolution& solution) noexcept {
  constexpr int kHeld = 10;  // of the last rounds: friction's bounds stay, so that normals settle
  // Likewise of the last factors, where these are numbered.
  constexpr std::int32_t kHeldNewton = 12;
  const std::int32_t& newton_left = work.s.newton_left;
  const double small = kSmall * work.speed;
  Change change;
  Relaxation relaxation;
  Patience changing, held;  // of rounds whose bounds of friction change, and stay
  bool is_cut_short = false, holds_radius = false;
  while (solution.rounds < kMostRounds) {
    solution.newton += detail::minimize(work, enough, kMostNewton);
    // Forces away from a round's minimum are no impulses: those of the round before stay.
    is_cut_short = newton_left == 0;
    if (is_cut_short) break;
    holds_radius = holds_radius || solution.rounds >= kMostRounds - kHeld ||
                   (newton_left > 0 && newton_left <= kHeldNewton);
    change = take_multipliers(work);
    ++solution.rounds;
    const bool is_met = change.speed <= kAccuracy * work.speed;
    if (is_met && (holds_radius || change.unsettled <= kSettled)) break;
    if (holds_radius) {
      if (held.is_over(change.speed, kInfinity, small)) break;
      continue;
    }
    holds_radius = changing.is_over(change.speed, change.unsettled, small);
    if (holds_radius && change.unsettled <= kNear) break;
    if (!is_met && !holds_radius) follow_drift(work);
    relaxation.take_radius(work, change.unsettled);
  }
  if (is_cut_short && solution.rounds > 0) leave_drift(work);
  solution.residual = std::max(change.residual, 0.0);
  solution.unsettled = change.unsettled;
  solution.is_whole =
      solution.residual <= detail::kRowsMet * work.speed && !(is_cut_short && solution.rounds == 0);
}

/// What the rows' impulses, as they are, make of the free velocities.
void finish(Work& work) noexcept {
  std::span<Vec6> sum(work.s.gradient.data(), work.bodies.size());
  for (Vec6& g : sum) g.setZero();
  for (const IslandRow& row : work.rows) add_impulse(row, row.impulse, sum);
  for (const JointRow& row : work.joints) detail::add_impulse(row, row.impulse, sum);
  for (std::size_t i = 0; i < work.bodies.size(); ++i) {
    work.bodies[i].impulse = -sum[i];
    work.bodies[i].velocity = work.bodies[i].free - work.s.inverse[i] * sum[i];
  }
}

}  // namespace

void reserve_island(std::size_t bodies, std::size_t rows, IslandScratch& scratch,
                    std::size_t joints) {
  for (std::vector<Vec6>* list : {&scratch.velocity, &scratch.trial, &scratch.gradient,
                                  &scratch.trial_gradient, &scratch.step})
    list->reserve(bodies);
  scratch.inverse.reserve(bodies);
  scratch.force.reserve(rows);
  scratch.weight.reserve(rows);
  scratch.radius.reserve(rows);
  scratch.joint_force.reserve(joints);
  scratch.joint_weight.reserve(joints);
  for (std::vector<Vec3>* list : {&scratch.change, &scratch.change_before, &scratch.kept})
    list->reserve(rows);
  for (std::vector<double>* list :
       {&scratch.joint_change, &scratch.joint_change_before, &scratch.joint_kept})
    list->reserve(joints);
  scratch.hessian.first.reserve(bodies);
  scratch.hessian.start.reserve(bodies + 1);
  scratch.hessian.blocks.reserve(bodies * (bodies + 1) / 2);
}

IslandSolution solve_island(std::span<IslandBody> bodies, std::span<IslandRow> rows,
                            std::span<JointRow> joints, IslandScratch& scratch) noexcept {
  Work work{bodies, rows, joints, scratch};
  prepare(work);
  const double momentum = work.speed * std::sqrt(largest_mass(bodies));
  const double enough = kGradient * momentum;
  IslandSolution solution;
  if (solve_sticking(work, enough, solution))
    solution.is_whole = true;
  else
    solve_sliding(work, enough, solution);
  finish(work);
  return solution;
}

}  // namespace thigma
