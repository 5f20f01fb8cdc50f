#pragma once
// What drivers of devices share: rotations that vendors give as matrices, and wrenches cut at
// limits.

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"
#include "thigma/math/pose.h"

namespace thigma::detail {

/// The rotation nearest to a matrix that is one up to rounding: vendors' matrices are not exactly
/// orthonormal.
///
/// matrix      columns are the handle's axes [device frame]
/// rotation    unit; written only where there is one; of NaN where the matrix is not finite
/// returns     whether it is one: columns of unit length and at right angles to 0.05, right-handed
/// Thread      [haptic].
bool nearest_rotation(const Mat3& matrix, Quat& rotation) THIGMA_RT;

/// The wrench as a device may be sent it: without what it does not actuate, cut by norm at its
/// limits; zero where it is not finite.
/// Thread      [haptic].
Wrench sendable(const Wrench& wrench, const DeviceLimits& limits) THIGMA_RT;

}  // namespace thigma::detail
