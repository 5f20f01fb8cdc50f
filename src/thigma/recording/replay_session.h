#pragma once
// Running recorded haptic frames again, and comparing every bit.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "thigma/loop/haptic_step.h"
#include "thigma/loop/samples.h"

namespace thigma {

/// What replaying a recording gave.
struct ReplayReport {
  std::uint64_t frames = 0;
  std::uint64_t state_hash = 0;     // of the replay
  std::uint64_t recorded_hash = 0;  // of the recorded states and wrenches
  bool identical = false;
  std::int64_t first_difference = -1;  // frame, -1: none
  std::string reason;                  // of the first difference, "" without one
};

/// Runs a session again as its samples and models go by, in the order they were recorded.
/// Invariant: holds the models that frames may still name, and at most kMostWaiting frames whose
/// model has not come. Thread: one, [offline]; no failure: what is missing or damaged is a
/// difference.
class SessionReplay {
 public:
  /// params           of the recorded session, with its device's limits
  /// world_from_body  of the centre of mass before frame 0
  SessionReplay(const HapticParams& params, const Pose& world_from_body);
  ~SessionReplay();
  SessionReplay(const SessionReplay&) = delete;
  SessionReplay& operator=(const SessionReplay&) = delete;

  void add(const ContactSample& model);  // in order of their sequence
  void add(const HapticSample& sample);  // in order from frame 0
  ReplayReport finish();                 // after the last of both

  // ten seconds and more between a model and its frame: it is missing
  static constexpr std::size_t kMostWaiting = 10000;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Steps through recorded device samples with the recorded models; lockstep and threaded sessions
/// alike, as both are functions of the samples and of which model each frame used.
///
/// params           of the recorded session, with its device's limits
/// world_from_body  of the centre of mass before frame 0
/// samples          every haptic frame, in order from frame 0; digests of 0 (here and in models)
///                  are not compared
/// models           every model that a frame names, in order of their sequence
/// Thread           [offline]; no failure: what is missing or damaged is a difference.
ReplayReport replay_session(const HapticParams& params, const Pose& world_from_body,
                            const std::vector<HapticSample>& samples,
                            const std::vector<ContactSample>& models);

/// The same of a recording of any size, read a piece at a time. Sessions of a device only:
/// `thigma replay` simulates a simulated body again.
/// Thread    [offline]; InputError as stream_recording.
ReplayReport replay_recording(const std::string& path);

/// Whether two states, or two wrenches, are the same bit for bit: 0 and -0 differ, NaNs with the
/// same bits do not.
/// Thread    [any].
bool same_bits(const BodyState& a, const BodyState& b) noexcept;
bool same_bits(const Wrench& a, const Wrench& b) noexcept;

}  // namespace thigma
