#pragma once
// What the real-time threads tell the others: one sample a frame, plain data, through bounded
// rings.

#include <array>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"
#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/loop/safety.h"

namespace thigma {

/// One haptic frame. With the models it names, the device samples reproduce every other number bit
/// for bit.
struct HapticSample {
  // What went in.
  std::uint64_t frame = 0;             // counts from 0
  double time = 0.0;                   // `now` of the step [s; session clock]
  double elapsed = 0.0;                // step length [s]
  DeviceState device;                  // as read [device frame]
  std::uint64_t model_sequence = 0;    // contact model used, 0 = none yet
  Fault external_fault = Fault::none;  // told to the step from outside (watchdog)
  std::uint64_t input_digest = 0;  // of the lines above: tells a damaged recording even where the
                                   // change is lost in rounding
  // What came out.
  Motion handle;    // of the device in the scene [world]
  BodyState body;   // at the end of the step
  Wrench coupling;  // on the object about its centre of mass [world]
  Wrench contact;   // on the object about its centre of mass [world]
  Wrench feedback;  // on the hand about the handle, after the limits [device frame]
  // what was sent: feedback without the axes the device lacks, made passive where the session asks
  // for that [device frame]
  Wrench command;
  double model_age = 0.0;     // infinity: no model yet [s]
  double model_weight = 0.0;  // 1 fresh .. 0 stale
  // deepest contact of the model at the new state; -infinity: none near [m]. With the constrained
  // response minus the least gap of a row before the step: how far a feature lies behind a plane
  // that it is kept in front of, which beside the surface is no depth
  double penetration = 0.0;
  // how much deeper that contact is than when the model was made; not recorded [m]
  double sunk = 0.0;
  double stretch = 0.0;       // of the coupling: handle to grasp point [m; world]
  double energy = 0.0;        // the hand has put in so far at the device's port [J]
  std::int32_t touching = 0;  // contact terms that push
  // Of the constrained response.
  double wanted_speed = 0.0;    // of the object's fastest point, were its travel not to end [m/s]
  double solve_residual = 0.0;  // largest speed at which a row is violated [m/s]
  bool is_held_back = false;    // the travel of the model has ended the motion early
  // rows nearer than the slop asked to be left in ways that contradict each other
  bool is_squeezed = false;
  PressingRows pressing;  // the strongest first
  // Not recorded: what replays recompute.
  SlipCount slip;  // how friction held, of any response
  Wrench tap;      // of taps on the hand about the handle, before the limits [world]
  bool is_grasped = false;
  bool is_armed = false;
  Fault fault = Fault::none;  // latched
  // Timing, not reproduced. Of the frame before, as a step cannot time itself.
  float step_cpu = 0.0f;   // [s]
  float wake_late = 0.0f;  // [s]
  // of the row solves of this frame, by HapticPorts::clock; 0: there were none; not recorded [ns]
  std::int64_t solve_ns = 0;
};
static_assert(RtPayload<HapticSample>);

/// How many contacts lie at each level of detail, 0 the finest; the last bin holds all above.
inline constexpr std::int32_t kLevelBins = 24;
using LevelCounts = std::array<std::int32_t, kLevelBins>;

/// What may decide the level of a contact, see LevelDecision, which the haptic thread does not
/// know.
inline constexpr std::size_t kLevelDeciders = 6;

/// One contact frame: the model published and how it came about.
struct ContactSample {
  double time = 0.0;       // of the body state it was computed for [s]
  double published = 0.0;  // [s]
  double query_cpu = 0.0;  // of the query alone [s]
  double step_cpu = 0.0;   // of the whole contact step [s]
  std::int64_t contacts = 0;
  std::int64_t dropped = 0;
  std::int64_t front = 0;
  std::int64_t tests = 0;
  std::int32_t clusters = 0;
  // of the contacts, minus the distance when separated; means nothing without one [m]
  double depth_max = 0.0;
  std::uint64_t model_digest = 0;  // of the model's terms, as input_digest
  // Of levels of detail; all 0 of an exact query but for the first entry of the counts.
  std::int64_t mandatory_tests = 0;  // of tests, those no budget can leave out
  std::int64_t unrefined = 0;        // contacts left coarser than asked for want of budget
  std::int32_t level_changes = 0;    // contacts that were refined or coarsened since the last frame
  double bound_max = 0.0;            // of the contacts [m]
  LevelCounts object_levels{}, scene_levels{};
  // Of the constrained response.
  std::int64_t rows = 0;  // found; those of the model are in `model`
  // times the travel was halved, as more rows were needed than a model holds
  std::int32_t travel_halvings = 0;
  std::int64_t left_out = 0;  // contacts and candidates for want of room: nothing may move then
  double travel = 0.0;        // of the object's points, as far as the rows say all [m]
  double look_ahead = 0.0;    // tolerance of the query [m]
  std::int64_t coarse = 0;    // of the contacts, those not of two finest patches: far away
  std::int32_t pressing_changes = 0;  // of level_changes, those that a force can show; not recorded
  // contacts, by LevelDecision; not recorded
  std::array<std::int32_t, kLevelDeciders> decided_by{};
  // of the original, below a contact, mean of both sides, sum over contacts; 0 of an exact query;
  // not recorded
  double triangles_below = 0.0;
  // Not recorded: what replays recompute.
  std::int32_t texture_depths = 0;  // that textures gave
  // of these, where a fine surface is no height field at the deepest place
  std::int32_t texture_folds = 0;
  std::int32_t texture_sheets = 0;  // of these, depths of the displaced texels themselves
  // where textures were sampled too coarsely, where a bent row leaves out more than 1 % of the
  // relief, and peaks for want of room (ReliefStats)
  std::int32_t texture_coarse = 0, texture_bent = 0;
  std::int64_t texture_left_out = 0;
  LinearContactModel model;
};
static_assert(RtPayload<ContactSample>);

/// Bits of several numbers in one; order matters.
/// Thread    [haptic].
struct StateHash {
  std::uint64_t value = 0xcbf29ce484222325ull;
};
void add_bits(StateHash& hash, std::uint64_t bits) THIGMA_RT;
void add_number(StateHash& hash, double number) THIGMA_RT;
void add_vector(StateHash& hash, const Vec3& v) THIGMA_RT;
void add_quaternion(StateHash& hash, const Quat& q) THIGMA_RT;

/// The frame's part of `state_hash`: the 13 state numbers and the six of the wrench sent.
/// Thread    [haptic].
void add_frame(StateHash& hash, const BodyState& body, const Wrench& command) THIGMA_RT;

/// Digest of what a haptic frame read, and of what a contact frame published: equal after writing
/// and reading a recording, so all that is not finite counts as one value.
/// Thread    [haptic].
std::uint64_t input_digest(const HapticSample& sample) THIGMA_RT;
std::uint64_t model_digest(const LinearContactModel& model) THIGMA_RT;

}  // namespace thigma
