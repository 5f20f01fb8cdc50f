#include "thigma/dynamics/bristle.h"

#include <algorithm>
#include <cmath>

#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr int kMaxTurns = 4;  // of a step, each letting more bristles slide

using Mat3x13 = Eigen::Matrix<double, 3, 13>;

/// What presses two surfaces together, with its derivative.
struct Press {
  double force = 0.0;  // >= 0 [N]
  Vec13 by_y = Vec13::Zero();
};

Press press_of(const Bristle& b, const BodyAtState& at, bool has_derivative) THIGMA_RT {
  Press press;
  WrenchJacobian jacobian = WrenchJacobian::Zero();
  WrenchJacobian* const into = has_derivative ? &jacobian : nullptr;
  if (b.plane != nullptr) {
    const PlaneForce f = plane_force(*b.plane, at, 1.0, into);
    if (!f.is_active) return press;
    press.force = b.scale * f.magnitude;
    // The force is -magnitude n.
    press.by_y = -b.scale * (jacobian.topRows<3>().transpose() * b.plane->normal);
    return press;
  }
  const PlaneForce f = depth_force(*b.depth, *b.taken_at, at, 1.0, into);
  if (!f.is_active) return press;
  const double scale = b.scale * b.depth->linear.norm();
  press.force = scale * f.magnitude;
  // The wrench is -magnitude (linear, angular), the gradient constant.
  press.by_y = -scale / b.depth->linear.squaredNorm() *
               (jacobian.topRows<3>().transpose() * b.depth->linear);
  return press;
}

Vec3 along_surface(const Bristle& b, const Vec3& v) THIGMA_RT {
  const Vec3& n = b.entry.normal;
  return v - n * n.dot(v);
}

/// The point of a bristle at a state.
struct PointAt {
  Vec3 arm, bend, velocity;  // the last two along the surface
};

PointAt point_at(const Bristle& b, const BodyAtState& at) THIGMA_RT {
  const BodyKinematics& kin = at.kinematics;
  PointAt p;
  p.arm = kin.rotation * b.arm_body;
  p.bend = b.entry.bend + along_surface(b, at.state.position + p.arm - b.start);
  p.velocity = along_surface(b, kin.velocity.linear + kin.velocity.angular.cross(p.arm));
  return p;
}

/// What the bristle would hold with were there no cone, against the motion.
Vec3 hold_of(const Bristle& b, const PointAt& p) THIGMA_RT {
  return b.entry.stiffness * p.bend + b.damping * p.velocity;
}

/// A vector across n0 turned with it to n1; where that is a right angle or more, its part across
/// n1. Never longer than before.
Vec3 turned(const Vec3& v, const Vec3& n0, const Vec3& n1) THIGMA_RT {
  const double cosine = n0.dot(n1);
  Vec3 result = v;
  if (cosine > 0.0) {
    const Vec3 w = n0.cross(n1), turn = w.cross(v);
    result += turn + w.cross(turn) / (1.0 + cosine);
  }
  result -= n1 * n1.dot(result);
  const double before = v.norm(), after = result.norm();
  return after > before ? Vec3(result * (before / after)) : result;
}

void recall(const BristleMemory& memory, Bristle& b) THIGMA_RT {
  for (const BristleMemory::Entry& kept : memory.entries) {
    if (kept.id != b.entry.id || kept.body != b.entry.body || kept.is_relief != b.entry.is_relief)
      continue;
    b.entry.is_sliding = kept.is_sliding;
    b.entry.bend = std::sqrt(kept.stiffness / b.entry.stiffness) *
                   turned(kept.bend, kept.normal, b.entry.normal);
    return;
  }
}

/// What plane and depth terms have in common.
template <class Term>
void add_bristle(const Term& term, const Vec3& normal, Bristle bristle, const BodyAtState& at,
                 const BristleMemory& memory, Bristles& bristles) THIGMA_RT {
  const double stiffness = bristle.scale * term.stiffness;
  if (!(term.friction.at_rest > 0.0) || !(stiffness > 0.0)) return;
  bristle.entry = {term.id, term.body,   bristle.depth != nullptr, false, stiffness,
                   normal,  Vec3::Zero()};
  bristle.damping = bristle.scale * term.damping;
  bristle.friction = term.friction;
  bristle.arm_body = term.arm_body;
  bristle.start = at.state.position + at.kinematics.rotation * term.arm_body;
  recall(memory, bristle);
  bristles.push_back(bristle);
}

double coefficient(const Bristle& b) THIGMA_RT {
  return b.slides || b.entry.is_sliding ? b.friction.kinetic : b.friction.at_rest;
}

/// Lets those slide that end beyond their cone; returns whether there are any.
bool let_slide(const BodyAtState& after, Bristles& bristles) THIGMA_RT {
  bool is_any = false;
  for (Bristle& b : bristles) {
    if (b.slides) continue;
    const Vec3 hold = hold_of(b, point_at(b, after));
    const double size = hold.norm();
    if (!(size > coefficient(b) * press_of(b, after, false).force)) continue;
    b.slides = is_any = true;
    b.direction = hold / size;
  }
  return is_any;
}

