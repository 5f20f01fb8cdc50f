// Gains for a scene, or for a body in a device, as `thigma tune` proposes them.

#include "bind.h"

#include "thigma/core/error.h"
#include "thigma/scene/gain_task.h"
#include "thigma/scene/load_scene.h"

namespace thigma::python {
namespace {

py::dict to_dict(const GainChoice& choice) {
  py::dict limits;
  for (int i = 0; i < kGainLimits; ++i)
    limits[limit_name(static_cast<GainLimit>(i))] = choice.limits[static_cast<std::size_t>(i)];
  py::dict d;
  d["stiffness"] = choice.stiffness;
  d["damping"] = choice.damping;
  d["limit"] = choice.limit;
  d["binds"] = limit_name(choice.binds);
  d["limits"] = limits;
  return d;
}

py::dict to_dict(const GainProposal& proposal, const std::vector<GainWarning>& warnings) {
  py::list list;
  for (const GainWarning& w : warnings) {
    py::dict d;
    d["gain"] = w.gain;
    d["value"] = w.value;
    d["limit"] = w.limit;
    d["text"] = w.text;
    list.append(std::move(d));
  }
  py::dict d;
  d["linear"] = to_dict(proposal.linear);
  d["angular"] = to_dict(proposal.angular);
  d["contact"] = to_dict(proposal.contact);
  d["max_force"] = proposal.max_force;
  d["max_torque"] = proposal.max_torque;
  d["warnings"] = list;
  return d;
}

py::dict tune_scene(const Scene& scene, const std::string& device, double delay) {
  const py::gil_scoped_release unlocked;
  const DevicePort port = describe_device(device.empty() ? scene.description.device.uri : device);
  SceneDescription description = scene.description;
  description.device.uri = device.empty() ? description.device.uri : device;
  description.contact.response = scene.config.haptic.response;
  const ClodAsset& object = *scene.object;
  const SessionConfig config = make_session_config(
      description, {object.mass.measure, {object.hierarchy.center, object.hierarchy.radius}});
  const HapticParams& haptic = config.haptic;
  GainTask task = gain_task(port, haptic.body, haptic.workspace, description.rate, haptic.response);
  if (delay >= 0.0) task.delay = delay;
  const GainProposal proposal = propose_gains(task);
  const PenaltyParams& contact = config.contact.response;
  const std::vector<GainWarning> warnings =
      check_gains(task, proposal, haptic.coupling, contact.stiffness, contact.damping);
  const py::gil_scoped_acquire locked;
  return to_dict(proposal, warnings);
}

py::dict tune_body(const std::string& device, double mass, const Doubles& moments,
                   const py::dict& options) {
  const DevicePort port = describe_device(device);
  const double* i = moments.data();
  const Mat3 inertia = Vec3(i[0], i[1], i[2]).asDiagonal();
  if (!(mass > 0.0) || !std::isfinite(mass))
    throw InputError("tune: mass must be a number above 0 [kg]");
  for (int k = 0; k < 3; ++k)
    if (!(i[k] > 0.0) || !std::isfinite(i[k]))
      throw InputError("tune: inertia must be one moment above 0, or three [kg m^2]");
  const auto response = response_of(options["response"].cast<std::string>());
  if (!response) throw InputError("tune: response must be penalty, constraint or direct");
  const Workspace workspace =
      stiffness_keeping_workspace(Pose{}, options["motion_scale"].cast<double>());
  GainTask task = gain_task(port, make_body(mass, inertia), workspace,
                            options["rate"].cast<double>(), *response);
  if (const auto delay = options["delay"].cast<double>(); delay >= 0.0) task.delay = delay;
  return to_dict(propose_gains(task), {});
}

}  // namespace

void bind_tune(py::module_& module) {
  module.def("tune_scene", &tune_scene);
  module.def("tune_body", &tune_body);
}

}  // namespace thigma::python
