#include "thigma/response/potential_law.h"

#include <algorithm>
#include <cmath>

namespace thigma {

void add_point(const AreaPoint& point, int exponent, PotentialMoments& moments) noexcept {
  Eigen::Matrix<double, 7, 1> u;
  u << point.depth, point.push, point.turn;
  const double w2 = point.depth * point.depth;
  const double weight = exponent == 2 ? point.area : point.area * w2;
  // The lower triangle alone: potential_force and add_springs read no other.
  for (int j = 0; j < 7; ++j) {
    const double by = weight * u[j];
    for (int i = j; i < 7; ++i) moments.sum(i, j) += by * u[i];
  }
  moments.place += weight * point.depth * point.arm;
  moments.deepest = std::max(moments.deepest, point.depth);
}

namespace {

/// Integrals of w^(p-2) times shares of two corners, over a triangle of area 1. Six points: of
/// degree 4.
/// Source  Dunavant 1985.
Mat3 share_integrals(const Vec3& w, int exponent) noexcept {
  struct Place {
    double near, far, weight;  // shares of two corners and of the third
  };
  constexpr Place kPlaces[2] = {
      {0.445948490915965, 0.108103018168070, 0.223381589678011},
      {0.091576213509771, 0.816847572980459, 0.109951743655322},
  };
  Mat3 sum = Mat3::Zero();
  for (const Place& place : kPlaces) {
    for (int k = 0; k < 3; ++k) {
      Vec3 share = Vec3::Constant(place.near);
      share[k] = place.far;
      const double depth = share.dot(w);
      const double weight = exponent == 2 ? place.weight : place.weight * depth * depth;
      sum += weight * share * share.transpose();
    }
  }
  return sum;
}

}  // namespace

void add_triangle(const AreaPoint& a, const AreaPoint& b, const AreaPoint& c, double weight,
                  int exponent, PotentialMoments& moments) noexcept {
  const AreaPoint* corners[3] = {&a, &b, &c};
  const double area = 0.5 * weight * (b.arm - a.arm).cross(c.arm - a.arm).norm();
  const Vec3 w(a.depth, b.depth, c.depth);
  const Mat3 shares = area * share_integrals(w, exponent);
  Eigen::Matrix<double, 7, 3> u;
  for (int k = 0; k < 3; ++k) u.col(k) << w[k], corners[k]->push, corners[k]->turn;
  const Eigen::Matrix<double, 7, 3> weighted = u * shares;
  for (int j = 0; j < 7; ++j)
    for (int i = j; i < 7; ++i) moments.sum(i, j) += u.row(i).dot(weighted.row(j));
  const Vec3 pressing = shares * w;
  for (int k = 0; k < 3; ++k) moments.place += pressing[k] * corners[k]->arm;
  moments.deepest = std::max(moments.deepest, w.maxCoeff());
}

void add_moments(const PotentialMoments& other, PotentialMoments& moments) noexcept {
  moments.sum += other.sum;
  moments.place += other.place;
  moments.deepest = std::max(moments.deepest, other.deepest);
}

PotentialForce potential_force(const PotentialMoments& moments, double stiffness,
                               const PotentialLaw& law) noexcept {
  PotentialForce f;
  const double sum = moments.sum(0, 0) / law.area;  // S
  if (!(sum > 0.0)) return f;
  const Vec6 h = moments.sum.col(0).tail<6>() / law.area;
  const Mat6 lower = moments.sum.bottomRightCorner<6, 6>() / law.area;
  const Mat6 second = lower.selfadjointView<Eigen::Lower>();
  // S^(2/p - 1)
  const double scale = law.exponent == 2 ? stiffness : stiffness / std::sqrt(sum);
  f.energy = 0.5 * scale * sum;
  f.wrench = {-scale * h.head<3>(), -scale * h.tail<3>()};
  const double p1 = law.exponent - 1;
  f.curvature = p1 * scale * (second - h * h.transpose() / sum);
  f.jacobian = -f.curvature - scale / sum * h * h.transpose();
  return f;
}

namespace {

/// Columns whose squares add up to a positive semidefinite matrix, in the order of its rows, so
/// that they move as smoothly as it does.
struct Factor {
  Mat6 columns = Mat6::Zero();
  int count = 0;
};

/// size  of the diagonal before anything was taken off it: what is rounding beside it is left out
Factor factor_of(Mat6 rest, const Vec6& size) noexcept {
  constexpr double kRounding = 1e-9;
  Factor factor;
  for (int j = 0; j < 6; ++j) {
    const double pivot = rest(j, j);
    if (!(pivot > kRounding * size[j])) continue;
    const Vec6 column = rest.col(j) / std::sqrt(pivot);
    factor.columns.col(factor.count++) = column;
    rest -= column * column.transpose();
  }
  return factor;
}

/// The point on a body nearest to `near` at which a push has this gradient.
Vec3 arm_of(const Vec6& gradient, const Vec3& near) noexcept {
  const Vec3 push = gradient.head<3>();
  const double size = push.squaredNorm();
  if (!(size > 0.0)) return near;
  return near + push.cross(gradient.tail<3>() - near.cross(push)) / size;
}

}  // namespace

void add_springs(const PotentialMoments& moments, const PenaltyParams& penalty,
                 const PotentialLaw& law, const Mat3& body_from_world,
                 StaticVector<DepthTerm, kMaxClusters>& terms) noexcept {
  const PotentialForce f = potential_force(moments, penalty.stiffness, law);
  if (!(f.energy > 0.0) || !(penalty.stiffness > 0.0)) return;
  const Vec6 h = moments.sum.col(0).tail<6>();
  const Factor factor = factor_of(f.curvature, -f.jacobian.diagonal());
  const int count = std::max(1, 2 * factor.count);
  const double w = moments.deepest;
  const double stiffness = 2.0 * f.energy / (w * w);
  const Vec6 mean = h * (w / moments.sum(0, 0));
  // Where all presses together.
  const double weight = h.head<3>().norm();
  const Vec3 place = weight > 0.0 ? Vec3(moments.place / weight) : Vec3::Zero();
  const double apart = std::sqrt(0.5 * count / stiffness);
  for (int i = 0; i < count; ++i) {
    DepthTerm term;
    Vec6 gradient = mean;
    if (factor.count > 0) gradient += (i % 2 == 0 ? apart : -apart) * factor.columns.col(i / 2);
    term.linear = gradient.head<3>();
    term.angular = gradient.tail<3>();
    term.depth = w - penalty.tolerance;
    term.stiffness = stiffness / count;
    term.damping = penalty.damping / penalty.stiffness * term.stiffness;
    term.tolerance = penalty.tolerance;
    term.id = i;
    term.body = -1;
    term.arm_body = body_from_world * arm_of(gradient, place);
    terms.push_back(term);
  }
}

}  // namespace thigma
