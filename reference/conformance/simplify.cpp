#include "reference/conformance/conformance.h"

#include "thigma/simplify/convexity.h"
#include "thigma/simplify/resolution.h"

namespace thigma::app {
namespace {

/// A result that exists only where the program is feasible, else null.
template <class Value>
void expect_if(bool exists, const char* name, const Value& got, CaseCheck& check) {
  const JsonField want = check.take(name);
  if (want.is_null() != !exists) return check.differ(want);
  if (exists) check.compare(want, got);
}

}  // namespace

void check_resolution(const JsonField& in, CaseCheck& check, const CaseContext&) {
  check.expect("r", edge_resolution(vector<3>(member(in, "v1")), vector<3>(member(in, "v2")),
                                    vector<3>(member(in, "n"))));
}

void check_collapse_lp(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const Vec3 v_hat = vector<3>(member(in, "v_hat")), v_tilde = vector<3>(member(in, "v_tilde"));
  const JsonField list = member(in, "constraints");
  std::vector<ConvexityConstraint> constraints;
  for (std::size_t i = 0; i < list_size(list); ++i) {
    const JsonField c = element(list, i);
    constraints.push_back(
        {vector<3>(member(c, "va")), vector<3>(member(c, "vc")), vector<3>(member(c, "vd"))});
  }
  const UnitInterval solved = solve_convexity(v_hat, v_tilde, constraints);
  const Vec3 v3 = mix(solved.low, v_hat, v_tilde);
  std::vector<double> volumes;  // Eq. 3.2 with v3 as vb
  for (const ConvexityConstraint& c : constraints)
    volumes.push_back((v3 - c.va).cross(c.vc - c.va).dot(c.vd - c.va));
  check.expect_flag("feasible", solved.is_feasible);
  expect_if(solved.is_feasible, "u", solved.low, check);
  const JsonField position = check.take("v3"), list_of_volumes = check.take("volumes");
  if (position.is_null() != !solved.is_feasible) return check.differ(position);
  if (list_of_volumes.is_null() != !solved.is_feasible) return check.differ(list_of_volumes);
  if (!solved.is_feasible) return;
  check.compare(position, v3, check.tolerance());
  check.compare(list_of_volumes, volumes, {volumes.size()}, check.tolerance());
}

void check_bisection(const JsonField& in, CaseCheck& check, const CaseContext&) {
  const double least = number(member(in, "global_ok_iff_u_ge"));
  const BisectionResult got =
      bisect(number(member(in, "u_local")), 1.0, static_cast<int>(whole_number(member(in, "K"))),
             [&](double u) { return u >= least; });
  check.expect_flag("accepted", got.is_accepted);
  expect_if(got.is_accepted, "u", got.u, check);
}

}  // namespace thigma::app
