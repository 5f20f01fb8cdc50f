#include "thigma/math/rotation.h"

#include "reference/conformance/conformance.h"
#include "reference/conformance/values.h"

namespace thigma::app {

void check_rotations(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const Quat a = read_quaternion(member(in, "a"));
  Mat34 dlog;
  check.expect("log_a", vector_from_rotation(a, &dlog));
  check.expect("dlog_a", dlog);
  const bool is_log_only = !in.has("b") && !in.has("v") && !in.has("w");
  if (is_log_only) return;

  const Vec3 v = vector<3>(member(in, "v"));
  const Vec3 w = vector<3>(member(in, "w"));
  check.expect("ab", (a * read_quaternion(member(in, "b"))).coeffs());
  check.expect("R_a", rotation_matrix(a));
  check.expect("Rv", rotation_matrix(a) * v);
  check.expect("Q_a", rate_matrix(a));
  check.expect("qdot", rate_matrix(a) * w);
  check.expect("exp_w", rotation_from_vector(w).coeffs());
  std::vector<double> derivatives;
  for (const Mat3& d : rotation_matrix_derivatives(a)) {
    for (int i = 0; i < 9; ++i) derivatives.push_back(d(i / 3, i % 3));
  }
  check.compare(check.take("dR_a"), derivatives, {4, 3, 3}, check.tolerance());
}

void check_spline(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const Saturation spring = read_saturation(member(in, "spline"));
  const JsonField r = member(in, "r");
  std::vector<double> force, slope;
  for (const double stretch : numbers(r, {list_size(r)})) {
    const SpringForce f = spring_force(spring, stretch);
    force.push_back(f.force);
    slope.push_back(f.slope);
  }
  check.expect("f", force);
  check.expect("df", slope);
  check.expect_flag("monotone", is_monotone(spring));
}

}  // namespace thigma::app
