#pragma once
// Whether the HD library takes a torque in N m or in mN m: public code disagrees, a factor of 1000.

namespace thigma {

struct CalibrationTalk;

namespace detail {

struct HdLibrary;

/// The torques that are tried, one step after the other, each growing from what the step before
/// has shown to be nothing. In N m the second is a firm twist of a stylus, and what is felt at all
/// is felt there; in mN m the last is the same. [vendor's unit]
inline constexpr double kTorqueSteps[] = {0.01, 0.05, 0.2, 0.8, 3.0, 12.0, 50.0};

/// How fast a torque grows within a step.
struct TorqueRamp {
  double rise = 0.3;    // to what the step before has shown to be nothing [s]
  double growth = 4.0;  // from there to the end of the step [s]
};

/// Finds out with the person who holds the stylus. A torque is there only while the button of the
/// stylus is held, and grows by half a second; it is zero from the frame on in which the button is
/// let go, the stylus has turned by 0.1 rad, the library tells an error, or the talk is stopped.
/// Forces are off while a question is asked, and without a yes to it nothing stronger is tried.
///
/// device   initialised, of six outputs
/// returns  what the library takes for 1 N m: 1 or 1000; 0: not found
/// errors   DeviceUnavailable
/// Thread   [offline]; a step takes 5 s at most, its button is waited for 20 s at most.
double find_torque_unit(const HdLibrary& library, unsigned device, const CalibrationTalk& talk,
                        const TorqueRamp& ramp = {});

}  // namespace detail
}  // namespace thigma
