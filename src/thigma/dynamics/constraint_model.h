#pragma once
// What the haptic thread knows of a contact world that its body must not enter: inequalities, and
// how far they reach.

#include <array>
#include <cmath>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/core/static_vector.h"
#include "thigma/dynamics/body.h"

namespace thigma {

/// Rows a model has room for: 64 are usual, wide conforming contact has more.
inline constexpr int kMaxRows = 256;

/// Which features of the two surfaces a row keeps apart.
enum class RowKind : std::uint8_t {
  scene_plane,   // a point of the object, a plane of the scene
  object_plane,  // a plane of the object, a point of the scene
  edges,         // an edge of each
  relief,        // a point of the object, a bent surface of the scene about one place
};

/// Coulomb's numbers of a material, or of two surfaces that touch. Dimensionless. No initializers:
/// models have room for many rows; Friction{} is none.
struct Friction {
  double kinetic;  // while they slide, >= 0
  double at_rest;  // until they do, >= kinetic; 0: no friction
  friend bool operator==(const Friction&, const Friction&) = default;
};

/// A number of Friction, as scenes and recordings call it.
struct FrictionNumber {
  const char* key;
  double Friction::*number;
};

/// All of them: what reads, writes and combines friction follows this list.
inline constexpr FrictionNumber kFrictionNumbers[] = {{"friction", &Friction::kinetic},
                                                      {"static_friction", &Friction::at_rest}};

/// Whether both are finite and in order. Thread: any.
inline bool is_valid(const Friction& f) noexcept {
  return f.kinetic >= 0.0 && f.at_rest >= f.kinetic && std::isfinite(f.at_rest);
}

/// One inequality: two features stay apart. Evaluated anew at every state, so that only the change
/// within a step is taken as linear.
/// Every member is set where a row is made: models have room for many.
struct ContactRow {
  RowKind kind;
  std::uint64_t id;   // of the pair of features, the same in every model
  Vec3 object_point;  // the point, of the plane or of the edge [m; body frame]
  Vec3 scene_point;   // likewise of the scene [m; world]
  // object_plane: unit normal out of the object; edges: unit, along the object's [body frame];
  // relief: how the gap bends, see `relief_frame` [1/m]; else zero
  Vec3 object_direction;
  // scene_plane, relief: unit normal out of the object, into the scene; edges: unit, along the
  // scene's, so that object x scene points into the scene; else zero [world]
  Vec3 scene_direction;
  // relief: unit normal of the plane that the bend is told along, out of the object; else zero.
  // Zero of relief, as in recordings before there was one: scene_direction [world]
  Vec3 plane;
  Friction friction;  // of the two materials
  std::int32_t body;  // static object of the scene
};

/// Two unit vectors across a normal, a function of it alone.
/// Thread    [haptic]; |normal| = 1.
struct TangentPair {
  Vec3 first, second;
};
TangentPair tangents_of(const Vec3& normal) THIGMA_RT;

/// What the bend of a relief row is told in: the tangents of its plane. With t the way of the
/// object's point along them from scene_point, its gap there is normal . (scene_point - object's
/// point) - 1/2 (bend.x t_1^2 + 2 bend.y t_1 t_2 + bend.z t_2^2), over the length of its gradient:
/// in metres, to first order in the gap.
/// Thread    [haptic].
TangentPair relief_frame(const ContactRow& row) THIGMA_RT;

/// A row of which nothing is known but its kind.
inline ContactRow make_row(RowKind kind) THIGMA_RT {
  const Vec3 zero = Vec3::Zero();
  return {kind, 0, zero, zero, zero, zero, zero, Friction{}, 0};
}

/// What keeps the body from entering. Part of the contact model.
struct ConstraintModel {
  BodyState state;  // the rows were found at
  // The rows say all as long as no point of the object is farther than this from where it was at
  // `state` [m]. 0, as before the first query: nothing may move.
  double travel = 0.0;
  double reach = 0.0;  // of the object's farthest point from its centre of mass [m]
  StaticVector<ContactRow, kMaxRows> rows;
};
static_assert(RtPayload<ConstraintModel>);

/// Numbers of the constraint response. Constant while a session runs.
struct ConstraintParams {
  double slop = 0.0;  // the gap that is kept, > 0 [m]
  // A gap below slop grows by this share a step, and no faster than this.
  double recovery = 0.2;
  double recovery_speed = 2e-3;  // [m/s]
};

/// How a pair of surfaces rings when they meet: a sinusoid that dies away.
struct Tap {
  double amplitude = 0.0;    // at its beginning, of the approach speed, >= 0; 0: none [N s/m]
  double frequency = 150.0;  // > 0 [Hz]
  double decay = 0.015;      // until 1/e is left, > 0 [s]
  friend bool operator==(const Tap&, const Tap&) = default;
};

/// Two surfaces that may meet.
struct ImpactPair {
  double restitution = 0.0;  // share of the approach speed that comes back, 0..1
  Tap tap;
  friend bool operator==(const ImpactPair&, const ImpactPair&) = default;
};

/// Whether all is finite and in range. Thread: any.
inline bool is_valid(const ImpactPair& pair) noexcept {
  const Tap& t = pair.tap;
  return pair.restitution >= 0.0 && pair.restitution <= 1.0 && t.amplitude >= 0.0 &&
         std::isfinite(t.amplitude) && t.frequency > 0.0 && std::isfinite(t.frequency) &&
         t.decay > 0.0 && std::isfinite(t.decay);
}

/// A contact that began in a step. Every member is set where one is made.
struct Impact {
  std::int32_t body;  // static object of the scene
  Vec3 normal;        // unit, out of the object, into the scene [world]
  Vec3 arm;           // of where they meet, from the centre of mass [m; world]
  double speed;       // at which they came together, > 0 [m/s]
  double impulse;     // of the contact in the step, along the normal, > 0 [N s]
};
inline constexpr int kMaxImpacts = 8;  // that are told of in a step: as a rule six rows press
using Impacts = StaticVector<Impact, kMaxImpacts>;

/// How friction held over a step.
struct SlipCount {
  std::int32_t sticking = 0, sliding = 0;  // contacts with friction that press
  double work = 0.0;                       // taken by those that slide [J]
};

/// Impulses of the rows that pressed in the last step, by the features they are of: the warm start
/// of the next, whatever model it has.
struct RowMemory {
  struct Entry {
    std::uint64_t id;
    double normal;                     // [N s]
    std::array<double, 2> tangential;  // [N s]
    bool is_active;                    // in the exact solution
    bool is_sliding;                   // at the end of it
  };
  StaticVector<Entry, 64> entries;
  // A contact that began in the last step and is to throw the body back in the next.
  struct Bounce {
    Vec3 normal, arm;  // as of Impact
    double speed;      // at which it leaves, > 0 [m/s]
  };
  StaticVector<Bounce, kMaxImpacts> bounces;
};

/// A row that pressed in a step. Every member is set where one is made.
struct PressingRow {
  std::uint64_t id;  // of the row
  Vec3 force;        // on the object, mean over the step, friction included [N; world]
};
inline constexpr int kMaxPressing = 8;  // that are told of: as a rule six at most press
using PressingRows = StaticVector<PressingRow, kMaxPressing>;

/// A row at one state.
struct RowAtState {
  double gap = 0.0;             // between the two features, negative through each other [m]
  Vec3 normal = Vec3::UnitZ();  // unit, out of the object, into the scene [world]
  Vec3 arm = Vec3::Zero();      // of where they touch, from the centre of mass [m; world]
};

/// Gap and gradient of a row. The gap's rate is -(normal . v + (arm x normal) . omega).
///
/// row       of a model
/// position  of the centre of mass [m; world]
/// rotation  world from body, orthonormal
/// Thread    [haptic]; no failure. Parallel edges have no normal: gap infinite.
RowAtState row_at(const ContactRow& row, const Vec3& position, const Mat3& rotation) THIGMA_RT;

/// Bound on how far any point of a body of this reach is moved between two states [m].
/// Thread    [haptic].
double travel_between(const BodyState& a, const BodyState& b, double reach) THIGMA_RT;

/// Whether a body may be farther from where a model was made than its rows hold.
/// Thread    [haptic].
bool is_beyond(const ConstraintModel& model, const BodyState& body) THIGMA_RT;

/// Whether the rows of a model that has come hold for a body that has moved since: it is within
/// their travel and has passed none of them, or no other model says more. A body that goes beside a
/// surface may pass a plane that the model in use does not have. The new model would let it enter
/// from behind that plane. Until one may be taken the body stays within the travel of the one it
/// has. At its end it rests, and the next model holds where it is.
///
/// offered, held  the model that has come, and the one in use
/// body           where it is now
/// Thread         [haptic].
bool may_take(const ConstraintModel& offered, const ConstraintModel& held,
              const BodyState& body) THIGMA_RT;

}  // namespace thigma
