#include <algorithm>
#include <cmath>

#include "reference/conformance/conformance.h"
#include "reference/conformance/values.h"
#include "reference/offset_surface.h"
#include "reference/taylor_term.h"

namespace thigma::app {
namespace {

// Steps for central differences of a relief: 1e-4 of a wave, or of the lever arm where there is no
// wave.
double difference_step(const TexturedPoint& probe) {
  const double wave = std::max(std::fabs(probe.plate.wave_u), std::fabs(probe.plate.wave_v));
  const double arm = probe.arm_body.norm();
  if (wave > 0.0) return 6e-4 / wave;
  return arm > 0.0 ? 1e-4 * arm : 1e-6;
}

Wrench wrench_by_differences(const TexturedPoint& probe, const BodyState& state) {
  Mat3 basis;
  basis << probe.plate.u.transpose(), probe.plate.v.transpose(), probe.plate.n.transpose();
  const auto depth = [&](const Pose& pose) {
    return plate_depth(probe.plate, transform_point(pose, probe.arm_body)).depth;
  };
  const double step = difference_step(probe);
  const double arm = probe.arm_body.norm();
  const double turn = arm > step ? step / arm : 1e-6;
  return texture_wrench_by_differences(depth, probe.stiffness, basis, state, step, turn);
}

}  // namespace

void check_coupling(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const RigidBody body = read_body(member(in, "body"));
  const BodyState state = read_state(member(in, "y"));
  const Coupling coupling = read_coupling(member(in, "coupling"));
  const Motion device = read_device(member(in, "device"));
  WrenchJacobian jacobian;
  check.expect("FT", to_vector(coupling_wrench(coupling, device, body, state, &jacobian)));
  check.expect("J", jacobian);
  const CouplingStretch stretch = coupling_stretch(coupling, device.pose, state);
  check.expect("u_c", stretch.angular);
  check.expect("du_dq", stretch.angular_by_q);
  check.expect("device_wrench", to_vector(coupling_reaction(coupling, device, body, state)));
}

void check_penalty(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const RigidBody body = read_body(member(in, "body"));
  const BodyState state = read_state(member(in, "y"));
  const CasePlane plane = read_plane(member(in, "contact"));
  WrenchJacobian jacobian = WrenchJacobian::Zero();
  const PlaneForce force = plane_force(plane, at_state(body, state), &jacobian);
  check.expect("delta", force.depth);
  check.expect_flag("active", force.is_active);
  check.expect("FT", to_vector(force.wrench));
  check.expect("J", jacobian);
}

void check_texture_point(const JsonField& in, CaseCheck& check, const CaseContext& context) {
  const BodyState state = read_state(member(in, "y"));
  const TexturedPoint probe = read_textured_point(member(in, "texture"));
  const Pose world_from_body{state.position, state.orientation};
  const PlateDepth depth =
      plate_depth(probe.plate, transform_point(world_from_body, probe.arm_body));
  check.expect("delta", depth.depth);
  check.expect("grad_p", depth.gradient);
  check.expect("hess_p", depth.hessian);
  WrenchJacobian jacobian;
  check.expect("FT", to_vector(texture_wrench(probe, state, TextureJacobian::exact, &jacobian)));
  check.expect("J", jacobian);
  texture_wrench(probe, state, TextureJacobian::gauss_newton, &jacobian);
  check.expect("J_gauss_newton", jacobian);
  if (context.has_difference_tolerance) {
    check.compare(check.take("FT"), to_vector(wrench_by_differences(probe, state)),
                  context.difference);
  }
}

void check_texture_disk(const JsonField& in, CaseCheck& check, const CaseContext& context) {
  const double radius = number(member(in, "radius"));
  const double amplitude = number(member(in, "amp"));
  const double wavelength = number(member(in, "lambda"));
  const JsonField places = member(in, "u");
  std::vector<double> depths, slopes;
  for (const double at : numbers(places, {list_size(places)})) {
    const OffsetHeight height = disk_on_wave(radius, amplitude, wavelength, at);
    depths.push_back(height.height);
    slopes.push_back(height.slope);
  }
  check.compare(check.take("delta"), depths, {depths.size()}, context.depth);
  check.compare(check.take("ddelta_du"), slopes, {slopes.size()}, context.slope);
}

void check_linearized_contact(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const RigidBody body = read_body(member(in, "body"));
  const BodyState start = read_state(member(in, "y0"));
  const BodyState end = read_state(member(in, "y1"));
  const CaseForces forces = read_forces(in);
  TaylorTerm term;
  term.wrench = sum_forces(forces, {}, body, start, &term.jacobian);
  check.expect("FT0", to_vector(term.wrench));
  check.expect("J", term.jacobian);
  check.expect("FT_extrapolated", to_vector(extrapolate(term, start, end)));
  check.expect("FT_exact_at_y1", to_vector(sum_forces(forces, {}, body, end, nullptr)));
}

}  // namespace thigma::app
