// The handle in a hand: a mass on the spring of an arm, pulled to a target, in the vendor's axes
// and SI.
#pragma once

#include <array>

namespace standin {

using Vec = std::array<double, 3>;
using Quat = std::array<double, 4>;  // w, x, y, z

Quat multiply(const Quat& a, const Quat& b);
// Turn about a vector by its length, rad.
Quat turn(const Vec& v);
// The vector of a turn, the shorter way.
Vec turn_vector(const Quat& q);
// Rows of the matrix of a turn.
std::array<Vec, 3> matrix(const Quat& q);
double norm(const Vec& v);

// Moves the handle of a device on to that time. Under the lock.
void move_handle(int unit, double time);

// The pose as the device tells it, with the faults that are set.
struct Pose {
  Vec position{};  // m
  Quat orientation{1, 0, 0, 0};
};
Pose told_pose(int unit);

}  // namespace standin
