#include "thigma/device/detail/hand_table.h"

namespace thigma::detail {
namespace {

// Upper ends are far beyond anything held in a hand; they keep a slip of the unit (mm for m) from
// passing.
#define THIGMA_HAND_FIELD(member) [](HandParams& p) -> double& { return p.member; }
constexpr HandNumber kNumbers[] = {
    {"mass", "kg", "of the handle", 0.0, 100.0, THIGMA_HAND_FIELD(mass)},
    {"damping", "N s/m", "of the device", 0.0, 1e4, THIGMA_HAND_FIELD(damping)},
    {"friction", "N", "Coulomb friction of the device", 0.0, 100.0, THIGMA_HAND_FIELD(friction)},
    {"encoder", "m", "step of the sensed position", 0.0, 0.01, THIGMA_HAND_FIELD(encoder)},
    {"inertia", "kg m^2", "of the handle", 0.0, 10.0, THIGMA_HAND_FIELD(inertia)},
    {"angular_damping", "N m s/rad", "of the device", 0.0, 100.0,
     THIGMA_HAND_FIELD(angular_damping)},
    {"angular_friction", "N m", "Coulomb friction of the device", 0.0, 10.0,
     THIGMA_HAND_FIELD(angular_friction)},
    {"angular_encoder", "rad", "step of the sensed orientation", 0.0, 0.1,
     THIGMA_HAND_FIELD(angular_encoder)},
    {"sampling", "Hz", "encoders are read this often, 0: at every read", 0.0, 16000.0,
     THIGMA_HAND_FIELD(sampling)},
    {"delay", "s", "age of a sample when it arrives", 0.0, 0.1, THIGMA_HAND_FIELD(delay)},
    {"jitter", "s", "added to the delay, uniform from 0 to this", 0.0, 0.1,
     THIGMA_HAND_FIELD(jitter)},
    {"velocity_window", "s", "longest window of the velocity estimate", 1e-6, 1.0,
     THIGMA_HAND_FIELD(velocity_window)},
    {"max_force", "N", "the actuators saturate here", 0.0, 1000.0, THIGMA_HAND_FIELD(max_force)},
    {"max_torque", "N m", "the actuators saturate here", 0.0, 100.0, THIGMA_HAND_FIELD(max_torque)},
    {"max_stiffness", "N/m", "what the device can render at 1 kHz", 0.0, 1e7,
     THIGMA_HAND_FIELD(max_stiffness)},
    {"max_angular_stiffness", "N m/rad", "what the device can render at 1 kHz", 0.0, 1e5,
     THIGMA_HAND_FIELD(max_angular_stiffness)},
    {"workspace_radius", "m", "of the device", 1e-3, 10.0, THIGMA_HAND_FIELD(workspace_radius)},
    {"arm_mass", "kg", "that moves with the handle", 0.0, 100.0, THIGMA_HAND_FIELD(arm_mass)},
    {"arm_stiffness", "N/m", "from the target to the handle", 0.0, 1e6,
     THIGMA_HAND_FIELD(arm_stiffness)},
    {"arm_damping", "N s/m", "from the target to the handle", 0.0, 1e4,
     THIGMA_HAND_FIELD(arm_damping)},
    {"arm_inertia", "kg m^2", "that turns with the handle", 0.0, 10.0,
     THIGMA_HAND_FIELD(arm_inertia)},
    {"arm_angular_stiffness", "N m/rad", "from the target to the handle", 0.0, 1e4,
     THIGMA_HAND_FIELD(arm_angular_stiffness)},
    {"arm_angular_damping", "N m s/rad", "from the target to the handle", 0.0, 100.0,
     THIGMA_HAND_FIELD(arm_angular_damping)},
    {"tremor", "m", "of the target, 8-12 Hz, root mean square; 0 on paths other than demo", 0.0,
     0.05, THIGMA_HAND_FIELD(tremor)},
    {"angular_tremor", "rad", "of the target, 8-12 Hz, root mean square", 0.0, 1.0,
     THIGMA_HAND_FIELD(angular_tremor)},
    {"force", "N", "pressed with", 1e-3, 100.0, THIGMA_HAND_FIELD(program.force)},
    {"speed", "m/s", "of approach and retract", 1e-4, 2.0, THIGMA_HAND_FIELD(program.speed)},
    {"tap_speed", "m/s", "of taps", 1e-4, 2.0, THIGMA_HAND_FIELD(program.tap_speed)},
    {"slide_speed", "m/s", "of the slide", 1e-4, 2.0, THIGMA_HAND_FIELD(program.slide_speed)},
    {"slide_length", "m", "of the slide, radius of the circle", 0.0, 1.0,
     THIGMA_HAND_FIELD(program.slide_length)},
    {"twist_angle", "rad", "of the twist", -1.5, 1.5, THIGMA_HAND_FIELD(program.twist_angle)},
    {"twist_time", "s", "there, and the same back", 0.0, 60.0,
     THIGMA_HAND_FIELD(program.twist_time)},
    {"lift_height", "m", "between taps", 0.0, 1.0, THIGMA_HAND_FIELD(program.lift_height)},
    {"clearance", "m", "travel to first touch", 0.0, 1e3, THIGMA_HAND_FIELD(program.clearance)},
    {"reach", "m", "the target never goes deeper", 0.0, 1e3, THIGMA_HAND_FIELD(program.reach)},
};
#undef THIGMA_HAND_FIELD

}  // namespace

std::span<const HandNumber> hand_numbers() { return kNumbers; }

}  // namespace thigma::detail
