#pragma once
// The few linear-algebra types everything is written in. Double precision, fixed size, no
// allocation.

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace thigma {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Vec13 = Eigen::Matrix<double, 13, 1>;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Mat34 = Eigen::Matrix<double, 3, 4>;
using Mat43 = Eigen::Matrix<double, 4, 3>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat13 = Eigen::Matrix<double, 13, 13>;
using Quat = Eigen::Quaterniond;  ///< memory order x y z w, as in files and in y (Eq. 5.17)

/// d(force, torque)/dy, rows force then torque, columns the 13 numbers of y = (x, q, P, L).
using WrenchJacobian = Eigen::Matrix<double, 6, 13>;

}  // namespace thigma
