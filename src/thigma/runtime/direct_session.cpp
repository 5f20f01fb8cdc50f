#include "thigma/runtime/direct_session.h"

#include <algorithm>
#include <stdexcept>

#include "thigma/response/direct.h"

namespace thigma {

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

}  // namespace thigma
