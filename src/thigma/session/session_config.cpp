#include "thigma/session/session_config.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "thigma/constraint/build_constraints.h"
#include "thigma/response/direct.h"
#include "thigma/response/potential_contacts.h"

namespace thigma {
namespace {

/// As the hand feels them: a world newton per world metre is f s device newtons per device metre.
PassivityParams springs_of(const Workspace& workspace, double linear, double angular, double period,
                           double delay) THIGMA_RT {
  return passivity_for(linear * workspace.force_scale * workspace.motion_scale,
                       angular * torque_scale(workspace), period, delay);
}

}  // namespace

void enable_passivity(const DeviceLimits& device, SessionConfig& config) {
  HapticParams& params = config.haptic;
  const double period = 1.0 / config.rate;
  if (params.response == ResponseKind::direct) {
    // Contacts are the spring; their torque is that of forces at the object's surface and has none
    // of its own.
    params.passivity =
        springs_of(params.workspace, config.contact.response.stiffness, 0.0, period, device.delay);
    return;
  }
  params.passivity.period = period;
  params.passivity.delay = device.delay;
  retune_passivity(params);
}

void retune_passivity(HapticParams& params) THIGMA_RT {
  if (params.response == ResponseKind::direct) return;
  const PassivityParams& now = params.passivity;
  params.passivity = springs_of(params.workspace, params.coupling.linear_stiffness,
                                params.coupling.angular_stiffness, now.period, now.delay);
}

void use_direct_response(const DeviceLimits& device, SessionConfig& config) {
  const double max_force = std::min(device.max_force, config.haptic.safety.max_force);
  if (!(max_force > 0.0) || !(device.max_stiffness > 0.0)) {
    throw std::invalid_argument("direct response: the device renders no force");
  }
  const Workspace& workspace = config.haptic.workspace;
  config.contact.response = direct_penalty(
      {max_force, device.max_stiffness, workspace.motion_scale, workspace.force_scale});
  config.contact.tolerance = config.contact.response.tolerance;
  config.haptic.response = ResponseKind::direct;
}

void use_constraints(SessionConfig& config) {
  const auto refuse = [](const char* text) {
    throw std::invalid_argument(std::string("constrained response: ") + text);
  };
  ContactWorld& contact = config.contact;
  if (contact.object == nullptr || contact.scene.empty()) refuse("there are no surfaces");
  if (contact.source) refuse("contacts of a source are not known to it");
  ConstraintWorld world =
      make_constraint_world(*contact.object, contact.body_from_mesh, contact.scene);
  world.relief = find_relief_patches(contact.textures);
  if (!contact.textures.is_empty()) widen(world);
  contact.constraints = std::make_shared<const ConstraintWorld>(std::move(world));
  config.haptic.constraint.slop = contact.constraints->slop;
  config.haptic.response = ResponseKind::constrained;
}

void use_potential(SessionConfig& config) {
  const auto refuse = [](const std::string& text) {
    throw std::invalid_argument("potential response: " + text);
  };
  ContactWorld& contact = config.contact;
  const PotentialLaw& law = contact.potential_law;
  const auto is_above = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (contact.object == nullptr || contact.scene.empty()) refuse("there are no surfaces");
  if (contact.source) refuse("contacts of a source are not known to it");
  if (!is_above(contact.response.stiffness))
    refuse("stiffness " + std::to_string(contact.response.stiffness) +
           ", expected a number above 0 [N/m]");
  if (!is_above(law.area))
    refuse("area " + std::to_string(law.area) + ", expected a number above 0 [m^2]");
  if (law.exponent != 2 && law.exponent != 4)
    refuse("exponent " + std::to_string(law.exponent) + ", expected 2 or 4");
  contact.potential = std::make_shared<const PotentialWorld>(make_potential_world(
      *contact.object, contact.body_from_mesh, contact.scene, contact.textures));
  config.haptic.response = ResponseKind::potential;
}

}  // namespace thigma
