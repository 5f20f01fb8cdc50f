#include "thigma/mesh/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace thigma {
namespace {

// A sum that keeps what rounding loses (Neumaier): hundreds of thousands of terms of both signs.
struct Sum {
  double total = 0.0, lost = 0.0;
  void add(double x) {
    const double t = total + x;
    lost += std::fabs(total) >= std::fabs(x) ? (total - t) + x : (x - t) + total;
    total = t;
  }
  double value() const { return total + lost; }
};

// The power of two nearest below x: scaling by it is exact.
double scale_of(double x) { return x > 1e-300 ? std::ldexp(1.0, std::ilogb(x)) : 1.0; }

double square_distance(const Vec3& a, const Vec3& b) { return (a - b).squaredNorm(); }

// Smallest ball with all of the given points on its sphere; false when they have no such ball
// (degenerate).
bool circumscribe(const Vec3* p, int count, Ball& ball) {
  ball.center = p[0];
  ball.radius = 0.0;
  if (count == 1) return true;
  // center = p0 + Q x with Q's columns q_i = p_i - p0: 2 Q^T Q x = (|q_i|^2).
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> q(3, count - 1);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> squares(count - 1);
  for (int i = 1; i < count; ++i) {
    q.col(i - 1) = p[i] - p[0];
    squares(i - 1) = q.col(i - 1).squaredNorm();
  }
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram = q.transpose() * q;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> x = gram.fullPivLu().solve(0.5 * squares);
  const double largest = squares.maxCoeff();
  if (!x.allFinite() || !((gram * x - 0.5 * squares).cwiseAbs().maxCoeff() <= 1e-9 * largest))
    return false;
  const Vec3 to_center = q * x;
  ball.center = p[0] + to_center;
  ball.radius = to_center.norm();
  return std::isfinite(ball.radius);
}

// Smallest ball around at most five points: of all their subsets, the smallest ball that holds
// every point.
Ball ball_of_few(const std::vector<Vec3>& points, std::vector<Vec3>& support) {
  Ball best{points[0], std::numeric_limits<double>::infinity()};
  const unsigned subsets = 1u << points.size();
  for (unsigned subset = 1; subset < subsets; ++subset) {
    std::array<Vec3, 4> chosen;
    chosen.fill(Vec3::Zero());
    int count = 0;
    for (std::size_t i = 0; i < points.size() && count <= 4; ++i) {
      if ((subset >> i & 1u) == 0) continue;
      if (count < 4) chosen[static_cast<std::size_t>(count)] = points[i];
      ++count;
    }
    Ball ball;
    if (count > 4 || !circumscribe(chosen.data(), count, ball) || !(ball.radius < best.radius))
      continue;
    const double reach = ball.radius * (1.0 + 1e-10);
    const bool holds_all = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return square_distance(p, ball.center) <= reach * reach;
    });
    if (!holds_all) continue;
    best = ball;
    support.assign(chosen.begin(), chosen.begin() + count);
  }
  return best;
}

std::size_t farthest(const std::vector<Vec3>& points, const Vec3& from, double& distance) {
  std::size_t best = 0;
  double best_square = -1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = square_distance(points[i], from);
    if (d > best_square) {
      best_square = d;
      best = i;
    }
  }
  distance = std::sqrt(best_square);
  return best;
}

}  // namespace

Bounds bounds_of(std::span<const Vec3> points) {
  Bounds b;
  if (points.empty()) return b;
  b.min = b.max = points[0];
  for (const Vec3& p : points) {
    b.min = b.min.cwiseMin(p);
    b.max = b.max.cwiseMax(p);
  }
  return b;
}

Ball enclosing_ball(std::span<const Vec3> points) {
  if (points.empty()) return {};
  const Bounds box = bounds_of(points);
  const Vec3 middle = 0.5 * box.min + 0.5 * box.max;
  const double scale = scale_of((box.max - box.min).maxCoeff());
  std::vector<Vec3> local(points.size());
  for (std::size_t i = 0; i < local.size(); ++i) local[i] = (points[i] - middle) / scale;

  double distance = 0.0;
  Ball best{Vec3::Zero(), std::numeric_limits<double>::infinity()};
  std::vector<Vec3> support{local[farthest(local, Vec3::Zero(), distance)]};
  Ball ball{support[0], 0.0};
  // Each turn's ball is larger than the one before, so no support set returns; on rounding the best
  // found stays.
  for (int turn = 0; turn < 1000; ++turn) {
    const std::size_t out = farthest(local, ball.center, distance);
    if (distance < best.radius) best = {ball.center, distance};
    if (distance <= ball.radius * (1.0 + 1e-10)) break;
    const double before = ball.radius;
    support.push_back(local[out]);
    const std::vector<Vec3> few = support;
    ball = ball_of_few(few, support);
    if (!(ball.radius > before)) break;
  }
  return {middle + scale * best.center, scale * best.radius};
}

MassProperties mass_properties(const TriangleMesh& mesh) {
  MassProperties result;
  const Bounds box = bounds_of(mesh.positions);
  if (mesh.positions.empty()) return result;
  const Vec3 origin = 0.5 * box.min + 0.5 * box.max;
  const double scale = scale_of((box.max - box.min).maxCoeff());
  const double unscale = 1.0 / scale;

  Sum area, volume;
  std::array<Sum, 3> first;
  std::array<Sum, 6> second;  // xx yy zz xy yz zx
  for (const std::array<std::int32_t, 3>& t : mesh.triangles) {
    const Vec3 a = (mesh.positions[static_cast<std::size_t>(t[0])] - origin) * unscale;
    const Vec3 b = (mesh.positions[static_cast<std::size_t>(t[1])] - origin) * unscale;
    const Vec3 c = (mesh.positions[static_cast<std::size_t>(t[2])] - origin) * unscale;
    const Vec3 normal = (b - a).cross(c - a);
    area.add(0.5 * normal.norm());
    // a . (b x c) with the differences first: they carry the small triangle's digits.
    const double det = a.dot(normal);
    volume.add(det / 6.0);
    const Vec3 s = a + b + c;
    const auto moment = [&](int i, int j) {
      return det / 120.0 * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    };
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      first[static_cast<std::size_t>(i)].add(det / 24.0 * s[i]);
      second[static_cast<std::size_t>(i)].add(moment(i, i));
      second[static_cast<std::size_t>(i + 3)].add(moment(i, j));
    }
  }

  const double v = volume.value();
  const double l2 = scale * scale;
  result.area = area.value() * l2;
  result.volume = v * l2 * scale;
  result.center_of_mass = origin;
  if (v == 0.0) return result;
  const Vec3 c(first[0].value() / v, first[1].value() / v, first[2].value() / v);
  result.center_of_mass = origin + scale * c;
  Mat3 covariance;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    covariance(i, i) = second[static_cast<std::size_t>(i)].value() - v * c[i] * c[i];
    covariance(i, j) = covariance(j, i) =
        second[static_cast<std::size_t>(i + 3)].value() - v * c[i] * c[j];
  }
  result.inertia = (covariance.trace() * Mat3::Identity() - covariance) * (l2 * l2 * scale);
  return result;
}

}  // namespace thigma
