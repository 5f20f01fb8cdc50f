#pragma once
// Contact queries where constrained sessions ask them: ours beside the point shell's, on the path
// that the exact rows let the object take.

#include <string>
#include <vector>

#include "benchmarks/bench_rows.h"

namespace thigma::bench {

/// A measurement a scene: the exact query as sessions ask it, alone and with its rows, the same
/// with carried contacts, and levels far away; each beside the two-way point shell at the same
/// poses and tolerances. Accuracy: of the answers against a fresh exact query, and of sessions
/// that have these contacts.
std::vector<Measurement> proxy_measurements(bool quick);

/// The same of a scene by name or file, in the simulated hand with a contact frame a millisecond,
/// whatever device and rates it names. Thread [offline]; InputError for what cannot be measured.
Measurement proxy_measurement(const std::string& scene, bool quick);

}  // namespace thigma::bench
