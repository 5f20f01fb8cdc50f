#pragma once
// Rows of a joint: from where a part of a step begins to where it ends.

#include <array>
#include <vector>

#include "thigma/multibody/island_solve.h"
#include "thigma/multibody/joint.h"

namespace thigma::detail {

/// What a row is for.
enum class JointRowKind : std::uint8_t { hold, spring, servo, motor, lower, upper };

/// Impulses of a joint, by place: six that hold it, then of spring, motor or servo, both limits.
inline constexpr std::size_t kJointPlaces = 10;
using JointImpulses = std::array<double, kJointPlaces>;  // [N s]
inline constexpr std::size_t kSpringPlace = 6, kMotorPlace = 7, kLowerPlace = 8, kUpperPlace = 9;

/// Where a row comes from.
struct JointRowSource {
  std::int32_t joint = -1;
  std::size_t place = 0;
  JointRowKind kind = JointRowKind::hold;
};

/// Rows that are being listed, with the impulses to begin with.
struct JointRowList {
  std::vector<JointRow> rows;
  std::vector<JointRowSource> sources;
};

/// A joint in a part of a step.
struct JointPart {
  const JointLaw& joint;
  std::int32_t number = -1;     // of the joint
  double arm = 1.0;             // angles are ways at it [m]
  JointMotor motor{};           // with the target of this step
  std::int32_t a = -1, b = -1;  // places in the island; -1: does not move
  JointEnds begin{}, end{};     // end: where u takes it
  Vec6 u_a = Vec6::Zero(), u_b = Vec6::Zero();
  double dt = 0.0;     // [s]
  double share = 1.0;  // of a row's impulse in the whole: 1/2 where velocities are means
};

/// Rows for the velocities that move the bodies from `begin` to `end`: with them what holds the
/// joint is met at the end, however far it turns, and does no work. Limits and motors at a speed
/// act at the beginning with their whole impulse, springs and servos through the part.
///
/// before   impulses to begin with, by place
/// Source   discrete gradients (Gonzalez 1999): all that a joint asks is bilinear in arms and axes,
///          so its change is its gradient at their means, where bodies turn by Cayley's map
void list_part_rows(const JointPart& part, const JointImpulses& before, JointRowList& list);

/// Rows for the velocities at the end of a part: what holds stands still, limits that pressed do
/// not part, a motor gives what it has left.
///
/// given    impulses of the part, by place: all of them
void list_end_rows(const JointPart& part, const JointImpulses& given, const JointImpulses& before,
                   JointRowList& list);

}  // namespace thigma::detail
