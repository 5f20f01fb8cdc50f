#pragma once
// The fields of a recorded configuration, one list for each struct: writing and reading follow it.
// Numbers, flags and whole numbers go to visit(key, value), the rest to a member of visit named
// after its form; config_json.cpp has both visitors.

#include "thigma/loop/safety_fields.h"
#include "thigma/recording/config_json.h"

namespace thigma::detail {

/// inverse_inertia follows from the rest.
template <class Body, class Visit>
void visit_body_fields(Body& b, Visit&& visit) {
  visit("mass", b.mass);
  visit.rows("inertia", b.inertia);
  visit.vector("gravity", b.gravity);
}

template <class Spring, class Visit>
void visit_saturation(Spring& s, Visit&& visit) {
  visit("stiffness", s.stiffness);
  visit("linear_range", s.linear_range);
  visit("full_range", s.full_range);
  visit("max_force", s.max_force);
}

/// But for the grasp, which the step sets.
template <class Springs, class Visit>
void visit_coupling(Springs& c, Visit&& visit) {
  const auto saturation = [](auto& s, auto& inner) { visit_saturation(s, inner); };
  visit("linear_stiffness", c.linear_stiffness);
  visit("linear_damping", c.linear_damping);
  visit("angular_stiffness", c.angular_stiffness);
  visit("angular_damping", c.angular_damping);
  visit.optional("linear_saturation", c.linear_saturation, saturation);
  visit.optional("angular_saturation", c.angular_saturation, saturation);
}

template <class Space, class Visit>
void visit_workspace(Space& w, Visit&& visit) {
  visit.pose("world_from_device", w.world_from_device);
  visit("motion_scale", w.motion_scale);
  visit("force_scale", w.force_scale);
}

template <class Limits, class Visit>
void visit_safety(Limits& s, Visit&& visit) {
  visit_safety_limits(s, visit);
  visit("rides_out_gaps", s.rides_out_gaps);
}

template <class Limits, class Visit>
void visit_device_limits(Limits& d, Visit&& visit) {
  visit("max_force", d.max_force);
  visit("max_torque", d.max_torque);
  visit("max_stiffness", d.max_stiffness);
  visit("max_angular_stiffness", d.max_angular_stiffness);
  visit("workspace_radius", d.workspace_radius);
  visit("senses_translation", d.senses_translation);
  visit("senses_rotation", d.senses_rotation);
  visit("actuates_translation", d.actuates_translation);
  visit("actuates_rotation", d.actuates_rotation);
  visit.flag_for("device_clock", d.clock, DeviceClock::device, DeviceClock::engine);
  visit("delay", d.delay);
  visit("holds_person", d.holds_person);
}

template <class Params, class Visit>
void visit_passivity(Params& p, Visit&& visit) {
  visit("period", p.period);
  visit("delay", p.delay);
  visit("max_damping", p.max_damping);
  visit("max_angular_damping", p.max_angular_damping);
  visit("stiffness", p.stiffness);
  visit("angular_stiffness", p.angular_stiffness);
  visit("acceleration", p.acceleration);
  visit("angular_acceleration", p.angular_acceleration);
  visit("velocity_lag", p.velocity_lag);
  visit("credit", p.credit);
}

/// What no haptic frame depends on; what is infinite, as a cap that is off, is null in JSON.
template <class Params, class Visit>
void visit_resolution(Params& r, Visit&& visit) {
  visit("exact", r.is_exact);
  visit("haptic", r.metric.haptic);
  visit("velocity", r.metric.velocity);
  visit.view("view", r.metric.view);
  visit.cap("deviation_cap", r.deviation_cap);
  visit("coarsest_level", r.coarsest_level);
  visit.word("support", r.reading, {"one_ring", "flood", "patch"});
  visit.word("area", r.area, {"larger", "smaller"});
  visit("interpolates", r.interpolates);
  visit("budget_tests", r.budget_tests);
  visit("budget_cpu", r.budget_cpu);
  visit.unless("carry", r.carry, 0.0);
}

template <class Params, class Visit>
void visit_constraint(Params& p, Visit&& visit) {
  visit("slop", p.slop);
  visit("recovery", p.recovery);
  visit("recovery_speed", p.recovery_speed);
}

template <class Params, class Visit>
void visit_haptic_params(Params& p, Visit&& visit) {
  visit.object("body", p.body, [](auto& b, auto& v) { visit_body_fields(b, v); });
  visit.object("coupling", p.coupling, [](auto& c, auto& v) { visit_coupling(c, v); });
  visit.object("workspace", p.workspace, [](auto& w, auto& v) { visit_workspace(w, v); });
  visit.object("safety", p.safety, [](auto& s, auto& v) { visit_safety(s, v); });
  visit.object("device_limits", p.device, [](auto& d, auto& v) { visit_device_limits(d, v); });
  visit.word("grasp_place", p.grasp_place, {"grasp_point", "handle"});
  visit.vector("grasp_point", p.grasp_point);
  visit("turn_rate", p.turn_rate);
  visit.word("response", p.response, {"coupled", "direct", "constrained", "potential"});
  visit.object("constraint", p.constraint, [](auto& c, auto& v) { visit_constraint(c, v); });
  visit.impacts("impacts", p.impacts);
  visit("resumes_lost_device", p.resumes_lost_device);
  visit.object_if("passivity", p.passivity.is_on, p.passivity,
                  [](auto& s, auto& v) { visit_passivity(s, v); });
}

/// After the version.
template <class Config, class Visit>
void visit_config(Config& c, Visit&& visit) {
  visit.text("scene", c.scene);
  visit.text("device", c.device);
  visit("rate_hz", c.rate_hz);
  visit("lockstep", c.is_lockstep);
  visit("simulated", c.is_simulated);
  visit.digits("seed", c.seed);
  visit.pose("world_from_body", c.world_from_body);
  visit_haptic_params(c.params, visit);
  visit.object("resolution", c.resolution, [](auto& r, auto& v) { visit_resolution(r, v); });
  visit.frictions("friction", c.friction);
}

}  // namespace thigma::detail
