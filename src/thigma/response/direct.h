#pragma once
// Direct rendering: contact forces go to the hand as they are, without a simulated body between
// (Sec. 3.5.3).

#include "thigma/contact/clustering.h"
#include "thigma/math/pose.h"
#include "thigma/response/penalty.h"

namespace thigma {

/// What a device can render best, in its own size.
struct DirectDevice {
  double max_force = 0.0;      // [N]
  double max_stiffness = 0.0;  // the stiffest it renders well at the session's rate [N/m]
  double motion_scale = 1.0;   // s: virtual metres per device metre
  double force_scale = 1.0;    // f: device newtons per virtual newton
};

/// Penalty whose force reaches the device's maximum where the surfaces meet, at the device's best
/// stiffness: k = K / (f s), d = (F_max / f) / k. Clusters share k, so that the force is k (d -
/// distance) however many they are.
///
/// device   all above 0
/// returns  without damping: the hand's own has to do
/// Thread   [offline]
/// Source   Sec. 3.5.3, after Kim, Otaduy, Lin and Manocha 2003.
PenaltyParams direct_penalty(const DirectDevice& device) noexcept;

/// Net penalty force of clusters on the object at rest, and its torque about a point.
///
/// clusters  as found [world]
/// params    stiffness, tolerance, sharing; damping is not read
/// about     the handle, or the centre of mass [m; world]
/// returns   [N, N m; world]
/// Thread    [contact]; no failure.
Wrench direct_wrench(const ContactClusters& clusters, const PenaltyParams& params,
                     const Vec3& about) noexcept;

}  // namespace thigma
