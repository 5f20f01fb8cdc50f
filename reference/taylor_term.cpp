#include "reference/taylor_term.h"

namespace thigma {

Wrench extrapolate(const TaylorTerm& term, const BodyState& taken_at, const BodyState& state,
                   WrenchJacobian* jacobian) THIGMA_RT {
  const double cover =
      state.orientation.coeffs().dot(taken_at.orientation.coeffs()) < 0.0 ? -1.0 : 1.0;
  BodyState aligned = state;
  aligned.orientation.coeffs() *= cover;
  const Vec6 change = term.jacobian * (to_vector(aligned) - to_vector(taken_at));
  if (jacobian) {
    *jacobian = term.jacobian;
    jacobian->middleCols<4>(3) *= cover;
  }
  return {term.wrench.force + change.head<3>(), term.wrench.torque + change.tail<3>()};
}

Wrench pushing_wrench(const TaylorTerm& term, const BodyState& taken_at, const BodyState& state,
                      WrenchJacobian* jacobian) THIGMA_RT {
  const Wrench wrench = extrapolate(term, taken_at, state, jacobian);
  if (wrench.force.dot(term.normal) <= 0.0) return wrench;
  if (jacobian) jacobian->setZero();
  return {};
}

}  // namespace thigma
