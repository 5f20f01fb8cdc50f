#pragma once
// Where an axis has ticks and what they are called.

#include <string>
#include <vector>

namespace thigma::plot {

struct Tick {
  double value = 0.0;
  std::string label;  // "": a minor tick
};

/// An interval of an axis with its ticks; low < high, both positive when logarithmic.
struct Scale {
  double low = 0.0, high = 1.0;
  bool is_log = false;
  std::vector<Tick> ticks;
};

/// Scale over [low, high], widened to whole steps where `fit` is set for that end. About `wanted`
/// labels.
Scale make_scale(double low, double high, bool is_log, int wanted, bool fit_low = true,
                 bool fit_high = true);

/// Where a value lies, 0 at low, 1 at high; not finite where the scale has no place for it.
double position(const Scale& scale, double value);

}  // namespace thigma::plot
