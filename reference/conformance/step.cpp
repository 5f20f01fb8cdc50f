#include "reference/conformance/conformance.h"
#include "reference/conformance/values.h"

#include "thigma/dynamics/explicit_step.h"

namespace thigma::app {
namespace {

struct NamedIntegrator {
  const char* name;
  Integrator integrator;
};
constexpr NamedIntegrator kIntegrators[] = {
    {"forward_euler", Integrator::forward_euler},
    {"rk4", Integrator::runge_kutta},
    {"backward_euler_13", Integrator::implicit_13},
    {"backward_euler_6", Integrator::implicit_6},
    {"backward_euler_tangent", Integrator::implicit_tangent}};

// Every k-th device sample drives one step of length h.
void check_run(const JsonField& want, const CaseForces& forces, const std::vector<Motion>& devices,
               const RigidBody& body, BodyState y, double h, Integrator integrator,
               CaseCheck& check) {
  const bool has_history = want.has("every10");
  for (std::size_t k = 0; k < devices.size(); ++k) {
    const auto act = [&](const BodyState& state, WrenchJacobian* jacobian) THIGMA_RT {
      return sum_forces(forces, devices[k], body, state, jacobian);
    };
    y = step_body(integrator, body, y, act, h);
    if (has_history && (k + 1) % 10 == 0) {
      check.compare(element(member(want, "every10"), k / 10), to_vector(y), check.tolerance());
    }
  }
  check.compare(member(want, "y"), to_vector(y), check.tolerance());
}

}  // namespace

void check_integrators(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const RigidBody body = read_body(member(in, "body"));
  const BodyState start = read_state(member(in, "y0"));
  const CaseForces forces = read_forces(in);
  const double h = number(member(in, "h"));
  const JsonField samples = member(in, "devices");
  std::vector<Motion> devices;
  for (std::size_t i = 0; i < list_size(samples); ++i)
    devices.push_back(read_device(element(samples, i)));
  if (devices.empty()) fail_field(samples, "at least one device sample");

  for (const NamedIntegrator& scheme : kIntegrators) {
    check_run(check.take(scheme.name), forces, devices, body, start, h, scheme.integrator, check);
  }
  WrenchJacobian jacobian;
  const Wrench wrench = sum_forces(forces, devices.front(), body, start, &jacobian);
  if (check.has("ydot")) check.expect("ydot", state_rate(body, start, wrench));
  if (check.has("ydot_jacobian"))
    check.expect("ydot_jacobian", state_rate_jacobian(body, start, jacobian));
}

}  // namespace thigma::app
