#pragma once
// The fields of the terms of a contact model: recordings and digests follow these lists.

#include "thigma/dynamics/linear_contact_model.h"

namespace thigma {

/// How hard a term pushes, and which one it is.
template <class Term, class Visit>
void visit_push(Term& term, Visit&& visit) {
  visit("stiffness", term.stiffness);
  visit("damping", term.damping);
  visit("tolerance", term.tolerance);
  visit("id", term.id);
}

/// Its friction, where it has any.
template <class Term, class Visit>
void visit_friction(Term& term, Visit&& visit) {
  visit.unless("static_friction", term.static_friction, 0.0);
  if (!(term.static_friction > 0.0)) return;
  visit("friction", term.friction);
  visit("body", term.body);
}

/// Calls visit(key, number) and visit.vector(key, vector) for every field of a PlaneTerm.
template <class Term, class Visit>
void visit_plane(Term& p, Visit&& visit) {
  visit.vector("arm_body", p.arm_body);
  visit.vector("normal", p.normal);
  visit.vector("scene_point", p.scene_point);
  visit.vector("scene_velocity", p.scene_velocity);
  visit_push(p, visit);
  visit_friction(p, visit);
}

/// The same of a DepthTerm.
template <class Term, class Visit>
void visit_depth(Term& t, Visit&& visit) {
  visit("depth", t.depth);
  visit.vector("linear", t.linear);
  visit.vector("angular", t.angular);
  visit_push(t, visit);
  visit_friction(t, visit);
  if (t.static_friction > 0.0) visit.vector("arm_body", t.arm_body);
}

/// The same of a ContactRow.
template <class Row, class Visit>
void visit_row(Row& r, Visit&& visit) {
  visit("kind", r.kind);
  visit.digest("id", r.id);
  visit.vector("object_point", r.object_point);
  visit.vector("scene_point", r.scene_point);
  visit.vector("object_direction", r.object_direction);
  visit.vector("scene_direction", r.scene_direction);
  visit("friction", r.friction);
  visit.unless("static_friction", r.static_friction, r.friction);
  visit.unless("body", r.body, std::int32_t{0});
}

}  // namespace thigma
