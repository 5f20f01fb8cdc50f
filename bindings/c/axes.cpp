// Axes of game engines: M maps our coordinates to theirs; it mirrors, so that turns, which are
// pseudovectors, go by -M.

#include "thigma/thigma_c.h"

namespace {

constexpr double kCentimetres = 100.0;  // of a metre

/// Ours: x to the operator, y right, z up. Unity's: x right, y up, z forward.
void to_unity(const double* from, double sign, double* to) {
  const double v[3] = {from[0], from[1], from[2]};
  to[0] = sign * v[1], to[1] = sign * v[2], to[2] = -sign * v[0];
}

void from_unity(const double* from, double sign, double* to) {
  const double v[3] = {from[0], from[1], from[2]};
  to[0] = -sign * v[2], to[1] = sign * v[0], to[2] = sign * v[1];
}

/// Unreal's: x forward, y right, z up. Its own inverse.
void mirror_x(const double* from, double sign, double* to) {
  to[0] = -sign * from[0], to[1] = sign * from[1], to[2] = sign * from[2];
}

}  // namespace

extern "C" {

void thigma_pose_to_unity(const double* from, double* to) {
  to_unity(from, 1.0, to);
  to_unity(from + 3, -1.0, to + 3);
  to[6] = from[6];
}

void thigma_pose_from_unity(const double* from, double* to) {
  from_unity(from, 1.0, to);
  from_unity(from + 3, -1.0, to + 3);
  to[6] = from[6];
}

void thigma_wrench_to_unity(const double* from, double* to) {
  to_unity(from, 1.0, to);
  to_unity(from + 3, -1.0, to + 3);
}

void thigma_pose_to_unreal(const double* from, double* to) {
  mirror_x(from, kCentimetres, to);
  mirror_x(from + 3, -1.0, to + 3);
  to[6] = from[6];
}

void thigma_pose_from_unreal(const double* from, double* to) {
  mirror_x(from, 1.0 / kCentimetres, to);
  mirror_x(from + 3, -1.0, to + 3);
  to[6] = from[6];
}

void thigma_wrench_to_unreal(const double* from, double* to) {
  mirror_x(from, 1.0, to);
  mirror_x(from + 3, -1.0, to + 3);
}

}  // extern "C"
