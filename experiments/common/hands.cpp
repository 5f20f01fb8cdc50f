#include "experiments/common/hands.h"

namespace thigma::experiments {

HandScript jaws_hand(double radius) {
  return {.seconds = 1.05,
          .depth = 0.06 * radius,
          .slide = radius * Vec3(0.03, 0.02, 0.0),
          .slide_rate = 2.0,
          .turn = Vec3(0.02, 0.01, 0.02),
          .turn_rate = 1.4,
          .tap = 0.02 * radius,
          .tap_rate = 3.0};
}

HandScript golf_hand(double radius) {
  return {.seconds = 0.55,
          .depth = 0.08 * radius,
          .slide = radius * Vec3(0.0, 0.12, 0.08),
          .slide_rate = 2.5,
          .turn = Vec3(0.0, 0.04, 0.04),
          .turn_rate = 2.0,
          .tap = 0.06 * radius,
          .tap_rate = 6.0};
}

HandScript spoon_hand(double radius) {
  return {.seconds = 0.8,
          .depth = 0.04 * radius,
          .slide = radius * Vec3(0.03, 0.0, 0.02),
          .slide_rate = 1.5,
          .turn = Vec3(0.02, 0.02, 0.0),
          .turn_rate = 1.2,
          .tap = 0.01 * radius,
          .tap_rate = 3.0};
}

HandScript joint_hand(double radius) {
  return {.seconds = 0.8,
          .depth = 0.04 * radius,
          .slide = radius * Vec3(0.01, 0.01, 0.0),
          .slide_rate = 1.5,
          .turn = Vec3(0.2, 0.2, 0.1),
          .turn_rate = 1.3,
          .tap = 0.01 * radius,
          .tap_rate = 3.0};
}

}  // namespace thigma::experiments
