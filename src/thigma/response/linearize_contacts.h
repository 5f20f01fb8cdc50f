#pragma once
// From contact clusters to the model that the haptic thread evaluates.

#include <cstdint>

#include "thigma/contact/clustering.h"
#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/response/penalty.h"

namespace thigma {

/// Where and when a contact model is taken, and which one it is.
struct ModelStamp {
  BodyState state;             // of the object when the contacts were found
  double time = 0.0;           // of it on the session's clock [s]
  std::uint64_t sequence = 0;  // of this publication, from 1
};

/// Contact model of one contact frame: a plane term a cluster, in the clusters' order.
///
/// clusters  of contacts found at the stamp's state [world]
/// params    stiffness, damping, tolerance
/// stamp     the terms' arms are fixed to its state
/// other_reach  sum of depth + tolerance of terms that share the stiffness with these [m]
/// returns   plane terms only; the scene is at rest. Texture terms: response/texture_contacts.h
/// Thread    [contact]; no failure, no allocation. Clusters beyond kMaxClusters do not exist.
/// Source    Sec. 5.4.3, Eqs. 5.36-5.37.
LinearContactModel linearize_contacts(const ContactClusters& clusters, const PenaltyParams& params,
                                      const ModelStamp& stamp, double other_reach = 0.0) noexcept;

/// Sum of depth + tolerance over the clusters that press [m]: what they share the stiffness by.
double total_indentation(const ContactClusters& clusters, double tolerance) noexcept;

}  // namespace thigma
