#pragma once
// The fields of samples, one list for each message of a recording and one for tables: digests,
// writing, reading and the header of a table follow them. A new number of a haptic sample gets a
// line in the list of its message and one in the table's.

#include "thigma/loop/samples.h"

namespace thigma {

/// /device/state: what a frame was told; input_digest is of these.
template <class Sample, class Visit>
void visit_device_state(Sample& s, Visit&& visit) {
  visit("frame", s.frame);
  visit("time", s.time);
  visit("elapsed", s.elapsed);
  visit("sample_time", s.device.time);
  visit.pose(s.device.motion.pose);
  visit.twist(s.device.motion.twist);
  visit("buttons", s.device.buttons);
  visit("status", s.device.status);
  visit.unless("weight", s.device.weight, 1.0);
  visit.optional_pose("true_handle", s.device.has_true_handle, s.device.true_handle);
  visit.optional_pose("camera", s.device.has_camera, s.device.camera);
  visit("model_sequence", s.model_sequence);
  visit("external_fault", s.external_fault);
  visit.digest("input_digest", s.input_digest);
}

/// /device/command, after frame and time.
template <class Sample, class Visit>
void visit_device_command(Sample& s, Visit&& visit) {
  visit.wrench("force", "torque", s.command);
  visit.wrench("feedback_force", "feedback_torque", s.feedback);
}

/// /body/state, after frame and time.
template <class Sample, class Visit>
void visit_body_state(Sample& s, Visit&& visit) {
  visit.body(s.body);
  visit.motion("handle", s.handle);
  visit.wrench("coupling_force", "coupling_torque", s.coupling);
  visit.wrench("contact_force", "contact_torque", s.contact);
  visit("model_age", s.model_age);
  visit("model_weight", s.model_weight);
  visit("penetration", s.penetration);
  visit("stretch", s.stretch);
  visit("energy", s.energy);
  visit("touching", s.touching);
  visit("is_grasped", s.is_grasped);
  visit("is_armed", s.is_armed);
  visit("fault", s.fault);
  visit.unless("wanted_speed", s.wanted_speed, 0.0);
  visit.unless("solve_residual", s.solve_residual, 0.0);
  visit.unless("is_held_back", s.is_held_back, false);
  visit.unless("is_squeezed", s.is_squeezed, false);
  visit.pressing("pressing", s.pressing);
}

/// /timing, after frame and time.
template <class Sample, class Visit>
void visit_timing(Sample& s, Visit&& visit) {
  visit("step_cpu", s.step_cpu);
  visit("wake_late", s.wake_late);
}

/// /contact/frame, after the sequence.
template <class Sample, class Visit>
void visit_contact_frame(Sample& c, Visit&& visit) {
  visit("time", c.time);
  visit("published", c.published);
  visit("query_cpu", c.query_cpu);
  visit("step_cpu", c.step_cpu);
  visit("contacts", c.contacts);
  visit("dropped", c.dropped);
  visit("front", c.front);
  visit("tests", c.tests);
  visit("clusters", c.clusters);
  visit("depth_max", c.depth_max);
}

/// The rest of it: of levels of detail.
template <class Sample, class Visit>
void visit_contact_levels(Sample& c, Visit&& visit) {
  visit("mandatory_tests", c.mandatory_tests);
  visit("unrefined", c.unrefined);
  visit("level_changes", c.level_changes);
  visit("bound_max", c.bound_max);
  visit.counts("object_levels", c.object_levels);
  visit.counts("scene_levels", c.scene_levels);
}

/// The rest of it: of the constrained response, left out where all is 0.
template <class Sample, class Visit>
void visit_contact_rows(Sample& c, Visit&& visit) {
  visit.unless("rows", c.rows, std::int64_t{0});
  visit.unless("travel_halvings", c.travel_halvings, std::int32_t{0});
  visit.unless("left_out", c.left_out, std::int64_t{0});
  visit.unless("travel", c.travel, 0.0);
  visit.unless("look_ahead", c.look_ahead, 0.0);
  visit.unless("coarse", c.coarse, std::int64_t{0});
}

/// Columns of a table of haptic samples. A vector's columns are `name` + x, y, z(, w) + `unit`.
template <class Visit>
void visit_columns(const HapticSample& s, Visit&& visit) {
  visit("frame", s.frame);
  visit("time [s]", s.time);
  visit.vector("device ", " [m]", s.device.motion.pose.position);
  visit.vector("device q", "", s.device.motion.pose.orientation.coeffs());
  visit("buttons", s.device.buttons);
  visit.vector("body ", " [m]", s.body.position);
  visit.vector("body q", "", s.body.orientation.coeffs());
  visit.vector("P", " [kg m/s]", s.body.linear_momentum);
  visit.vector("L", " [kg m^2/s]", s.body.angular_momentum);
  visit.vector("contact f", " [N]", s.contact.force);
  visit.vector("contact t", " [N m]", s.contact.torque);
  visit.vector("command f", " [N]", s.command.force);
  visit.vector("command t", " [N m]", s.command.torque);
  visit.vector("feedback f", " [N]", s.feedback.force);
  visit.vector("feedback t", " [N m]", s.feedback.torque);
  visit("penetration [m]", s.penetration);
  visit("stretch [m]", s.stretch);
  visit("model age [s]", s.model_age);
  visit("energy [J]", s.energy);
  visit("touching", s.touching);
  visit("grasped", s.is_grasped);
  visit("armed", s.is_armed);
  visit("fault", s.fault);
  visit("step cpu [s]", s.step_cpu);
  visit("wake late [s]", s.wake_late);
  visit("wanted speed [m/s]", s.wanted_speed);
  visit("solve residual [m/s]", s.solve_residual);
  visit("held back", s.is_held_back);
  visit("squeezed", s.is_squeezed);
}

}  // namespace thigma
