#pragma once
// Ways to play the motion of Fig. 5.10, and what came of each.

#include <vector>

#include "experiments/common/coupled_run.h"
#include "experiments/common/experiment.h"

namespace thigma::experiments::fig_5_10 {

inline constexpr double kStiffness = 5000.0;  // of the penalty [N/m]
inline constexpr int kQuickTriangles = 4000;
inline constexpr double kSettled = 0.15;  // after the first touch [s]
// ripple of the coupling force that is no instability [N]
inline constexpr double kCalm = 0.1;

/// A way to play the motion.
struct Way {
  const char* series;  // of rows in data.csv
  double threshold;
  int every;  // contact frames a haptic frame
  bool is_linearized;
  int clusters = 5;
  double cap = 0.02;              // on the deviation of coarse surfaces, of the radius
  double stiffness = kStiffness;  // [N/m]
};

struct Ran {
  std::vector<CoupledFrame> frames;
  std::vector<double> coupling;
  double ripple = 0.0, peak = 0.0;
  double level = 0.0;                   // mean of the frames
  double deepest = 0.0, settled = 0.0;  // between exact meshes: largest, median [m]
};

/// Plays the motion with springs.
Ran play(const CoupledSetup& base, const LedMotion& motion, const Way& way);

/// A row of the first table, and curves in the panels of springs, held forces and constraints.
void add(const Way& way, const Ran& ran, Outcome& outcome);

/// The third column: what the text does not have, constraints, at its contact rates.
void run_constrained(const Context& context, const SessionPair& session, const LedMotion& motion,
                     Outcome& outcome);

}  // namespace thigma::experiments::fig_5_10
