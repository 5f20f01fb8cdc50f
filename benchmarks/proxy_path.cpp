#include "benchmarks/proxy_path.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/core/latest.h"
#include "thigma/scene/scene_file.h"

namespace thigma::bench {

void check_can_measure(const SceneDescription& scene, const std::string& name) {
  if (scene.simulation)
    throw InputError(name + ": nobody holds its object, expected a scene without [simulation]");
  if (scene.statics.size() != 1)
    throw InputError(name + ": " + std::to_string(scene.statics.size()) +
                     " static objects, expected one: the point shell is of two surfaces");
  if (has_relief(scene))
    throw InputError(name + ": has relief, expected a scene without: the point shell has none");
}

ProxyScene load_proxy_scene(const ProxyRequest& request) {
  SceneDescription description = read_scene(request.scene);
  ProxyScene out;
  const ResponseKind own =
      description.contact.response.value_or(default_response(description, true));
  out.is_default = own == ResponseKind::constrained;
  description.contact.response = ResponseKind::constrained;
  description.contact.has_levels_far = request.has_levels_far;
  const auto resize = [&](SceneObject& object) {
    if (request.triangles > 0 && object.model) object.model->triangles = request.triangles;
  };
  resize(description.object);
  for (SceneObject& other : description.statics) resize(other);
  out.scene = load_scene(std::move(description));
  return out;
}

SceneSession open_proxy_session(const ProxyScene& scene) {
  return open_session(scene.scene, {.device = "hand:"});
}

PlayedSession play_session(SceneSession& session, double seconds, const ContactMaker& maker) {
  const SessionConfig& config = session.config;
  HapticParams params = config.haptic;
  use_device_limits(session.device->limits(), params);
  HapticState state = initial_state(params, config.world_from_body);
  // Models are large.
  const auto models = std::make_unique<Latest<LinearContactModel>>();
  const auto sample = std::make_unique<ContactSample>();
  Latest<StampedBody> bodies;
  PlayedSession played;
  const auto step_contacts = [&](const StampedBody& body) {
    maker(body, *sample);
    played.bodies.push_back(body);
    played.models.push_back(sample->model_digest);
    models->publish(sample->model);
  };
  step_contacts({state.body, 0.0, 0});
  const auto frames = static_cast<std::uint64_t>(std::llround(seconds * config.rate));
  for (std::uint64_t k = 0; k < frames; ++k) {
    const HapticTick tick{static_cast<double>(k) / config.rate, 1.0 / config.rate};
    const HapticSample frame =
        haptic_step(params, {session.device.get(), models.get(), &bodies}, tick, state);
    played.forces.push_back(frame.command.force);
    bodies.fetch();
    step_contacts(bodies.value());
  }
  session.device->write(Wrench{});
  return played;
}

double force_error(const PlayedSession& played, const PlayedSession& exact) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < std::min(played.forces.size(), exact.forces.size()); ++i) {
    error += (played.forces[i] - exact.forces[i]).squaredNorm();
    size += exact.forces[i].squaredNorm();
  }
  return size > 0.0 ? std::sqrt(error / size) : 0.0;
}

}  // namespace thigma::bench
