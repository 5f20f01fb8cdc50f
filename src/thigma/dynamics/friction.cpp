#include "thigma/dynamics/friction.h"

#include <algorithm>

namespace thigma {
namespace {

double combined(double a, double b, CombineRule rule) THIGMA_RT {
  switch (rule) {
    case CombineRule::geometric:
      return std::sqrt(a) * std::sqrt(b);  // a b may be out of range
    case CombineRule::average:
      return 0.5 * a + 0.5 * b;
    case CombineRule::minimum:
      return std::min(a, b);
    case CombineRule::maximum:
      break;
  }
  return std::max(a, b);
}

}  // namespace

Friction combined(const Friction& a, const Friction& b, CombineRule rule) THIGMA_RT {
  if (a == b) return a;  // to the last bit
  return {combined(a.kinetic, b.kinetic, rule), combined(a.at_rest, b.at_rest, rule)};
}

}  // namespace thigma
