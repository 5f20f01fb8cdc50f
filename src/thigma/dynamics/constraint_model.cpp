#include "thigma/dynamics/constraint_model.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/infinity.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

/// Two lines: the normal is that of the plane along both, the arm ends on the object's.
RowAtState edges_at(const ContactRow& row, const Vec3& position, const Mat3& rotation) THIGMA_RT {
  RowAtState at;
  const Vec3 u = rotation * row.object_direction;
  const Vec3& w = row.scene_direction;
  const Vec3 cross = u.cross(w);
  const double square = cross.squaredNorm();
  const Vec3 arm = rotation * row.object_point;
  at.arm = arm;
  if (!(square > 0.0)) {
    at.gap = kInfinity;
    return at;
  }
  at.normal = cross / std::sqrt(square);
  const Vec3 between = row.scene_point - (position + arm);
  at.gap = at.normal.dot(between);
  // Where the object's line is nearest to the scene's: (between - s u) . (w x cross) = 0.
  const double along = between.dot(w.cross(cross)) / u.dot(w.cross(cross));
  at.arm = arm + along * u;
  return at;
}

/// A surface of second order about the place where relief was found deepest.
RowAtState relief_at(const ContactRow& row, const Vec3& position, const Mat3& rotation) THIGMA_RT {
  RowAtState at;
  at.arm = rotation * row.object_point;
  const Vec3& n = row.scene_direction;
  const Vec3& bend = row.object_direction;
  const Vec3 left = row.scene_point - position - at.arm;
  const TangentPair tangent = relief_frame(row);
  const double first = -tangent.first.dot(left), second = -tangent.second.dot(left);
  const double by_first = bend.x() * first + bend.y() * second;
  const double by_second = bend.y() * first + bend.z() * second;
  const Vec3 slope = n + by_first * tangent.first + by_second * tangent.second;
  const double length = slope.norm();  // at least n . plane
  at.normal = slope / length;
  at.gap = (n.dot(left) - 0.5 * (by_first * first + by_second * second)) / length;
  return at;
}

/// Least gap of rows but those of relief, which tell a depth to second order only.
double least_plain_gap(const ConstraintModel& model, const Vec3& position,
                       const Mat3& rotation) THIGMA_RT {
  double least = kInfinity;
  for (const ContactRow& row : model.rows)
    if (row.kind != RowKind::relief) least = std::min(least, row_at(row, position, rotation).gap);
  return least;
}

}  // namespace

TangentPair tangents_of(const Vec3& normal) THIGMA_RT {
  const Vec3 axis = std::fabs(normal.x()) < 0.6 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
  const Vec3 first = normal.cross(axis).normalized();
  return {first, normal.cross(first)};
}

TangentPair relief_frame(const ContactRow& row) THIGMA_RT {
  return tangents_of((row.plane.array() == 0.0).all() ? row.scene_direction : row.plane);
}

RowAtState row_at(const ContactRow& row, const Vec3& position, const Mat3& rotation) THIGMA_RT {
  if (row.kind == RowKind::edges) return edges_at(row, position, rotation);
  if (row.kind == RowKind::relief) return relief_at(row, position, rotation);
  RowAtState at;
  if (row.kind == RowKind::scene_plane) {
    at.normal = row.scene_direction;
    at.arm = rotation * row.object_point;
    at.gap = at.normal.dot(row.scene_point - position - at.arm);
  } else {
    at.normal = rotation * row.object_direction;
    at.arm = row.scene_point - position;
    at.gap = at.normal.dot(at.arm) - row.object_direction.dot(row.object_point);
  }
  return at;
}

double travel_between(const BodyState& a, const BodyState& b, double reach) THIGMA_RT {
  const Quat turn = b.orientation * a.orientation.conjugate();
  // A point at r from the centre goes 2 r sin(angle / 2) at most; |vec(q)| is that sine.
  return (b.position - a.position).norm() + 2.0 * reach * turn.vec().norm();
}

bool is_beyond(const ConstraintModel& model, const BodyState& body) THIGMA_RT {
  return travel_between(model.state, body, model.reach) > model.travel;
}

bool may_take(const ConstraintModel& offered, const ConstraintModel& held,
              const BodyState& body) THIGMA_RT {
  constexpr double kAtRest = 1e-9;  // of the reach: nothing has moved since
  if (is_beyond(held, body)) return true;
  const double moved = travel_between(offered.state, body, offered.reach);
  if (moved > offered.travel) return false;
  if (moved <= kAtRest * offered.reach) return true;
  const Mat3 rotation = rotation_matrix(body.orientation);
  const double least = least_plain_gap(offered, body.position, rotation);
  // What began inside is led out by rows that it has passed.
  return least >= 0.0 || least >= least_plain_gap(held, body.position, rotation);
}

}  // namespace thigma
