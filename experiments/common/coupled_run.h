#pragma once
// A recorded motion of the handle played through coupling, contacts and any integrator, without a
// hand that feels it: the experiments of Sec. 5.5.

#include <span>
#include <vector>

#include "experiments/common/session_pair.h"

#include "thigma/dynamics/constraint_model.h"
#include "thigma/dynamics/explicit_step.h"
#include "thigma/loop/contact_step.h"

namespace thigma::experiments {

/// How a motion is played.
struct CoupledSetup {
  RigidBody body;
  Coupling coupling;  // grasped, with its grasp frame
  BodyState start;
  Integrator integrator = Integrator::implicit_tangent;
  double period = 1e-3;  // of the haptic frames [s]
  ContactWorld contact;  // neither scene nor source: free space
  // haptic frames from one contact frame to the next, a new model being used a frame later
  int contact_every = 1;
  // of the constrained response, which is played where `contact` has constraints, whatever
  // integrator is named; its steps are implicit
  ConstraintParams constraint{};
  // false: contact forces are held from one model to the next, without a Jacobian
  bool is_linearized = true;
};

/// One haptic frame.
struct CoupledFrame {
  BodyState body;
  Wrench coupling, contact;          // on the object about its centre of mass [world]
  double stretch = 0.0, turn = 0.0;  // of the coupling [m, rad]
  std::int64_t contacts = 0;         // of the model in use
  double level = 0.0;                // mean level of detail of both surfaces in them, 0 the finest
};

/// Frames until the motion ends or the object is gone: more than a metre from the handle, or not
/// finite.
/// Thread    [offline].
std::vector<CoupledFrame> run_coupled(const CoupledSetup& setup, std::span<const Motion> handle);

/// The handle's motion in the scene while the simulated hand leads a session, from `before` seconds
/// ahead of the first touch on; and the object as it was then.
struct LedMotion {
  std::vector<Motion> handle;
  BodyState start;
  Pose body_from_grasp;
  double first_touch = 0.0;  // within the motion [s]
};
/// uri       of the hand: "hand:?path=slide&force=1"
/// errors    std::runtime_error where the hand never touches anything
LedMotion lead(const SessionPair& session, const std::string& uri, double before, double seconds);

/// Body, gains and contacts of a session for a motion it was led along.
CoupledSetup setup_of(const SessionPair& session, const LedMotion& motion);

/// Root mean square of what is faster than 20 Hz in frames [from, to).
double ripple(std::span<const double> values, std::size_t from, std::size_t to, double period);

/// Motion along poses a period apart, with velocities by central differences.
std::vector<Motion> motion_along(std::span<const Pose> poses, double period);

/// Depth between exact meshes, as an exact query says, of every `stride`-th frame: 0 where they are
/// apart [m].
std::vector<double> exact_depths(const ContactWorld& world, std::span<const CoupledFrame> frames,
                                 int stride, double tolerance);

/// Norms of a wrench's force over frames [N].
std::vector<double> coupling_force(std::span<const CoupledFrame> frames);
std::vector<double> contact_force(std::span<const CoupledFrame> frames);

/// Contacts of a point at the object's origin with the floor z = 0: a source for ContactWorld.
void point_on_floor(const Pose& at, double tolerance, ContactSet& set);

}  // namespace thigma::experiments
