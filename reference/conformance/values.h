#pragma once
// From the vocabulary of the reference vectors to the engine's types.

#include <optional>
#include <vector>

#include "reference/conformance/json_fields.h"
#include "reference/textured_point.h"

#include "thigma/dynamics/coupling.h"
#include "thigma/dynamics/linear_contact_model.h"

namespace thigma::app {

Quat read_quaternion(const JsonField& field);
RigidBody read_body(const JsonField& field);
BodyState read_state(const JsonField& field);
Saturation read_saturation(const JsonField& field);
Coupling read_coupling(const JsonField& field);
Motion read_device(const JsonField& field);

/// A plane of a case, which may be glued to.
struct CasePlane {
  PlaneTerm term;
  bool is_glued = false;  // pulls as well (reference/glued_plane.h)
};
CasePlane read_plane(const JsonField& field);
PlaneForce plane_force(const CasePlane& plane, const BodyAtState& at, WrenchJacobian* jacobian);

TexturedPoint read_textured_point(const JsonField& field);

inline Vec6 to_vector(const Wrench& wrench) {
  Vec6 v;
  v << wrench.force, wrench.torque;
  return v;
}

/// Everything that may act on a body in a case, but gravity.
struct CaseForces {
  std::optional<Coupling> coupling;
  std::vector<CasePlane> planes;
  std::vector<TexturedPoint> textures;
};

/// coupling (absent or null: none), contacts and textures of a case.
CaseForces read_forces(const JsonField& in);

/// Their sum at a state; the textures' Jacobian is the exact one.
Wrench sum_forces(const CaseForces& forces, const Motion& device, const RigidBody& body,
                  const BodyState& state, WrenchJacobian* jacobian) THIGMA_RT;

}  // namespace thigma::app
