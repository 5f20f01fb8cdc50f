#include <algorithm>
#include <cmath>

#include "reference/conformance/conformance.h"

#include "thigma/math/infinity.h"

namespace thigma::app {

JsonField CaseCheck::take(const char* name) {
  taken_.insert(name);
  return member(expected_, name);
}

void CaseCheck::note(const JsonField& want, double error, double allowed) {
  if (std::isnan(error)) error = kInfinity;
  double used = error == 0.0 ? 0.0 : kInfinity;
  if (error > 0.0 && allowed > 0.0) used = error / allowed;
  if (used <= worst_.used) return;
  worst_.used = used;
  worst_.error = error;
  worst_.field = want.place.substr(expected_.place.size() + 1);
}

void CaseCheck::compare(const JsonField& want, const std::vector<double>& got,
                        const std::vector<std::size_t>& shape, const Tolerance& tolerance) {
  const std::vector<double> wanted = numbers(want, shape);
  double largest = 0.0;
  double error = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (std::isfinite(wanted[i])) largest = std::max(largest, std::fabs(wanted[i]));
    const double difference = wanted[i] == got[i] ? 0.0 : std::fabs(got[i] - wanted[i]);
    error = std::isnan(difference) || difference > error ? difference : error;
    if (std::isnan(error)) break;
  }
  note(want, error, tolerance.absolute + tolerance.relative * largest);
}

void CaseCheck::differ(const JsonField& want) {
  note(want, std::numeric_limits<double>::infinity(), 0.0);
}

void CaseCheck::expect_flag(const char* name, bool got) {
  const JsonField want = take(name);
  if (flag(want) == got) {
    note(want, 0.0, 0.0);
  } else {
    differ(want);
  }
}

void CaseCheck::expect_whole(const char* name, long got) {
  const JsonField want = take(name);
  note(want, std::fabs(static_cast<double>(whole_number(want) - got)), 0.0);
}

void CaseCheck::expect_list(const JsonField& want, const std::vector<long>& got) {
  bool is_equal = list_size(want) == got.size();
  for (std::size_t i = 0; i < list_size(want); ++i) {
    const long value = whole_number(element(want, i));
    is_equal = is_equal && value == got[i];
  }
  if (is_equal) {
    note(want, 0.0, 0.0);
  } else {
    differ(want);
  }
}

}  // namespace thigma::app
