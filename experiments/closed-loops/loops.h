#pragma once
// Slow motions of the hand that come back to where they began, in contact all the way.

#include <string>
#include <vector>

#include "experiments/common/led_session.h"

namespace thigma::experiments {

/// A motion of one cycle, repeated.
struct Loop {
  std::string name{};
  LedPair pair{};
  HandPath pressed{};  // phase 0..1 of a cycle to the handle's pose; begins and ends alike
  double cycle = 4.0;  // [s]
  double contact_stiffness = 2000.0;  // of the penalty [N/m]
};

/// Two feet rocked, a cube wobbled, a block pressed on the coarse half of a plate and lifted on
/// the fine one, jaws circled.
/// triangles  of each jaw
std::vector<Loop> closed_loops(int triangles);

/// Energy that the hand puts in during each cycle after the first [J].
struct LoopRun {
  std::vector<double> put_in;
  double energy_min = 0.0;
  double force = 0.0;  // largest [N]
  int held_back = 0, frames = 0;
};

/// is_reversed  the cycle run backwards
/// cycles       of which the first is not counted
LoopRun run_loop(const Loop& loop, const LedGains& gains, bool is_reversed, int cycles);

/// A loop on the potential law alone, without bodies, couplings, dampers and time.
struct LawLoop {
  double handed_out = 0.0;  // over the closed path, of either sign [J]
  double put_in = 0.0;      // where it was pressed [J]
  double force = 0.0;       // largest [N]
};

/// The path of a loop at so many poses, lifted until the law pushes with 2 N; force times way.
/// Thread [offline]
LawLoop run_law(const Loop& loop, bool is_reversed, int steps);

}  // namespace thigma::experiments
