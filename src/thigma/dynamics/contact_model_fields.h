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

/// The numbers of its friction, each where it is not zero.
template <class Term, class Visit>
void visit_friction(Term& term, Visit&& visit) {
  for (const FrictionNumber& f : kFrictionNumbers)
    visit.unless(f.key, term.friction.*f.number, 0.0);
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
  if (p.friction.at_rest > 0.0) visit("body", p.body);
}

/// The same of a DepthTerm.
template <class Term, class Visit>
void visit_depth(Term& t, Visit&& visit) {
  visit("depth", t.depth);
  visit.vector("linear", t.linear);
  visit.vector("angular", t.angular);
  visit_push(t, visit);
  visit_friction(t, visit);
  if (!(t.friction.at_rest > 0.0)) return;
  visit("body", t.body);
  visit.vector("arm_body", t.arm_body);
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
  visit.unless_zero("plane", r.plane);
  visit_friction(r, visit);
  visit.unless("body", r.body, std::int32_t{0});
}

}  // namespace thigma
