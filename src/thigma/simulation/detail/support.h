#pragma once
// What holds a body that lies or slides: the mean force of contacts over a flight, in place of a
// train of impulses.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/simulation/simulate.h"

namespace thigma::detail {

/// Some contacts of a set, by index.
struct HeldContacts {
  const ContactSet& set;
  std::span<const std::int32_t> contacts;
};

struct SupportedFlight {
  double time = 0.0;  // [s]
  double lift = 0.0;  // share of the missing distance that contacts are moved out by
};

/// Forces of contacts that hold a body while it flies on for a time.
///
/// Each contact pushes outward, with friction in Coulomb's cone against the sliding and a couple of
/// at most `rolling` times its normal force against the turning, so that its point does not come
/// nearer on the mean of the flight: by its mean velocity, which is that at half the time. Where it
/// would move off by itself it does not push. So the normal forces do no work and friction takes
/// some, exactly for translation and to second order for rotation. A contact nearer than half the
/// collision distance is moved out towards it, by `lift` of what is missing at most: that is the
/// only work given, and the caller sees that something else pays for it.
/// held       those to hold; none may approach
/// flight     time > 0, lift 0..1
/// points     scratch; forces found before are where the search begins, as long as the contacts are
///            the same
/// returns    wrench about the centre of mass, constant over the flight [N, N m; world]
/// Thread     any; no failure. Sweeps until velocities change no more, or 200 times; fewer where
///            more than 20 touch.
Wrench support_wrench(const SimulationWorld& world, const BodyState& state,
                      const HeldContacts& held, const SupportedFlight& flight,
                      std::vector<SupportPoint>& points);

}  // namespace thigma::detail
