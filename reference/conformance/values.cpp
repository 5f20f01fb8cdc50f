#include "reference/conformance/values.h"

#include "reference/glued_plane.h"

namespace thigma::app {

Quat read_quaternion(const JsonField& field) { return Quat(vector<4>(field)); }

RigidBody read_body(const JsonField& field) {
  const double mass = number(member(field, "mass"));
  const Mat3 inertia = matrix3(member(field, "inertia"));
  const Vec3 gravity =
      field.has("gravity") ? Vec3(vector<3>(member(field, "gravity"))) : Vec3(Vec3::Zero());
  try {
    return make_body(mass, inertia, gravity);
  } catch (const InputError& error) {
    throw InputError(field.place + ": " + error.what());
  }
}

BodyState read_state(const JsonField& field) { return from_vector(vector<13>(field)); }

Saturation read_saturation(const JsonField& field) {
  return {.stiffness = number(member(field, "k0")),
          .linear_range = number(member(field, "x1")),
          .full_range = number(member(field, "x2")),
          .max_force = number(member(field, "fmax"))};
}

Coupling read_coupling(const JsonField& field) {
  Coupling c;
  c.linear_stiffness = number(member(field, "kc"));
  c.linear_damping = number(member(field, "bc"));
  c.angular_stiffness = number(member(field, "kt"));
  c.angular_damping = number(member(field, "bt"));
  c.body_from_grasp = {vector<3>(member(field, "c")), read_quaternion(member(field, "qc"))};
  const auto saturation = [&](const char* key) -> std::optional<Saturation> {
    if (!field.has(key) || member(field, key).is_null()) return std::nullopt;
    return read_saturation(member(field, key));
  };
  c.linear_saturation = saturation("lin");
  c.angular_saturation = saturation("ang");
  return c;
}

Motion read_device(const JsonField& field) {
  return {{vector<3>(member(field, "x")), read_quaternion(member(field, "q"))},
          {vector<3>(member(field, "v")), vector<3>(member(field, "w"))}};
}

CasePlane read_plane(const JsonField& field) {
  CasePlane plane;
  PlaneTerm& t = plane.term;
  t.arm_body = vector<3>(member(field, "r"));
  t.normal = vector<3>(member(field, "n"));
  t.scene_point = vector<3>(member(field, "p0"));
  t.stiffness = number(member(field, "k"));
  t.damping = number(member(field, "b"));
  t.tolerance = number(member(field, "d"));
  plane.is_glued = field.has("unilateral") && !flag(member(field, "unilateral"));
  return plane;
}

PlaneForce plane_force(const CasePlane& plane, const BodyAtState& at, WrenchJacobian* jacobian) {
  return plane.is_glued ? glued_plane_force(plane.term, at, jacobian)
                        : plane_force(plane.term, at, 1.0, jacobian);
}

TexturedPoint read_textured_point(const JsonField& field) {
  const JsonField plate = member(field, "plate");
  TexturedPoint t;
  t.arm_body = vector<3>(member(field, "r"));
  t.stiffness = number(member(field, "k"));
  t.plate.u = vector<3>(member(plate, "u"));
  t.plate.v = vector<3>(member(plate, "v"));
  t.plate.n = vector<3>(member(plate, "n"));
  t.plate.offset = number(member(plate, "h0"));
  t.plate.amplitude_u = number(member(plate, "a1"));
  t.plate.wave_u = number(member(plate, "k1"));
  t.plate.phase_u = number(member(plate, "f1"));
  t.plate.amplitude_v = number(member(plate, "a2"));
  t.plate.wave_v = number(member(plate, "k2"));
  t.plate.phase_v = number(member(plate, "f2"));
  return t;
}

CaseForces read_forces(const JsonField& in) {
  CaseForces forces;
  if (in.has("coupling") && !member(in, "coupling").is_null())
    forces.coupling = read_coupling(member(in, "coupling"));
  const JsonField contacts = member(in, "contacts");
  for (std::size_t i = 0; i < list_size(contacts); ++i)
    forces.planes.push_back(read_plane(element(contacts, i)));
  const JsonField textures = member(in, "textures");
  for (std::size_t i = 0; i < list_size(textures); ++i) {
    forces.textures.push_back(read_textured_point(element(textures, i)));
  }
  return forces;
}

Wrench sum_forces(const CaseForces& forces, const Motion& device, const RigidBody& body,
                  const BodyState& state, WrenchJacobian* jacobian) THIGMA_RT {
  const BodyAtState at = at_state(body, state);
  Wrench sum;
  if (jacobian) jacobian->setZero();
  if (forces.coupling) sum = coupling_wrench(*forces.coupling, device, at, jacobian);
  for (const CasePlane& plane : forces.planes) sum = sum + plane_force(plane, at, jacobian).wrench;
  for (const TexturedPoint& probe : forces.textures) {
    WrenchJacobian of_texture;
    sum = sum +
          texture_wrench(probe, state, TextureJacobian::exact, jacobian ? &of_texture : nullptr);
    if (jacobian) *jacobian += of_texture;
  }
  return sum;
}

}  // namespace thigma::app
