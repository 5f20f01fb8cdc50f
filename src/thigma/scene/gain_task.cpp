#include "thigma/scene/gain_task.h"

#include "thigma/device/hand.h"
#include "thigma/device/open_device.h"
#include "thigma/device/web_device.h"

namespace thigma {
namespace {

DevicePort port_of_limits(const HapticDevice& device) {
  DevicePort port;
  port.name = device.name();
  port.limits = device.limits();
  return port;
}

DevicePort port_of_hand(const std::string& uri) {
  const std::size_t query = uri.find('?');
  const HandParams hand = parse_hand(
      query == std::string::npos ? std::string_view() : std::string_view(uri).substr(query + 1));
  DevicePort port = port_of_limits(*make_hand(hand));
  port.linear.mass = hand.mass;
  port.linear.damping = hand.damping;
  port.linear.friction = hand.friction;
  port.linear.encoder = hand.encoder;
  port.angular.mass = hand.inertia;
  port.angular.damping = hand.angular_damping;
  port.angular.friction = hand.angular_friction;
  port.angular.encoder = hand.angular_encoder;
  port.delay = hand.delay + hand.jitter + (hand.sampling > 0.0 ? 1.0 / hand.sampling : 0.0);
  return port;
}

DevicePort open_port(const std::string& uri) {
  const std::string scheme = device_scheme(uri);
  if (scheme == "hand") return port_of_hand(uri);
  if (scheme == "web") {
    const auto link = std::make_unique<WebDeviceChannel>();
    return port_of_limits(*make_web_device(*link, {}));
  }
  if (scheme != "replay") {
    DevicePort port = port_of_limits(*open_device(uri));
    port.delay = port.limits.delay;  // as its driver measured it
    return port;
  }
  DevicePort port;  // its forces are felt by nobody
  port.name = "replay";
  return port;
}

}  // namespace

DevicePort describe_device(const std::string& uri) {
  DevicePort port = open_port(uri);
  port.linear.max_effort = port.limits.max_force;
  port.linear.max_stiffness = port.limits.max_stiffness;
  port.angular.max_effort = port.limits.max_torque;
  port.angular.max_stiffness = port.limits.max_angular_stiffness;
  return port;
}

GainTask gain_task(const DevicePort& port, const RigidBody& body, const Workspace& workspace,
                   double rate, ResponseKind response) {
  GainTask task;
  task.is_constrained = response == ResponseKind::constrained;
  task.body = body;
  task.rate = rate;
  task.delay = port.delay;
  task.motion_scale = workspace.motion_scale;
  task.force_scale = workspace.force_scale;
  task.linear = port.linear;
  task.angular = port.angular;
  task.has_device_rotation = port.limits.senses_rotation && port.limits.actuates_rotation;
  return task;
}

void fill_gains(const GainProposal& proposal, SceneDescription& scene) {
  CouplingGains& coupling = scene.coupling;
  const bool has_ratio = coupling.damping_ratio.has_value();
  const auto fill = [](const GainChoice& choice, bool is_damped, std::optional<double>& stiffness,
                       std::optional<double>& damping) {
    if (stiffness) return;  // its damping, too, is the scene's business
    stiffness = choice.stiffness;
    if (!damping && !is_damped) damping = choice.damping;
  };
  fill(proposal.linear, has_ratio, coupling.linear_stiffness, coupling.linear_damping);
  fill(proposal.angular, has_ratio, coupling.angular_stiffness, coupling.angular_damping);
  if (proposal.contact.stiffness > 0.0)
    fill(proposal.contact, scene.contact.damping_ratio.has_value(), scene.contact.stiffness,
         scene.contact.damping);
  if (!coupling.max_force && proposal.max_force > 0.0) coupling.max_force = proposal.max_force;
  if (!coupling.max_torque && proposal.max_torque > 0.0) coupling.max_torque = proposal.max_torque;
}

}  // namespace thigma
