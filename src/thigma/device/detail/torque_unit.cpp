#include "thigma/device/detail/torque_unit.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <string>
#include <thread>

#include "thigma/device/detail/hd_session.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kFrame = 1e-3;                   // of the vendor's scheduler [s]
constexpr double kFirst = 1e-4;                   // what the first step grows from [vendor's unit]
constexpr double kFeltTurn = 0.1;                 // [rad]
constexpr int kTriesOfStep = 3;                   // of a button that is let go too early
constexpr std::int64_t kMostMs = 20'000 + 5'000;  // for the button, and a whole step [ms]
// Hands feel from about 5 to 50 mN m, which is 0.005 to 0.05 in N m and 5 to 50 in mN m. The border
// is high: N m taken for mN m is a thousandfold torque, mN m taken for N m is none at all.
constexpr double kUnitBorder = 3.0;  // [vendor's unit]

enum class StepEnd { running, unfelt, let_go, turned };

/// One step, in the frames of the vendor's thread.
struct TorqueStep {
  HdServo* servo = nullptr;
  double from = 0.0, to = 0.0;  // [vendor's unit]
  TorqueRamp ramp;
  int frames = 0;      // with the button held
  double value = 0.0;  // sent last
  Quat start = Quat::Identity();
  std::atomic<StepEnd> end{StepEnd::running};
};

/// From nothing to what was nothing, then on, slowly at first.
double torque_of(const TorqueStep& step) THIGMA_RT {
  const double t = kFrame * step.frames;
  if (t < step.ramp.rise) return step.from * t / step.ramp.rise;
  const double share = std::min(1.0, (t - step.ramp.rise) / step.ramp.growth);
  return step.from + (step.to - step.from) * share * share;
}

StepEnd end_of(const TorqueStep& step, const DeviceState& sample) THIGMA_RT {
  if ((sample.buttons & kClutchButton) == 0) return StepEnd::let_go;
  const Quat turned = sample.motion.pose.orientation * step.start.conjugate();
  // A number that is none is a turn.
  if (!(turned.vec().norm() <= 0.5 * kFeltTurn)) return StepEnd::turned;
  const bool is_over = kFrame * step.frames >= step.ramp.rise + step.ramp.growth;
  return is_over ? StepEnd::unfelt : StepEnd::running;
}

void step_frame(void* context) noexcept {
  TorqueStep& step = *static_cast<TorqueStep*>(context);
  if (step.end != StepEnd::running || step.servo->trouble().is_lost()) return;  // zero is sent
  const DeviceState& sample = step.servo->sample();
  const bool is_held = (sample.buttons & kClutchButton) != 0;
  if (step.frames == 0 && !is_held) return;  // waits for the button
  if (step.frames == 0) step.start = sample.motion.pose.orientation;
  const StepEnd end = end_of(step, sample);
  if (end != StepEnd::running) {
    step.end = end;
    return;
  }
  ++step.frames;
  step.value = torque_of(step);
  const Vec3 torque(step.value, 0.0, 0.0);
  step.servo->send(Vec3::Zero(), &torque);
}

/// Device and person.
struct Trial {
  const HdLibrary& library;
  const unsigned device;
  const CalibrationTalk& talk;
  const TorqueRamp& ramp;
  bool is_stopped() const { return talk.is_stopped && talk.is_stopped(); }
};

/// Runs a step to its end; forces are off afterwards.
StepEnd run_step(const Trial& trial, double from, double to, double& felt) {
  TorqueStep step;  // outlives the frames
  HdServo servo(trial.library, trial.device);
  step.servo = &servo;
  step.from = from;
  step.to = to;
  step.ramp = trial.ramp;
  servo.start(1.0 / kFrame, {step_frame, &step});
  constexpr auto kLook = std::chrono::milliseconds(5);
  const auto last = std::chrono::steady_clock::now() + std::chrono::milliseconds(kMostMs);
  while (step.end == StepEnd::running && !servo.trouble().is_lost() && !trial.is_stopped() &&
         std::chrono::steady_clock::now() < last)
    std::this_thread::sleep_for(kLook);
  servo.stop();
  if (servo.trouble().is_lost())
    throw DeviceUnavailable(std::string("openhaptics: ") + servo.trouble().text());
  felt = step.value;
  return step.end;
}

/// What a step says: of a unit, that the next may come, or that it is over.
enum class Verdict { felt, next, over };

Verdict try_step(const Trial& trial, std::size_t i, double& felt) {
  const CalibrationTalk& talk = trial.talk;
  const std::string name =
      "Step " + std::to_string(i + 1) + " of " + std::to_string(std::size(kTorqueSteps));
  const double from = i == 0 ? kFirst : kTorqueSteps[i - 1];
  for (int tries = 0; tries < kTriesOfStep; ++tries) {
    talk.say(name + ": hold the button of the stylus down; let go as soon as a torque is felt.");
    const StepEnd end = run_step(trial, from, kTorqueSteps[i], felt);
    if (trial.is_stopped() || end == StepEnd::running) return Verdict::over;
    if (end == StepEnd::unfelt) {
      const bool is_sure = talk.confirm(name + " is over. Was there really no torque at all?");
      return is_sure ? Verdict::next : Verdict::over;
    }
    const bool has_turned = end == StepEnd::turned;
    if (talk.confirm(has_turned ? "The stylus has turned: was that a torque?"
                                : "The button was let go: was a torque felt?"))
      return Verdict::felt;
    if (trial.is_stopped()) return Verdict::over;
  }
  return Verdict::over;
}

}  // namespace

double find_torque_unit(const HdLibrary& library, unsigned device, const CalibrationTalk& talk,
                        const TorqueRamp& ramp) {
  if (!talk.is_answered) {
    talk.say("The unit of the torque takes somebody who answers: it is left out with --yes.");
    return 0.0;
  }
  if (!talk.confirm("Torque: hold the stylus lightly between two fingers, and keep them out of "
                    "where it may strike. A torque grows from nothing, in steps, only while its "
                    "button is held. Ready?"))
    return 0.0;
  const Trial trial{library, device, talk, ramp};
  for (std::size_t i = 0; i < std::size(kTorqueSteps); ++i) {
    double felt = 0.0;
    const Verdict verdict = try_step(trial, i, felt);
    if (verdict == Verdict::over) return 0.0;
    if (verdict == Verdict::felt) return felt < kUnitBorder ? 1.0 : 1000.0;
  }
  return 0.0;
}

}  // namespace thigma::detail
