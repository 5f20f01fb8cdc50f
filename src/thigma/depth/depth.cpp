#include "thigma/depth/depth.h"

#include "thigma/math/rotation.h"

namespace thigma {

Pose configuration_motion(const DepthSamples& sample, const Vec3& centre, int i) noexcept {
  if (i == 0) return {};
  const int pair = (i - 1) / 2;
  const double sign = i % 2 == 1 ? 1.0 : -1.0;
  Pose motion;
  if (pair < 2) {
    motion.position = sign * sample.shift * sample.frame.world_from_contact.col(pair);
    return motion;
  }
  const Vec3 axis = sample.frame.world_from_contact.col(pair - 2);
  motion.orientation = rotation_from_vector(sign * sample.turn * axis);
  motion.position = centre - motion.orientation._transformVector(centre);
  return motion;
}

}  // namespace thigma
