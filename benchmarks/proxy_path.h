#pragma once
// The path that a constrained object takes in a simulated hand, for whoever asks the same queries.

#include <functional>
#include <string>
#include <vector>

#include "thigma/loop/haptic_step.h"
#include "thigma/loop/samples.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/scene/load_scene.h"

namespace thigma::bench {

/// A scene whose object is kept outside by rows, whatever response the scene names.
struct ProxyScene {
  Scene scene;
  bool is_default = false;  // the scene itself has this response
};

/// What a built-in scene is opened with.
struct ProxyRequest {
  std::string scene;
  int triangles = 0;            // of each model; 0: its own
  bool has_levels_far = false;  // coarse contacts where they are far apart, at s0 = 2.5 %
};

/// Throws InputError where a scene cannot be asked beside the point shell: nobody holds its object,
/// there are several others, or something has relief. Thread [offline].
void check_can_measure(const SceneDescription& scene, const std::string& name);

/// Loads a scene, one that check_can_measure lets pass. Thread [offline]; throws InputError.
ProxyScene load_proxy_scene(const ProxyRequest& request);

/// A session's configuration, and the hand that will hold its object.
/// scene   outlives it
/// Thread  [offline]; throws InputError
SceneSession open_proxy_session(const ProxyScene& scene);

/// Makes the model of a contact frame: contact_step, or what takes its place.
using ContactMaker = std::function<void(const StampedBody& body, ContactSample& sample)>;

/// What a session was.
struct PlayedSession {
  std::vector<StampedBody> bodies;    // of the contact frames, the first before any haptic frame
  std::vector<Vec3> forces;           // sent to the hand, one a haptic frame [N; device frame]
  std::vector<std::uint64_t> models;  // digests, one a contact frame
};

/// Runs a session in lockstep: one contact frame after each haptic frame, its model in use in the
/// next. With contact_step as its maker, bit for bit what run_lockstep does.
///
/// session   its device is at its start, and has moved afterwards
/// seconds   of the session clock, > 0
/// Thread    [offline]
PlayedSession play_session(SceneSession& session, double seconds, const ContactMaker& maker);

/// RMS of the difference of two sessions' forces, frame by frame, over the RMS of the second's.
double force_error(const PlayedSession& played, const PlayedSession& exact);

}  // namespace thigma::bench
