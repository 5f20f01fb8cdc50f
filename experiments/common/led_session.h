#pragma once
// A session of two meshes under a hand that goes where a script says, whatever it feels: the
// engine's own loop on a virtual clock, with no limit of a device in the way.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/session/session.h"

namespace thigma::experiments {

/// Two exact surfaces. The object's frame is at its centre of mass, the scene's at the world's.
struct LedPair {
  std::string name{};
  TriangleMesh object{}, scene{};
  std::shared_ptr<const ClodHierarchy> object_levels{}, scene_levels{};
  Pose start{};             // of the object, apart from the scene
  double tolerance = 0.0;   // d of the penalty [m]
  double mass = 0.05;       // [kg]
  double reach = 0.0;       // of the object's farthest vertex from its centre of mass [m]
  double clearance = 1e-3;  // from start to the first touch, about [m]
};

/// object  any frame: it is moved to its centre of mass, and start with it
/// scene   in the world
/// Thread  [offline]
LedPair make_led_pair(std::string name, TriangleMesh object, TriangleMesh scene, Pose start);

/// The same pair, its start moved against `towards` until the surfaces stand `clearance` apart.
LedPair placed_apart(LedPair pair, const Vec3& towards, double clearance);

/// How a pair is felt.
struct LedGains {
  bool is_constrained = true;
  bool is_potential = false;  // the potential law instead of either, k of contact_stiffness
  int every = 1;              // haptic frames from one contact frame to the next
  int latency = 1;            // haptic frames until a model is used
  double friction = 0.0;
  double stiffness = 1000.0, damping = 2.0;               // of the coupling [N/m, N s/m]
  double angular_stiffness = 0.5, angular_damping = 0.0;  // 0: ratio 0.7 [N m/rad, N m s/rad]
  double contact_stiffness = 5000.0;                      // of the penalty [N/m]
  double threshold = 0.0;  // s0 of levels far away, under constraints; 0: exact
};

/// The same pair with levels of detail of both surfaces, which take their time to build.
LedPair with_levels(LedPair pair);

/// The session of a pair: springs linear, no limit on speeds and forces, armed in the first frame
/// that nothing touches.
SessionConfig led_config(const LedPair& pair, const LedGains& gains, double seconds);

/// Where the handle is at a time [world]; continuous.
using HandPath = std::function<Pose(double)>;

/// What a frame of the constrained response was, computed again outside the session from what the
/// session says it had.
struct LedStep {
  bool is_known = false;  // of a grasped object under constraints
  bool is_held_back = false;
  int rows = 0, active = 0;
  int active_edges = 0;          // of those that press, rows of two edges
  std::uint64_t active_set = 0;  // of the rows that press in the exact solution: which they are
  double cpu = 0.0;              // of the whole step [s]
  double travel = 0.0;           // of the model [m]
  bool is_same = false;          // the body comes out bit for bit as in the session
};

/// Called every frame.
using LedLook = std::function<void(const HapticSample&, const LedStep&)>;

/// What a run was like.
struct LedRun {
  SessionSummary summary;
  int frames = 0, held_back = 0;
  int unlike = 0;  // frames that come out otherwise when they are computed again
  std::vector<double> query, solve, rows;     // CPU of contact steps and of steps [s]; rows a model
  std::vector<double> travel;                 // of the models [m]
  std::vector<double> coarse;                 // pairs a model that stay coarse
  double energy_end = 0.0, energy_min = 0.0;  // [J]
};

/// Runs a session; `look` may be empty.
/// Thread [offline]
LedRun run_led(const SessionConfig& config, const HandPath& hand, const LedLook& look = {});

}  // namespace thigma::experiments
