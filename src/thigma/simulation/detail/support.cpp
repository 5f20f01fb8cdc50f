#include "thigma/simulation/detail/support.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/rotation.h"
#include "thigma/simulation/detail/safe_time.h"

namespace thigma::detail {
namespace {

constexpr int kFewestSweeps = 5, kMostSweeps = 200;
// contacts, in all sweeps: where levels change hundreds may touch at once
constexpr std::size_t kMostRelaxed = 4000;
// change of velocity in a sweep that counts as none, of the speed of a fall over the tolerance
constexpr double kSteady = 1e-9;

// Mean velocity of the body over a flight, as forces change it.
struct MeanMotion {
  double by_force;  // of the mean velocity by a unit of force, over the flight
  Mat3 by_torque;
  Vec3 linear, angular;

  Vec3 at(const Vec3& arm) const { return linear + angular.cross(arm); }
  void push(const Vec3& arm, const Vec3& force) {
    linear += by_force * force;
    angular += by_torque * arm.cross(force);
  }
  void turn(const Vec3& torque) { angular += by_torque * torque; }
};

MeanMotion free_mean(const RigidBody& body, const BodyState& state, double time) {
  const Twist v = velocity(body, state);
  const Mat3 R = rotation_matrix(state.orientation);
  return {0.5 * time / body.mass, 0.5 * time * (R * body.inverse_inertia * R.transpose()),
          v.linear + 0.5 * time * body.gravity, v.angular};
}

// Brings the point of a contact to its outward speed and, as far as the cones allow, to no sliding
// and no turning.
void relax(SupportPoint& p, const CollisionLaw& law, MeanMotion& mean) {
  const Vec3 before = p.force;
  const double pushing =
      std::max(p.force.dot(p.out) + (p.speed - p.out.dot(mean.at(p.arm))) * p.per_speed, 0.0);
  const Vec3 along = p.force - p.force.dot(p.out) * p.out;
  p.force = pushing * p.out + along;
  mean.push(p.arm, p.force - before);
  const Vec3 velocity = mean.at(p.arm);
  const Vec3 sliding = velocity - p.out.dot(velocity) * p.out;
  Vec3 wanted = along - p.per_slide * sliding;
  const double most = law.friction * pushing, size = wanted.norm();
  if (size > most) wanted *= most / size;
  const Vec3 held = pushing * p.out + wanted;
  mean.push(p.arm, held - p.force);
  p.force = held;
  if (!(law.rolling > 0.0)) return;
  Vec3 couple = p.couple - p.per_turn * mean.angular;
  const double most_couple = law.rolling * pushing, couple_size = couple.norm();
  if (couple_size > most_couple) couple *= most_couple / couple_size;
  mean.turn(couple - p.couple);
  p.couple = couple;
}

// The same contacts in the same order keep their forces from one time to another.
void set_up(const SimulationWorld& world, const BodyState& state, const HeldContacts& held,
            const SupportedFlight& flight, std::vector<SupportPoint>& points) {
  const std::span<const std::int32_t> contacts = held.contacts;
  const double time = flight.time;
  const bool is_known = points.size() == contacts.size();
  points.resize(contacts.size());
  const double target = 0.5 * collision_gap(world);
  const double fastest =
      std::sqrt(2.0 * world.body.gravity.norm() * kShortestFall * collision_gap(world));
  const double per_turn = 1.0 / (0.5 * time * world.body.inverse_inertia.trace());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = held.set.contacts[static_cast<std::size_t>(contacts[i])];
    SupportPoint& p = points[i];
    const ApproachingContact touch = approaching(world, state, c);
    const Mat3 matrix = 0.5 * time * collision_matrix(world.body, state, touch.arm);
    p.out = -c.normal;
    p.arm = touch.arm;
    p.per_speed = 1.0 / p.out.dot(matrix * p.out);
    p.per_slide = 1.0 / (matrix.trace() - p.out.dot(matrix * p.out));
    p.speed = std::min(flight.lift * std::max(target - touch.gap, 0.0) / time, fastest);
    p.per_turn = per_turn;
    if (is_known) continue;
    p.force.setZero();
    p.couple.setZero();
  }
}

}  // namespace

Wrench support_wrench(const SimulationWorld& world, const BodyState& state,
                      const HeldContacts& held, const SupportedFlight& flight,
                      std::vector<SupportPoint>& points) {
  set_up(world, state, held, flight, points);
  MeanMotion mean = free_mean(world.body, state, flight.time);
  for (const SupportPoint& p : points) {
    mean.push(p.arm, p.force);
    mean.turn(p.couple);
  }
  double reach = 0.0;
  for (const SupportPoint& p : points) reach = std::max(reach, p.arm.norm());
  const double steady = kSteady * std::sqrt(2.0 * world.body.gravity.norm() * world.tolerance);
  const int sweeps =
      std::clamp(static_cast<int>(kMostRelaxed / std::max<std::size_t>(points.size(), 1)),
                 kFewestSweeps, kMostSweeps);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const MeanMotion before = mean;
    for (SupportPoint& p : points) relax(p, world.law, mean);
    if ((mean.linear - before.linear).norm() + reach * (mean.angular - before.angular).norm() <=
        steady)
      break;
  }
  Wrench push;
  for (const SupportPoint& p : points) {
    push.force += p.force;
    push.torque += p.arm.cross(p.force) + p.couple;
  }
  return push;
}

}  // namespace thigma::detail