void forget(BristleMemory& memory) THIGMA_RT {
  memory.entries.clear();
  memory.wrench = {};
  memory.slip = {};
}

/// Bristles at the end of a step, their elastic part returned to the cone.
void keep(const BodyAtState& after, const Bristles& bristles, BristleMemory& memory) THIGMA_RT {
  forget(memory);
  for (const Bristle& b : bristles) {
    const double press = press_of(b, after, false).force;
    if (!(press > 0.0)) continue;
    BristleMemory::Entry entry = b.entry;
    entry.bend = point_at(b, after).bend;
    entry.is_sliding = b.slides;
    const double most = coefficient(b) * press / entry.stiffness, size = entry.bend.norm();
    ++(b.slides ? memory.slip.sliding : memory.slip.sticking);
    if (size > most) {
      entry.bend *= most / size;
      if (b.slides) memory.slip.work += coefficient(b) * press * (size - most);
    }
    memory.entries.push_back(entry);
    memory.wrench = memory.wrench + bristle_wrench(b, after);
  }
}

bool has_friction(const LinearContactModel& model) THIGMA_RT {
  const auto has = [](const auto& term) { return term.friction.at_rest > 0.0; };
  return std::any_of(model.planes.begin(), model.planes.end(), has) ||
         std::any_of(model.depths.begin(), model.depths.end(), has);
}

}  // namespace

Bristles bristles_of(const BristleContact& contact, const BodyAtState& at,
                     const BristleMemory& memory) THIGMA_RT {
  Bristles bristles;
  for (const PlaneTerm& term : contact.model.planes) {
    if (!(term.friction.at_rest > 0.0)) continue;
    if (!(plane_force(term, at).depth + term.tolerance > 0.0)) continue;
    Bristle b;
    b.plane = &term;
    b.scale = contact.scale;
    add_bristle(term, term.normal, b, at, memory, bristles);
  }
  for (const DepthTerm& term : contact.model.depths) {
    const double length = term.linear.norm();
    if (!(term.friction.at_rest > 0.0) || !(length > 0.0)) continue;
    if (!(depth_at(term, contact.model.state, at.state) + term.tolerance > 0.0)) continue;
    Bristle b;
    b.depth = &term;
    b.taken_at = &contact.model.state;
    b.scale = contact.scale;
    add_bristle(term, term.linear / length, b, at, memory, bristles);
  }
  return bristles;
}

Wrench bristle_wrench(const Bristle& b, const BodyAtState& at, WrenchJacobian* jacobian) THIGMA_RT {
  const BodyKinematics& kin = at.kinematics;
  const PointAt p = point_at(b, at);
  Press press;
  if (b.slides) press = press_of(b, at, jacobian != nullptr);
  const Vec3 force =
      b.slides ? Vec3(-b.friction.kinetic * press.force * b.direction) : Vec3(-hold_of(b, p));
  const Wrench wrench{force, p.arm.cross(force)};
  if (!jacobian) return wrench;
  const Mat34 arm_by_q = rotated_derivative(at.state.orientation, b.arm_body);
  Mat3x13 by_y;
  if (b.slides) {
    by_y = -b.friction.kinetic * b.direction * press.by_y.transpose();
  } else {
    const double k = b.entry.stiffness, d = b.damping;
    const Mat3 across = Mat3::Identity() - b.entry.normal * b.entry.normal.transpose();
    const Mat3 arm_cross = skew(p.arm);
    by_y.leftCols<3>() = -k * across;
    by_y.middleCols<4>(3) = -across * (k * arm_by_q + d * (skew(kin.velocity.angular) * arm_by_q -
                                                           arm_cross * kin.angular_velocity_by_q));
    by_y.middleCols<3>(7) = -(d / at.body.mass) * across;
    by_y.rightCols<3>() = d * across * arm_cross * kin.inverse_inertia;
  }
  jacobian->topRows<3>() += by_y;
  jacobian->bottomRows<3>() += skew(p.arm) * by_y;
  jacobian->block<3, 4>(3, 3) -= skew(force) * arm_by_q;
  return wrench;
}

BodyState bristle_step(const BodyAtState& at, const StepForces& forces,
                       const BristleContact& contact, BristleMemory& memory) THIGMA_RT {
  if (!has_friction(contact.model)) {
    forget(memory);
    return implicit_step(at, forces.wrench, forces.jacobian, contact.dt);
  }
  Bristles bristles = bristles_of(contact, at, memory);
  BodyState next;
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    StepForces all = forces;
    for (const Bristle& b : bristles)
      all.wrench = all.wrench + bristle_wrench(b, at, &all.jacobian);
    next = implicit_step(at, all.wrench, all.jacobian, contact.dt);
    if (!let_slide(at_state(at.body, next), bristles)) break;
  }
  keep(at_state(at.body, next), bristles, memory);
  return next;
}

void bend_bristles(const BodyAtState& before, const BodyAtState& after,
                   const BristleContact& contact, BristleMemory& memory) THIGMA_RT {
  if (!has_friction(contact.model)) return forget(memory);
  Bristles bristles = bristles_of(contact, before, memory);
  let_slide(after, bristles);
  keep(after, bristles, memory);
}

}  // namespace thigma
