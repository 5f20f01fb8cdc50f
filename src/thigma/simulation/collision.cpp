#include "thigma/simulation/collision.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr double kSteps = 32.0;  // of a compression without friction
constexpr int kMostSteps = 2000;
constexpr double kStuck = 1e-12;  // of the speed at the start: does not slide

// The velocity of a point while the normal impulse grows. A step adds an impulse of constant
// direction, so that velocity runs straight and the work of the step is exact; it ends at the
// latest where sliding stops.
class Collision {
 public:
  Collision(const Mat3& matrix, const Vec3& velocity, const Vec3& normal, double friction)
      : matrix_(matrix), out_(-normal), u_(velocity), mu_(friction) {
    const double compression = -out_.dot(u_) / out_.dot(matrix_ * out_);
    step_ = compression / kSteps;
    stuck_ = kStuck * velocity.norm();
    const Vec3 hold = matrix_.inverse() * out_;
    hold_ = hold / out_.dot(hold);
  }

  Vec3 impulse() const { return impulse_; }

  // To the end of the approach; returns the work of the normal impulse, negative.
  double compress() {
    double work = 0.0;
    for (int i = 0; i < kMostSteps && approach() > 0.0; ++i) {
      const Push push = next_push();
      work += advance(push, std::min(push.longest, approach() / push.gain));
    }
    return work;
  }

  // Until the normal impulse has done this work, positive.
  void push_off(double work) {
    for (int i = 0; i < kMostSteps && work > 0.0; ++i) {
      const Push push = next_push();
      const double speed = std::max(-approach(), 0.0);
      const double enough =
          2.0 * work / (speed + std::sqrt(speed * speed + 2.0 * push.gain * work));
      if (enough <= push.longest) {
        advance(push, enough);
        return;
      }
      work -= advance(push, push.longest);
    }
  }

 private:
  // Impulse and change of velocity by a unit of normal impulse.
  struct Push {
    Vec3 impulse, change;
    double gain;     // of the speed along the normal, > 0
    double longest;  // normal impulse until sliding may stop or turn
  };

  double approach() const { return -out_.dot(u_); }
  Vec3 along(const Vec3& v) const { return v - out_.dot(v) * out_; }

  Push push_by(const Vec3& impulse) const {
    const Vec3 change = matrix_ * impulse;
    return {impulse, change, out_.dot(change), step_};
  }

  Push next_push() const {
    const Vec3 sliding = along(u_);
    const double speed = sliding.norm();
    if (speed > stuck_) return sliding_push(sliding / speed, speed);
    if (along(hold_).norm() <= mu_) return push_by(hold_);
    return sliding_push(direction_of_slip(), 0.0);
  }

  // Friction against the sliding; none where it would press the point in faster than the normal
  // pushes it out.
  Push sliding_push(const Vec3& way, double speed) const {
    Push push = push_by(out_ - mu_ * way);
    if (!(push.gain > 0.0)) push = push_by(out_);
    const double slows = -way.dot(push.change);
    if (speed > 0.0 && slows * push.longest > speed) push.longest = speed / slows;
    return push;
  }

  // Where a point goes that the cone cannot hold: the way its friction opposes.
  Vec3 direction_of_slip() const {
    Vec3 way = along(matrix_ * out_).normalized();
    for (int i = 0; i < 8; ++i) {
      const Vec3 next = along(matrix_ * (out_ - mu_ * way));
      if (!(next.norm() > 0.0)) break;
      way = (way + next.normalized()).normalized();
    }
    return way;
  }

  double advance(const Push& push, double normal_impulse) {
    const double before = -approach();
    u_ += normal_impulse * push.change;
    if (along(u_).norm() <= 4.0 * stuck_) u_ = out_.dot(u_) * out_;
    impulse_ += normal_impulse * push.impulse;
    return 0.5 * normal_impulse * (before - approach());
  }

  Mat3 matrix_;
  Vec3 out_;
  Vec3 u_;
  double mu_;
  Vec3 hold_;  // impulse that changes no velocity along the surface, of unit normal part
  double step_ = 0.0, stuck_ = 0.0;
  Vec3 impulse_ = Vec3::Zero();
};

}  // namespace

Mat3 collision_matrix(const RigidBody& body, const BodyState& state, const Vec3& arm) noexcept {
  const Mat3 R = rotation_matrix(state.orientation);
  // in body axes, so that the result is symmetric to the bit
  const Mat3 lever = R.transpose() * skew(arm);
  const Mat3 turning = lever.transpose() * body.inverse_inertia * lever;
  return Mat3::Identity() / body.mass + 0.5 * (turning + turning.transpose());
}

Vec3 point_velocity(const RigidBody& body, const BodyState& state, const Vec3& arm) noexcept {
  const Twist v = velocity(body, state);
  return v.linear + v.angular.cross(arm);
}

Vec3 collision_impulse(const Mat3& matrix, const Vec3& velocity, const Vec3& normal,
                       const CollisionLaw& law) noexcept {
  if (!(normal.dot(velocity) > 0.0)) return Vec3::Zero();
  Collision at(matrix, velocity, normal, law.friction);
  const double work = at.compress();
  at.push_off(-law.restitution * law.restitution * work);
  return at.impulse();
}

BodyState with_impulse(const BodyState& state, const Vec3& arm, const Vec3& impulse) noexcept {
  BodyState next = state;
  next.linear_momentum += impulse;
  next.angular_momentum += arm.cross(impulse);
  return next;
}

}  // namespace thigma
