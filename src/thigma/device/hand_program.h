#pragma once
// What the simulated hand wants to do: a target pose that reacts to the force it feels.

#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Programs by name (`hand:?path=NAME`).
enum class HandPath : std::uint8_t {
  demo,    // approach, press, slide, twist, tap twice, retract, again
  rest,    // stay at the start, clutch held
  press,   // approach, press, hold the force
  slide,   // approach, press, slide there and back for ever
  tap,     // approach, then tap for ever
  circle,  // in the air, about the start, across the approach
  turn,    // in the air, about the approach, there and back for ever
};

enum class HandPhase : std::uint8_t {
  rest,
  approach,
  press,
  slide,
  twist,
  untwist,
  lift,
  tap,
  retract,
  circle,
  script,
  turn
};

/// One program. Lengths and speeds are in device space.
struct HandProgramParams {
  HandPath path = HandPath::demo;
  Pose start;                                  // handle pose at the start [device frame]
  Vec3 approach = -Vec3::UnitZ();              // unit; toward the scene [device frame]
  Vec3 slide = Vec3::UnitX();                  // unit, across the approach [device frame]
  double clearance = 0.02;                     // travel to first touch, as far as known [m]
  double reach = 0.06;                         // the target never goes deeper than this [m]
  double force = 1.0;                          // pressed with [N]
  double arm_stiffness = 400.0;                // turns a lack of force into a way to push [N/m]
  double speed = 0.05;                         // approach, retract [m/s]
  double tap_speed = 0.1;                      // [m/s]
  double slide_speed = 0.03;                   // [m/s]
  double slide_length = 0.010;                 // also the radius of `circle` [m]
  double twist_angle = 0.0872664625997164788;  // 5 degrees, about the approach; of `turn` too [rad]
  double twist_time = 0.5;                     // there; back the same [s]
  double lift_height = 0.005;                  // between taps [m]
  bool twist_by_buttons = false;  // the device senses no rotation: hold a turn button instead
};

/// Slide, lift and circle of at most `radius` / 5 of a grasped object of that radius [m; device
/// space], reach of 1.5 clearance + radius; larger objects keep the lengths above.
/// Thread    [offline].
HandProgramParams scale_to_object(HandProgramParams params, double radius);

/// What changes while a program runs.
struct HandProgram {
  HandPhase phase = HandPhase::rest;
  double phase_time = 0.0;       // since the phase began [s]
  double depth = 0.0;            // along the approach [m]
  double across = 0.0;           // along slide [m]
  double angle = 0.0;            // about the approach [rad]
  double speed = 0.0;            // of depth [m/s]
  double lift_depth = 0.0;       // where taps start [m]
  double from = 0.0;             // value of what moves when the phase began [m or rad]
  double steady_time = 0.0;      // since the force is right [s]
  double felt = 0.0;             // low-passed force beyond the baseline [N]
  Vec3 baseline = Vec3::Zero();  // felt in the air: weight, drag [N]
  int taps = 0;
  int rounds = 0;  // demo programs finished
};

/// Where the hand wants the handle to be.
struct HandTarget {
  Pose pose;  // [device frame]
  std::uint32_t buttons = 0;
};

/// Advances a program by dt.
///
/// force    what the device applies to the hand now [N; device frame]
/// dt       [s], >= 0
/// returns  the target at the end of dt; continuous in time, speeds bounded by those of params
/// Thread   [haptic]; no failure.
HandTarget advance_program(const HandProgramParams& params, const Vec3& force, double dt,
                           HandProgram& program) THIGMA_RT;

}  // namespace thigma
