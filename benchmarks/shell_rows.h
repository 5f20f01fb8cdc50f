#pragma once
// Rows of a point shell's contacts, so that it can keep an object outside as exact contacts do.

#include <span>
#include <vector>

#include "benchmarks/baselines/point_shell.h"

#include "thigma/constraint/build_constraints.h"
#include "thigma/dynamics/constraint_model.h"

namespace thigma::bench {

/// Working memory.
struct ShellRowScratch {
  std::vector<FoundRow> found;
  ImpliedScratch implied;
};

/// A row a contact: the point stays in front of the plane through what the field has nearest,
/// square to its gradient. Rows that others imply are left out, and the travel is halved until the
/// others fit, as for exact contacts.
///
/// world       of the object; gives reach and stand-off
/// state       of the body the shells were asked at
/// contacts    of query_shells
/// separation  of what that did not report, at least [m]
/// friction    of the two
/// model       overwritten
/// Thread      any
void make_shell_rows(const ConstraintWorld& world, const BodyState& state,
                     std::span<const ShellContact> contacts, double separation,
                     const Friction& friction, ShellRowScratch& scratch, ConstraintModel& model);

}  // namespace thigma::bench
