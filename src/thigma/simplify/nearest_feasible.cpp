#include "thigma/simplify/nearest_feasible.h"

#include <array>
#include <cmath>

#include <Eigen/Cholesky>

namespace thigma {
namespace {

/// Where the search is confined to: a point and what spans the plane or line through it.
struct Flat {
  Vec3 point = Vec3::Zero();
  std::array<Vec3, 3> axis;  // orthonormal
  int dimension = 3;
};

/// The part of a constraint's normal that lies in the flat; zero when the constraint is the same
/// all over it.
Vec3 inside(const Flat& flat, const Vec3& normal) {
  Vec3 part = Vec3::Zero();
  for (int i = 0; i < flat.dimension; ++i) {
    const Vec3& axis = flat.axis[static_cast<std::size_t>(i)];
    part += normal.dot(axis) * axis;
  }
  return part;
}

/// The flat's section with normal . x = offset, `part` being what of the normal lies in it.
Flat section(const Flat& flat, const Vec3& part, double height) {
  const double size2 = part.squaredNorm();
  Flat cut;
  cut.point = flat.point - (height / size2) * part;
  cut.dimension = flat.dimension - 1;
  const Vec3 gone = part / std::sqrt(size2);
  // Gram and Schmidt over the axes, that most along the normal last.
  std::array<Vec3, 3> axis = flat.axis;
  const auto count = static_cast<std::size_t>(flat.dimension);
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (std::fabs(axis[i].dot(gone)) > std::fabs(axis[count - 1].dot(gone)))
      std::swap(axis[i], axis[count - 1]);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    Vec3 a = axis[i] - axis[i].dot(gone) * gone;
    for (std::size_t j = 0; j < i; ++j) a -= a.dot(cut.axis[j]) * cut.axis[j];
    cut.axis[i] = a.normalized();
  }
  return cut;
}

/// Of the flat, whose point is the nearest of all of it, the nearest that meets the constraints.
std::optional<Vec3> search(const Flat& flat, std::span<const LinearConstraint> constraints,
                           double tolerance) {
  Vec3 x = flat.point;
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const LinearConstraint& c = constraints[i];
    if (c.normal.dot(x) - c.offset <= tolerance) continue;
    const Vec3 part = inside(flat, c.normal);
    if (!(part.squaredNorm() > 1e-16 * c.normal.squaredNorm())) return std::nullopt;
    const std::optional<Vec3> next = search(
        section(flat, part, c.normal.dot(flat.point) - c.offset), constraints.first(i), tolerance);
    if (!next) return std::nullopt;
    x = *next;
  }
  return x;
}

}  // namespace

std::optional<Vec3> nearest_feasible(const Vec3& target, const Mat3& metric,
                                     std::span<const LinearConstraint> constraints,
                                     double tolerance) {
  // y = U (x - target) makes the metric the plain distance.
  const Eigen::LLT<Mat3> factors(metric);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const Mat3 back = factors.matrixU().solve(Mat3::Identity());
  std::array<LinearConstraint, kMostConstraints> scaled;
  const std::size_t count = constraints.size();
  if (count > scaled.size()) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i)
    scaled[i] = {back.transpose() * constraints[i].normal,
                 constraints[i].offset - constraints[i].normal.dot(target)};
  Flat all;
  all.axis = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const std::optional<Vec3> y = search(all, {scaled.data(), count}, tolerance);
  if (!y) return std::nullopt;
  return Vec3(target + back * *y);
}

}  // namespace thigma
