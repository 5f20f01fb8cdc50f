#pragma once
// What the haptic thread knows of a world of several bodies: the body in the hand, those next to
// it, and the rows between them. Bounded, so that a step with it is.

#include <array>
#include <cstdint>
#include <memory>

#include "thigma/core/rt.h"
#include "thigma/core/static_vector.h"
#include "thigma/dynamics/body.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/multibody/detail/joint_rows.h"
#include "thigma/multibody/joint.h"
#include "thigma/multibody/step_world.h"

namespace thigma {

/// Room of a hand model.
inline constexpr int kHandBodies = 16;  // with the one in the hand
inline constexpr int kHandMovers = 6;   // of them, those that a haptic step solves with it
inline constexpr int kHandPairs = 32;
inline constexpr int kHandRows = 192;
inline constexpr int kHandJoints = 8;

/// A body of a hand model. The first is the one in the hand.
struct HandBody {
  std::int32_t body = -1;  // of the world
  // A haptic step moves it by its mass and its rows; else it keeps its velocity until the world's
  // next step, whatever it meets: it is where the world begins that the haptic thread does not know
  bool is_solved = false;
  bool is_free = false;  // rows move it in the world
  RigidBody rigid;
  BodyState state;               // where the world has it
  Vec6 velocity = Vec6::Zero();  // there [m/s, rad/s; world]
};

/// Two bodies of a hand model with rows between them, which are in the frame of `second`.
struct HandPair {
  std::int32_t first = -1, second = -1;  // into HandModel::bodies
  BodyState state;                       // of the first in the frame of the second, of the rows
  double travel = 0.0;                   // from there that they hold for [m]
  double reach = 0.0;                    // of the first body [m]
  double slop = 0.0;                     // the gap that is kept [m]
  double restitution = 0.0;              // the larger of the two bodies'

  /// Whether one of them is the body in the hand, which goes no farther than these rows hold.
  bool is_guarded() const noexcept { return first == 0 || second == 0; }
};

/// A row of a pair, as the world's last step left it.
struct HandRow {
  ContactRow row = make_row(RowKind::scene_plane);
  std::int32_t pair = -1;
  bool is_sliding = false;
  Vec3 impulse = Vec3::Zero();  // along the normal and its tangents [N s]
};

/// A joint of a hand model; a and b are of HandModel::bodies.
struct HandJoint : JointLaw {
  double arm = 1.0;                 // angles are ways at it [m]
  detail::JointImpulses impulse{};  // of the world's last step [N s]
};

/// The world about the body in a hand, as of the end of a step of the world.
struct HandModel {
  std::uint64_t sequence = 0;  // counts models; 0: none yet
  double step = 1e-3;          // of the world [s]
  // How far any point of the body in the hand may go from where the world has it: so far the world
  // was looked at, and within it only the bodies of the model can be met [m]
  double room = 0.0;
  double reach = 0.0;  // of its farthest point from its centre of mass [m]
  // Pairs and rows without room, which `room` ends before, and bodies that are the border for it
  std::int32_t left_out = 0;
  StaticVector<HandBody, kHandBodies> bodies;
  StaticVector<HandPair, kHandPairs> pairs;
  StaticVector<HandRow, kHandRows> rows;  // those of a pair stand together
  StaticVector<HandJoint, kHandJoints> joints;
};
static_assert(RtPayload<HandModel>);

/// What a hand model is asked for.
struct HandModelRequest {
  std::int32_t body = -1;  // in the hand
  double way = 0.0;        // that its points may go before the next model, as far as known [m]
  double step = 1e-3;      // of the world [s]
};

/// Working memory. Grows while warming up, never after. Moved, not copied.
struct HandModelScratch;
struct HandModelScratchDeleter {
  void operator()(HandModelScratch* scratch) const noexcept;
};
using HandModelScratchPtr = std::unique_ptr<HandModelScratch, HandModelScratchDeleter>;

/// Thread    [offline]; throws std::bad_alloc.
HandModelScratchPtr reserve_hand_model(const World& world);

/// Makes the model of the body in a hand after a step of its world: what may be met within a way of
/// it, the bodies it touches, what these touch, and joints between them, breadth first as far as
/// there is room.
///
/// world    constant
/// state    after the step
/// step     working memory of that step: its rows, and what pressed
/// request  see there
/// model    overwritten but for `sequence`
/// Thread   [contact]; throws std::bad_alloc where memory grows. The same bits for the same calls
void make_hand_model(const World& world, const WorldState& state, const WorldScratch& step,
                     const HandModelRequest& request, HandModelScratch& scratch, HandModel& model);

}  // namespace thigma
