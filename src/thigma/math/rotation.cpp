#include "thigma/math/rotation.h"

#include "thigma/math/elementary.h"

namespace thigma {
namespace {

// Below this tangent of half the angle the series of sin and atan beat their closed forms.
constexpr double kSeriesLimit = 1e-4;

// d(R v)/dq with the sign of the vector part as a parameter: R(q)^T = R of the conjugate.
// R v = (s^2 - w.w) v + 2 w (w.v) + 2 s w x v, q = (w, s).
Mat34 sandwich_derivative(const Vec3& w, double s, const Vec3& v, double sign) THIGMA_RT {
  Mat34 d;
  d.leftCols<3>() = 2.0 * (w * v.transpose() - v * w.transpose()) - (2.0 * sign * s) * skew(v);
  d.leftCols<3>().diagonal().array() += 2.0 * w.dot(v);
  d.col(3) = 2.0 * s * v + (2.0 * sign) * w.cross(v);
  return d;
}

}  // namespace

Mat3 rotation_matrix(const Quat& q) THIGMA_RT {
  const double x = q.x(), y = q.y(), z = q.z(), s = q.w();
  const double xx = x * x, yy = y * y, zz = z * z, ss = s * s;
  Mat3 r;
  r << xx - yy - zz + ss, 2.0 * (x * y - z * s), 2.0 * (x * z + y * s),  //
      2.0 * (x * y + z * s), -xx + yy - zz + ss, 2.0 * (y * z - x * s),  //
      2.0 * (x * z - y * s), 2.0 * (y * z + x * s), -xx - yy + zz + ss;
  return r;
}

std::array<Mat3, 4> rotation_matrix_derivatives(const Quat& q) THIGMA_RT {
  const double x = q.x(), y = q.y(), z = q.z(), s = q.w();
  std::array<Mat3, 4> d;
  d[0] << x, y, z, y, -x, -s, z, s, -x;
  d[1] << -y, x, s, x, y, z, -s, z, -y;
  d[2] << -z, -s, x, s, -z, y, x, y, z;
  d[3] << s, -z, y, z, s, -x, -y, x, s;
  for (Mat3& m : d) m *= 2.0;
  return d;
}

Mat34 rotated_derivative(const Quat& q, const Vec3& v) THIGMA_RT {
  return sandwich_derivative(q.vec(), q.w(), v, 1.0);
}

Mat34 inverse_rotated_derivative(const Quat& q, const Vec3& v) THIGMA_RT {
  return sandwich_derivative(q.vec(), q.w(), v, -1.0);
}

Mat43 rate_matrix(const Quat& q) THIGMA_RT {
  const double x = 0.5 * q.x(), y = 0.5 * q.y(), z = 0.5 * q.z(), s = 0.5 * q.w();
  Mat43 m;
  m << s, z, -y, -z, s, x, y, -x, s, -x, -y, -z;
  return m;
}

Mat4 rate_derivative(const Vec3& omega) THIGMA_RT {
  const Vec3 w = 0.5 * omega;
  Mat4 m;
  m << 0.0, -w.z(), w.y(), w.x(),  //
      w.z(), 0.0, -w.x(), w.y(),   //
      -w.y(), w.x(), 0.0, w.z(),   //
      -w.x(), -w.y(), -w.z(), 0.0;
  return m;
}

Mat4 left_product_matrix(const Quat& a) THIGMA_RT {
  Mat4 m;
  m << a.w(), -a.z(), a.y(), a.x(),  //
      a.z(), a.w(), -a.x(), a.y(),   //
      -a.y(), a.x(), a.w(), a.z(),   //
      -a.x(), -a.y(), -a.z(), a.w();
  return m;
}

Quat rotation_from_vector(const Vec3& rotation_vector) THIGMA_RT {
  const double half = 0.5 * std::sqrt(rotation_vector.squaredNorm());
  const SinCos at = sin_cos(half);
  const double h2 = half * half;
  const double scale =
      half < kSeriesLimit ? 0.5 * (1.0 - h2 / 6.0 + h2 * h2 / 120.0) : 0.5 * at.sin / half;
  const Vec3 v = scale * rotation_vector;
  return Quat(at.cos, v.x(), v.y(), v.z());
}

Vec3 vector_from_rotation(const Quat& q, Mat34* derivative) THIGMA_RT {
  const double cover = q.w() < 0.0 ? -1.0 : 1.0;
  const Vec3 v = cover * q.vec();
  const double s = cover * q.w();
  const double n2 = v.squaredNorm();
  const double r2 = n2 + s * s;
  const double n = std::sqrt(n2);
  double g = 0.0;        // atan2(n, s) / n
  double g_slope = 0.0;  // (dg/dn) / n
  if (n < kSeriesLimit * s) {
    const double t2 = n2 / (s * s);
    g = (1.0 - t2 / 3.0 + t2 * t2 / 5.0) / s;
    g_slope = (-2.0 / 3.0 + 4.0 * t2 / 5.0) / (s * s * s);
  } else {
    g = arc_tangent2(n, s) / n;
    g_slope = (s / r2 - g) / n2;
  }
  if (derivative) {
    derivative->leftCols<3>() = (2.0 * cover * g_slope) * v * v.transpose();
    derivative->leftCols<3>().diagonal().array() += 2.0 * cover * g;
    derivative->col(3) = (-2.0 * cover / r2) * v;
  }
  return (2.0 * g) * v;
}

}  // namespace thigma
