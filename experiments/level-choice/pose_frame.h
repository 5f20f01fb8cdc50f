#pragma once
// What a way of asking for contacts finds at one pose, and how that is compared with what the exact
// query finds there.

#include <cstddef>
#include <vector>

#include "experiments/level-choice/shells.h"
#include "experiments/level-choice/touched_pair.h"

#include "thigma/contact/front.h"
#include "thigma/contact/least_separation.h"

namespace thigma::experiments::level_choice {

/// Contacts of one pose.
struct PoseFrame {
  std::vector<Contact> contacts;
  Vec3 force = Vec3::Zero();  // of 16 clusters, each by itself, per unit of stiffness [m]
  // Of the same clusters, which share the stiffness as sessions have it [m].
  Vec3 shared_force = Vec3::Zero();
  double front = 0.0;
  std::vector<double> query;  // CPU times of the burst [s]
  // What the contacts' bounds were narrowed to, and the CPU time that took [s]; of levels alone.
  SeparationInterval narrowed;
  double narrowing = 0.0;
};

/// What queries need between poses.
struct QueryMemory {
  ContactFront front;
  ContactSet set;
  SeparationScratch separation;
  std::vector<bench::ShellContact> shell;
};
QueryMemory make_memory(const TouchedPair& pair);

/// Asks at pose number `sample`, after some poses before it, which are timed with it.
PoseFrame query_at(const TouchedPair& pair, std::size_t sample, const Resolution& resolution,
                   QueryMemory& memory);
PoseFrame query_at(const TouchedPair& pair, std::size_t sample, const ShellPair& shells,
                   QueryMemory& memory);

/// Share of the exact contacts with one of the frame's within `near` [m]; neither without a
/// contact.
double recall_of(const PoseFrame& exact, const PoseFrame& frame, double near);

/// Least of minus depth, and of that minus and plus the bound: between those two lies the least
/// separation [m].
struct LeastSeparation {
  double reported = 0.0, low = 0.0, high = 0.0;
};
/// Of a frame with contacts.
LeastSeparation least_separation(const PoseFrame& frame);

}  // namespace thigma::experiments::level_choice
