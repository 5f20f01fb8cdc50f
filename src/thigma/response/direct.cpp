#include "thigma/response/direct.h"

#include "thigma/response/linearize_contacts.h"

namespace thigma {

PenaltyParams direct_penalty(const DirectDevice& device) noexcept {
  PenaltyParams penalty;
  penalty.stiffness = device.max_stiffness / (device.force_scale * device.motion_scale);
  penalty.tolerance = device.max_force / device.force_scale / penalty.stiffness;
  penalty.damping = 0.0;
  penalty.is_divided_among_clusters = true;
  return penalty;
}

Wrench direct_wrench(const ContactClusters& clusters, const PenaltyParams& params,
                     const Vec3& about) noexcept {
  // The terms of the haptic thread, for some body at rest whose axes are the world's and whose
  // centre is `about`.
  BodyState state;
  state.position = about;
  const RigidBody body = make_body(1.0, Mat3::Identity());
  return contact_wrench(linearize_contacts(clusters, params, {state}), body, state);
}

}  // namespace thigma
