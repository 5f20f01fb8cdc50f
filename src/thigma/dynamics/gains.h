#pragma once
// Gains of coupling and contact from what is known beforehand: device, object, rate and delay.
// docs/gains.md has the reasons, docs/journal/gains.md a table.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "thigma/dynamics/coupling.h"

namespace thigma {

/// What one half of a device brings into the loop: lengths in [m] or [rad], forces in [N] or [N m];
/// device frame. 0: not known, and then it limits nothing.
struct PortHalf {
  double max_effort = 0.0;     // norm of what it can exert
  double max_stiffness = 0.0;  // published, at 1 kHz without delay
  double mass = 0.0;           // of the handle
  double damping = 0.0;        // of the device
  double friction = 0.0;       // Coulomb
  double encoder = 0.0;        // step of what is sensed
};

/// What gains are for.
struct GainTask {
  RigidBody body;                   // the grasped object
  double rate = 1000.0;             // of haptic frames [Hz]
  double delay = 0.0;               // of device samples beyond the frame they are read in [s]
  double motion_scale = 1.0;        // s [virtual m / device m]
  double force_scale = 1.0;         // f [device N / virtual N]
  PortHalf linear, angular;         // of the device
  bool has_device_rotation = true;  // rotation is sensed and actuated: the angular spring is felt
  // contacts are inequalities (docs/constraints.md): no contact stiffness; against a contact the
  // object stays where it is
  bool is_constrained = false;
};

/// What a stiffness is limited by.
enum class GainLimit : std::uint8_t {
  device,  // published stiffness, less at lower rates and with delay: K T_0 / (T + 2 delay)
  // encoder steps that Coulomb friction still swallows: 2 f_c / D (docs/sources.md, E3, check 3)
  friction,
  // the sampled loop with the handle's mass, in the air and against a contact (sampled_loop.h)
  loop,
  frames,  // a radian a frame: beyond it a contact found one frame late throws the object back
};
inline constexpr int kGainLimits = 4;

/// "device", "friction", "loop", "frames".
const char* limit_name(GainLimit limit) noexcept;

/// A stiffness with its critical damping, virtual world: [N/m, N s/m] or [N m/rad, N m s/rad].
struct GainChoice {
  double stiffness = 0.0;  // kGainMargin * limit
  double damping = 0.0;    // 2 sqrt(stiffness * mass)
  double limit = 0.0;      // the least of `limits`
  GainLimit binds = GainLimit::frames;
  std::array<double, kGainLimits> limits{};  // by GainLimit; infinity: does not apply
};

/// Share of its limit that a stiffness is proposed at, so that twice the proposal is beyond it.
inline constexpr double kGainMargin = 0.6;

struct GainProposal {
  GainChoice linear, angular;  // k_c b_c, k_theta b_theta
  GainChoice contact;          // k b; stiffness 0 and no limit where contacts are constraints
  double max_force = 0.0;      // where the linear spring levels off [N; virtual]; 0: device unknown
  double max_torque = 0.0;  // the angular one [N m; virtual]; 0: device unknown or without torque
};

/// Largest stiffnesses with a margin, each critically damped. Angular damping and the frame limit
/// go by the largest principal moment about the centre of mass, so that no axis is left
/// underdamped.
///
/// errors   InputError naming what is not positive
/// Thread   [offline].
/// Source   Sec. 2.2 and 5.5; docs/sources.md, E3.
GainProposal propose_gains(const GainTask& task);

/// One gain that lies outside, or combination that does.
struct GainWarning {
  std::string gain;    // as a scene names it: "linear_stiffness", "damping_ratio", ...
  double value = 0.0;  // [its unit]
  double limit = 0.0;  // that it should not pass [same unit]
  std::string text;    // one sentence
};

/// What is outside in gains that a scene or a person chose; empty when nothing is.
/// `coupling.linear_saturation` and the angular one are looked at where they are set.
///
/// proposal           propose_gains(task)
/// contact_stiffness  of all contacts together [N/m]; not looked at where they are constraints
/// contact_damping    of all contacts together [N s/m]; likewise
/// Thread             [offline].
std::vector<GainWarning> check_gains(const GainTask& task, const GainProposal& proposal,
                                     const Coupling& coupling, double contact_stiffness,
                                     double contact_damping);

}  // namespace thigma
