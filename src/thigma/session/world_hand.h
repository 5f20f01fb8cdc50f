#pragma once
// A hand of a world by itself: the haptic step of the body that it holds, apart from the world's
// step, and what both tell each other.

#include <cstdint>

#include "thigma/core/latest.h"
#include "thigma/device/haptic_device.h"
#include "thigma/loop/haptic_params.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/loop/samples.h"
#include "thigma/multibody/hand_step.h"
#include "thigma/session/world_session.h"
#include "thigma/session/world_ticks.h"

namespace thigma {

/// What the world tells a hand after a step.
struct HandNews {
  std::uint64_t sequence = 0;  // counts news; 0: none yet
  double time = 0.0;           // of the newest note of the hand that the world had then [s; hand's]
  std::uint64_t grip = 0;      // WorldGrip::number of what it holds; 0: nothing
  Coupling coupling;           // as it took hold
  WorkspaceAnchor anchor;
  HandModel model;  // of what it holds
};
static_assert(RtPayload<HandNews>);

/// What a hand tells the world after a haptic step.
struct HandNote {
  std::uint64_t frame = 0;     // counts ticks of haptic steps, from 1, those without a step too
  double time = 0.0;           // of it [s; hand's]
  double period = 1e-3;        // of haptic steps [s]
  DeviceState device;          // as read [device frame]
  std::uint64_t openings = 0;  // of its clutch so far
  std::uint64_t grip = 0;      // of the body below; 0: none
  BodyState body;              // where the haptic step has it
  double wanted_speed = 0.0;   // of any of its points, were nothing to hold it back [m/s]
  double energy = 0.0;         // that the hand has put in at its device [J]
  Wrench sent;                 // by it [N, N m; device frame]
};
static_assert(RtPayload<HandNote>);

/// The device as haptic_step sees it: its clutch is closed while the world says that it holds
/// something and it has not let go since. One that is lost has let go. What senses no rotation is
/// turned by its buttons, as in other sessions; from here on its pose says so.
class GripDevice final : public HapticDevice {
 public:
  /// has_clutch  it holds something only while its clutch is closed
  GripDevice(HapticDevice& device, bool has_clutch)
      : device_(&device), limits_(device.limits()), has_clutch_(has_clutch) {
    limits_.senses_rotation = true;
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return device_->name(); }
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench& wrench) THIGMA_RT override { device_->write(wrench); }
  const char* trouble() const THIGMA_RT override { return device_->trouble(); }

  bool holds = false;  // what the world says
  DeviceState sample;  // the last one, as read, turned by its buttons
  std::uint64_t openings = 0;

 private:
  void turn(double now) THIGMA_RT;

  HapticDevice* device_;
  DeviceLimits limits_;
  const bool has_clutch_;
  bool was_closed_ = false;
  double last_read_ = 0.0;
  Quat turned_ = Quat::Identity();  // by buttons
};

/// A hand on the haptic side. Not moved while it runs.
struct WorldHandLoop {
  WorldHandLoop(const WorldHand& config, HapticDevice& device, double rate);
  WorldHandLoop(const WorldHandLoop&) = delete;
  WorldHandLoop& operator=(const WorldHandLoop&) = delete;

  GripDevice device;
  const bool is_free;
  const bool has_clutch;  // a free one has it, too
  const double period;    // of haptic steps [s]
  HapticParams params;
  HapticState state;
  HandMemory memory;
  HandScratch scratch;
  std::uint64_t grip = 0;  // that it holds; 0: none
  WorldHapticSummary summary;
  StateHash hash;                   // of the body and what was sent
  std::uint64_t published = 0;      // news so far; the world's
  Latest<HandNews> news;            // world -> hand
  Latest<HandNote> notes;           // hand -> world
  Latest<LinearContactModel> ages;  // of the news; both sides are the hand's
  HapticPorts ports;
};

/// One haptic step of a hand: takes up the newest news, then haptic_step with the bodies of the
/// model in the place of fixed ones, by the same limits, ramps and ages. A model that is too old
/// fades by the rules of models with rows; nothing is predicted beyond the world's next step.
///
/// A lost device of a free hand lets go and may come back; any other fault stays latched, with zero
/// force. Late steps and models are ridden out where the device holds nobody, else they are faults.
///
/// Thread   [haptic]; bounded, no failure, nothing allocated
HapticSample step_world_hand(WorldHandLoop& loop, const HapticTick& tick) THIGMA_RT;

/// What such a step was, for whoever records it.
///
/// hand     number of it
/// Thread   [haptic], after step_world_hand
HandTick tick_of(std::int32_t hand, const HapticTick& tick, const HapticSample& sample,
                 const WorldHandLoop& loop) THIGMA_RT;

/// What the world's side has had of a hand.
struct HandBorder {
  bool is_held = false;
  double energy = 0.0;  // put into the world by it [J; device]
  // On the hand about the handle, not cut at any limit: of the coupling's springs, and of its
  // dampers as the body moves under a handle at rest [N, N m; device]
  Wrench springs, dampers;
  // of both in a step: what they grow by, at most, as the handle goes [N/m, N m/rad; device]
  double stiffness = 0.0, angular_stiffness = 0.0;
};

/// The hand's device as the world reads it: the newest note, and nothing is sent by it. The world's
/// time stands still while a step of it takes long. What the hand has done meanwhile comes to it no
/// faster than kCatchUp, or than the hand itself, and no farther than the energy lasts that the
/// hand has put in at its device: a world that lives more slowly than its hand gets no more work
/// from it than the hand has done. Where the world keeps up the samples are those of the device,
/// bit for bit.
class HandRelay final : public HapticDevice {
 public:
  /// loop outlives it; step: of the world [s]
  HandRelay(WorldHandLoop& loop, double step)
      : loop_(&loop), step_(step), limits_(loop.device.limits()) {
    limits_.holds_person = false;  // nothing is sent by it
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return loop_->device.name(); }
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench&) THIGMA_RT override {}
  const char* trouble() const THIGMA_RT override { return loop_->device.trouble(); }

  HandBorder border;       // after the world's last step
  std::uint64_t seen = 0;  // HandNote::frame of the last sample; 0: none yet

 private:
  double share_of(const Pose& pose, const Twist& twist, double energy) const THIGMA_RT;

  WorldHandLoop* loop_;
  const double step_;
  DeviceLimits limits_;
  bool has_passed_ = false, is_closed_ = false, is_behind_ = false;
  Pose passed_;  // handle pose of the last sample
  std::uint64_t frame_ = 0, openings_ = 0;
};

/// Speeds at which a world that was late comes after a hand, where the limits of its device allow
/// as much [m/s, rad/s; device].
inline constexpr double kCatchUp = 1.2, kCatchUpTurn = 20.0;

/// That the world may have had beyond what the hand has put in, so that a touch can begin [J].
inline constexpr double kBorderCredit = 1e-5;

/// A hand in a frame.
struct HandInFrame {
  const WorldGrip& grip;
  const Motion& handle;  // [world]
  const WorldHand& config;
  double step = 1e-3;  // of the world [s]
};

/// What the world has after a frame for a hand, to both of its sides.
///
/// run     after make_frame
/// last    time of the hand's newest note when the news before were made [s]; becomes this one's
/// Thread  [contact]; throws std::bad_alloc where memory grows
void publish_news(const WorldRun& run, const HandInFrame& hand, WorldHandLoop& loop,
                  HandRelay& relay, HandModelScratch& scratch, double& last);

}  // namespace thigma
